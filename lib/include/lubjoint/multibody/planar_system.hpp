/// Equations of motion of constrained planar bodies with lubricated joints.
#pragma once

#include <vector>

#include "lubjoint/multibody/constraint.hpp"
#include "lubjoint/multibody/film_slide.hpp"
#include "lubjoint/multibody/force_elements.hpp"
#include "lubjoint/multibody/system_workspace.hpp"

namespace lubjoint {

/// Baumgarte's α and β [1/s]: a violation Φ obeys Φ̈ + 2αΦ̇ + β²Φ = 0. Both 0: none.
template <class R>
struct Baumgarte {
  R alpha = R(0);  ///< damping
  R beta = R(0);   ///< stiffness
};

/// What a constraint does to its second body at the joint: at the pin's or the slider's point, or, where it holds no
/// point, at the mass centre.
template <class T>
struct JointReaction {
  Vector2<T> force;  ///< inertial axes [N]
  T moment;          ///< about that point, counter-clockwise positive [N m]
};

/// Bodies, constraints, joints, springs and loads. The state is y = (q, q̇), q = (x, y, φ) of every body in turn.
///   M q̈ + Φqᵀ λ = g,  Φq q̈ = γ − 2αΦ̇ − β²Φ
/// Source: Flores et al. (2009), eqs. 39 to 41. M is diagonal: λ comes from the Schur complement Φq M⁻¹ Φqᵀ, whose
/// structure is found once. Without constraints there is no solve. On a scalar with derivatives the value is solved
/// once, and the derivatives of q̈ and λ are right-hand sides of the same factors (implicit differentiation).
template <class R>
class PlanarSystem {
 public:
  /// Finds the structure of the equations; numbers of bodies are those of their place in the list.
  PlanarSystem(std::vector<PlanarBody<R>> bodies, std::vector<NamedConstraint<R>> constraints,
               std::vector<JointElement<R>> joints, const Vector2<R>& gravity, const Baumgarte<R>& stabilisation,
               ForceElements<R> elements = {})
      : bodies_(std::move(bodies)),
        constraints_(std::move(constraints)),
        joints_(std::move(joints)),
        elements_(std::move(elements)),
        has_elements_(!elements_.empty()),
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
  bool has_elements() const { return has_elements_; }                              ///< springs or moving loads?
  const ForceElements<R>& elements() const { return elements_; }                   ///< springs and moving loads
  const Vector2<R>& gravity() const { return gravity_; }                           ///< [m/s²]
  std::size_t coordinates() const { return planar_coordinates * bodies_.size(); }  ///< number of q
  std::size_t constraint_rows() const { return first_row_.back(); }                ///< number of λ
  /// Number of the first λ of a constraint.
  std::size_t first_row(std::size_t constraint) const { return first_row_[constraint]; }
  std::size_t places() const { return coordinates(); }      ///< likewise
  std::size_t velocities() const { return coordinates(); }  ///< number of q̇
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
  /// @throws FilmDomainError, SingularConstraints, SpringWithoutDirection
  template <class T, class Time>
  void evaluate(const Time& t, const T* y, const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w) const {
    place(y, w);
    apply_forces(memory, w);
    if (has_elements_) apply_elements(t, w);
    if (constraint_rows() > 0) {
      evaluate_constraints(t, w);
      factorise(w);
    }
    if (!w.slides.empty()) {
      place_slides(t, memory, w);
      detail::hold_slides(*this, w);
    }
    if (constraint_rows() > 0) {
      solve(w);
    } else {
      accelerate_freely(w);
    }
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      if (!w.slides.empty()) detail::differentiate_slides(*this, w.slide_response, w);
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
    apply_forces(memory, w, [](std::size_t, JointKinematics<T>&) -> const JointForce<T>* { return nullptr; });
  }

