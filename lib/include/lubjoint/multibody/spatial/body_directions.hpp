/// Directions that the places of bodies in space are counted along.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

#include "lubjoint/multibody/spatial/constraint.hpp"

namespace lubjoint {

/// Velocities (ṙ, ω′) of bodies by components: ṙ of most along the inertial axes, and ṙ of a body that a guide on the
/// ground holds along those of the guide, Q = (t₁, t₂, n). In these the guide's rows hold one component each, and what
/// slides freely is one number in place of three.
template <class R>
class BodyDirections {
 public:
  /// Inertial ones. @param bodies  how many there are
  explicit BodyDirections(std::size_t bodies) : of_body_(bodies, none) {}

  /// Counts the places of bodies that a constraint guides along its axes.
  void take(const NamedSpatialConstraint<R>& constraint) {
    std::visit(
        [this]<class Constraint>(const Constraint& guide) {
          if constexpr (std::is_same_v<Constraint, PrismaticJoint<R>> ||
                        std::is_same_v<Constraint, CylindricalJoint<R>> || std::is_same_v<Constraint, PlanarJoint<R>>) {
            const std::size_t body = guide.second.body;
            if (guide.first.body != ground_body || body == ground_body || of_body_[body] != none) return;
            Matrix3<R> q;
            q << guide.first.across, guide.first.third(), guide.first.axis;
            of_body_[body] = turned_.size();
            turned_.push_back({body, q});
          }
        },
        constraint.constraint);
  }

  bool are_inertial() const { return turned_.empty(); }  ///< of every body?

  /// A row's derivatives by these, from those by inertial components.
  template <class Row>
  Row of(const Row& row, std::size_t first, std::size_t second) const {
    if (are_inertial()) return row;
    Row along = row;
    if (first != ground_body && of_body_[first] != none) turn_back(turned_[of_body_[first]].q, along.first.data());
    if (second != ground_body && of_body_[second] != none) turn_back(turned_[of_body_[second]].q, along.second.data());
    return along;
  }
  /// Velocities or accelerations by these as inertial ones.
  template <class V>
  void to_inertial(V* x) const {
    for (const Turned& each : turned_) {
      V* v = x + spatial_velocities * each.body;
      const V along[3] = {v[0], v[1], v[2]};
      for (Eigen::Index k = 0; k < 3; ++k)
        v[k] = each.q(k, 0) * along[0] + each.q(k, 1) * along[1] + each.q(k, 2) * along[2];
    }
  }
  /// The other way; forces, too.
  template <class V>
  void from_inertial(V* x) const {
    for (const Turned& each : turned_) turn_back(each.q, x + spatial_velocities * each.body);
  }
  /// Component i of inertial velocities, accelerations or forces x(c).
  template <class X>
  auto component(std::size_t i, const X& x) const -> std::decay_t<decltype(x(i))> {
    const std::size_t k = i % spatial_velocities;
    if (are_inertial() || k >= 3 || of_body_[i / spatial_velocities] == none) return x(i);
    const Matrix3<R>& q = turned_[of_body_[i / spatial_velocities]].q;
    const auto column = static_cast<Eigen::Index>(k);
    const std::size_t first = i - k;
    return q(0, column) * x(first) + q(1, column) * x(first + 1) + q(2, column) * x(first + 2);
  }
  /// Adds component i to inertial velocities, or to a place: add(k, value) adds to entry k of (ṙ, ω′) of its body.
  template <class V, class Add>
  void add(std::size_t i, const V& value, const Add& add) const {
    const std::size_t k = i % spatial_velocities;
    if (are_inertial() || k >= 3 || of_body_[i / spatial_velocities] == none) {
      add(k, value);
      return;
    }
    const Matrix3<R>& q = turned_[of_body_[i / spatial_velocities]].q;
    for (std::size_t row = 0; row < 3; ++row)
      add(row, V(q(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) * value));
  }
  /// Calls visit(body) for those that are counted along a guide.
  template <class Visit>
  void for_each_turned(const Visit& visit) const {
    for (const Turned& each : turned_) visit(each.body);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Turned {
    std::size_t body;
    Matrix3<R> q;
  };
  template <class V>
  static void turn_back(const Matrix3<R>& q, V* v) {
    const V x[3] = {v[0], v[1], v[2]};
    for (Eigen::Index k = 0; k < 3; ++k) v[k] = q(0, k) * x[0] + q(1, k) * x[1] + q(2, k) * x[2];
  }

  std::vector<std::size_t> of_body_;  ///< place in turned_, or none
  std::vector<Turned> turned_;
};

}  // namespace lubjoint
