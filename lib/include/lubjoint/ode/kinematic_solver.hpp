/// The linear systems of an implicit step for equations of motion of bodies in space, at less than half their size.
#pragma once

#include <Eigen/LU>
#include <vector>

namespace lubjoint {

/// Bodies in a Jacobian of y = (q, v, w) whose places are seven numbers a body and whose velocities are six:
///   q̇ = (v₁, P p),  v̇ = f(q, v),  ẇ = g(q, v):   J = [P G 0; A B 0; C D 0]
/// where each body's rows of P and G are its own: three places with the rate v₁ of three velocities, and four
/// parameters p whose rate is linear in them and in the other three.
struct KinematicForm {
  static constexpr Eigen::Index lengths = 3;                    ///< places whose rates are velocities
  static constexpr Eigen::Index parameters = 4;                 ///< those whose rates depend on themselves
  static constexpr Eigen::Index turns = 3;                      ///< velocities that these depend on
  static constexpr Eigen::Index places = lengths + parameters;  ///< of a body
  static constexpr Eigen::Index velocities = lengths + turns;   ///< of a body
  static constexpr Eigen::Index states = places + velocities;   ///< of a body
};

/// Solves (λI − J) x = r for such a J. With K = (λ − P)⁻¹, which is of blocks of four and a diagonal,
///   x_q = K (r_q + G x_v),   (λ − B − A K G) x_v = r_v + A K r_q:
/// of n bodies a factorisation of 6n×6n in place of 13n×13n. w's rows are the caller's.
/// @tparam S  real or std::complex
template <class S>
class KinematicSolver {
 public:
  /// Factorises λ − B − A K G.
  /// @param jacobian  of the whole system;  @param bodies  as bodies_of_kinematic_form has found
  template <class Matrix>
  void factorise(const Matrix& jacobian, Eigen::Index bodies, const S& shift) {
    const Eigen::Index q = Form::places * bodies;
    const Eigen::Index v = Form::velocities * bodies;
    shift_ = shift;
    a_ = jacobian.block(q, 0, v, q).template cast<S>();
    k_ = -jacobian.block(q, q, v, v).template cast<S>();
    k_.diagonal().array() += shift;
    inverses_.resize(static_cast<std::size_t>(bodies));
    couplings_.resize(static_cast<std::size_t>(bodies));
    for (Eigen::Index b = 0; b < bodies; ++b) {
      const auto i = static_cast<std::size_t>(b);
      const Eigen::Index p = Form::places * b + Form::lengths;
      const Eigen::Index w = Form::velocities * b;
      Square block = -jacobian.template block<Form::parameters, Form::parameters>(p, p).template cast<S>();
      block.diagonal().array() += shift;
      inverses_[i] = block.inverse();
      couplings_[i] =
          jacobian.template block<Form::parameters, Form::turns>(p, q + w + Form::lengths).template cast<S>();
      const Coupling turning = inverses_[i] * couplings_[i];
      k_.template middleCols<Form::lengths>(w) -= a_.template middleCols<Form::lengths>(Form::places * b) / shift;
      k_.template middleCols<Form::turns>(w + Form::lengths).noalias() -=
          a_.template middleCols<Form::parameters>(p) * turning;
    }
    lu_.compute(k_);
  }

  /// Solves for the velocities, then the places.
  /// @param r  in its first 13 elements a body the right-hand side, replaced by x_q and x_v
  template <class Right>
  void solve_in_place(Right&& r) {
    const Eigen::Index v = k_.rows();
    const Eigen::Index q = a_.cols();
    places_ = r.segment(0, q);
    apply_inverse(places_);
    right_ = r.segment(q, v);
    right_.noalias() += a_ * places_;
    velocities_.noalias() = lu_.solve(right_);
    places_ = r.segment(0, q);
    for (std::size_t i = 0; i < inverses_.size(); ++i) {
      const auto b = static_cast<Eigen::Index>(i);
      const Eigen::Index w = Form::velocities * b;
      places_.template segment<Form::lengths>(Form::places * b) += velocities_.template segment<Form::lengths>(w);
      places_.template segment<Form::parameters>(Form::places * b + Form::lengths).noalias() +=
          couplings_[i] * velocities_.template segment<Form::turns>(w + Form::lengths);
    }
    apply_inverse(places_);
    r.segment(0, q) = places_;
    r.segment(q, v) = velocities_;
  }

 private:
  using Form = KinematicForm;
  using Square = Eigen::Matrix<S, Form::parameters, Form::parameters>;
  using Coupling = Eigen::Matrix<S, Form::parameters, Form::turns>;
  using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

  /// K
  void apply_inverse(Vector& places) const {
    for (std::size_t i = 0; i < inverses_.size(); ++i) {
      const Eigen::Index first = Form::places * static_cast<Eigen::Index>(i);
      places.template segment<Form::lengths>(first) /= shift_;
      auto of_body = places.template segment<Form::parameters>(first + Form::lengths);
      of_body = (inverses_[i] * of_body).eval();
    }
  }

  S shift_{};
  Matrix a_, k_;
  std::vector<Square> inverses_;     ///< of λ − P, of each body's parameters
  std::vector<Coupling> couplings_;  ///< G of them
  Eigen::PartialPivLU<Matrix> lu_;
  Vector places_, velocities_, right_;
};

/// Number of bodies of a Jacobian of that form; 0 if it is of another.
template <class Matrix>
Eigen::Index bodies_of_kinematic_form(const Matrix& jacobian) {
  using Form = KinematicForm;
  const Eigen::Index n = jacobian.rows();
  Eigen::Index q = 0;
  while (q < n && jacobian(0, q) == 0) ++q;
  const Eigen::Index bodies = q / Form::places;
  if (bodies == 0 || q != Form::places * bodies || Form::states * bodies > n) return 0;
  const auto may_be = [&](Eigen::Index b, Eigen::Index k, Eigen::Index j) {
    const Eigen::Index velocity = q + Form::velocities * b;
    if (k < Form::lengths) return jacobian(Form::places * b + k, j) == (j == velocity + k ? 1 : 0);
    const Eigen::Index own = j - (Form::places * b + Form::lengths);
    const Eigen::Index turn = j - (velocity + Form::lengths);
    return (own >= 0 && own < Form::parameters) || (turn >= 0 && turn < Form::turns) ||
           jacobian(Form::places * b + k, j) == 0;
  };
  for (Eigen::Index b = 0; b < bodies; ++b) {
    for (Eigen::Index k = 0; k < Form::places; ++k) {
      for (Eigen::Index j = 0; j < n; ++j) {
        if (!may_be(b, k, j)) return 0;
      }
    }
  }
  if (Form::states * bodies < n && !(jacobian.rightCols(n - Form::states * bodies).array() == 0).all()) return 0;
  return bodies;
}

}  // namespace lubjoint
