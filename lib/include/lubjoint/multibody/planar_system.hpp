/// Equations of motion of constrained planar bodies with lubricated joints.
#pragma once

#include <Eigen/QR>
#include <limits>
#include <vector>

#include "lubjoint/multibody/constraint.hpp"
#include "lubjoint/multibody/envelope_cholesky.hpp"
#include "lubjoint/multibody/joint_element.hpp"

namespace lubjoint {

/// Baumgarte's α and β [1/s]: a violation Φ obeys Φ̈ + 2αΦ̇ + β²Φ = 0. Both 0: none.
template <class R>
struct Baumgarte {
  R alpha = R(0);  ///< damping
  R beta = R(0);   ///< stiffness
};

namespace detail {

/// What the solve needs beside the workspace on a scalar with derivatives: the numbers, and the derivatives as
/// right-hand sides of the same factors. On a plain number, nothing.
template <class T, bool = ScalarTraits<T>::carries_derivatives>
struct ImplicitDifferentiation {
  void resize(std::size_t, std::size_t) {}
};
template <class T>
struct ImplicitDifferentiation<T, true> {
  using R = RealOf<T>;
  using Derivatives = std::decay_t<decltype(std::declval<T>().derivatives())>;
  std::vector<ConstraintRow<R>> rows;
  std::vector<R> accelerations;
  std::vector<R> multipliers;
  std::vector<Derivatives> d_accelerations;
  std::vector<Derivatives> d_multipliers;

  void resize(std::size_t coordinates, std::size_t constraint_rows) {
    rows.resize(constraint_rows);
    accelerations.resize(coordinates);
    multipliers.resize(constraint_rows);
    d_accelerations.resize(coordinates);
    d_multipliers.resize(constraint_rows);
  }
};

/// Numbers behind the tangential forces of journals that slide: what a unit of each does.
template <class R>
struct SlideResponse {
  using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<R, Eigen::Dynamic, 1>;
  Matrix accelerations;  ///< of every coordinate, a column each slide
  Matrix multipliers;    ///< of every constraint row
  Vector weights;        ///< units of the forces
  /// Of what a unit of each does to the acceleration across each line.
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
  std::vector<R> solution, lambda;  ///< work

