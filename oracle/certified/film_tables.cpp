#include <stdexcept>

#include "oracle/certified/film_pressure.hpp"
#include "oracle/certified/film_quadrature.hpp"
#include "oracle/certified/golden_states.hpp"
#include "oracle/certified/golden_table.hpp"
#include "oracle/certified/overlap.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::certified {

namespace {

FilmBalls in_balls(const PolarState& state) { return {Ball(state.epsilon), Ball(state.a), Ball(state.b)}; }

enum class Field { short_film, long_eq5, long_half, long_dynamic };

struct FieldEntry {
  Field field;
  std::string_view name;
};

constexpr std::array<FieldEntry, 4> fields = {{{Field::short_film, "short"},
                                               {Field::long_eq5, "long_eq5"},
                                               {Field::long_half, "long_half"},
                                               {Field::long_dynamic, "long_dynamic"}}};

Extent extent_of(Field field) { return field == Field::long_half ? Extent::half : Extent::dynamic; }

/// Is θ certainly inside of the film?
bool inside(Extent extent, const PolarState& state, double theta) {
  const WorkingPrecision precision(192);
  const ExtentBalls bounds = film_extent(extent, in_balls(state));
  const Ball after = Ball(theta) - bounds.start;
  const Ball before = bounds.end - Ball(theta);
  return arb_is_positive(after.get()) && arb_is_positive(before.get());
}

struct PressurePlace {
  Field field;
  std::string_view name;
  BearingValues bearing;
  PolarState state;
  double theta, z;
};

std::vector<PressurePlace> pressure_places() {
  const std::vector<PolarState> states = {
      {0.5, 50, 0},      {0.5, 0, 50},      {0.5, 0, -50},       {0.1, 20, 30},     {0.8, -40, 10},
      {0.8, 40, -60},    {0.95, 100, 5},    {0.95, -3, -7},      {1e-6, 25, -12.5}, {0, 10, 20},
      {0.999, 1, 1},     {0.999, 1, -1},    {1 - 1e-8, 2, 0.25}, {1 - 1e-12, 1, 1}, {1 - 1e-12, -1, -0.5},
      {1e-300, 50, 0.5}, {0.3, 1e-9, 10.0}, {0.3, -1e-9, -10.0},
  };
  const std::array<double, 12> angles = {-2.5, -1, -0.125, 0.25, 1, 2, 3, 3.1415926, 3.25, 4, 5, 6.125};
  std::vector<PressurePlace> places;
  for (const FieldEntry& entry : fields) {
    std::size_t number = 0;
    for (const PolarState& state : states) {
      const BearingValues& bearing = bearings[number++ % bearings.size()];
      for (const double theta : angles) {
        const bool whole = entry.field == Field::short_film || entry.field == Field::long_eq5;
        if (!whole && !inside(extent_of(entry.field), state, theta)) continue;
        // z matters to the short film alone: the middle, a quarter of the length, and near an edge.
        const std::array<double, 3> z = {0, bearing.length / 4, -0.46875 * bearing.length};
        places.push_back({entry.field, entry.name, bearing, state, theta,
                          entry.field == Field::short_film ? z[places.size() % z.size()] : 0});
      }
    }
  }
  return places;
}

/// p [Pa].
Ball pressure(const PressurePlace& at) {
  const FilmBalls film = in_balls(at.state);
  const auto& [viscosity, length, radius, clearance] = at.bearing;
  const Ball c(clearance);
  if (at.field == Field::short_film) {
    return 3 * Ball(viscosity) / (c * c) * short_pressure(film, length, at.theta, at.z);
  }
  const Ball slender = Ball(radius) / c;
  const Ball scale = 6 * Ball(viscosity) * slender * slender;
  if (at.field == Field::long_eq5) return scale * long_pressure_eq5(film, at.theta);
  return scale * long_pressure(extent_of(at.field), film, at.theta);
}

void check_pressure(const PressurePlace& at) {
  if (at.field == Field::short_film || at.field == Field::long_eq5) return;  // the definition itself
  const FilmBalls film = in_balls(at.state);
  const Extent extent = extent_of(at.field);
  const std::string where =
      std::string(at.name) + " pressure at ε " + reports::number(at.state.epsilon) + ", θ " + reports::number(at.theta);
  require_overlap([&] { return std::vector<Ball>{long_pressure(extent, film, at.theta)}; },
                  [&] { return std::vector<Ball>{long_pressure_by_quadrature(extent, film, at.theta)}; }, where);
}

}  // namespace

