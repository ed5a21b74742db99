/// Angles in the plane that tables of loads are over, as their knots are looked for.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "lubjoint/motion/table_knots.hpp"
#include "lubjoint/multibody/planar_system.hpp"

namespace lubjoint {

/// Those of bodies of a system in the plane, whose states are (q, q̇, work).
template <class R>
class PlanarAngles {
 public:
  using Table = TableCurves<3>;  ///< of a load

  /// Of a system, kept by reference.
  explicit PlanarAngles(const PlanarSystem<R>& system) : system_(&system) {}

  /// Calls visit(load, number of the angle's body, table), but not where knots are times that a run is told.
  template <class Visit>
  void visit_tables(const Visit& visit) const {
    const auto& loads = system_->elements().loads;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const auto* load = std::get_if<TableLoad<R>>(&loads[i]);
      if (load == nullptr || !load->of_angle || load->at_known_times) continue;
      visit(i, load->against, load->table.get());
    }
  }
  /// Angle and spin of a body at a state.
  TurningAngle<R> at(const R&, const std::vector<R>& y, std::size_t body) const {
    const std::size_t place = planar_coordinates * body + 2;
    return {y[place], y[system_->coordinates() + place]};
  }

 private:
  const PlanarSystem<R>* system_;
};

}  // namespace lubjoint
