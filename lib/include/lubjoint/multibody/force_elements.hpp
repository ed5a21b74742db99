/// Springs and moving loads of a system. A system without any has none of their code in its path.
#pragma once

#include <algorithm>
#include <vector>

#include "lubjoint/multibody/moving_load.hpp"
#include "lubjoint/multibody/spring.hpp"

namespace lubjoint {

/// Forces that depend on places, velocities and time, other than those of joints and constraints.
template <class R>
struct ForceElements {
  std::vector<NamedSpring<R>> springs;  ///< in the scene's order
  std::vector<MovingLoad<R>> loads;     ///< likewise

  bool empty() const { return springs.empty() && loads.empty(); }  ///< is there none?
  /// Does any spring have a damper?
  bool has_dampers() const {
    return std::any_of(springs.begin(), springs.end(), [](const auto& s) { return s.is_damped(); });
  }

  /// Adds all forces and moments about mass centres, g in coordinates.
  /// @param frame  frame(body) is the frame of a body or of the ground
  /// @param pieces  of the tables of the loads, one a load, where they may be held; may be null
  /// @throws SpringWithoutDirection
  template <class T, class Time, class Frame>
  void apply(const Time& t, const Frame& frame, const std::vector<TablePiece>* pieces, std::vector<T>& forces) const {
    const auto add = [&](std::size_t body, const Vector2<T>& force, const T& moment) {
      if (body == ground_body) return;
      forces[3 * body] += force.x();
      forces[3 * body + 1] += force.y();
      forces[3 * body + 2] += moment;
    };
    for (const NamedSpring<R>& each : springs) {
      std::visit([&](const auto& s) { s.apply(frame(s.first_body()), frame(s.second_body()), add); }, each.spring);
    }
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const std::size_t body = body_of(loads[i]);
      apply_load<T>(loads[i], t, frame, piece_of(i, pieces),
                    [&](const Vector2<T>& force, const T& moment) { add(body, force, moment); });
    }
  }

  /// Power of the loads [W].
  template <class T, class Time, class Frame>
  T load_power(const Time& t, const Frame& frame, const std::vector<TablePiece>* pieces) const {
    T power(0);
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const PlanarFrame<T>& body = frame(body_of(loads[i]));
      apply_load<T>(loads[i], t, frame, piece_of(i, pieces), [&](const Vector2<T>& force, const T& moment) {
        power += dot(force, body.velocity) + moment * body.spin;
      });
    }
    return power;
  }

  /// Elastic energy of the springs [J]. @throws SpringWithoutDirection
  template <class T, class Frame>
  T energy(const Frame& frame) const {
    T sum(0);
    for (const NamedSpring<R>& each : springs) {
      sum += std::visit([&](const auto& s) { return s.energy(frame(s.first_body()), frame(s.second_body())); },
                        each.spring);
    }
    return sum;
  }

  /// Power of the dampers, never positive [W]. @throws SpringWithoutDirection
  template <class T, class Frame>
  T damper_power(const Frame& frame) const {
    T sum(0);
    for (const NamedSpring<R>& each : springs) {
      sum += std::visit([&](const auto& s) { return s.damper_power(frame(s.first_body()), frame(s.second_body())); },
                        each.spring);
    }
    return sum;
  }

 private:
  static const TablePiece* piece_of(std::size_t load, const std::vector<TablePiece>* pieces) {
    return pieces == nullptr ? nullptr : &(*pieces)[load];
  }
};

}  // namespace lubjoint
