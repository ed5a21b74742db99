#include "oracle/results/coefficient_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "lubjoint/film/law_facts.hpp"
#include "lubjoint/film/steady_place.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

using Wide = long double;

CoefficientRow row_at(const FilmInBearing& film, const SteadyLaw& law, const SteadyPlace<Wide>& place, double omega) {
  const Bearing<Wide> bearing(film.bearing.length(), film.bearing.radius(), film.bearing.clearance());
  const int sign = omega < 0 ? -1 : 1;
  const CoefficientRatios<Wide> differentiated = law.differentiated(place, sign);
  const CoefficientRatios<Wide> ratios = law.coefficients(place, sign);
  const Wide scale = force_scale(law.limit, bearing, Lubricant<Wide>(film.oil.viscosity()));
  const SteadyFilm<Wide> rest = steady_film_of<Wide>(bearing, scale, law.force_ratio, place, Wide(omega), ratios);
  const auto narrow = [](const Wide& value) { return static_cast<double>(value); };
  CoefficientRow row{narrow(place.eccentricity_ratio),
                     omega,
                     narrow(rest.load),
                     narrow(rest.attitude),
                     rest.stiffness.cast<double>(),
                     rest.damping.cast<double>(),
                     narrow(rest.threshold.critical_mass),
                     std::nullopt,
                     narrow(coefficient_difference(ratios, differentiated))};
  if (rest.threshold.whirl_frequency) row.whirl_ratio = narrow(*rest.threshold.whirl_frequency / std::abs(Wide(omega)));
  return row;
}

}  // namespace

CoefficientRow coefficients_at(const FilmInBearing& film, double eccentricity_ratio, double omega) {
  const SteadyPlace<Wide> place{Wide(eccentricity_ratio)};
  return row_at(film, steady_law(film.law, film.table.get()), place, omega);
}

std::optional<CoefficientRow> coefficients_under(const FilmInBearing& film, double load, double omega) {
  const SteadyLaw law = steady_law(film.law, film.table.get());
  const double scale = force_scale(law.limit, film.bearing, film.oil);
  const auto place = steady_place_of(law.force_ratio, Wide(load) / scale / std::abs(Wide(omega)));
  if (!place) return std::nullopt;
  CoefficientRow row = row_at(film, law, *place, omega);
  row.load = load;
  return row;
}

std::string coefficients_csv(const FilmInBearing& film, const std::vector<CoefficientRow>& rows, bool dimensionless) {
  std::string csv =
      "eccentricity_ratio,omega,load,attitude,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy,critical_mass,whirl_ratio\n";
  for (const CoefficientRow& row : rows) {
    const double spin = std::abs(row.omega);
    const double k_unit = dimensionless ? film.bearing.clearance() / row.load : 1;
    const double c_unit = dimensionless ? k_unit * spin : 1;
    const double m_unit = dimensionless ? c_unit * spin : 1;
    std::vector<double> numbers{row.eccentricity_ratio, row.omega, row.load, row.attitude};
    for (int i = 0; i < 4; ++i) numbers.push_back(k_unit * row.stiffness(i / 2, i % 2));
    for (int i = 0; i < 4; ++i) numbers.push_back(c_unit * row.damping(i / 2, i % 2));
    for (const double value : numbers) {
      if (!std::isfinite(value)) {
        throw std::range_error(fmt::format(
            "a coefficient at eccentricity ratio {} and spin {} rad/s is beyond the range of double precision; allowed "
            "are smaller or larger eccentricity ratios",
            row.eccentricity_ratio, row.omega));
      }
      csv += number(value) + ",";
    }
    csv += std::isinf(row.critical_mass) ? "inf" : number(m_unit * row.critical_mass);
    csv += "," + (row.whirl_ratio ? number(*row.whirl_ratio) : std::string()) + "\n";
  }
  return csv;
}

double whirl_ratio_at_the_centre(std::string_view law, const CompiledFilm* table) {
  const SteadyPlace<Wide> place(Wide(1e-9));  // what is left of ε is of order ε
  const CoefficientRatios<Wide> ratios = steady_law(law, table).coefficients(place, 1);
  return static_cast<double>(*routh_threshold<Wide>(ratios.stiffness, ratios.damping).whirl_frequency);
}

std::string stability_warning(std::string_view law, const CompiledFilm* table) {
  const double whirl = whirl_ratio_at_the_centre(law, table);
  if (std::abs(whirl - 0.5) < 1e-6) return {};  // ε is 1e-9 there
  return fmt::format(
      "{} whirls at {:.3f} times the spin as the eccentricity goes to 0, where every film that is isotropic at the "
      "centre whirls at half of it: its damping there depends on the direction of e. For stability use a law without "
      "this fault, such as {}",
      law, whirl,
      table != nullptr            ? "finite_dynamic"
      : law_facts(law).is_short() ? "short_dynamic"
                                  : "long_dynamic");
}

std::string beyond_table_note(const FilmInBearing& film, double eccentricity_ratio) {
  if (film.table == nullptr || eccentricity_ratio <= film.table->ratio_limit) return {};
  return fmt::format(
      "the error of {}, {:.1e} of |F|, was measured up to eccentricity ratio {:g}, and is not known at {:g}", film.law,
      film.table->error, film.table->ratio_limit, eccentricity_ratio);
}

}  // namespace lubjoint::reports