GoldenTable film_force_table() {
  const std::vector<PolarState> states = polar_states();
  const auto row = [states](std::size_t number) {
    const LawEntry& law = laws[number / states.size()];
    const std::size_t which = number % states.size();
    const PolarState& state = states[which];
    const BearingValues& bearing = bearings[which % bearings.size()];
    const FilmBalls film = in_balls(state);
    if (law.has_pressure) {
      const std::string where = std::string(law.name) + " at ε " + reports::number(state.epsilon) + ", a " +
                                reports::number(state.a) + ", b " + reports::number(state.b);
      const auto as_vector = [](const PolarBalls& f) { return std::vector<Ball>{f.radial, f.tangential}; };
      require_overlap([&] { return as_vector(force_ratio(law.law, film)); },
                      [&] { return as_vector(force_ratio_by_quadrature(law.law, film)); }, where);
    }
    const auto force = certify([&] {
      const Ball scale = force_scale(law, bearing.viscosity, bearing.length, bearing.radius, Ball(bearing.clearance));
      const PolarBalls ratio = force_ratio(law.law, film);
      return std::vector<Ball>{scale * ratio.radial, scale * ratio.tangential};
    });
    RowText text;
    text.add(law.name).add(bearing.viscosity).add(bearing.length).add(bearing.radius).add(bearing.clearance);
    return text.add(state.epsilon).add(state.a).add(state.b).add(force).take();
  };
  return {"film_force.csv",
          golden_header("law,viscosity,length,radius,clearance,eccentricity_ratio,slip_rate,squeeze_rate",
                        {"radial", "tangential"}),
          laws.size() * states.size(), row};
}

GoldenTable film_extent_table() {
  const std::vector<PolarState> states = [] {
    std::vector<PolarState> list = {{0, 0, 0}};
    for (const double a : {0.0, 1.0, -1.0, 3.5, -250.0, 1e-300, -1e-300, 1e12}) {
      for (const double b : {0.0, 1.0, -1.0, 0.125, -80.0, 1e-300, -1e-300}) {
        if (a != 0 || b != 0) list.push_back({0, a, b});
      }
    }
    return list;
  }();
  constexpr std::array<std::pair<Extent, std::string_view>, 3> extents = {
      {{Extent::full, "full"}, {Extent::half, "half"}, {Extent::dynamic, "dynamic"}}};
  const auto row = [states, extents](std::size_t number) {
    const auto& entry = extents[number / states.size()];
    const PolarState& state = states[number % states.size()];
    const auto bounds = certify([&] {
      const ExtentBalls balls = film_extent(entry.first, in_balls(state));
      return std::vector<Ball>{balls.start, balls.end};
    });
    return RowText().add(entry.second).add(state.a).add(state.b).add(bounds).take();
  };
  return {"film_extent.csv", golden_header("extent,slip_rate,squeeze_rate", {"theta_s", "theta_e"}),
          extents.size() * states.size(), row};
}

GoldenTable film_pressure_table() {
  const std::vector<PressurePlace> places = pressure_places();
  const auto row = [places](std::size_t number) {
    const PressurePlace& at = places[number];
    check_pressure(at);
    const auto value = certify([&] { return std::vector<Ball>{pressure(at)}; });
    const auto& [viscosity, length, radius, clearance] = at.bearing;
    RowText text;
    text.add(at.name).add(viscosity).add(length).add(radius).add(clearance);
    text.add(at.state.epsilon).add(at.state.a).add(at.state.b).add(at.theta).add(at.z);
    return text.add(value).take();
  };
  return {"film_pressure.csv",
          golden_header("field,viscosity,length,radius,clearance,eccentricity_ratio,slip_rate,squeeze_rate,theta,z",
                        {"pressure"}),
          places.size(), row};
}

}  // namespace lubjoint::certified
