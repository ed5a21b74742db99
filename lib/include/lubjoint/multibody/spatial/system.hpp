/// Equations of motion of constrained bodies in space with lubricated joints.
#pragma once

#include <algorithm>
#include <vector>

#include "lubjoint/multibody/planar_system.hpp"
#include "lubjoint/multibody/spatial/constraint.hpp"
#include "lubjoint/multibody/spatial/film_slide.hpp"
#include "lubjoint/multibody/spatial/force_elements.hpp"
#include "lubjoint/multibody/spatial/joint_element.hpp"
#include "lubjoint/multibody/spatial/system_workspace.hpp"

namespace lubjoint {

/// What a constraint does to its second body at the joint's point.
template <class T>
struct SpatialReaction {
  Vector3<T> force;   ///< inertial axes [N]
  Vector3<T> moment;  ///< about that point, inertial axes [N m]
};

/// Bodies, constraints, joints, springs and loads in space. The state is y = (r, p of every body; ṙ, ω′ of every body).
///   ṗ = ½ Lᵀ ω′,   m r̈ = f,   J′ω̇′ = n′ − ω̃′J′ω′,   with −Φ_vᵀλ and Φ_v (r̈, ω̇′) = γ − 2αΦ̇ − β²Φ
/// Source: Flores et al. (2009), section 6, eqs. 35 to 41. M = diag(m, J′) is constant: λ comes from the Schur
/// complement Φ_v M⁻¹ Φ_vᵀ, whose structure is found once. Without constraints there is no solve. On a scalar with
/// derivatives the values are those of a plain evaluation, and the derivatives of accelerations and λ are right-hand
/// sides of its factors.
template <class R>
class SpatialSystem {
 public:
  /// Finds the structure of the equations; numbers of bodies are those of their place in the list.
  SpatialSystem(std::vector<SpatialBody<R>> bodies, std::vector<NamedSpatialConstraint<R>> constraints,
                std::vector<SpatialJointElement<R>> joints, const Vector3<R>& gravity,
                const Baumgarte<R>& stabilisation, SpatialForceElements<R> elements = {})
      : bodies_(std::move(bodies)),
        constraints_(std::move(constraints)),
        joints_(std::move(joints)),
        elements_(std::move(elements)),
        gravity_(gravity),
        stabilisation_(stabilisation) {
    for (const SpatialBody<R>& body : bodies_) {
      inverse_mass_.push_back(1 / body.mass);
      inverse_inertia_.push_back(body.inverse_inertia());
    }
    first_row_.push_back(0);
    for (const NamedSpatialConstraint<R>& each : constraints_) {
      joint_points_.push_back(each.second_point());
      for (std::size_t i = 0; i < each.rows(); ++i) sides_.push_back({each.first_body(), each.second_body()});
      first_row_.push_back(first_row_.back() + each.rows());
    }
    for (const SpatialJointElement<R>& joint : joints_) {
      turn_of_joint_.push_back(elements_.angles.size());
      if (joint.plane.has_half_film()) elements_.angles.push_back({joint.bearing_at, joint.journal_at, R(0)});
    }
    leave_out({});
  }

