/// Singular positions on the way of a mechanism: where its constraints stop being independent, as at the change point
/// of a parallelogram. A step may land beyond one without noticing.
#pragma once

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/multibody_step.hpp"

namespace lubjoint {

/// Watches the independence of the constraints: the least sine s of the angle between a row of Φq M^{-1/2} and the rows
/// before it, which the factors of Φq M⁻¹ Φqᵀ have at hand. s is smooth but where it vanishes, and there it is a V: so
/// its least value is looked for, by the method itself, wherever its slope between three looks could reach 0. A look at
/// every accepted step, and more in a step in which bodies turn far. s is small, too, where a light body hangs between
/// heavy ones; so what is found counts only if rows of Φq in lengths, whatever the masses, are as near to dependent.
template <class R>
class SingularWatch {
 public:
  using State = std::vector<R>;                          ///< (q, q̇, work)
  using Step = std::shared_ptr<const MultibodyStep<R>>;  ///< an accepted one

  /// @param tolerance  relative, of the run: s is known to ten of it, and to 1e-4 at best. Above 1e-3 it says too
  ///   little for a verdict: a coarser run may pass a singular position, and is never stopped at what is none
  SingularWatch(MultibodyOde<R>& ode, double tolerance)
      : ode_(ode), close_(std::clamp(10 * tolerance, 1e-4, 1e-3)), watches_(ode.system().constraint_rows() > 1) {}

  /// The start of the run.
  void start(const R& t, const State& y) {
    if (watches_) remember({t, sine_at(t, y), nullptr});
  }

  /// The next accepted step.
  /// @param inside  inside(step, t, y) is the state inside it, as accurate as the run
  /// @returns a singular position that it, or the one before it, passes
  template <class Inside>
  std::optional<SingularPosition> step(const Step& step, const Inside& inside) {
    if (!watches_) return std::nullopt;
    const std::size_t pieces = pieces_of(*step);
    for (std::size_t i = 1; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(pieces);
      const R t = i == pieces ? step->t_new : R(step->t_old + (step->t_new - step->t_old) * share);
      if (i < pieces) step->state_at(t, ode_.system().coordinates(), state_);
      remember({t, sine_at(t, i < pieces ? state_ : step->y_new), step});
      const auto& [first, middle, end] = recent_;
      if (count_ < 3 || middle.sine > first.sine || middle.sine > end.sine || !may_vanish()) continue;
      for (const auto& [from, to] : {std::pair{&first, &middle}, std::pair{&middle, &end}}) {
        if (const auto found = least_between(*from, *to, inside)) return found;
      }
    }
    return std::nullopt;
  }

  /// The run is over, whose last step nothing follows.
  template <class Inside>
  std::optional<SingularPosition> finish(const Inside& inside) {
    if (!watches_ || count_ < 3 || !may_vanish()) return std::nullopt;
    return least_between(recent_[1], recent_[2], inside);
  }

  /// Is the mechanism at a singular position, or as near as makes no difference to a step?
  std::optional<SingularPosition> at(const R& t, const State& y) {
    if (!watches_) return std::nullopt;
    const double sine = sine_at(t, y);
    if (!(sine < 10 * close_ && dependence_of_lengths() < 10 * close_)) return std::nullopt;
    return SingularPosition{static_cast<double>(t), ode_.workspace().schur.least_row(), sine};
  }

  /// The constraint that repeats others there.
  const std::string& constraint(const SingularPosition& position) const {
    const auto& constraints = ode_.system().constraints();
    std::size_t c = 0;
    while (c + 1 < constraints.size() && ode_.system().first_row(c + 1) <= position.row) ++c;
    return constraints[c].name;
  }

  /// "a singular position …", with the constraint and what to do.
  std::string words(const SingularPosition& position) const {
    return "a singular position, where the constraints are not independent: \"" + constraint(position) +
           "\" repeats what the others fix. The mechanism may go on from there in more than one way; let the run end "
           "before it, change a length, or say singular_positions = \"pass\" to go on as the velocities lead";
  }