  /// Forces that change the accelerations across the lines by so much. Of journals that hold each other, such as two on
  /// one pin, only the sum is determined: each then has a part in proportion to its reach.
  template <class Right>
  auto forces_for(const Right& accelerations_across) const {
    return (weights.asDiagonal() * decomposition.solve(accelerations_across)).eval();
  }
};

}  // namespace detail

/// A journal that slides on a = 0, held by the force T n⊥ on it and −T n⊥ at the same point of the bearing's body.
template <class T>
struct FilmSlide {
  std::size_t joint;            ///< its number
  SlidePlace<T> place;          ///< on its line
  ConstraintRow<T> row;         ///< of n⊥·e = 0: first the bearing's body
  std::array<T, 3> on_bearing;  ///< what T = 1 puts on the bearing's body: force, moment
  std::array<T, 3> on_journal;  ///< on the journal's
  T force;                      ///< T, the share of eq. 20 in it [N]
};

/// What a run keeps of a system between evaluations, for one scalar T. Made by PlanarSystem::workspace; an evaluation
/// takes no other memory.
template <class T>
struct SystemWorkspace {
  using R = RealOf<T>;                        ///< the number itself
  std::vector<PlanarFrame<T>> frames;         ///< of the bodies
  PlanarFrame<T> ground{ground_motion<T>()};  ///< what stands in for a body
  std::vector<ConstraintRow<T>> rows;         ///< of Φ = 0
  std::vector<JointForce<T>> joints;          ///< what each joint does
  std::vector<T> shear_torques;               ///< T_J of each joint with shear, in the order of sheared_joints
  std::vector<T> forces;                      ///< g: loads, weights and joints
  std::vector<T> accelerations;               ///< q̈
  std::vector<T> multipliers;                 ///< λ
  std::vector<FilmSlide<T>> slides;           ///< of the journals that slide, if any
  detail::SlideResponse<R> slide_response;    ///< of these
  EnvelopeCholesky<R> schur;                  ///< Φq M⁻¹ Φqᵀ
  /// Memory for derivatives through the solve.
  detail::ImplicitDifferentiation<T> implicit;
};

/// Bodies, constraints, joints. The state is y = (q, q̇), q = (x, y, φ) of every body in turn.
///   M q̈ + Φqᵀ λ = g,  Φq q̈ = γ − 2αΦ̇ − β²Φ
/// Source: Flores et al. (2009), eqs. 39 to 41. M is diagonal: λ comes from the Schur complement Φq M⁻¹ Φqᵀ, whose
/// structure is found once. Without constraints there is no solve. On a scalar with derivatives the value is solved
/// once, and the derivatives of q̈ and λ are right-hand sides of the same factors (implicit differentiation).
template <class R>
class PlanarSystem {
 public:
  /// Finds the structure of the equations; numbers of bodies are those of their place in the list.
  PlanarSystem(std::vector<PlanarBody<R>> bodies, std::vector<NamedConstraint<R>> constraints,
               std::vector<JointElement<R>> joints, const Vector2<R>& gravity, const Baumgarte<R>& stabilisation)
      : bodies_(std::move(bodies)),
        constraints_(std::move(constraints)),
        joints_(std::move(joints)),
        gravity_(gravity),
        stabilisation_(stabilisation) {
    for (const PlanarBody<R>& body : bodies_) inverse_mass_.push_back(body.inverse_mass());
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (joints_[j].shear) sheared_joints_.push_back(j);
    }
    find_structure();
  }

  const std::vector<PlanarBody<R>>& bodies() const { return bodies_; }                 ///< in their order
  const std::vector<NamedConstraint<R>>& constraints() const { return constraints_; }  ///< in their order
  const std::vector<JointElement<R>>& joints() const { return joints_; }               ///< in their order
  /// Numbers of the joints whose oil is sheared.
  const std::vector<std::size_t>& sheared_joints() const { return sheared_joints_; }
  const Vector2<R>& gravity() const { return gravity_; }                           ///< [m/s²]
  std::size_t coordinates() const { return planar_coordinates * bodies_.size(); }  ///< number of q
  std::size_t constraint_rows() const { return first_row_.back(); }                ///< number of λ
  /// Number of the first λ of a constraint.
  std::size_t first_row(std::size_t constraint) const { return first_row_[constraint]; }
  /// 1/m, 1/m, 1/I of a body.
  const std::array<R, 3>& inverse_mass(std::size_t body) const { return inverse_mass_[body]; }

  /// All the memory that evaluations on the scalar T take.
  template <class T>
  SystemWorkspace<T> workspace() const {
    SystemWorkspace<T> w;
    w.frames.assign(bodies_.size(), PlanarFrame<T>(ground_motion<T>()));
    w.rows.resize(constraint_rows());
    w.joints.resize(joints_.size());
    w.shear_torques.resize(sheared_joints_.size());
    w.forces.resize(coordinates());
    w.accelerations.resize(coordinates());
    w.multipliers.resize(constraint_rows());
    w.schur = EnvelopeCholesky<R>(envelope_);
    w.implicit.resize(coordinates(), constraint_rows());
    return w;
  }

