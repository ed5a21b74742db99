#include "oracle/verify/states/losses_oracle.hpp"

#include <cmath>
#include <limits>

#include "oracle/verify/states/film_places.hpp"

namespace lubjoint::verify {

namespace {

const Real half_turn = pi<Real>();

using Places = std::vector<FilmPlace>;

/// θ of the film's ends.
struct Ends {
  Real begin, end;
};

Ends ends_of(const Solution& s) {
  if (is_full(s.law)) return {0, 2 * half_turn};
  const bool at_rest = s.a == 0 && s.b == 0;
  const Real begin = is_half(s.law) || at_rest ? (s.a < 0 ? half_turn : 0) : std::atan2(2 * s.b, s.a);
  return {begin, begin + half_turn};
}

/// ∫dθ/H over what is sheared.
Real sheared(const Solution& s, const Places& film, const Ends& ends) {
  const auto over_thickness = [](const FilmPlace& at) { return 1 / at.thickness; };
  const Real in_film = sum(film, over_thickness);
  if (s.costs.shear == ShearExtent::film || is_full(s.law)) return in_film;
  if (s.costs.shear == ShearExtent::flooded) {
    return sum(film_places(s.ratio, s.ratio_gap, 0, 2 * half_turn), over_thickness);
  }
  const Real before = ends.begin > 0 ? 0 : half_turn;  // the other half of the gap, by where it begins
  const Places cavity = film_places(s.ratio, s.ratio_gap, before, before + half_turn);
  return in_film + sum(cavity, [&](const FilmPlace& at) { return s.ratio_gap / (at.thickness * at.thickness); });
}

/// ∫H dP and the dissipation, P the pressure without its scale.
struct PressureSums {
  Real shear = 0, dissipation = 0;
};

PressureSums short_sums(const Solution& s, const Places& film, const Ends& ends) {
  const auto source = [&](Real sine, Real cosine) { return s.a * sine - 2 * s.b * cosine; };
  PressureSums sums;
  sums.shear = sum(film, [&](const FilmPlace& at) {  // P = g/H³, dH/dθ = −ε sinθ
    const Real rise = s.a * at.cosine + 2 * s.b * at.sine;
    return (rise + 3 * source(at.sine, at.cosine) * s.ratio * at.sine / at.thickness) / (at.thickness * at.thickness);
  });
  sums.dissipation = sum(film, [&](const FilmPlace& at) {
    const Real g = source(at.sine, at.cosine);
    return g * g / cube(at.thickness);
  });
  if (is_full(s.law)) return sums;
  const auto step = [&](Real theta) {  // H P where the film ends
    const Real h = film_thickness(s.ratio, s.ratio_gap, theta);
    return source(std::sin(theta), std::cos(theta)) / (h * h);
  };
  sums.shear += step(ends.begin) - step(ends.end);
  return sums;
}

/// H³ dP/dθ = a cosθ + 2b sinθ + C = a(w − w̄) + 2b(sinθ − s̄), w = 1 + cosθ, means with the weight 1/H³: small where
/// the film is thin.
class LongFlow {
 public:
  LongFlow(const Solution& s, const Places& film) : a_(s.a), b_(s.b) {
    const bool of_whole = is_full(s.law) || s.law == "long_half_eq5"_law;
    const Places whole = of_whole ? film_places(s.ratio, s.ratio_gap, 0, 2 * half_turn) : film;
    const Real weight = sum(whole, [](const FilmPlace& at) { return 1 / cube(at.thickness); });
    wall_ = sum(whole, [](const FilmPlace& at) { return at.wall / cube(at.thickness); }) / weight;
    sine_ = sum(whole, [](const FilmPlace& at) { return at.sine / cube(at.thickness); }) / weight;
  }
  Real operator()(const FilmPlace& at) const { return a_ * (at.wall - wall_) + 2 * b_ * (at.sine - sine_); }

