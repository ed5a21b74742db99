#include "oracle/results/mobility_table.hpp"

#include <cmath>
#include <optional>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/mobility.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

using Wide = long double;
using Velocity = std::optional<Vector2<Wide>>;

/// Two fields of a row.
std::string fields(const CsvTable& states, std::size_t row, const Velocity& velocity) {
  if (!velocity) return ",,";
  std::string text;
  for (const Wide component : {velocity->x(), velocity->y()}) {
    const double rounded = static_cast<double>(component) + 0.0;  // no minus before a zero
    if (!std::isfinite(rounded)) {
      states.refuse(row, "the velocity is beyond the range of double precision; allowed are smaller forces");
    }
    text += ',' + number(rounded);
  }
  return text;
}

template <FilmLaw Law>
std::string rows(const CsvTable& states, const Bearing<Wide>& bearing, const Lubricant<Wide>& oil) {
  constexpr bool can_have_two = Law::extent == FilmExtent::half;
  const std::size_t ex = states.column("ex_over_c");
  const std::size_t ey = states.column("ey_over_c");
  const std::size_t fx = states.column("fx");
  const std::size_t fy = states.column("fy");
  std::string csv = states.header() + ",ux,uy,status" + (can_have_two ? ",other_ux,other_uy\n" : "\n");
  for (std::size_t row = 0; row < states.rows(); ++row) {
    csv += states.line(row);
    try {
      const Vector2<Wide> e_hat(states.number(row, ex), states.number(row, ey));
      const Vector2<Wide> force(states.number(row, fx), states.number(row, fy));
      const Mobility<Wide> found = mobility<Law>(bearing, oil, e_hat, force);
      csv += fields(states, row, found.velocity) + ',';
      csv += mobility_status_names[static_cast<std::size_t>(found.status)];
      if (can_have_two) csv += fields(states, row, found.other);
    } catch (const FilmDomainError& error) {
      states.refuse(row, error.what());
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace

std::string mobility_csv(const CsvTable& states, std::string_view law, const Bearing<double>& bearing,
                         const Lubricant<double>& oil) {
  const Bearing<Wide> wide_bearing(bearing.length(), bearing.radius(), bearing.clearance());
  const Lubricant<Wide> wide_oil(oil.viscosity());
  return with_every_film_law(law, [&]<class Law>() { return rows<Law>(states, wide_bearing, wide_oil); });
}

std::string mobility_note(std::string_view law) {
  const bool open = with_every_film_law(
      law, []<class Law>() { return Law::potential == Potential::none && Law::extent != FilmExtent::half; });
  if (!open) return {};
  return std::string(law) + ": a velocity exists for every force; that it is the only one is measured, not proved";
}

}  // namespace lubjoint::reports
