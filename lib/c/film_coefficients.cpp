#include "array_rows.hpp"
#include "film_at_rest.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

int lubjoint_film_coefficients(const char* law, const lubjoint_bearing* bearing, size_t n,
                               lubjoint_in eccentricity_ratio, lubjoint_in omega,
                               const lubjoint_coefficients* coefficients) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("coefficients", coefficients);
    const lubjoint_coefficients& to = *coefficients;
    const lubjoint_out* const outputs[] = {&to.load,         &to.attitude,     &to.stiffness[0], &to.stiffness[1],
                                           &to.stiffness[2], &to.stiffness[3], &to.damping[0],   &to.damping[1],
                                           &to.damping[2],   &to.damping[3],   &to.critical_mass};
    if (n > 0) {
      require("eccentricity_ratio", eccentricity_ratio.data);
      require("omega", omega.data);
      for (const lubjoint_out* output : outputs) require("an array of coefficients", output->data);
    }
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    with_law_at_rest(law, geometry, [&]<class Law>(const Law& named) {
      const double scale = force_scale(Law::limit, geometry, oil);
      const auto force_ratio = [&named](const PolarFilmState<double>& film) { return ratio_at_rest(named, film); };
      for (std::size_t i = 0; i < n; ++i) {
        try {
          const SteadyPlace<double> place(at(eccentricity_ratio, i));
          const double spin = at(omega, i);
          const auto rest = steady_film_of<double>(geometry, scale, force_ratio, place, spin,
                                                   coefficients_at_rest(named, place, spin < 0 ? -1 : 1));
          const auto& k = rest.stiffness;
          const auto& c = rest.damping;
          const double row[] = {rest.load, rest.attitude, k(0, 0), k(0, 1), k(1, 0),
                                k(1, 1),   c(0, 0),       c(0, 1), c(1, 0), c(1, 1)};
          for (const double value : row) {
            if (!std::isfinite(value)) throw ForceRowError(i);
          }
          for (std::size_t j = 0; j < std::size(row); ++j) put(*outputs[j], i, row[j]);
          put(to.critical_mass, i, rest.threshold.critical_mass);
        } catch (const FilmDomainError& error) {
          throw FilmRowError(i, error.what());
        }
      }
    });
  });
}