  /// Everything at (t, y): frames, joint forces, constraint rows, q̈ and λ, into the workspace. The time, too, may carry
  /// derivatives.
  /// @param y  2 × coordinates() numbers;  @param memory  of the joints, one each (unused without contact)
  /// @throws FilmDomainError, SingularConstraints
  template <class T, class Time>
  void evaluate(const Time& t, const T* y, const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w) const {
    place(y, w);
    apply_forces(memory, w);
    if (constraint_rows() > 0) {
      evaluate_constraints(t, w);
      factorise(w);
    }
    if (!w.slides.empty()) hold_slides(memory, w);
    if (constraint_rows() > 0) {
      solve(w);
    } else {
      accelerate_freely(w);
    }
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      if (!w.slides.empty()) differentiate_slides(w);
    }
  }

  /// Frames and constraint rows alone.
  template <class T, class Time>
  void evaluate_kinematics(const Time& t, const T* y, SystemWorkspace<T>& w) const {
    place(y, w);
    evaluate_constraints(t, w);
  }

  /// Of a joint's journal in its bearing, from the frames of an evaluated workspace.
  template <class T>
  JournalMotion<T> journal_motion(std::size_t joint, const SystemWorkspace<T>& w) const {
    const JointElement<R>& at = joints_[joint];
    return at.kinematics(frame(at.bearing_at.body, w), frame(at.journal_at.body, w)).motion;
  }

  // The parts of evaluate, in its order. Each reads what those before it have left in the workspace.

  /// Frames of the bodies.
  template <class T>
  void place(const T* y, SystemWorkspace<T>& w) const {
    const T* v = y + coordinates();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      w.frames[b] = PlanarFrame<T>(PlanarMotion<T>{Vector2<T>(y[3 * b], y[3 * b + 1]), y[3 * b + 2],
                                                   Vector2<T>(v[3 * b], v[3 * b + 1]), v[3 * b + 2]});
    }
  }

  /// Weights, loads and joints, into forces. @throws FilmDomainError
  template <class T>
  void apply_forces(const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const PlanarBody<R>& body = bodies_[b];
      w.forces[3 * b] = T(body.mass * gravity_.x() + body.load.x());
      w.forces[3 * b + 1] = T(body.mass * gravity_.y() + body.load.y());
      w.forces[3 * b + 2] = T(body.moment);
    }
    static const JointMemory<R> no_memory;
    w.slides.clear();
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const JointElement<R>& joint = joints_[j];
      if (!memory.empty() && memory[j].side == FilmSide::sliding) w.slides.emplace_back().joint = j;
      w.joints[j] = joint.force(frame(joint.bearing_at.body, w), frame(joint.journal_at.body, w),
                                memory.empty() ? no_memory : memory[j]);
      const JointForce<T>& force = w.joints[j];
      const JointWrenches<T> wrenches = joint_wrenches(force.kinematics, force.total());
      add(joint.bearing_at.body, wrenches.bearing, T(-force.contact.couple), w);
      add(joint.journal_at.body, wrenches.journal, force.contact.couple, w);
    }
    for (std::size_t k = 0; k < sheared_joints_.size(); ++k) {
      const std::size_t j = sheared_joints_[k];
      const JointElement<R>& joint = joints_[j];
      const T torque = joint.shear_torque(w.joints[j], memory.empty() ? no_memory : memory[j]);
      w.shear_torques[k] = torque;
      if (joint.journal_at.body != ground_body) w.forces[3 * joint.journal_at.body + 2] += torque;
      if (joint.bearing_at.body != ground_body) w.forces[3 * joint.bearing_at.body + 2] -= torque;
    }
  }

  /// Constraint rows of the frames.
  template <class T, class Time>
  void evaluate_constraints(const Time& t, SystemWorkspace<T>& w) const {
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      const Sides& sides = sides_[first_row_[c]];
      std::visit(
          [&](const auto& constraint) {
            constraint.evaluate(frame(sides.first, w), frame(sides.second, w), t, &w.rows[first_row_[c]]);
          },
          constraints_[c].constraint);
    }
  }

  /// Rows n⊥·e = 0 of the journals that slide, from the frames, and what their forces act on. With
  /// d(n⊥)/dt = −ω̄ n:  Φ̇ = n⊥·v − ω̄ n·e,  Φ̈ = n⊥·v̇ − ½(ω̇_i + ω̇_j) n·e − 2ω̄ n·v − ω̄² n⊥·e.
  /// The force's virtual power is not that of a multiplier of this row: at the bearing's body it turns with ω_i, the
  /// line with ω̄. The film's work on a spin is what lies between (3.4), unless its shear is modelled.
  template <class T>
  void evaluate_slides(const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w) const {
    for (FilmSlide<T>& slide : w.slides) {
      const JointElement<R>& joint = joints_[slide.joint];
      const PlanarFrame<T>& body_i = frame(joint.bearing_at.body, w);
      const PlanarFrame<T>& body_j = frame(joint.journal_at.body, w);
      const JointKinematics<T> k = joint.kinematics(body_i, body_j);
      slide.place = joint.slide_place(body_i, body_j, k.motion, memory[slide.joint]);
      const SlidePlace<T>& at = slide.place;
      const Vector2<T> across = perpendicular(at.line);
      const T mean_spin = (body_i.spin + body_j.spin) / 2;
      const T lever_i = dot(at.line, k.bearing_arm);  // n⊥·s_i⊥
      const T lever_j = dot(at.line, k.journal_arm);
      slide.row.value = at.across;
      slide.row.time_rate = T(0);
      slide.row.gamma = body_j.spin * body_j.spin * dot(across, k.journal_arm) -
                        body_i.spin * body_i.spin * dot(across, k.bearing_arm) +
                        2 * mean_spin * dot(at.line, k.motion.velocity) + mean_spin * mean_spin * at.across;
      slide.row.first = {T(-across.x()), T(-across.y()), T(-lever_i - at.along / 2)};
      slide.row.second = {across.x(), across.y(), T(lever_j - at.along / 2)};
      // With shear the film's tangential force turns both bodies: ½ e × F is taken from either (T_J and T_B).
      const T sheared = joint.shear ? T(at.along / 2) : T(0);
      slide.on_bearing = {T(-across.x()), T(-across.y()), T(-lever_i - at.along + sheared)};
      slide.on_journal = {across.x(), across.y(), T(lever_j - sheared)};
    }
  }

  /// Φ̇ of a journal's line.
  template <class T>
  T slide_rate(const FilmSlide<T>& slide, const SystemWorkspace<T>& w) const {
    const JointElement<R>& joint = joints_[slide.joint];
    T rate(0);
    if (joint.bearing_at.body != ground_body) rate += along(slide.row.first, w.frames[joint.bearing_at.body]);
    if (joint.journal_at.body != ground_body) rate += along(slide.row.second, w.frames[joint.journal_at.body]);
    return rate;
  }

  /// Factors of Φq M⁻¹ Φqᵀ of the rows. @throws SingularConstraints
  template <class T>
  void factorise(SystemWorkspace<T>& w) const {
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      for (std::size_t i = 0; i < w.rows.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          w.implicit.rows[i].first[k] = value_of(w.rows[i].first[k]);
          w.implicit.rows[i].second[k] = value_of(w.rows[i].second[k]);
        }
      }
      assemble(w.implicit.rows, w.schur);
    } else {
      assemble(w.rows, w.schur);
    }
    w.schur.factorise();
  }

  /// The tangential forces that keep every journal that slides on its line, put into the workspace:
  ///   Φ̈ = 0,  q̈ = q̈₀ + Σ q̈_k T_k,  q̈_k what T_k = 1 does through mass and constraints.
  /// The matrix has as many rows as journals slide, and is not symmetric.
  template <class T>
  void hold_slides(const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w) const {
    evaluate_slides(memory, w);
    auto& response = w.slide_response;
    const auto count = static_cast<Eigen::Index>(w.slides.size());
    const auto n = static_cast<Eigen::Index>(coordinates());
    const auto rows = static_cast<Eigen::Index>(constraint_rows());
    response.accelerations.setZero(n, count);
    response.multipliers.setZero(rows, count);
    response.weights.resize(count);
    using std::abs;
    typename detail::SlideResponse<R>::Matrix matrix(count, count);
    Eigen::Matrix<R, Eigen::Dynamic, 1> wanted(count);
    std::vector<R>& a = response.solution;
    std::vector<R>& lambda = response.lambda;
    const auto constrained = [&] {
      if (rows > 0) constrain(values_of_rows(w), w.schur, lambda.data(), a.data());
    };
    a.resize(coordinates());
    lambda.resize(constraint_rows());
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = inverse_mass_[i / 3][i % 3] * value_of(w.forces[i]);
    for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] = -value_of(wanted_acceleration(i, w));
    constrained();
    for (Eigen::Index k = 0; k < count; ++k) {
      const FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
      wanted(k) = value_of(slide.row.gamma) - value_of(across_line(slide, a));
      response.weights(k) = abs(value_of(joints_[slide.joint].jump_force(slide.place).reach));
    }
    const R largest = response.weights.maxCoeff();
    // So that one without a reach of its own still has a part.
    response.weights.array() += largest > 0 ? R(largest / 1000) : R(1);
    for (Eigen::Index k = 0; k < count; ++k) {
      std::fill(a.begin(), a.end(), R(0));
      std::fill(lambda.begin(), lambda.end(), R(0));
      for_each_side(w.slides[static_cast<std::size_t>(k)], [&](std::size_t body, const auto&, const auto& push) {
        for (std::size_t c = 0; c < 3; ++c) a[3 * body + c] += inverse_mass_[body][c] * value_of(push[c]);
      });
      constrained();
      for (Eigen::Index i = 0; i < n; ++i) response.accelerations(i, k) = a[static_cast<std::size_t>(i)];
      for (Eigen::Index i = 0; i < rows; ++i) response.multipliers(i, k) = lambda[static_cast<std::size_t>(i)];
      for (Eigen::Index i = 0; i < count; ++i) {
        matrix(i, k) = value_of(across_line(w.slides[static_cast<std::size_t>(i)], a));
      }
    }
    response.decomposition.setThreshold(1e4 * std::numeric_limits<R>::epsilon());  // rounding of the rows
    response.decomposition.compute(matrix * response.weights.asDiagonal());
    wanted = response.forces_for(wanted);
    for (Eigen::Index k = 0; k < count; ++k) {
      FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
      slide.force = T(wanted(k));
      for_each_side(slide, [&](std::size_t body, const auto&, const auto& push) {
        for (std::size_t c = 0; c < 3; ++c) w.forces[3 * body + c] += push[c] * slide.force;
      });
      push_journal(slide, slide.force, w);
    }
  }

  /// After a solve with the tangential forces held at their values: Φ̈ = 0 gives their derivatives.
  template <class T>
  void differentiate_slides(SystemWorkspace<T>& w) const {
    using Derivatives = typename detail::ImplicitDifferentiation<T>::Derivatives;
    const detail::SlideResponse<R>& response = w.slide_response;
    const auto count = static_cast<Eigen::Index>(w.slides.size());
    Eigen::Matrix<R, Eigen::Dynamic, Derivatives::RowsAtCompileTime> change(count, Derivatives::RowsAtCompileTime);
    for (Eigen::Index k = 0; k < count; ++k) {
      const FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
      change.row(k) = -T(across_line(slide, w.accelerations) - slide.row.gamma).derivatives().transpose();
    }
    change = response.forces_for(change);
    for (Eigen::Index k = 0; k < count; ++k) {
      FilmSlide<T>& slide = w.slides[static_cast<std::size_t>(k)];
      const Derivatives of_force = change.row(k).transpose();
      for (std::size_t i = 0; i < coordinates(); ++i) {
        w.accelerations[i].derivatives() += response.accelerations(static_cast<Eigen::Index>(i), k) * of_force;
      }
      for (std::size_t i = 0; i < constraint_rows(); ++i) {
        w.multipliers[i].derivatives() += response.multipliers(static_cast<Eigen::Index>(i), k) * of_force;
      }
      push_journal(slide, T(R(0), of_force), w);
      slide.force.derivatives() = of_force;
    }
  }

  /// λ and q̈ from forces, rows and factors.
  void solve(SystemWorkspace<R>& w) const {
    accelerate_freely(w);
    for (std::size_t row = 0; row < w.rows.size(); ++row) w.multipliers[row] = -wanted_acceleration(row, w);
    constrain(w.rows, w.schur, w.multipliers.data(), w.accelerations.data());
  }

  /// d(g − Φqᵀλ − M q̈) = 0 and d(Φq q̈ − wanted) = 0 with q̈ and λ held give the right-hand sides of dq̈ and dλ.
  template <class T>
  void solve(SystemWorkspace<T>& w) const {
    const auto& rows = w.implicit.rows;
    auto& a = w.implicit.accelerations;
    auto& lambda = w.implicit.multipliers;
    auto& da = w.implicit.d_accelerations;
    auto& dlambda = w.implicit.d_multipliers;
    const std::size_t n = coordinates();
    for (std::size_t i = 0; i < n; ++i) a[i] = inverse_mass_[i / 3][i % 3] * value_of(w.forces[i]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const T wanted = wanted_acceleration(i, w);
      lambda[i] = -value_of(wanted);
      dlambda[i] = -wanted.derivatives();
    }
    constrain(rows, w.schur, lambda.data(), a.data());

    for (std::size_t i = 0; i < n; ++i) da[i] = w.forces[i].derivatives();
    for_each_side([&](std::size_t row, std::size_t body, bool second) {
      const std::array<T, 3>& columns = second ? w.rows[row].second : w.rows[row].first;
      for (std::size_t k = 0; k < 3; ++k) {
        da[3 * body + k] -= lambda[row] * columns[k].derivatives();
        dlambda[row] += a[3 * body + k] * columns[k].derivatives();
      }
    });
    for (std::size_t i = 0; i < n; ++i) da[i] *= inverse_mass_[i / 3][i % 3];
    constrain(rows, w.schur, dlambda.data(), da.data());
    for (std::size_t i = 0; i < n; ++i) w.accelerations[i] = T(a[i], da[i]);
    for (std::size_t i = 0; i < rows.size(); ++i) w.multipliers[i] = T(lambda[i], dlambda[i]);
  }

  /// x −= M⁻¹ Φqᵀ μ, x in coordinates.
  template <class V>
  void subtract_constraint_forces(const std::vector<ConstraintRow<R>>& rows, const V* mu, V* x) const {
    for_each_side([&](std::size_t row, std::size_t body, bool second) {
      const std::array<R, 3>& columns = second ? rows[row].second : rows[row].first;
      for (std::size_t k = 0; k < 3; ++k) x[3 * body + k] -= (inverse_mass_[body][k] * columns[k]) * mu[row];
    });
  }

  /// Φ̇ = Φq q̇ + Φt of a row of an evaluated workspace.
  template <class T>
  T constraint_rate(std::size_t row, const SystemWorkspace<T>& w) const {
    T rate(w.rows[row].time_rate);
    const Sides& sides = sides_[row];
    if (sides.first != ground_body) rate += along(w.rows[row].first, w.frames[sides.first]);
    if (sides.second != ground_body) rate += along(w.rows[row].second, w.frames[sides.second]);
    return rate;
  }

  /// Body i of a row, or ground_body.
  std::size_t first_body_of_row(std::size_t row) const { return sides_[row].first; }
  /// Body j of a row, or ground_body.
  std::size_t second_body_of_row(std::size_t row) const { return sides_[row].second; }

  /// −Φqᵀλ of one constraint on its second body: force [N] and moment about the mass centre [N m].
  template <class T>
  std::array<T, 3> reaction_on_second(std::size_t constraint, const SystemWorkspace<T>& w) const {
    std::array<T, 3> sum{T(0), T(0), T(0)};
    for (std::size_t row = first_row_[constraint]; row < first_row_[constraint + 1]; ++row) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] -= w.rows[row].second[k] * w.multipliers[row];
    }
    return sum;
  }

 private:
  struct Sides {
    std::size_t first;
    std::size_t second;
  };
  /// Two constraints that hold the same body: a block of the Schur complement.
  struct SchurBlock {
    std::size_t row;
    std::size_t rows;
    bool row_second;
    std::size_t column;
    std::size_t columns;
    bool column_second;
    std::size_t body;
  };

  void find_structure() {
    first_row_.push_back(0);
    for (const NamedConstraint<R>& each : constraints_) {
      for (std::size_t i = 0; i < each.rows(); ++i) sides_.push_back({each.first_body(), each.second_body()});
      first_row_.push_back(first_row_.back() + each.rows());
    }
    envelope_.resize(constraint_rows());
    std::vector<std::vector<std::size_t>> holding(bodies_.size());  // constraints of each body, in order
    for (std::size_t a = 0; a < constraints_.size(); ++a) {
      std::size_t lowest = first_row_[a];
      for (const bool a_second : {false, true}) {
        const std::size_t body = a_second ? constraints_[a].second_body() : constraints_[a].first_body();
        if (body == ground_body) continue;
        holding[body].push_back(a);
        for (const std::size_t b : holding[body]) {
          const bool b_second = constraints_[b].second_body() == body;
          blocks_.push_back(
              {first_row_[a], constraints_[a].rows(), a_second, first_row_[b], constraints_[b].rows(), b_second, body});
          lowest = std::min(lowest, first_row_[b]);
        }
      }
      for (std::size_t row = first_row_[a]; row < first_row_[a + 1]; ++row) envelope_[row] = lowest;
    }
  }

  template <class T>
  const PlanarFrame<T>& frame(std::size_t body, const SystemWorkspace<T>& w) const {
    return body == ground_body ? w.ground : w.frames[body];
  }

  template <class T>
  void add(std::size_t body, const Wrench<T>& wrench, const T& couple, SystemWorkspace<T>& w) const {
    if (body == ground_body) return;
    w.forces[3 * body] += wrench.force.x();
    w.forces[3 * body + 1] += wrench.force.y();
    w.forces[3 * body + 2] += wrench.moment + couple;
  }

  template <class T>
  static T along(const std::array<T, 3>& columns, const PlanarFrame<T>& body) {
    return T(columns[0] * body.velocity.x() + columns[1] * body.velocity.y() + columns[2] * body.spin);
  }

  /// γ − 2αΦ̇ − β²Φ
  template <class T>
  T wanted_acceleration(std::size_t row, const SystemWorkspace<T>& w) const {
    const R& alpha = stabilisation_.alpha;
    const R& beta = stabilisation_.beta;
    if (alpha == 0 && beta == 0) return w.rows[row].gamma;
    return T(w.rows[row].gamma - 2 * alpha * constraint_rate(row, w) - (beta * beta) * w.rows[row].value);
  }

  void assemble(const std::vector<ConstraintRow<R>>& rows, EnvelopeCholesky<R>& schur) const {
    schur.set_zero();
    for (const SchurBlock& block : blocks_) {
      const std::array<R, 3>& inverse = inverse_mass_[block.body];
      for (std::size_t i = 0; i < block.rows; ++i) {
        const ConstraintRow<R>& a = rows[block.row + i];
        const std::array<R, 3>& left = block.row_second ? a.second : a.first;
        const std::array<R, 3> weighted{left[0] * inverse[0], left[1] * inverse[1], left[2] * inverse[2]};
        const std::size_t last = block.row == block.column ? i + 1 : block.columns;
        for (std::size_t j = 0; j < last; ++j) {
          const ConstraintRow<R>& b = rows[block.column + j];
          const std::array<R, 3>& right = block.column_second ? b.second : b.first;
          schur(block.row + i, block.column + j) +=
              weighted[0] * right[0] + weighted[1] * right[1] + weighted[2] * right[2];
        }
      }
    }
  }

  /// Calls act(row, body, second) for both sides of every row that are bodies.
  template <class Act>
  void for_each_side(const Act& act) const {
    for (std::size_t row = 0; row < sides_.size(); ++row) {
      if (sides_[row].first != ground_body) act(row, sides_[row].first, false);
      if (sides_[row].second != ground_body) act(row, sides_[row].second, true);
    }
  }

  /// Calls act(body, row's columns, force's columns) for both sides of a slide that are bodies.
  template <class T, class Act>
  void for_each_side(const FilmSlide<T>& slide, const Act& act) const {
    const JointElement<R>& joint = joints_[slide.joint];
    if (joint.bearing_at.body != ground_body) act(joint.bearing_at.body, slide.row.first, slide.on_bearing);
    if (joint.journal_at.body != ground_body) act(joint.journal_at.body, slide.row.second, slide.on_journal);
  }

  /// Φq x of a slide's row. V: R or T.
  template <class T, class V>
  T across_line(const FilmSlide<T>& slide, const std::vector<V>& x) const {
    T sum(0);
    for_each_side(slide, [&](std::size_t body, const auto& columns, const auto&) {
      for (std::size_t c = 0; c < 3; ++c) sum += columns[c] * x[3 * body + c];
    });
    return sum;
  }

  /// A tangential force into the joint's results; the bodies have theirs.
  template <class T>
  void push_journal(const FilmSlide<T>& slide, const T& force, SystemWorkspace<T>& w) const {
    const Vector2<T>& n = slide.place.line;
    Vector2<T>& film = w.joints[slide.joint].film;
    film.x() -= force * n.y();
    film.y() += force * n.x();
    for (std::size_t k = 0; k < sheared_joints_.size(); ++k) {
      if (sheared_joints_[k] == slide.joint) w.shear_torques[k] -= force * slide.place.along / 2;
    }
  }

  static const std::vector<ConstraintRow<R>>& values_of_rows(const SystemWorkspace<R>& w) { return w.rows; }
  template <class T>
  static const std::vector<ConstraintRow<R>>& values_of_rows(const SystemWorkspace<T>& w) {
    return w.implicit.rows;
  }

  /// q̈ = M⁻¹g
  template <class T>
  void accelerate_freely(SystemWorkspace<T>& w) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (std::size_t k = 0; k < 3; ++k) w.accelerations[3 * b + k] = inverse_mass_[b][k] * w.forces[3 * b + k];
    }
  }

  /// From −wanted in lambda and M⁻¹g in a to λ and q̈. V: R, or its derivatives.
  template <class V>
  void constrain(const std::vector<ConstraintRow<R>>& rows, const EnvelopeCholesky<R>& schur, V* lambda, V* a) const {
    for_each_side([&](std::size_t row, std::size_t body, bool second) {
      const std::array<R, 3>& columns = second ? rows[row].second : rows[row].first;
      for (std::size_t k = 0; k < 3; ++k) lambda[row] += columns[k] * a[3 * body + k];
    });
    schur.solve(lambda);
    subtract_constraint_forces(rows, lambda, a);
  }

  std::vector<PlanarBody<R>> bodies_;
  std::vector<NamedConstraint<R>> constraints_;
  std::vector<JointElement<R>> joints_;
  std::vector<std::size_t> sheared_joints_;
  Vector2<R> gravity_;
  Baumgarte<R> stabilisation_;
  std::vector<std::array<R, 3>> inverse_mass_;
  std::vector<std::size_t> first_row_;
  std::vector<Sides> sides_;
  std::vector<SchurBlock> blocks_;
  std::vector<std::size_t> envelope_;
};

}  // namespace lubjoint
