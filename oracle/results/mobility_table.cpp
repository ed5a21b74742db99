#include "oracle/results/mobility_table.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "lubjoint/film/shaped_mobility.hpp"
#include "lubjoint/joint/chosen_film.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

using Wide = long double;
using Velocity = std::optional<Vector2<Wide>>;

/// Two fields of a row.
std::string fields(const Velocity& velocity) {
  if (!velocity) return ",,";
  std::string text;
  for (const Wide component : {velocity->x(), velocity->y()}) {
    const double rounded = static_cast<double>(component) + 0.0;  // no minus before a zero
    if (!std::isfinite(rounded)) {
      throw std::range_error("the velocity is beyond the range of double precision; allowed are smaller forces");
    }
    text += ',' + number(rounded);
  }
  return text;
}

bool can_have_two(std::string_view law) {
  return with_film_law<NamedFilmLaws>(law, []<class Law>() { return Law::extent == FilmExtent::half; });
}

}  // namespace

std::vector<std::string> mobility_column_names(std::string_view law) {
  std::vector<std::string> names = {"ux", "uy", "status"};
  if (can_have_two(law)) names.insert(names.end(), {"other_ux", "other_uy"});
  return names;
}

std::string mobility_columns(const FilmInBearing& film, const Vector2<double>& e_hat, const Vector2<double>& force) {
  const std::string& law = film.law;
  const Bearing<Wide> wide_bearing(film.bearing.length(), film.bearing.radius(), film.bearing.clearance());
  const Lubricant<Wide> wide_oil(film.oil.viscosity());
  const Vector2<Wide> wide_place(e_hat.x(), e_hat.y());
  const Vector2<Wide> wide_force(force.x(), force.y());
  const Mobility<Wide> found = with_film_law<NamedFilmLaws>(law, [&]<class Law>() -> Mobility<Wide> {
    if constexpr (FilmLaw<Law>) {
      return mobility<Law>(wide_bearing, wide_oil, wide_place, wide_force);
    } else if constexpr (CompiledLaw<Law>) {
      const Law compiled(table_of<Law>(film.table.get()));
      require_shape_of(compiled, wide_bearing);
      const Wide q = one_minus_squared_norm<Wide>(wide_place.x(), wide_place.y());
      const Vector2<Wide> ratio = wide_force / force_scale(Law::limit, wide_bearing, wide_oil);
      return compiled_mobility(compiled, wide_place, q, ratio);
    } else if constexpr (std::is_same_v<Law, MoesImpedance>) {
      const Wide q = one_minus_squared_norm<Wide>(wide_place.x(), wide_place.y());
      const Vector2<Wide> ratio = wide_force / force_scale(Law::limit, wide_bearing, wide_oil);
      return {MobilityStatus::found, moes_velocity(wide_place, q, ratio, length_to_diameter(wide_bearing))};
    } else {
      throw std::logic_error("require_mobility has let a law pass");
    }
  });
  std::string text = fields(found.velocity) + ',';
  text += mobility_status_names[static_cast<std::size_t>(found.status)];
  return can_have_two(law) ? text + fields(found.other) : text;
}

void require_mobility(std::string_view law) {
  if (law != Butenschoen::name) return;
  throw std::invalid_argument(
      "the law butenschoen has no mobility: its sum is not passive, and how many velocities carry a force is not "
      "known; allowed are the other laws");
}

std::string mobility_note(std::string_view law) {
  const bool open = with_film_law<NamedFilmLaws>(
      law, []<class Law>() { return Law::potential == Potential::none && Law::extent != FilmExtent::half; });
  if (!open) return {};
  return std::string(law) + ": a velocity exists for every force; that it is the only one is measured, not proved";
}

}  // namespace lubjoint::reports
