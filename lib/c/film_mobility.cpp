#include "array_rows.hpp"
#include "lubjoint/film/compiled_mobility.hpp"
#include "lubjoint/film/mobility.hpp"
#include "lubjoint/film/shaped_mobility.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

namespace {

template <class Law>
Mobility<double> mobility_of([[maybe_unused]] const Law& law, const Bearing<double>& bearing,
                             const Lubricant<double>& oil, const Vector2<double>& place, const Vector2<double>& force) {
  if constexpr (FilmLaw<Law>) {
    return mobility<Law>(bearing, oil, place, force);
  } else if constexpr (CompiledLaw<Law>) {
    const double q = one_minus_squared_norm<double>(place.x(), place.y());
    return compiled_mobility(law, place, q, Vector2<double>(force / force_scale(Law::limit, bearing, oil)));
  } else if constexpr (std::is_same_v<Law, MoesImpedance>) {
    const double q = one_minus_squared_norm<double>(place.x(), place.y());
    const Vector2<double> ratio = force / force_scale(Law::limit, bearing, oil);
    return {MobilityStatus::found, moes_velocity(place, q, ratio, length_to_diameter(bearing))};
  } else {
    throw std::invalid_argument("the law " + std::string(Law::name) +
                                " has no mobility: its sum of two fits is not passive; allowed are the other laws");
  }
}

/// Both components; NaN where there is no velocity, which the status says.
void put_velocity(const lubjoint_out& x, const lubjoint_out& y, std::size_t i,
                  const std::optional<Vector2<double>>& velocity) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  put(x, i, velocity ? velocity->x() : none);
  put(y, i, velocity ? velocity->y() : none);
}

bool is_finite(const std::optional<Vector2<double>>& velocity) {
  return !velocity || (std::isfinite(velocity->x()) && std::isfinite(velocity->y()));
}

}  // namespace

int lubjoint_film_mobility(const char* law, const lubjoint_bearing* bearing, size_t n, lubjoint_in ex_over_c,
                           lubjoint_in ey_over_c, lubjoint_in fx, lubjoint_in fy, const lubjoint_mobility* mobility) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("mobility", mobility);
    const bool has_other = mobility->other_ux.data != nullptr;
    if (has_other != (mobility->other_uy.data != nullptr)) {
      throw std::invalid_argument("one of other_ux and other_uy is a null pointer; allowed are both or neither");
    }
    if (n > 0) {
      require("ex_over_c", ex_over_c.data);
      require("ey_over_c", ey_over_c.data);
      require("fx", fx.data);
      require("fy", fy.data);
      require("ux", mobility->ux.data);
      require("uy", mobility->uy.data);
      require("status", mobility->status);
    }
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    with_law(law, geometry, [&](const auto& named) {
      for (std::size_t i = 0; i < n; ++i) {
        try {
          const Mobility<double> found =
              mobility_of(named, geometry, oil, Vector2<double>(at(ex_over_c, i), at(ey_over_c, i)),
                          Vector2<double>(at(fx, i), at(fy, i)));
          if (!is_finite(found.velocity) || !is_finite(found.other)) throw ForceRowError(i);
          put_velocity(mobility->ux, mobility->uy, i, found.velocity);
          if (has_other) put_velocity(mobility->other_ux, mobility->other_uy, i, found.other);
          mobility->status[i] = static_cast<int>(found.status);
        } catch (const FilmDomainError& error) {
          throw FilmRowError(i, error.what());
        }
      }
    });
  });
}
