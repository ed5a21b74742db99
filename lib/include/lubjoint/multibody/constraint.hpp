/// The constraints that there are. A new one is a header of its own (rows, bodies, evaluate, cast, visit_points), a
/// place in AnyConstraint, a reader in lib/src/scene_parts.cpp, and a proof of its γ in oracle/proofs/mechanics.cpp.
#pragma once

#include <string>
#include <variant>

#include "lubjoint/multibody/driver.hpp"
#include "lubjoint/multibody/ground_constraint.hpp"
#include "lubjoint/multibody/revolute.hpp"
#include "lubjoint/multibody/translational.hpp"

namespace lubjoint {

/// Any of them.
template <class R>
using AnyConstraint = std::variant<GroundConstraint<R>, Revolute<R>, Translational<R>, Driver<R>, SlideDriver<R>>;

/// A constraint of a system, and the name that messages and results give it.
template <class R>
struct NamedConstraint {
  std::string name;             ///< unique among the constraints
  AnyConstraint<R> constraint;  ///< the constraint itself

  /// Number of scalar equations.
  std::size_t rows() const {
    return std::visit([](const auto& c) { return c.rows; }, constraint);
  }
  /// Number of body i, or ground_body.
  std::size_t first_body() const {
    return std::visit([](const auto& c) { return c.first_body(); }, constraint);
  }
  /// Number of body j.
  std::size_t second_body() const {
    return std::visit([](const auto& c) { return c.second_body(); }, constraint);
  }
  /// The same on another scalar.
  template <class S>
  NamedConstraint<S> cast() const {
    return {name, std::visit([](const auto& c) { return AnyConstraint<S>(c.template cast<S>()); }, constraint)};
  }
  /// Calls visit(point) for each point that it fixes to a body or the ground.
  template <class Visit>
  void visit_points(Visit&& visit) {
    std::visit([&](auto& c) { c.visit_points(visit); }, constraint);
  }
  /// The same, of points that stay as they are.
  template <class Visit>
  void visit_points(Visit&& visit) const {
    std::visit([&](auto c) { c.visit_points(visit); }, constraint);
  }
  /// Does it prescribe a motion, so that its multiplier is a driving moment or force?
  bool is_driver() const {
    return std::holds_alternative<Driver<R>>(constraint) || std::holds_alternative<SlideDriver<R>>(constraint);
  }
};

}  // namespace lubjoint
