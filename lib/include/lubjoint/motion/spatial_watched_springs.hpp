/// Springs in space as a watch sees them.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "lubjoint/motion/multibody_step.hpp"
#include "lubjoint/motion/spatial_interpolant.hpp"
#include "lubjoint/multibody/spatial/system.hpp"

namespace lubjoint {

/// Those of a system in space, whose states are (r, p; ṙ, ω′; work).
template <class R>
class SpatialSprings {
 public:
  using Span = Vector3<double>;  ///< d = P_j − P_i [m]

  /// Of a system, kept by reference.
  explicit SpatialSprings(const SpatialSystem<R>& system) : system_(&system) {}

  std::size_t size() const { return system_->elements().springs.size(); }  ///< number of springs
  /// Of a spring.
  const std::string& name(std::size_t spring) const { return system_->elements().springs[spring].name; }
  /// Is it one along a line, and not about an axis?
  bool has_direction(std::size_t spring) const {
    return std::holds_alternative<SpatialTranslationalSpring<R>>(system_->elements().springs[spring].spring);
  }
  /// d of a spring along a line at a state.
  Span span(const std::vector<R>& y, std::size_t k) const {
    const auto& spring = std::get<SpatialTranslationalSpring<R>>(system_->elements().springs[k].spring);
    const auto place = [&](const SpatialBodyPoint<R>& point) {
      if (point.on_ground()) return point.point;
      const SpatialMotion<R> body = spatial_motion_in(y.data(), system_->bodies().size(), point.body);
      return Vector3<R>(sum(body.position, product(rotation_matrix(body.parameters), point.point)));
    };
    const Vector3<R> d = difference(place(spring.second), place(spring.first));
    return {static_cast<double>(d(0)), static_cast<double>(d(1)), static_cast<double>(d(2))};
  }
  /// The state inside a step.
  void state_at(const MultibodyStep<R>& step, const R& t, std::vector<R>& y) const {
    spatial_state_at<R>(step, system_->bodies().size(), t, y);
  }

 private:
  const SpatialSystem<R>* system_;
};

}  // namespace lubjoint