 private:
  Real a_, b_, wall_ = 0, sine_ = 0;
};

PressureSums long_sums(const Solution& s, const Places& film, const LongFlow& flow) {
  PressureSums sums;
  sums.shear = sum(film, [&](const FilmPlace& at) { return flow(at) / (at.thickness * at.thickness); });
  sums.dissipation = sum(film, [&](const FilmPlace& at) { return flow(at) * flow(at) / cube(at.thickness); });
  if (s.law == "long_half_eq5"_law) {  // p is zero at the maximum film: its step is at the minimum
    sums.shear -= s.ratio_gap * sum(film, [&](const FilmPlace& at) { return flow(at) / cube(at.thickness); });
  }
  return sums;
}

/// F·u/S of the cut pressure, p = 0 at the maximum film.
Real cut_film_power(const Solution& s, const Places& film, const LongFlow& flow) {
  const Real radial = -6 * sum(film, [&](const FilmPlace& at) { return at.sine * flow(at) / cube(at.thickness); });
  const Real tangential = 6 * sum(film, [&](const FilmPlace& at) { return at.wall * flow(at) / cube(at.thickness); });
  return radial * s.b - tangential * s.a / 2;
}

}  // namespace

std::array<double, most_answers> losses_quadrature_error(const Solution& s) {
  const Real rate = std::hypot(s.a, 2 * s.b);
  const Real moment = s.film_clearance * std::hypot(s.radial, s.tangential),
             torque = std::abs(s.costs.couette) + moment;
  const Real power = std::abs(s.costs.relative_spin * s.costs.couette) + moment * rate;
  const Real share = 1e-17L / std::sqrt(s.ratio_gap);
  const Real flow = s.film_clearance * s.radius * s.length * rate;
  const auto error = [&](Real size) { return static_cast<double>(share * size); };
  std::array<double, most_answers> all = {error(torque), error(torque), error(power), error(flow)};
  if (!is_solved_film(s.law)) return all;
  const double of_couette = s.moving_costs.couette_error * static_cast<double>(std::abs(s.costs.couette));
  const double of_force = s.moving.error * static_cast<double>(moment);
  for (const std::size_t torque_column : {0, 1}) all[torque_column] += of_couette + of_force / 2;
  all[2] +=
      of_couette * static_cast<double>(std::abs(s.costs.relative_spin)) + of_force * static_cast<double>(rate) / 2;
  all[3] += s.moving_costs.flow_error * static_cast<double>(flow);
  return all;
}

std::array<Real, 4> losses_by_quadrature(const Solution& s) {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  if (!(s.q() > 0)) return {nan, nan, nan, nan};
  const Ends ends = ends_of(s);
  const Places film = film_places(s.ratio, s.ratio_gap, ends.begin, ends.end);
  const Real c = s.clearance, mu = s.viscosity, l = s.length, r = s.radius;
  const Real spin = s.omega_journal - s.omega_bearing;
  const bool bounds_are_free = s.law == "finite_reynolds"_law && s.costs.shear == ShearExtent::film;
  const bool at_rest = s.a == 0 && s.b == 0;
  const Real over_thickness = bounds_are_free && !at_rest ? s.moving_costs.couette_integral : sheared(s, film, ends);
  const Real couette = mu * spin * r * r * r * l / c * over_thickness;
  Real wall = 0, dissipated = 0;
  if (s.law == "pinkus_sternlicht"_law || is_solved_film(s.law)) {  // e × F and F·u of the force as it is
    wall = -s.ratio * c * s.tangential / 2;
    dissipated = -c * (s.radial * s.b - s.tangential * s.a / 2);
  } else if (is_short(s.law)) {
    const PressureSums sums = short_sums(s, film, ends);
    wall = -mu * r * l * l * l / (4 * c) * sums.shear;
    dissipated = mu * r * l * l * l / (4 * c) * sums.dissipation;
  } else {
    const LongFlow flow(s, film);
    const PressureSums sums = long_sums(s, film, flow);
    const Real scale = 3 * mu * l * r * r * r / c;
    wall = -scale * sums.shear;
    dissipated = s.law == "long_half_eq5"_law ? -scale / 3 * cut_film_power(s, film, flow) : scale * sums.dissipation;
  }
  Real flow = nan;
  if (is_solved_film(s.law)) {
    flow = c * r * l * s.moving_costs.side_flow;
  } else if (is_short(s.law)) {
    const Real source = sum(film, [&](const FilmPlace& at) { return s.a * at.sine - 2 * s.b * at.cosine; });
    flow = c * r * l / 2 * (at_rest ? 0 : source);
  }
  return {wall - couette, wall + couette, spin * couette + dissipated, flow};
}

}  // namespace lubjoint::verify
