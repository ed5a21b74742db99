/// What the sides of half films ask of bodies in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"

namespace lubjoint {

/// The bodies of FilmSides in the plane; motions are seen from the ground.
template <class Real>
class PlanarFilmBodies {
 public:
  using R = Real;                ///< the number
  using State = std::vector<R>;  ///< (q, q̇, work)

  /// Of equations, kept by reference.
  explicit PlanarFilmBodies(MultibodyOde<R>& ode) : ode_(&ode) {}

  const std::vector<JointMemory<R>>& memory() const { return ode_->memory(); }                 ///< of the joints
  JointMemory<R>& memory_of(std::size_t j) const { return ode_->memory()[j]; }                 ///< to be changed
  std::size_t joints() const { return ode_->system().joints().size(); }                        ///< how many
  const JointElement<R>& joint(std::size_t j) const { return ode_->system().joints()[j]; }     ///< in its plane
  void evaluate(const R& t, const State& y) const { ode_->at(t, y); }                          ///< everything
  const SystemWorkspace<R>& last() const { return ode_->workspace(); }                         ///< of that
  void place(const R&, const State& y) const { ode_->system().place(y.data(), workspace()); }  ///< frames alone
  /// From the frames.
  JournalMotion<R> motion(std::size_t j) const { return ode_->system().journal_motion(j, workspace()); }
  /// Sums of the lengths [m] and of the speeds [m/s] that a journal's motion is the difference of, from the frames.
  std::array<R, 2> sizes(std::size_t j) const {
    using std::abs;
    std::array<R, 2> size{R(0), R(0)};
    for (const BodyPoint<R>* at : {&joint(j).bearing_at, &joint(j).journal_at}) {
      const R arm = at->point.norm();
      size[0] += arm;
      if (at->body == ground_body) continue;
      const PlanarFrame<R>& frame = workspace().frames[at->body];
      size[0] += frame.position.norm();
      size[1] += frame.velocity.norm() + abs(frame.spin) * arm;
    }
    return size;
  }
  /// The largest force or inertial force [N], of an evaluated state.
  R force_size() const {
    using std::abs;
    const SystemWorkspace<R>& w = workspace();
    R size(0);
    for (std::size_t i = 0; i < w.forces.size(); ++i) {
      if (i % 3 == 2) continue;
      const R inertial = w.accelerations[i] / ode_->system().inverse_mass(i / 3)[0];
      size = std::max<R>(size, std::max<R>(abs(w.forces[i]), abs(inertial)));
    }
    return size;
  }
  /// r̈ + φ̈ s⊥ − φ̇² s of the journal, less that of the bearing, of an evaluated state.
  Vector2<R> eccentricity_acceleration(std::size_t j) const {
    return acceleration_of(joint(j).journal_at) - acceleration_of(joint(j).bearing_at);
  }
  /// A state a moment later, by the accelerations of the last evaluation.
  State moved(const State& y, const R& moment) const {
    const std::vector<R>& a = workspace().accelerations;
    State later = y;
    for (std::size_t i = 0; i < a.size(); ++i) {
      later[i] += moment * (y[a.size() + i] + moment * a[i] / 2);
      later[a.size() + i] += moment * a[i];
    }
    return later;
  }
  /// ½(φ_i + φ_j)
  R line_angle(const R&, const State& y, std::size_t j) const {
    R angle(0);
    for (const std::size_t body : {joint(j).bearing_at.body, joint(j).journal_at.body}) {
      if (body != ground_body) angle += y[3 * body + 2] / 2;
    }
    return angle;
  }

 private:
  SystemWorkspace<R>& workspace() const { return ode_->workspace(); }

  Vector2<R> acceleration_of(const BodyPoint<R>& at) const {
    if (at.body == ground_body) return Vector2<R>(R(0), R(0));
    const R* a = &workspace().accelerations[3 * at.body];
    const PlanarFrame<R>& frame = workspace().frames[at.body];
    const Vector2<R> s = inertial_vector(frame, at.point);
    const R square = frame.spin * frame.spin;
    return Vector2<R>(R(a[0] - a[2] * s.y() - square * s.x()), R(a[1] + a[2] * s.x() - square * s.y()));
  }

  MultibodyOde<R>* ode_;
};

}  // namespace lubjoint
