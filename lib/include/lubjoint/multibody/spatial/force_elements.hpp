/// Springs and moving loads in space. A system without any has none of their code in its path.
#pragma once

#include <algorithm>
#include <vector>

#include "lubjoint/multibody/spatial/moving_load.hpp"
#include "lubjoint/multibody/spatial/spring.hpp"

namespace lubjoint {

/// Forces in space that depend on places, velocities and time, other than those of joints and constraints.
template <class R>
struct SpatialForceElements {
  std::vector<NamedSpatialSpring<R>> springs;  ///< in the scene's order
  std::vector<SpatialMovingLoad<R>> loads;     ///< likewise
  std::vector<CountedAngle<R>> angles;         ///< that springs, tables and sensors name by number

  bool empty() const { return springs.empty() && loads.empty(); }  ///< is there no force?
  /// Does any spring have a damper?
  bool has_dampers() const {
    return std::any_of(springs.begin(), springs.end(), [](const auto& s) { return s.is_damped(); });
  }

  /// Calls add(body, force, moment about its mass centre) for all of them, inertial.
  /// @param in  in.frame(body) is the frame of a body or of the ground, in.angle(k) the motion of a counted angle
  /// @param pieces  of the tables of the loads, one a load, where they may be held; may be null
  /// @throws SpringWithoutDirection
  template <class T, class Time, class In, class Add>
  void apply(const Time& t, const In& in, const std::vector<TablePiece>* pieces, const Add& add) const {
    for (const NamedSpatialSpring<R>& each : springs)
      std::visit([&](const auto& s) { s.template apply<T>(in, add); }, each.spring);
    for_each_load<T>(t, in, pieces, add);
  }

  /// Power of the loads [W].
  template <class T, class Time, class In>
  T load_power(const Time& t, const In& in, const std::vector<TablePiece>* pieces) const {
    T power(0);
    for_each_load<T>(t, in, pieces, [&](std::size_t body, const Vector3<T>& force, const Vector3<T>& moment) {
      power += dot(force, in.frame(body).velocity) + dot(moment, in.frame(body).spin);
    });
    return power;
  }

  /// Elastic energy of the springs [J]. @throws SpringWithoutDirection
  template <class T, class In>
  T energy(const In& in) const {
    T total(0);
    for (const NamedSpatialSpring<R>& each : springs)
      total += std::visit([&](const auto& s) { return s.template energy<T>(in); }, each.spring);
    return total;
  }

  /// Power of the dampers, never positive [W]. @throws SpringWithoutDirection
  template <class T, class In>
  T damper_power(const In& in) const {
    T total(0);
    for (const NamedSpatialSpring<R>& each : springs)
      total += std::visit([&](const auto& s) { return s.template damper_power<T>(in); }, each.spring);
    return total;
  }

 private:
  template <class T, class Time, class In, class Add>
  void for_each_load(const Time& t, const In& in, const std::vector<TablePiece>* pieces, const Add& add) const {
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const TablePiece* piece = pieces == nullptr ? nullptr : &(*pieces)[i];
      std::visit(
          [&](const auto& load) {
            load.template apply<T>(in, t, piece, [&](const Vector3<T>& force, const Vector3<T>& moment) {
              add(load.body(), force, moment);
            });
          },
          loads[i]);
    }
  }
};

}  // namespace lubjoint