  const std::vector<SpatialBody<R>>& bodies() const { return bodies_; }                       ///< in their order
  const std::vector<NamedSpatialConstraint<R>>& constraints() const { return constraints_; }  ///< in their order
  const std::vector<SpatialJointElement<R>>& joints() const { return joints_; }               ///< in their order
  const SpatialForceElements<R>& elements() const { return elements_; }                       ///< springs, moving loads
  const Vector3<R>& gravity() const { return gravity_; }                                      ///< [m/s²]
  std::size_t places() const { return spatial_coordinates * bodies_.size(); }                 ///< number of (r, p)
  std::size_t velocities() const { return spatial_velocities * bodies_.size(); }  ///< number of (ṙ, ω′)
  std::size_t states() const { return spatial_states * bodies_.size(); }          ///< both
  std::size_t constraint_rows() const { return first_row_.back(); }               ///< number of λ
  /// Number of the first λ of a constraint.
  std::size_t first_row(std::size_t constraint) const { return first_row_[constraint]; }
  /// The constraint of a row.
  std::size_t constraint_of(std::size_t row) const {
    return static_cast<std::size_t>(std::upper_bound(first_row_.begin(), first_row_.end(), row) - first_row_.begin()) -
           1;
  }
  /// Body i of a row, or ground_body.
  std::size_t first_body_of_row(std::size_t row) const { return sides_[row].first; }
  /// Body j of a row, or ground_body.
  std::size_t second_body_of_row(std::size_t row) const { return sides_[row].second; }
  /// Is Φ of a row a length [m], and not an angle [rad]?
  bool row_is_length(std::size_t row) const {
    const std::size_t c = constraint_of(row);
    return constraints_[c].is_length(row - first_row_[c]);
  }
  /// J′⁻¹ of a body.
  const Matrix3<R>& inverse_inertia(std::size_t body) const { return inverse_inertia_[body]; }

  /// Leaves rows out of the equations, because others imply them: their multipliers are 0. Workspaces made before it
  /// are of no more use.
  void leave_out(const std::vector<std::size_t>& rows) {
    left_out_ = rows;
    kept_.clear();
    place_among_kept_.assign(constraint_rows(), not_kept);
    for (std::size_t row = 0; row < constraint_rows(); ++row) {
      if (std::find(rows.begin(), rows.end(), row) != rows.end()) continue;
      place_among_kept_[row] = kept_.size();
      kept_.push_back(row);
    }
    find_structure();
  }
  const std::vector<std::size_t>& left_out() const { return left_out_; }  ///< rows that the equations do without
  const std::vector<std::size_t>& kept() const { return kept_; }          ///< all others, in order
  /// In place of the place of a row that is left out.
  static constexpr std::size_t not_kept = ground_body;
  /// The place of a row among those that are kept.
  std::size_t place_among_kept(std::size_t row) const { return place_among_kept_[row]; }

  /// All the memory that evaluations on the scalar T take.
  template <class T>
  SpatialWorkspace<T> workspace() const {
    SpatialWorkspace<T> w;
    w.frames.assign(bodies_.size(), spatial_ground_frame<T>());
    w.rows.resize(constraint_rows());
    w.joints.resize(joints_.size());
    w.forces.resize(velocities());
    w.accelerations.resize(velocities());
    w.multipliers.assign(constraint_rows(), T(0));
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      w.implicit.at = workspace<R>();
      w.implicit.resize(states(), velocities(), constraint_rows(), kept_.size());
    } else {
      w.weighted.resize(2 * constraint_rows());
      w.schur = EnvelopeCholesky<R>(envelope_);
      w.kept.resize(kept_.size());
    }
    return w;
  }

  /// Everything at (t, y): frames, joint forces, constraint rows, accelerations and λ, into the workspace.
  /// @param y  states() numbers;  @param memory  of the joints, one each, or none where none may touch or jump
  /// @throws FilmDomainError, JournalAcross, SingularConstraints, SpringWithoutDirection, AngleNotCounted
  void evaluate(const R& t, const R* y, const std::vector<JointMemory<R>>& memory, SpatialWorkspace<R>& w) const {
    place(y, w);
    apply_forces(t, memory, w, every_body);
    evaluate_constraints(t, w, every_body);
    if (!kept_.empty()) factorise(w);
    if (!w.slides.empty()) {
      place_slides(t, memory, w);
      detail::hold_slides(*this, w);
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) accelerate(b, &w.forces[6 * b], &w.accelerations[6 * b]);
    if (kept_.empty()) return;
    for (const std::size_t row : kept_) w.multipliers[row] = -wanted_acceleration(row, w);
    constrain(w, w.multipliers.data(), w.accelerations.data(), w.kept);
  }
  /// The same with derivatives, which the time, too, may carry.
  template <class T, class Time>
  requires ScalarTraits<T>::carries_derivatives void evaluate(const Time& t, const T* y,
                                                              const std::vector<JointMemory<R>>& memory,
                                                              SpatialWorkspace<T>& w) const {
    for (std::size_t i = 0; i < states(); ++i) w.implicit.state[i] = value_of(y[i]);
    evaluate(R(value_of(t)), w.implicit.state.data(), memory, w.implicit.at);
    differentiate(every_body, t, y, memory, w);
  }

