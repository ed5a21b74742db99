#include "oracle/verify/states/solved_film_states.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "oracle/verify/states/films_by_solver.hpp"
#include "oracle/verify/states/finite_film.hpp"
#include "oracle/verify/states/steady_slopes.hpp"

namespace lubjoint::verify {

namespace {

using oracle::FilmOnset;
using oracle::FiniteFilm;

double scale_of(const State& s) {
  return force_scale(BearingLimit::long_bearing, Bearing<double>(s.length, s.radius, s.clearance),
                     Lubricant<double>(s.viscosity));
}

/// A journal that carries a load, at about this ε: short and long half films as springs in series.
State load_at(double shape, double ratio, double spin, std::size_t place) {
  State s;
  s.radius = 0.01 * (1 + static_cast<double>(place % 4));
  s.length = 2 * s.radius * shape;
  s.clearance = s.radius / 512;
  s.viscosity = 0.02 + 0.01 * static_cast<double>(place % 5);
  s.omega = spin * (1 + 0.1 * static_cast<double>(place % 7));
  const auto over_scale = [&](Law law) { return published_slopes(law, ratio, 1 - ratio).size(); };
  const Real slenderness = 2 * static_cast<Real>(shape);
  const Real load =
      1 / (1 / (over_scale("short_half"_law) * slenderness * slenderness) + 1 / over_scale("long_half"_law));
  s.load = static_cast<double>(load) * scale_of(s) * std::abs(s.omega);
  return s;
}

std::vector<State> loads() {
  std::vector<State> states;
  for (const double shape : finite_shapes) {
    for (const double ratio : {0.1, 0.25, 0.4, 0.55, 0.7, 0.8, 0.9}) {
      for (const double spin : {200.0, -300.0}) states.push_back(load_at(shape, ratio, spin, states.size()));
    }
  }
  return states;
}

/// Numbers of (0, 1) that fill it evenly.
double spread(std::size_t place, double step) { return std::fmod((static_cast<double>(place) + 0.5) * step, 1.0); }

/// Arms of any direction: a few clearances, where e × F shows in a moment, or a few radii.
void add_arms(std::vector<State>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    State& s = states[i];
    const double reach = i % 5 < 2 ? 4 * s.clearance : 3 * s.radius;  // there are six motions: each has both
    const auto arm = [&](double step) { return reach * (2 * spread(i, step) - 1); };
    s.sx_i = arm(0.618);
    s.sy_i = arm(0.414);
    s.sx_j = arm(0.732);
    s.sy_j = arm(0.236);
  }
}

/// Places inside of the dynamic film, and at every fourth state anywhere; half of them off the middle.
void add_places(std::vector<State>& states) {
  constexpr double turn = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < states.size(); ++i) {
    State& s = states[i];
    const double slip = s.eccentricity_ratio * (s.omega - 2 * s.attitude_rate);
    const bool anywhere = i % 4 == 3;
    const double start = anywhere ? 0 : std::atan2(2 * s.squeeze_rate, slip);
    s.theta = start + (anywhere ? turn : turn / 2) * spread(i, 0.618);
    if (s.theta < 0) s.theta += turn;
    s.z = i % 2 == 0 ? 0 : s.length / 2 * (2 * spread(i, 0.414) - 1);
  }
}

/// The motions of finite_states, farther out: inside of the clearance, in the blend, and beyond it. The wall's force is
/// about as large as the film's, and its loss shows.
std::vector<State> transitions() {
  std::vector<State> states = finite_states(Quantities::cartesian);
  constexpr double blend = 1.0 / 16, widening = 0.25;  // e₀/c, e₁/c: the film is never thinner than 0.15 (c + e₁)
  constexpr std::array distances = {0.4, 0.9, 1 + 0.25 * blend, 1 + 0.7 * blend, 1 + 1.5 * blend};
  static_assert(distances.size() == finite_ratios.size());
  for (State& s : states) {
    const Vector2<double> e(s.ex, s.ey);
    const double ratio = norm(e) / s.clearance;
    const auto nearest = std::ranges::min_element(finite_ratios, {}, [&](double x) { return std::abs(x - ratio); });
    const auto place = static_cast<std::size_t>(nearest - finite_ratios.begin());
    const double farther = distances[place] / *nearest;  // the rates keep their sizes over ε
    s.ex *= farther;
    s.ey *= farther;
    s.vx *= farther;
    s.vy *= farther;
    s.e0 = blend * s.clearance;
    s.e1 = widening * s.clearance;
    s.restitution = 0.3 + 0.1 * static_cast<double>(place);
    s.impact_speed = 50 * s.clearance;  // about half of the squeeze's
    s.contact_stiffness = 200 * scale_of(s) / std::pow(s.e0, 1.5);
  }
  return states;
}

[[noreturn]] void refuse(Quantities quantities, const FiniteClaim& claim, const std::string& why) {
  throw std::invalid_argument("--quantities " + std::string(name_of(quantities)) + " is not judged for " +
                              std::string(oracle::name_of(claim.film)) + ": " + why);
}

void require(const FiniteClaim& claim, Quantities quantities) {
  if (quantities == Quantities::dimensionless || quantities == Quantities::contact || is_finite_force(quantities)) {
    refuse(quantities, claim, "allowed are " + std::string(quantities_of_solved_films));
  }
  if (quantities == Quantities::extent && claim.film == FiniteFilm::finite_reynolds) {
    refuse(quantities, claim,
           "where it begins and ends is another angle at every place along the bearing; allowed is pressure, or extent "
           "with finite_full, finite_half and finite_dynamic");
  }
  const bool of_steady_onset = quantities != Quantities::coefficients && quantities != Quantities::losses;
  if (claim.onset == FilmOnset::maximum_film && !of_steady_onset) {
    throw std::invalid_argument("an onset at the maximum film is pinned in steady rotation alone, and " +
                                std::string(name_of(quantities)) +
                                " ask for films in squeeze; allowed with it are cartesian, polar, wrench, transition, "
                                "pressure and equilibrium");
  }
}

std::vector<State> states_for(Quantities quantities) {
  if (is_of_load(quantities)) return loads();
  if (quantities == Quantities::transition) return transitions();
  std::vector<State> states = finite_states(is_polar(quantities) ? Quantities::polar : Quantities::cartesian);
  if (quantities == Quantities::wrench) add_arms(states);
  if (quantities == Quantities::pressure) add_places(states);
  return states;
}

}  // namespace

std::vector<State> solved_film_states(const FiniteClaim& claim, Quantities quantities, const Conjunction& domain,
                                      ShearExtent shear, unsigned threads) {
  require(claim, quantities);
  std::vector<State> states = states_for(quantities);
  std::erase_if(states, [&domain](const State& state) { return !holds(domain, state); });
  if (states.empty()) {
    throw std::invalid_argument("no state of a film of finite length has " + words(domain) +
                                "; allowed is a domain that holds one of them");
  }
  const auto films = solved_films(claim.onset, threads);
  for (State& state : states) {
    state.films = films;
    state.shear = shear;
  }
  return states;
}

}  // namespace lubjoint::verify
