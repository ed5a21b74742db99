/// What the sides of half films ask of bodies in space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/multibody/spatial/chart_functions.hpp"

namespace lubjoint {

/// The bodies of FilmSides in space; motions are seen from the bearing, by t₁ and t₂.
template <class Real>
class SpatialFilmBodies {
 public:
  using R = Real;                ///< the number
  using State = std::vector<R>;  ///< (r, p; ṙ, ω′; work)

  /// Of equations, kept by reference.
  explicit SpatialFilmBodies(SpatialOde<R>& ode) : ode_(&ode) {}

  /// Of the joints; none if none remembers.
  const std::vector<JointMemory<R>>& memory() const { return std::as_const(*ode_).memory(); }
  JointMemory<R>& memory_of(std::size_t j) const { return ode_->memory()[j]; }                    ///< to be changed
  std::size_t joints() const { return ode_->system().joints().size(); }                           ///< how many
  const JointElement<R>& joint(std::size_t j) const { return ode_->system().joint_in_plane(j); }  ///< in its plane
  void evaluate(const R& t, const State& y) const { ode_->at(t, y); }                             ///< everything
  const SpatialWorkspace<R>& last() const { return ode_->last(); }                                ///< of that
  /// Frames alone.
  void place(const R&, const State& y) const { ode_->system().place(y.data(), ode_->workspace()); }
  /// From the frames.
  JournalMotion<R> motion(std::size_t j) const { return ode_->system().joint_kinematics(j, last()).motion; }
  /// Sums of the lengths [m] and of the speeds [m/s] that a journal's motion is the difference of, from the frames.
  std::array<R, 2> sizes(std::size_t j) const {
    std::array<R, 2> size{R(0), R(0)};
    const SpatialJointElement<R>& at = ode_->system().joints()[j];
    for (const BodyAxes<R>* axes : {&at.bearing_at, &at.journal_at}) {
      const R arm = axes->point.norm();
      size[0] += arm;
      if (axes->body == ground_body) continue;
      const SpatialFrame<R>& frame = last().frames[axes->body];
      size[0] += frame.position.norm();
      size[1] += frame.velocity.norm() + frame.spin.norm() * arm;
    }
    return size;
  }
  /// The largest force or inertial force [N], of an evaluated state.
  R force_size() const {
    using std::abs;
    R size(0);
    for (std::size_t i = 0; i < last().forces.size(); ++i) {
      if (i % 6 >= 3) continue;
      const R inertial = last().accelerations[i] * ode_->system().bodies()[i / 6].mass;
      size = std::max<R>(size, std::max<R>(abs(last().forces[i]), abs(inertial)));
    }
    return size;
  }
  /// ë seen from the bearing, of an evaluated state.
  Vector2<R> eccentricity_acceleration(std::size_t j) const {
    const SpatialJointElement<R>& at = ode_->system().joints()[j];
    std::array<SpatialRow<R>, 2> rows{};
    fill_eccentricity(ode_->system().frame(at.bearing_at.body, last()),
                      ode_->system().frame(at.journal_at.body, last()), ode_->system().joint_kinematics(j, last()),
                      rows);
    const auto of = [&](const SpatialRow<R>& row) {
      R second = -row.gamma;
      for (std::size_t k = 0; k < 6; ++k) {
        if (at.bearing_at.body != ground_body)
          second += row.first[k] * last().accelerations[6 * at.bearing_at.body + k];
        if (at.journal_at.body != ground_body)
          second += row.second[k] * last().accelerations[6 * at.journal_at.body + k];
      }
      return second;
    };
    return Vector2<R>(of(rows[0]), of(rows[1]));
  }
  /// A state a moment later, by the accelerations of the last evaluation.
  State moved(const State& y, const R& moment) const {
    const std::vector<R>& a = last().accelerations;
    const std::size_t places = ode_->system().places();
    std::vector<R> by(a.size());
    State later = y;
    for (std::size_t i = 0; i < a.size(); ++i) {
      by[i] = moment * (y[places + i] + moment * a[i] / 2);
      later[places + i] += moment * a[i];
    }
    ode_->system().displace(by, later.data());
    return later;
  }
  /// Half the turn of journal against bearing, counted.
  R line_angle(const R& t, const State& y, std::size_t j) const {
    return R(ode_->angle(t, y, ode_->system().counted_turn(j)).angle / 2);
  }

 private:
  SpatialOde<R>* ode_;
};

}  // namespace lubjoint
