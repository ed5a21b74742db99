/// The constraints that there are.
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
using AnyConstraint = std::variant<GroundConstraint<R>, Revolute<R>, Translational<R>, Driver<R>>;

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
  /// Does it prescribe a motion, so that its multiplier is a driving moment?
  bool is_driver() const { return std::holds_alternative<Driver<R>>(constraint); }
};

}  // namespace lubjoint
