#include "array_rows.hpp"
#include "film_at_rest.hpp"
#include "lubjoint/film/steady_place.hpp"
#include "lubjoint/text/message.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

namespace {

/// @throws FilmDomainError unless the load is finite and above 0, the spin finite and not 0, and the film carries it
/// @param force_ratio  F/S of a steady film
template <class Force>
SteadyPlace<double> place_of(const Force& force_ratio, double scale, double load, double omega) {
  Message message;
  if (!(load > 0) || !std::isfinite(load)) {
    message << "no steady state under a load of " << load << " N; allowed are finite loads above 0";
  } else if (!std::isfinite(omega) || omega == 0) {
    message << "no steady state at spin " << omega << " rad/s; allowed is a finite spin other than 0";
  } else {
    const auto place = steady_place_of(force_ratio, load / scale / std::abs(omega));
    if (place) return *place;
    message << "no steady state under a load of " << load << " N at spin " << omega
            << " rad/s; allowed is a load that the film carries at an eccentricity ratio from 1e-300 to 1 - 1e-15";
  }
  throw FilmDomainError(message.str());
}

}  // namespace

int lubjoint_film_equilibrium(const char* law, const lubjoint_bearing* bearing, size_t n, lubjoint_in load,
                              lubjoint_in omega, lubjoint_out eccentricity_ratio, lubjoint_out attitude) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    if (n > 0) {
      require("load", load.data);
      require("omega", omega.data);
      require("eccentricity_ratio", eccentricity_ratio.data);
      require("attitude", attitude.data);
    }
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    const auto places = [&](BearingLimit limit, const auto& force_ratio) {
      const double scale = force_scale(limit, geometry, oil);
      for_rows(n, eccentricity_ratio, attitude, [&](std::size_t i) {
        const SteadyPlace<double> place = place_of(force_ratio, scale, at(load, i), at(omega, i));
        const PolarForce<double> f = force_ratio(place.film(1));
        return Vector2<double>(place.eccentricity_ratio, std::atan2(f.tangential, -f.radial));
      });
    };
    with_law_at_rest(law, geometry, [&]<class Law>(const Law& named) {
      places(Law::limit, [&named](const PolarFilmState<double>& film) { return ratio_at_rest(named, film); });
    });
  });
}