 private:
  struct Look {
    R t{};
    double sine = 1;
    Step step;  ///< that t ends, or lies in
  };

  void remember(Look look) {
    recent_ = {std::move(recent_[1]), std::move(recent_[2]), std::move(look)};
    ++count_;
  }

  /// So many that no body turns by more than an eighth of a radian in one, and at most a hundred.
  std::size_t pieces_of(const MultibodyStep<R>& step) const {
    double turn = 0;
    for (std::size_t i = 2; i < ode_.system().coordinates(); i += planar_coordinates) {
      turn = std::max(turn, std::abs(static_cast<double>(step.y_new[i] - step.y_old[i])));
    }
    return turn < 100.0 / 8 ? 1 + static_cast<std::size_t>(8 * turn) : 100;
  }

  double sine_at(const R& t, const State& y) {
    SystemWorkspace<R>& w = ode_.workspace();
    ode_.system().evaluate_kinematics(t, y.data(), w);
    if (!std::all_of(y.begin(), y.end(), [](const R& x) { return std::isfinite(static_cast<double>(x)); })) return 1;
    try {
      ode_.system().factorise(w);
    } catch (const SingularConstraints&) {
      return 0;
    }
    return std::sqrt(std::max(0.0, static_cast<double>(w.schur.least_share())));
  }

  /// Least singular value of Φq of the last look, angles in units of its longest lever, rows of length 1.
  double dependence_of_lengths() {
    const PlanarSystem<R>& system = ode_.system();
    const auto& rows = ode_.workspace().rows;
    Eigen::MatrixXd matrix =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(system.coordinates()));
    double lever = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const auto put = [&](std::size_t body, const std::array<R, 3>& columns) {
        if (body == ground_body) return;
        for (std::size_t k = 0; k < 3; ++k) {
          matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(planar_coordinates * body + k)) +=
              static_cast<double>(columns[k]);
        }
        if (columns[0] != 0 || columns[1] != 0) lever = std::max(lever, std::abs(static_cast<double>(columns[2])));
      };
      put(system.first_body_of_row(row), rows[row].first);
      put(system.second_body_of_row(row), rows[row].second);
    }
    for (Eigen::Index i = 2; lever > 0 && i < matrix.cols(); i += planar_coordinates) matrix.col(i) /= lever;
    matrix.rowwise().normalize();
    return matrix.jacobiSvd().singularValues().minCoeff();
  }

  /// A V that vanishes between the looks falls and rises at least as fast as it did outside.
  bool may_vanish() const {
    const auto& [first, middle, end] = recent_;
    const auto slope = [](const Look& a, const Look& b) {
      return std::abs(b.sine - a.sine) / static_cast<double>(b.t - a.t);
    };
    const double steepest = std::max(slope(first, middle), slope(middle, end));
    return middle.sine < close_ || 2 * steepest * static_cast<double>(end.t - first.t) > middle.sine;
  }

  /// Between two looks, which lie in the step of the second.
  template <class Inside>
  std::optional<SingularPosition> least_between(const Look& from, const Look& to, const Inside& inside) {
    const auto sine = [&](double t) {
      inside(*to.step, R(t), state_);
      return sine_at(R(t), state_);
    };
    std::uintmax_t looks = 60;
    const auto [t, least] = boost::math::tools::brent_find_minima(
        sine, static_cast<double>(from.t), static_cast<double>(to.t), std::numeric_limits<double>::digits / 2, looks);
    if (!(least < close_)) return std::nullopt;
    sine(t);
    if (!(dependence_of_lengths() < close_)) return std::nullopt;
    return SingularPosition{t, ode_.workspace().schur.least_row(), least};
  }

  MultibodyOde<R>& ode_;
  double close_;
  bool watches_;
  std::array<Look, 3> recent_{};
  std::size_t count_ = 0;
  State state_;
};

}  // namespace lubjoint
