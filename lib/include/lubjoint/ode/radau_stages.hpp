/// The stages of a step of Radau IIA, by simplified Newton iterations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "lubjoint/ode/error_scale.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/radau_tableau.hpp"
#include "lubjoint/ode/shifted_solver.hpp"
#include "lubjoint/ode/stage_solver.hpp"

namespace lubjoint {

/// Increments z of the stages from a state x, and the linear systems that they are found with: one Jacobian for all on
/// the transformed stages, one real and (s − 1)/2 complex factorisations a step. Where a system knows the part of its
/// Jacobian that forces make (OdeSystem::force_part), each stage has its own of that, and what is left of the Jacobian
/// lasts for many steps; works lag one iteration. In a thin film a force's slopes change by a multiple within a step:
/// at equal error that takes 30 to 45 % fewer evaluations of order 9 and 5 to 30 % of order 5 (slider-cranks), and a
/// fifth of the Jacobians. The system's parts are as RadauIIA says; parts.force_part(x, J, t) is looked for in them.
/// @tparam N  number of states, or run_time_size;  @tparam Linear  as of RadauIIA
template <class R, std::size_t N, int Stages, class Linear>
class RadauStages {
 public:
  using State = StateOf<R, N>;                                      ///< x
  using Scale = ErrorScale<R, N>;                                   ///< of its errors
  using Vector = typename Scale::Vector;                            ///< of states
  using Matrix = typename Linear::Jacobian;                         ///< ∂f/∂x
  using Tableau = RadauTableau<R, Stages>;                          ///< its coefficients
  static constexpr auto stages = static_cast<std::size_t>(Stages);  ///< s
  static constexpr std::size_t middle = stages / 2;                 ///< the stage at 0.645 or 0.584 of the step
  using AllStages = std::array<Vector, stages>;                     ///< a vector for each
  static constexpr int most_iterations = 15;                        ///< of a step

  /// Takes work of every size at once: no step allocates, and a copy copies numbers.
  explicit RadauStages(std::size_t states) : solver_(index(states)) {
    Linear::prepare(jacobian_, index(states));
    for (Vector* v : {&right_, &solution_}) v->setZero(index(states));
    for (AllStages* each : {&z_, &w_, &g_, &change_}) {
      for (Vector& v : *each) v.setZero(index(states));
    }
  }

  AllStages& increments() { return z_; }                                 ///< z, or the guess of it
  const AllStages& increments() const { return z_; }                     ///< z
  int iterations() const { return iterations_; }                         ///< of the last step
  const R& rate_of_convergence() const { return rate_of_convergence_; }  ///< of the last step's iterations
  bool jacobian_is_known() const { return jacobian_is_known_; }          ///< was one evaluated?
  bool jacobian_is_ahead() const { return jacobian_is_ahead_; }          ///< at a guess, not at a state?
  bool has_own_parts() const { return has_own_parts_; }                  ///< has each stage its own part of a Jacobian?
  StepperCounts& counts() { return counts_; }                            ///< so far
  const StepperCounts& counts() const { return counts_; }                ///< so far

  /// Forgets the Jacobian.
  void reset(const State& x) {
    rate_ = trial_ = x;
    jacobian_is_known_ = false;
  }

  /// f(x, t)
  template <class F>
  void evaluate(F& f, const State& x, const R& t, Vector& out) {
    f(x, rate_, t);
    for (std::size_t i = 0; i < rate_.size(); ++i) out(index(i)) = rate_[i];
  }

  /// x + z
  const State& displaced(const State& x, const Vector& z) {
    for (std::size_t i = 0; i < trial_.size(); ++i) trial_[i] = x[i] + z(index(i));
    return trial_;
  }

