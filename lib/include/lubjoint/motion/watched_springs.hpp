/// Springs in the plane as a watch sees them.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/multibody_step.hpp"

namespace lubjoint {

/// Those of a system in the plane, whose states are (q, q̇, work).
template <class R>
class PlanarSprings {
 public:
  using Span = Vector2<double>;  ///< d = P_j − P_i [m]

  /// Of the equations' system, kept by reference.
  explicit PlanarSprings(const MultibodyOde<R>& ode) : system_(&ode.system()) {}

  std::size_t size() const { return springs().size(); }                                 ///< number of springs
  const std::string& name(std::size_t spring) const { return springs()[spring].name; }  ///< of a spring
  /// Is it one along a line, and not about a pivot?
  bool has_direction(std::size_t spring) const {
    return std::holds_alternative<TranslationalSpring<R>>(springs()[spring].spring);
  }
  /// d of a spring along a line at a state.
  Span span(const std::vector<R>& y, std::size_t k) const {
    const auto& spring = std::get<TranslationalSpring<R>>(springs()[k].spring);
    const std::size_t n = system_->coordinates();
    const auto place = [&](const BodyPoint<R>& point) {
      if (point.on_ground()) return point.point;
      const R* q = y.data() + planar_coordinates * point.body;
      const Vector2<R> s = inertial_vector(
          PlanarMotion<R>{Vector2<R>(q[0], q[1]), q[2], Vector2<R>(q[n], q[n + 1]), q[n + 2]}, point.point);
      return Vector2<R>(q[0] + s.x(), q[1] + s.y());
    };
    const Vector2<R> i = place(spring.first);
    const Vector2<R> j = place(spring.second);
    return {static_cast<double>(j.x() - i.x()), static_cast<double>(j.y() - i.y())};
  }
  /// The state inside a step.
  void state_at(const MultibodyStep<R>& step, const R& t, std::vector<R>& y) const {
    step.state_at(t, system_->coordinates(), y);
  }

 private:
  const std::vector<NamedSpring<R>>& springs() const { return system_->elements().springs; }

  const PlanarSystem<R>* system_;
};

}  // namespace lubjoint