  /// In place of a body's number.
  static constexpr std::size_t every_body = ground_body - 1;

  /// Derivatives of everything at (t, y), whose values are in w.implicit.at: of accelerations and λ with their values,
  /// of frames, rows, joints and forces with theirs where they have to do with the body; other joints do nothing.
  /// @param body  whose states alone carry derivatives in y, or every_body
  template <class T, class Time>
  void differentiate(std::size_t body, const Time& t, const T* y, const std::vector<JointMemory<R>>& memory,
                     SpatialWorkspace<T>& w) const {
    const SpatialWorkspace<R>& at = w.implicit.at;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      w.frames[b] = has_to_do(body, b) ? SpatialFrame<T>(spatial_motion_in(y, bodies_.size(), b))
                                       : at.frames[b].template cast<T>();
    }
    apply_forces(t, memory, w, body);
    evaluate_constraints(t, w, body);
    if (!w.slides.empty()) {
      place_slides(t, memory, w);
      for (std::size_t k = 0; k < w.slides.size(); ++k) {
        w.slides[k].force = T(at.slides[k].force);
        detail::apply_slide(*this, w.slides[k], w);
      }
    }
    solve(body, w);
    if (!w.slides.empty()) detail::differentiate_slides(*this, at.slide_response, w);
  }

  /// Frames and constraint rows alone.
  template <class T, class Time>
  void evaluate_kinematics(const Time& t, const T* y, SpatialWorkspace<T>& w) const {
    place(y, w);
    evaluate_constraints(t, w, every_body);
  }

  /// Of a joint's journal in its bearing, from the frames of a workspace. @throws JournalAcross
  template <class T>
  SpatialJointKinematics<T> joint_kinematics(std::size_t joint, const SpatialWorkspace<T>& w) const {
    const SpatialJointElement<R>& at = joints_[joint];
    return at.kinematics(frame(at.bearing_at.body, w), frame(at.journal_at.body, w));
  }

  /// Frame of a body of a workspace, or of the ground.
  template <class T>
  const SpatialFrame<T>& frame(std::size_t body, const SpatialWorkspace<T>& w) const {
    return body == ground_body ? w.ground : w.frames[body];
  }

  // The parts of evaluate, in its order. Each reads what those before it have left in the workspace.

  /// Frames of the bodies.
  template <class T>
  void place(const T* y, SpatialWorkspace<T>& w) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      w.frames[b] = SpatialFrame<T>(spatial_motion_in(y, bodies_.size(), b));
    }
  }

  /// Kinematics of the joints, from the frames. @throws JournalAcross
  template <class T>
  void place_joints(SpatialWorkspace<T>& w) const {
    for (std::size_t j = 0; j < joints_.size(); ++j) w.joints[j].kinematics = joint_kinematics(j, w);
  }

  /// Weights, loads, gyroscopic moments and joints, into forces.
  /// @param body  whose part alone is formed, or every_body
  template <class T, class Time>
  void apply_forces(const Time& t, const std::vector<JointMemory<R>>& memory, SpatialWorkspace<T>& w,
                    std::size_t body) const {
    apply_forces(t, memory, w, body,
                 [](std::size_t, const SpatialJointKinematics<T>&) -> const JointForce<T>* { return nullptr; });
  }
  /// @param correct  correct(j, kinematics) may put better eccentricities and velocities into those of joint j, and
  ///                 returns the force in its plane (JointForce<T>*) if it has it, or nullptr
  /// @param joints_are_placed  has place_joints been called for the frames?
  template <class T, class Time, class Correct>
  void apply_forces(const Time& t, const std::vector<JointMemory<R>>& memory, SpatialWorkspace<T>& w, std::size_t body,
                    const Correct& correct, bool joints_are_placed = false) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (has_to_do(body, b)) {
        apply_to_body(b, w);
      } else {
        std::fill_n(w.forces.begin() + static_cast<std::ptrdiff_t>(6 * b), 6, T(0));
      }
    }
    const auto add = [&](std::size_t b, const Vector3<T>& force, const Vector3<T>& moment) {
      if (b == ground_body) return;
      const Vector3<T> in_body = transposed_product(w.frames[b].rotation, moment);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        w.forces[6 * b + k] += force(i);
        w.forces[6 * b + 3 + k] += in_body(i);
      }
    };
    static const JointMemory<R> no_memory;
    w.slides.clear();
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const SpatialJointElement<R>& joint = joints_[j];
      const bool slides = !memory.empty() && memory[j].side == FilmSide::sliding;
      if (slides) w.slides.emplace_back().joint = j;
      if (!slides && !has_to_do(body, joint.bearing_at.body) && !has_to_do(body, joint.journal_at.body)) {
        if constexpr (ScalarTraits<T>::carries_derivatives) w.joints[j] = {};  // zeros
        continue;
      }
      if (!joints_are_placed) w.joints[j].kinematics = joint_kinematics(j, w);
      SpatialJointKinematics<T> at = w.joints[j].kinematics;
      const JointForce<T>* known = correct(j, at);
      w.joints[j] = slides ? joint.force_at(at, memory[j], turn_of_joint(t, j, w).angle)
                           : joint.force_at(at, memory.empty() ? no_memory : memory[j], T(0), known);
      const SpatialWrench<T> on_bearing = w.joints[j].on_bearing();
      const SpatialWrench<T> on_journal = w.joints[j].on_journal();
      add(joint.bearing_at.body, on_bearing.force, on_bearing.moment);
      add(joint.journal_at.body, on_journal.force, on_journal.moment);
    }
    if (!elements_.empty()) elements_.template apply<T>(t, elements_in(t, w), w.table_pieces, add);
  }

  /// Frames and counted angles as springs and moving loads ask for them.
  template <class T, class Frame>
  struct ElementView {
    const SpatialSystem& system;  ///< whose they are
    const TurnHistory<R>* turns;  ///< that counts revolutions; may be null
    R t;                          ///< [s]
    Frame frame_of;               ///< frame_of(body)

    /// Of a body or of the ground.
    decltype(auto) frame(std::size_t body) const { return frame_of(body); }
    /// Of a counted angle, by its number. @throws AngleNotCounted
    AngleMotion<T> angle(std::size_t k) const {
      const CountedAngle<R>& angle = system.elements_.angles[k];
      const auto motion = [&](const R& near) {
        return angle.template motion<T>(frame(angle.first.body), frame(angle.second.body), near);
      };
      return turns != nullptr && turns->has_begun() ? turns->counted(k, t, motion) : motion(angle.zero);
    }
  };
  /// Of a workspace whose frames are placed.
  template <class T, class Time>
  auto elements_in(const Time& t, const SpatialWorkspace<T>& w) const {
    const auto frame_of = [this, &w](std::size_t b) -> const SpatialFrame<T>& { return frame(b, w); };
    return ElementView<T, decltype(frame_of)>{*this, w.turns, R(value_of(t)), frame_of};
  }

  /// Constraint rows of the frames.
  /// @param body  whose rows alone are formed; the others are those of w.implicit.at
  template <class T, class Time>
  void evaluate_constraints(const Time& t, SpatialWorkspace<T>& w, std::size_t body) const {
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      if (has_to_do(body, sides_[first_row_[c]])) {
        evaluate_constraint(c, t, w);
      } else if constexpr (ScalarTraits<T>::carries_derivatives) {
        for (std::size_t i = first_row_[c]; i < first_row_[c + 1]; ++i)
          w.rows[i] = w.implicit.at.rows[i].template cast<T>();
      }
    }
  }
  /// Those of one constraint.
  template <class T, class Time>
  void evaluate_constraint(std::size_t c, const Time& t, SpatialWorkspace<T>& w) const {
    const std::size_t row = first_row_[c];
    const SpatialFrame<T>& first = frame(sides_[row].first, w);
    const SpatialFrame<T>& second = frame(sides_[row].second, w);
    std::visit(
        [&](const auto& constraint) { in_one_piece<T>([&] { constraint.evaluate(first, second, t, &w.rows[row]); }); },
        constraints_[c].constraint);
  }

  /// Factors of Φ_v M⁻¹ Φ_vᵀ of the rows that are kept. @throws SingularConstraints
  void factorise(SpatialWorkspace<R>& w) const {
    const std::vector<SpatialRow<R>>& rows = w.rows;
    for_each_kept_side([&](std::size_t row, std::size_t body, bool second) {
      accelerate(body, (second ? rows[row].second : rows[row].first).data(),
                 w.weighted[2 * row + (second ? 1 : 0)].data());
    });
    w.schur.set_zero();
    for (const Block& block : blocks_) {
      for (std::size_t i = block.first_row; i < block.end_row; ++i) {
        const std::array<R, 6>& left = w.weighted[2 * kept_[i] + (block.row_second ? 1 : 0)];
        const std::size_t end = std::min(block.end_column, i + 1);  // of the lower triangle
        for (std::size_t k = block.first_column; k < end; ++k) {
          const SpatialRow<R>& column = rows[kept_[k]];
          const std::array<R, 6>& right = block.column_second ? column.second : column.first;
          w.schur(i, k) += (left[0] * right[0] + left[1] * right[1] + left[2] * right[2]) +
                           (left[3] * right[3] + left[4] * right[4] + left[5] * right[5]);
        }
      }
    }
    w.schur.factorise();
  }

  /// M⁻¹ of a body: accelerations (r̈, ω̇′) that a force (f, n′) gives it. V: R, a number with derivatives, or
  /// derivatives.
  template <class V>
  void accelerate(std::size_t body, const V* force, V* acceleration) const {
    const R& inverse_mass = inverse_mass_[body];
    const Matrix3<R>& j = inverse_inertia_[body];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      acceleration[k] = inverse_mass * force[k];
      acceleration[3 + k] = j(i, 0) * force[3] + j(i, 1) * force[4] + j(i, 2) * force[5];
    }
  }

  /// x −= M⁻¹ Φ_vᵀ μ, x in velocities, μ of all rows; those left out count for nothing. Needs the factors' weights.
  template <class V>
  void subtract_constraint_forces(const SpatialWorkspace<R>& w, const V* mu, V* x) const {
    for_each_kept_side([&](std::size_t row, std::size_t body, bool second) {
      const std::array<R, 6>& by = w.weighted[2 * row + (second ? 1 : 0)];
      for (std::size_t k = 0; k < 6; ++k) x[6 * body + k] -= by[k] * mu[row];
    });
  }

  /// Solves Φ_v M⁻¹ Φ_vᵀ μ = b of the rows that are kept, in place.
  template <class W>
  void solve_schur(W& w, R* b) const {
    for (std::size_t k = 0; k < kept_.size(); ++k) w.kept[k] = b[kept_[k]];
    w.schur.solve(w.kept.data());
    for (std::size_t k = 0; k < kept_.size(); ++k) b[kept_[k]] = w.kept[k];
  }

  /// Φ̇ of a row of an evaluated workspace.
  template <class T>
  T constraint_rate(std::size_t row, const SpatialWorkspace<T>& w) const {
    T rate(w.rows[row].time_rate);
    const Sides& sides = sides_[row];
    if (sides.first != ground_body) rate += along(w.rows[row].first, w.frames[sides.first]);
    if (sides.second != ground_body) rate += along(w.rows[row].second, w.frames[sides.second]);
    return rate;
  }

  /// γ − 2αΦ̇ − β²Φ
  template <class T>
  T wanted_acceleration(std::size_t row, const SpatialWorkspace<T>& w) const {
    const R& alpha = stabilisation_.alpha;
    const R& beta = stabilisation_.beta;
    if (alpha == 0 && beta == 0) return w.rows[row].gamma;
    return T(w.rows[row].gamma - 2 * alpha * constraint_rate(row, w) - (beta * beta) * w.rows[row].value);
  }

  // Journals that slide on the jump of their half film (film_slide.hpp).

  /// A joint as an element of its plane.
  const JointElement<R>& joint_in_plane(std::size_t joint) const { return joints_[joint].plane; }
  /// The number of the counted angle of a joint with a half film: of its journal against its bearing.
  std::size_t counted_turn(std::size_t joint) const { return turn_of_joint_[joint]; }
  /// The lines of the journals that slide, from the frames of a workspace. @throws AngleNotCounted
  template <class T, class Time>
  void place_slides(const Time& t, const std::vector<JointMemory<R>>& memory, SpatialWorkspace<T>& w) const {
    detail::evaluate_slides(
        *this, memory, [&](std::size_t joint) { return turn_of_joint(t, joint, w); }, w);
  }
  /// A tangential force into the joint's results; the bodies have theirs.
  template <class T>
  void push_journal(const FilmSlide<SpatialRow<T>>& slide, const T& force, SpatialWorkspace<T>& w) const {
    const Vector2<T>& n = slide.place.line;
    SpatialJointForce<T>& joint = w.joints[slide.joint];
    joint.plane.film.x() -= force * n.y();
    joint.plane.film.y() += force * n.x();
    if (joints_[slide.joint].plane.shear) joint.shear_torque -= force * slide.place.along / 2;
  }
  /// From −wanted in lambda and M⁻¹g in a to λ and accelerations, with the rows and factors of a workspace.
  void constrain(SpatialWorkspace<R>& w, R* lambda, R* a) const {
    if (!kept_.empty()) constrain(w, lambda, a, w.kept);
  }
  /// Moves bodies by small displacements and turns (dr, dπ′), as velocities times a time.
  void displace(const std::vector<R>& by, R* y) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      R* q = y + spatial_coordinates * b;
      for (std::size_t k = 0; k < 3; ++k) q[k] += by[6 * b + k];
      const EulerParameters<R> p(q[3], q[4], q[5], q[6]);
      const EulerParameters<R> turned =
          normalised<R>(p + euler_rate(p, Vector3<R>(by[6 * b + 3], by[6 * b + 4], by[6 * b + 5])));
      for (std::size_t k = 0; k < 4; ++k) q[3 + k] = turned(static_cast<Eigen::Index>(k));
    }
  }

  /// What a constraint does to its second body at the joint's point, from an evaluated workspace. λ has the share of
  /// Baumgarte's terms in it, which is as small as the drift. Of a driver: about, or along, its axis.
  template <class T>
  SpatialReaction<T> reaction_at_joint(std::size_t constraint, const SpatialWorkspace<T>& w) const {
    std::array<T, 6> total{T(0), T(0), T(0), T(0), T(0), T(0)};
    for (std::size_t row = first_row_[constraint]; row < first_row_[constraint + 1]; ++row) {
      for (std::size_t k = 0; k < 6; ++k) total[k] -= w.rows[row].second[k] * w.multipliers[row];
    }
    const SpatialFrame<T>& body = frame(constraints_[constraint].second_body(), w);
    const Vector3<T> force(total[0], total[1], total[2]);
    const Vector3<T> moment = product<T>(body.rotation, Vector3<T>(total[3], total[4], total[5]));
    return {force, difference(moment, cross(inertial_vector(body, joint_points_[constraint]), force))};
  }
  /// Moment about the axis, or force along it, that a driver puts on its second body.
  template <class T>
  T driving_effort(std::size_t constraint, const SpatialWorkspace<T>& w) const {
    return T(-w.multipliers[first_row_[constraint]]);
  }

 private:
  struct Sides {
    std::size_t first;
    std::size_t second;
  };
  /// Rows that are kept of two constraints that hold the same body, by their numbers among all that are kept: where
  /// their products stand in the Schur complement.
  struct Block {
    std::size_t first_row, end_row;
    std::size_t first_column, end_column;
    bool row_second;
    bool column_second;
  };

  void find_structure() {
    blocks_.clear();
    envelope_.resize(kept_.size());
    // Where the rows of each constraint begin among those that are kept.
    std::vector<std::size_t> first;
    for (const std::size_t row : first_row_)
      first.push_back(static_cast<std::size_t>(std::lower_bound(kept_.begin(), kept_.end(), row) - kept_.begin()));
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      for (std::size_t i = first[c]; i < first[c + 1]; ++i) envelope_[i] = first[c];
      for (std::size_t d = 0; d <= c; ++d) {
        if (first[c] == first[c + 1] || first[d] == first[d + 1]) continue;
        const Sides& a = sides_[first_row_[c]];
        const Sides& b = sides_[first_row_[d]];
        for (const bool a_second : {false, true}) {
          for (const bool b_second : {false, true}) {
            const std::size_t body = a_second ? a.second : a.first;
            if (body == ground_body || body != (b_second ? b.second : b.first)) continue;
            blocks_.push_back({first[c], first[c + 1], first[d], first[d + 1], a_second, b_second});
            for (std::size_t i = first[c]; i < first[c + 1]; ++i) envelope_[i] = std::min(envelope_[i], first[d]);
          }
        }
      }
    }
  }

  /// J′ω′, of a matrix without derivatives.
  template <class T>
  static Vector3<T> weighted_spin(const Matrix3<R>& j, const Vector3<T>& spin) {
    Vector3<T> result;
    for (Eigen::Index i = 0; i < 3; ++i) result(i) = T(j(i, 0) * spin(0) + j(i, 1) * spin(1) + j(i, 2) * spin(2));
    return result;
  }

  template <class T>
  static T along(const std::array<T, 6>& columns, const SpatialFrame<T>& body) {
    return T(columns[0] * body.velocity(0) + columns[1] * body.velocity(1) + columns[2] * body.velocity(2) +
             columns[3] * body.body_spin(0) + columns[4] * body.body_spin(1) + columns[5] * body.body_spin(2));
  }

  /// Calls act(row, body, second) for both sides of every row that is kept, where they are bodies.
  template <class Act>
  void for_each_kept_side(const Act& act) const {
    for (const std::size_t row : kept_) {
      if (sides_[row].first != ground_body) act(row, sides_[row].first, false);
      if (sides_[row].second != ground_body) act(row, sides_[row].second, true);
    }
  }

  static bool has_to_do(std::size_t body, std::size_t other) { return body == every_body || body == other; }
  static bool has_to_do(std::size_t body, const Sides& sides) {
    return has_to_do(body, sides.first) || has_to_do(body, sides.second);
  }

  /// Of a joint's journal against its bearing, counted; of a joint with a half film.
  template <class T, class Time>
  AngleMotion<T> turn_of_joint(const Time& t, std::size_t joint, const SpatialWorkspace<T>& w) const {
    return elements_in(t, w).angle(turn_of_joint_[joint]);
  }

  /// Weight, constant loads and gyroscopic moment.
  template <class T>
  void apply_to_body(std::size_t b, SpatialWorkspace<T>& w) const {
    const SpatialBody<R>& body = bodies_[b];
    const SpatialFrame<T>& at = w.frames[b];
    const Vector3<T> gyroscopic = cross(at.body_spin, weighted_spin(body.inertia, at.body_spin));
    const Vector3<T> moment =
        is_zero(body.moment) ? zero_vector<T>() : transposed_product<T>(at.rotation, body.moment.template cast<T>());
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      w.forces[6 * b + k] = T(body.mass * gravity_(i) + body.load(i));
      w.forces[6 * b + 3 + k] = T(moment(i) - gyroscopic(i));
    }
  }

  /// d(g − Φ_vᵀλ − M a) = 0 and d(Φ_v a − wanted) = 0 with a and λ held give the right-hand sides of da and dλ.
  template <class T>
  void solve(std::size_t body, SpatialWorkspace<T>& w) const {
    const SpatialWorkspace<R>& at = w.implicit.at;
    auto& da = w.implicit.d_accelerations;
    auto& dlambda = w.implicit.d_multipliers;
    auto& force = w.implicit.d_forces;
    for (std::size_t i = 0; i < force.size(); ++i) force[i] = w.forces[i].derivatives();
    for (const std::size_t row : kept_) {
      if (has_to_do(body, sides_[row])) {
        dlambda[row] = -wanted_acceleration(row, w).derivatives();
      } else {
        dlambda[row].setZero();
      }
    }
    for_each_kept_side([&](std::size_t row, std::size_t b, bool second) {
      if (!has_to_do(body, sides_[row])) return;
      const std::array<T, 6>& columns = second ? w.rows[row].second : w.rows[row].first;
      for (std::size_t k = 0; k < 6; ++k) {
        force[6 * b + k] -= at.multipliers[row] * columns[k].derivatives();
        dlambda[row] += at.accelerations[6 * b + k] * columns[k].derivatives();
      }
    });
    for (std::size_t b = 0; b < bodies_.size(); ++b) accelerate(b, &force[6 * b], &da[6 * b]);
    constrain(at, dlambda.data(), da.data(), w.implicit.d_kept);
    for (std::size_t i = 0; i < da.size(); ++i) w.accelerations[i] = T(at.accelerations[i], da[i]);
    for (const std::size_t row : kept_) w.multipliers[row] = T(at.multipliers[row], dlambda[row]);
  }

  /// From −wanted in lambda and M⁻¹g in a to λ and accelerations, or, with their derivatives, to those. V: R, or its
  /// derivatives.
  template <class V>
  void constrain(const SpatialWorkspace<R>& w, V* lambda, V* a, std::vector<V>& kept) const {
    for_each_kept_side([&](std::size_t row, std::size_t body, bool second) {
      const std::array<R, 6>& columns = second ? w.rows[row].second : w.rows[row].first;
      for (std::size_t k = 0; k < 6; ++k) lambda[row] += columns[k] * a[6 * body + k];
    });
    for (std::size_t k = 0; k < kept_.size(); ++k) kept[k] = lambda[kept_[k]];
    w.schur.solve(kept.data());
    for (std::size_t k = 0; k < kept_.size(); ++k) lambda[kept_[k]] = kept[k];
    subtract_constraint_forces(w, lambda, a);
  }

  std::vector<SpatialBody<R>> bodies_;
  std::vector<NamedSpatialConstraint<R>> constraints_;
  std::vector<SpatialJointElement<R>> joints_;
  SpatialForceElements<R> elements_;
  std::vector<std::size_t> turn_of_joint_;  // among the counted angles, of a joint with a half film
  std::vector<Vector3<R>> joint_points_;    // of each constraint, fixed to its second body
  Vector3<R> gravity_;
  Baumgarte<R> stabilisation_;
  std::vector<R> inverse_mass_;
  std::vector<Matrix3<R>> inverse_inertia_;
  std::vector<std::size_t> first_row_;
  std::vector<Sides> sides_;
  std::vector<std::size_t> left_out_, kept_, place_among_kept_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> envelope_;
};

}  // namespace lubjoint
