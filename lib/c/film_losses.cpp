#include "array_rows.hpp"
#include "lubjoint/film/losses.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

namespace {

/// Force on the journal [N].
template <class Law>
Vector2<double> force_of(const Law& law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                         const FilmState<double>& film) {
  if constexpr (CompiledLaw<Law>) {
    return film_force(law, bearing, oil, film);
  } else {
    return film_force<Law>(bearing, oil, film);
  }
}

template <class Law>
void film_losses_of(const Law& law, const Bearing<double>& bearing, const Lubricant<double>& oil, ShearExtent shear,
                    std::size_t n, const lubjoint_motion& motion, const lubjoint_losses& losses) {
  static_cast<void>(sheared_gap<Law>(shear));  // refuses
  if (losses.side_flow.data != nullptr && (CompiledLaw<Law> || Law::limit == BearingLimit::long_bearing)) {
    throw std::invalid_argument("side_flow is asked of " + std::string(Law::name) +
                                "; allowed is a null pointer for a long bearing, which has none, and for a compiled "
                                "law, which has the force of its film alone");
  }
  const double couette = couette_scale(bearing, oil);
  std::size_t i = 0;
  try {
    for (; i < n; ++i) {
      const JournalMotion<double> m = motion_at(motion, i);
      const FilmState<double> film = film_state(m, bearing.clearance());
      const double rate = couette * couette_integral<Law>(film, shear);
      const FilmLosses<double> row = losses_of<double>(force_of(law, bearing, oil, film), film, bearing.clearance(),
                                                       rate, m.journal_spin - m.bearing_spin);
      const double flow = side_flow<Law>(bearing, film).value_or(0);
      const double power = row.power();
      if (!std::isfinite(row.torque_journal) || !std::isfinite(row.torque_bearing) || !std::isfinite(power) ||
          !std::isfinite(flow)) {
        throw ForceRowError(i);
      }
      put(losses.torque_journal, i, row.torque_journal);
      put(losses.torque_bearing, i, row.torque_bearing);
      put(losses.power, i, power);
      if (losses.side_flow.data != nullptr) put(losses.side_flow, i, flow);
    }
  } catch (const FilmDomainError& error) {
    throw FilmRowError(i, error.what());
  }
}

}  // namespace

int lubjoint_film_losses(const char* law, const lubjoint_bearing* bearing, const char* shear, size_t n,
                         const lubjoint_motion* motion, const lubjoint_losses* losses) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("shear", shear);
    require("motion", motion);
    require("losses", losses);
    if (n > 0) {
      require(*motion);
      require("torque_journal", losses->torque_journal.data);
      require("torque_bearing", losses->torque_bearing.data);
      require("power", losses->power.data);
    }
    const ShearExtent extent = shear_extent(shear);
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    with_law(law, geometry,
             [&](const auto& named) { film_losses_of(named, geometry, oil, extent, n, *motion, *losses); });
  });
}