  /// ∂f/∂x at the guess of the middle stage: from there it is half as far to the ends of the step as from its start,
  /// and Newton's iterations shrink twice as fast. Without a guess, or where it is beyond a wall, at the start. Less
  /// what stages have of their own. @returns false if it is not finite
  template <class Parts>
  bool take_jacobian(Parts& parts, const State& x, const R& t, const R& h, bool is_guessed) {
    ++counts_.jacobians;
    jacobian_is_known_ = false;
    factorised_for_ = 0;
    jacobian_is_ahead_ = is_guessed;
    if (is_guessed) {
      try {
        evaluate_jacobian(parts, displaced(x, z_[middle]), R(t + abscissa(middle) * h));
        jacobian_is_known_ = jacobian_.allFinite();
      } catch (const std::domain_error&) {
      }
    }
    was_at_middle_ = jacobian_is_known_;
    if (!jacobian_is_known_) {
      jacobian_is_ahead_ = false;
      evaluate_jacobian(parts, x, t);
      jacobian_is_known_ = jacobian_.allFinite();
    }
    return jacobian_is_known_;
  }

  /// Is the Jacobian still as good for another step as it was for that for which it was new? To be asked after each.
  bool jacobian_lasts(bool is_new) {
    if (!has_own_parts_) return rate_of_convergence_ < R(keep_below);
    if (is_new) {
      fewest_iterations_ = iterations_;
      evaluations_more_ = 0;
    }
    fewest_iterations_ = std::min(fewest_iterations_, iterations_);
    evaluations_more_ += Stages * (iterations_ - fewest_iterations_);
    return evaluations_more_ < evaluations_of_jacobian;
  }

  /// Simplified Newton iterations for z of a step of length h from x at t, from the guess in it, to a size of `enough`
  /// of what is left.
  /// @param is_in_vain  is_in_vain(size of what is left): need the step, by its stages as they are, go no further?
  ///                    Asked from the second iteration on
  /// @returns false if they do not converge, or in vain
  template <class Parts, class IsInVain>
  bool solve(Parts& parts, const State& x, const R& t, const R& h, const Scale& scale, const R& enough,
             const IsInVain& is_in_vain) {
    using std::pow;
    using std::sqrt;
    if (!has_own_parts_) {
      if (factorised_for_ != h) factorise(h);
      combine(tableau_.t_inverse, z_, w_);
    }
    R old_size = 0;
    R convergence = 1;
    rate_of_convergence_ = 0;
    for (iterations_ = 1; iterations_ <= most_iterations; ++iterations_) {
      ++counts_.newton_iterations;
      const bool is_first = iterations_ == 1;
      if (!evaluate_stages(parts, x, t, h, has_own_parts_ && is_first)) return false;
      if (has_own_parts_) {
        if (is_first) factorise_stages(h);
        change_by_stages(h);
      } else {
        change_transformed(h);
      }
      R square(0);
      for (const Vector& each : change_) square += scale.square(each);
      const R change = sqrt(square / static_cast<R>(Stages * scale.controlled()));
      if (!std::isfinite(static_cast<double>(change))) return false;
      if (!is_first) {
        const R theta = change / old_size;
        rate_of_convergence_ = iterations_ == 2 ? theta : R(sqrt(theta * rate_of_convergence_));
        if (rate_of_convergence_ >= R(0.99)) return false;
        const R expected = has_own_parts_ ? std::max<R>(rate_of_convergence_, R(slowest_part)) : rate_of_convergence_;
        convergence = expected / (1 - expected);
      }
      if (convergence * change <= enough || change == 0) return true;
      if (!is_first) {
        const R last =
            convergence * change * pow(rate_of_convergence_, static_cast<R>(most_iterations - 1 - iterations_));
        if (iterations_ < most_iterations && last >= enough) return false;
        if (is_in_vain(R(convergence * change))) return false;
      }
      old_size = std::max<R>(change, std::numeric_limits<R>::min());
    }
    return false;
  }

