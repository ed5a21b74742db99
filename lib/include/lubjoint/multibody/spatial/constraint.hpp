/// The constraints that there are in space. A new one is a struct (rows, bodies, evaluate, cast, visit_points), a place
/// in AnySpatialConstraint, a reader in lib/src/spatial_constraints.cpp, and a proof of its γ in oracle/proofs.
#pragma once

#include <array>
#include <string>
#include <variant>

#include "lubjoint/multibody/spatial/drivers.hpp"
#include "lubjoint/number/in_one_piece.hpp"

namespace lubjoint {

/// Any of them.
template <class R>
using AnySpatialConstraint = std::variant<FixedJoint<R>, SphericalJoint<R>, UniversalJoint<R>, RevoluteJoint<R>,
                                          CylindricalJoint<R>, PrismaticJoint<R>, PlanarJoint<R>, DistanceJoint<R>,
                                          RotationalDriver<R>, HeldSpin<R>, TranslationalDriver<R>>;

/// Hands each row of a constraint, from the frames of its bodies, to keep(i, row). γ is not formed where columns are
/// asked for, nor are columns where values are.
template <class Constraint, class R, class Time, class Keep>
void for_each_row_of(const Constraint& constraint, const SpatialFrame<R>& body_i, const SpatialFrame<R>& body_j,
                     const Time& t, const Keep& keep) {
  in_one_piece<R>([&] {
    std::array<SpatialRow<R>, Constraint::rows> rows;
    constraint.evaluate(body_i, body_j, t, rows.data());
    for (std::size_t i = 0; i < Constraint::rows; ++i) keep(i, rows[i]);
  });
}

/// A constraint of a system, and the name that messages and results give it.
template <class R>
struct NamedSpatialConstraint {
  std::string name;                    ///< unique among the constraints
  AnySpatialConstraint<R> constraint;  ///< the constraint itself

  /// Number of scalar equations.
  std::size_t rows() const {
    return std::visit([](const auto& c) { return c.rows; }, constraint);
  }
  /// Is Φ of one of its rows a length [m], and not an angle [rad]?
  bool is_length(std::size_t row) const {
    return std::visit([row](const auto& c) { return c.is_length(row); }, constraint);
  }
  /// Number of body i, or ground_body.
  std::size_t first_body() const {
    return std::visit([](const auto& c) { return c.first_body(); }, constraint);
  }
  /// Number of body j.
  std::size_t second_body() const {
    return std::visit([](const auto& c) { return c.second_body(); }, constraint);
  }
  /// Where the reaction on body j is reported, in its frame [m].
  Vector3<R> second_point() const {
    return std::visit([](const auto& c) { return c.second_point(); }, constraint);
  }
  /// The same on another scalar.
  template <class S>
  NamedSpatialConstraint<S> cast() const {
    return {name, std::visit([](const auto& c) { return AnySpatialConstraint<S>(c.template cast<S>()); }, constraint)};
  }
  /// Calls visit(body, point) for each point that it fixes to a body or the ground.
  template <class Visit>
  void visit_points(const Visit& visit) const {
    std::visit([&](const auto& c) { c.visit_points(visit); }, constraint);
  }
  /// Does it prescribe a motion, so that its multiplier is a driving moment or force?
  bool is_driver() const {
    return std::visit(
        [](const auto& c) {
          return requires { c.motion; };
        },
        constraint);
  }
  /// Can it hold a moment at its point?
  bool holds_moment() const {
    return !std::holds_alternative<SphericalJoint<R>>(constraint) &&
           !std::holds_alternative<DistanceJoint<R>>(constraint);
  }
};

}  // namespace lubjoint
