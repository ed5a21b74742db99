/// The constraints that there are.
#pragma once

#include <string>
#include <variant>

#include "lubjoint/multibody/driver.hpp"
#include "lubjoint/multibody/ground_constraint.hpp"
#include "lubjoint/multibody/revolute.hpp"
#include "lubjoint/multibody/translational.hpp"

namespace lubjoint {

template <class R>
using AnyConstraint = std::variant<GroundConstraint<R>, Revolute<R>, Translational<R>, Driver<R>>;

template <class R>
struct NamedConstraint {
  std::string name;
  AnyConstraint<R> constraint;

  std::size_t rows() const {
    return std::visit([](const auto& c) { return c.rows; }, constraint);
  }
  std::size_t first_body() const {
    return std::visit([](const auto& c) { return c.first_body(); }, constraint);
  }
  std::size_t second_body() const {
    return std::visit([](const auto& c) { return c.second_body(); }, constraint);
  }
  bool is_driver() const { return std::holds_alternative<Driver<R>>(constraint); }
};

}  // namespace lubjoint