  /// (γ/h − J)⁻¹ r of the last step, J that of the middle stage. Kept until the next call.
  const Vector& filtered(const Vector& r) {
    if constexpr (has_full_jacobian) {
      if (has_own_parts_) {
        stage_solver_.filter(r, solution_);
        return solution_;
      }
    }
    solver_.solve(r, solution_);
    return solution_;
  }

 private:
  using Index = Eigen::Index;
  static constexpr bool has_full_jacobian = std::is_same_v<Linear, FullLinear<R, N>> && std::is_floating_point_v<R>;
  /// Has the system a function for what stages have of their own?
  template <class Parts>
  static constexpr bool may_have_own_parts = has_full_jacobian&& requires(Parts parts) {
    parts.force_part;
  };

  /// Newton's iterations that shrink faster than this need no new Jacobian for the next step.
  static constexpr double keep_below = 1e-3;
  /// A Jacobian costs as much as so many evaluations of f: as many more than with a new one are worth another. From 6
  /// to 30 nothing else comes of it.
  static constexpr int evaluations_of_jacobian = 6;
  /// With parts of their own the first iteration finds nearly all that the films have to do with, and the second is so
  /// short that it says little of what the others, with a Jacobian that is some steps old, are slower by: no less than
  /// this. Without it a ledger of order 9 closes a hundred times worse; with it take 6 to 12 % more evaluations.
  static constexpr double slowest_part = 0.03;
  using Order = std::array<std::size_t, stages>;
  static constexpr Order in_time = [] {
    Order order{};
    for (std::size_t i = 0; i < stages; ++i) order[i] = i;
    return order;
  }();
  static constexpr Order middle_first = [] {
    Order order = in_time;
    std::swap(order[0], order[middle]);
    return order;
  }();

  static Index index(std::size_t i) { return static_cast<Index>(i); }
  const R& abscissa(std::size_t stage) const { return tableau_.c(index(stage)); }

  template <class Parts>
  void evaluate_jacobian(Parts& parts, const State& x, const R& t) {
    parts.second(x, jacobian_, t);
    if constexpr (may_have_own_parts<Parts>) {
      has_own_parts_ = parts.has_force_part();
      if (!has_own_parts_) return;
      Matrix& of_forces = own_.parts[middle];
      if (of_forces.size() != jacobian_.size()) {
        for (Matrix& each : own_.parts) each.setZero(jacobian_.rows(), jacobian_.cols());
      }
      parts.force_part(x, of_forces, t);
      own_.coordinates = second_order_coordinates(jacobian_);
      own_.rates_of(jacobian_) -= own_.rates_of(of_forces);
    }
  }

  /// f at each stage, into change_: one after the other in time, as each search for a stage's places starts from the
  /// last ones; but the middle first where a Jacobian was just evaluated, which the system may still know.
  /// @param own  also what the stages have of their own, first: a system may know f with it
  /// @returns false if one is not finite
  template <class Parts>
  bool evaluate_stages(Parts& parts, const State& x, const R& t, const R& h, bool own) {
    for (const std::size_t stage : std::exchange(was_at_middle_, false) ? middle_first : in_time) {
      const R t_stage = t + abscissa(stage) * h;
      const State& at = displaced(x, z_[stage]);
      if constexpr (may_have_own_parts<Parts>) {
        if (own) {
          Matrix& part = own_.parts[stage];
          parts.force_part(at, part, t_stage);
          if (!own_.rates_of(part).allFinite()) return false;
        }
      }
      evaluate(parts.first, at, t_stage, change_[stage]);
      if (!change_[stage].allFinite()) return false;
    }
    return true;
  }

  void factorise(const R& h) {
    typename Tableau::Pairs alpha = tableau_.alpha;
    typename Tableau::Pairs beta = tableau_.beta;
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      alpha[i] /= h;
      beta[i] /= h;
    }
    solver_.factorise(jacobian_, tableau_.gamma / h, alpha, beta);
    factorised_for_ = h;
    ++counts_.factorisations;
  }
  void factorise_stages(const R& h) {
    if constexpr (has_full_jacobian) {
      stage_solver_.factorise(jacobian_, own_.parts, own_.coordinates, h);
      ++counts_.factorisations;
    }
  }