  /// The same with correct(joint, kinematics), which may know the motion of a joint's journal better than the
  /// difference of its bodies' positions says, and returns the force in it (JointForce<T>*) if it has it, or nullptr.
  template <class T, class Correct>
  void apply_forces(const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w, const Correct& correct) const {
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
      const PlanarFrame<T>& bearing_body = frame(joint.bearing_at.body, w);
      const PlanarFrame<T>& journal_body = frame(joint.journal_at.body, w);
      JointKinematics<T> at = joint.kinematics(bearing_body, journal_body);
      const JointForce<T>* known = correct(j, at);
      w.joints[j] = joint.force_at(at, bearing_body, journal_body, memory.empty() ? no_memory : memory[j], known);
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

  /// Springs and moving loads, into forces. Not inlined: the path of systems without any stays as it is.
  /// @throws SpringWithoutDirection
  template <class T, class Time>
  [[gnu::noinline]] void apply_elements(const Time& t, SystemWorkspace<T>& w) const {
    elements_.apply(
        t, [&](std::size_t body) -> const PlanarFrame<T>& { return frame(body, w); }, w.table_pieces, w.forces);
  }

  /// Constraint rows of the frames.
  template <class T, class Time>
  void evaluate_constraints(const Time& t, SystemWorkspace<T>& w) const {
    for (std::size_t c = 0; c < constraints_.size(); ++c) evaluate_constraint(c, t, w);
  }
  /// Those of one constraint.
  template <class T, class Time>
  void evaluate_constraint(std::size_t c, const Time& t, SystemWorkspace<T>& w) const {
    const Sides& sides = sides_[first_row_[c]];
    std::visit(
        [&](const auto& constraint) {
          constraint.evaluate(frame(sides.first, w), frame(sides.second, w), t, &w.rows[first_row_[c]]);
        },
        constraints_[c].constraint);
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

  /// Frame of a body of an evaluated workspace, or of the ground.
  template <class T>
  const PlanarFrame<T>& frame(std::size_t body, const SystemWorkspace<T>& w) const {
    return body == ground_body ? w.ground : w.frames[body];
  }

  /// γ − 2αΦ̇ − β²Φ
  template <class T>
  T wanted_acceleration(std::size_t row, const SystemWorkspace<T>& w) const {
    const R& alpha = stabilisation_.alpha;
    const R& beta = stabilisation_.beta;
    if (alpha == 0 && beta == 0) return w.rows[row].gamma;
    return T(w.rows[row].gamma - 2 * alpha * constraint_rate(row, w) - (beta * beta) * w.rows[row].value);
  }

  /// From −wanted in lambda and M⁻¹g in a to λ and q̈, with the rows and factors of a workspace.
  template <class T>
  void constrain(const SystemWorkspace<T>& w, R* lambda, R* a) const {
    if (constraint_rows() > 0) constrain(values_of_rows(w), w.schur, lambda, a);
  }

  // Journals that slide on the jump of their half film (film_slide.hpp).

  /// A joint as an element of its plane.
  const JointElement<R>& joint_in_plane(std::size_t joint) const { return joints_[joint]; }
  /// The lines of the journals that slide, from the frames of a workspace.
  template <class T, class Time>
  void place_slides(const Time&, const std::vector<JointMemory<R>>& memory, SystemWorkspace<T>& w) const {
    detail::evaluate_slides(*this, memory, w);
  }
  /// A tangential force into the joint's results; the bodies have theirs.
  template <class T>
  void push_journal(const FilmSlide<ConstraintRow<T>>& slide, const T& force, SystemWorkspace<T>& w) const {
    const Vector2<T>& n = slide.place.line;
    Vector2<T>& film = w.joints[slide.joint].film;
    film.x() -= force * n.y();
    film.y() += force * n.x();
    for (std::size_t k = 0; k < sheared_joints_.size(); ++k) {
      if (sheared_joints_[k] == slide.joint) w.shear_torques[k] -= force * slide.place.along / 2;
    }
  }
  /// M⁻¹ of a body.
  void accelerate(std::size_t body, const R* force, R* acceleration) const {
    for (std::size_t k = 0; k < 3; ++k) acceleration[k] = inverse_mass_[body][k] * force[k];
  }
  /// Moves bodies by small displacements, as velocities times a time.
  void displace(const std::vector<R>& by, R* y) const {
    for (std::size_t i = 0; i < coordinates(); ++i) y[i] += by[i];
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

  /// The same at the joint, from an evaluated workspace. λ has the share of Baumgarte's terms in it, which is as small
  /// as the drift.
  template <class T>
  JointReaction<T> reaction_at_joint(std::size_t constraint, const SystemWorkspace<T>& w) const {
    const std::array<T, 3> sum = reaction_on_second(constraint, w);
    const Vector2<T> force(sum[0], sum[1]);
    const Vector2<T> arm = inertial_vector(frame(constraints_[constraint].second_body(), w), joint_points_[constraint]);
    return {force, T(sum[2] - cross(arm, force))};
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
      Vector2<R> at(R(0), R(0));  // the last of its points is the second body's
      each.visit_points([&](const BodyPoint<R>& point) { at = point.point; });
      joint_points_.push_back(at);
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
  ForceElements<R> elements_;
  bool has_elements_;
  std::vector<Vector2<R>> joint_points_;  // of each constraint, fixed to its second body
  Vector2<R> gravity_;
  Baumgarte<R> stabilisation_;
  std::vector<std::array<R, 3>> inverse_mass_;
  std::vector<std::size_t> first_row_;
  std::vector<Sides> sides_;
  std::vector<SchurBlock> blocks_;
  std::vector<std::size_t> envelope_;
};

}  // namespace lubjoint
