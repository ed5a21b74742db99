/// Angles in space that tables of loads are over, as their knots are looked for.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/motion/table_knots.hpp"

namespace lubjoint {

/// Counted angles of a system in space, whose states are (r, p; ṙ, ω′; work).
template <class R>
class SpatialAngles {
 public:
  using Table = TableCurves<6>;  ///< of a load

  /// Of equations, kept by reference.
  explicit SpatialAngles(const SpatialOde<R>& ode) : ode_(&ode) {}

  /// Calls visit(load, number of the angle, table).
  template <class Visit>
  void visit_tables(const Visit& visit) const {
    const auto& loads = ode_->system().elements().loads;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const auto* load = std::get_if<SpatialTableLoad<R>>(&loads[i]);
      if (load != nullptr && load->of_angle) visit(i, load->angle, load->table.get());
    }
  }
  /// A counted angle and its rate at a state. @throws AngleNotCounted
  TurningAngle<R> at(const R& t, const std::vector<R>& y, std::size_t k) const {
    const AngleMotion<R> motion = ode_->angle(t, y, k);
    return {motion.angle, motion.rate};
  }

 private:
  const SpatialOde<R>* ode_;
};

}  // namespace lubjoint