  /// Makes of rates of stages, in change_, the changes of their increments, and makes these.
  void change_transformed(const R& h) {
    const auto& tab = tableau_;
    combine(tab.t_inverse, change_, g_);
    right_ = g_[0] - (tab.gamma / h) * w_[0];
    solver_.solve(right_, change_[0]);
    for (std::size_t pair = 0; pair < tab.alpha.size(); ++pair) {
      const std::size_t first = 2 * pair + 1;
      const R alpha = tab.alpha[pair] / h;
      const R beta = tab.beta[pair] / h;
      change_[first] = g_[first] - alpha * w_[first] + beta * w_[first + 1];
      change_[first + 1] = g_[first + 1] - beta * w_[first] - alpha * w_[first + 1];
      solver_.solve_in_place(pair, change_[first], change_[first + 1]);
    }
    for (std::size_t i = 0; i < stages; ++i) w_[i] += change_[i];
    combine(tab.t, w_, z_);
  }
  /// The same with what stages have of their own.
  void change_by_stages(const R& h) {
    if constexpr (has_full_jacobian) {
      combine(tableau_.a_inverse, z_, w_);
      for (std::size_t i = 0; i < stages; ++i) change_[i] -= w_[i] / h;
      stage_solver_.solve_in_place(change_);
      for (std::size_t i = 0; i < stages; ++i) z_[i] += change_[i];
    }
  }

  /// Σ_j w_j v_j over the stages.
  template <class Weights, std::size_t... J>
  static auto sum(const Weights& w, const AllStages& v, std::index_sequence<J...>) {
    return (... + (w(index(J)) * v[J]));
  }
  /// out_i = Σ_j m_ij in_j, over the stages.
  template <class Weights>
  static void combine(const Weights& m, const AllStages& in, AllStages& out) {
    Index i = 0;
    for (Vector& each : out) {
      each.noalias() = sum(m.row(i), in, std::make_index_sequence<stages>());
      ++i;
    }
  }

  /// What each stage has of its own beside jacobian_, which they share.
  struct OwnParts {
    OwnParts() {
      if constexpr (N != run_time_size) parts.fill(Matrix::Zero());
    }

    Index coordinates = 0;  ///< of (q, v, work)
    std::array<Matrix, stages> parts;

    auto rates_of(Matrix& jacobian) const { return jacobian.middleRows(coordinates, coordinates); }  ///< of v
  };
  struct Nothing {};
  template <class T>
  using IfFull = std::conditional_t<has_full_jacobian, T, Nothing>;

  const Tableau& tableau_ = Tableau::instance();
  Matrix jacobian_;
  R factorised_for_ = 0;  ///< the step's length
  typename Linear::template Solver<static_cast<std::size_t>(Tableau::pairs)> solver_;
  bool jacobian_is_known_ = false;
  bool jacobian_is_ahead_ = false;
  bool was_at_middle_ = false;  ///< was the last evaluation the Jacobian's, at the guess of the middle stage?
  bool has_own_parts_ = false;
  [[no_unique_address]] IfFull<OwnParts> own_;
  [[no_unique_address]] IfFull<StageSolver<R, Scale::dimension, Stages>> stage_solver_;

  AllStages z_;
  int iterations_ = 0;
  int fewest_iterations_ = 0;  ///< of a step, since the Jacobian was new
  int evaluations_more_ = 0;   ///< than with so few, likewise
  R rate_of_convergence_ = 0;
  StepperCounts counts_;

  // Work of a step, kept so that none allocates.
  State rate_{};
  State trial_{};
  AllStages w_, g_, change_;
  Vector right_, solution_;
};

}  // namespace lubjoint
