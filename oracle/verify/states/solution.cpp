#include "oracle/verify/states/solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/verify/states/film_terms.hpp"
#include "oracle/verify/states/solved_films.hpp"
#include "oracle/verify/states/steady_slopes.hpp"

namespace lubjoint::verify {

namespace {

constexpr Real turn_half = boost::math::constants::pi<Real>();

void read(Solution& s, const State& state) {
  s.viscosity = state.viscosity;
  s.length = state.length;
  s.radius = state.radius;
  s.clearance = state.clearance;
  s.omega_bearing = state.omega_bearing;
  s.omega_journal = state.omega_journal;
  s.e = Plane(state.ex, state.ey);
  s.v = Plane(state.vx, state.vy);
  s.polar_ratio = state.eccentricity_ratio;
  s.polar_squeeze = state.squeeze_rate;
  s.polar_omega = state.omega;
  s.polar_attitude = state.attitude_rate;
  s.arm_bearing = Plane(state.sx_i, state.sy_i);
  s.arm_journal = Plane(state.sx_j, state.sy_j);
  s.theta = state.theta;
  s.z = state.z;
  s.rest.load = state.load;
  if (is_of_load(s.quantities)) s.omega_journal = state.omega;
  s.costs.shear = state.shear;
  s.films = state.films.get();
  if (s.quantities != Quantities::transition && s.quantities != Quantities::contact) return;
  if (s.quantities == Quantities::transition) {
    s.e0 = state.e0;
    s.e1 = state.e1;
    s.film_widening = s.e1;
  }
  s.stiffness = state.contact_stiffness;
  s.restitution = state.restitution;
  s.impact_speed = state.impact_speed;
}

void find_kinematics(Solution& s) {
  if (is_polar(s.quantities)) {
    s.ratio = s.polar_ratio;
    s.ratio_gap = 1 - s.polar_ratio;
    s.b = s.polar_squeeze;
    s.spin_part = s.ratio * s.polar_omega;
    s.attitude_part = -2 * s.ratio * s.polar_attitude;
    return;
  }
  const Real distance = std::hypot(s.e.x(), s.e.y());
  const bool centred = distance == 0;
  const Plane& along = centred ? s.v : s.e;  // at e = 0 the radial direction is that of the velocity
  if (!is_zero(along)) s.r = direction(along);
  s.t = perpendicular(s.r);
  s.ratio = distance / s.film_clearance;
  s.ratio_gap = (s.film_clearance - distance) / s.film_clearance;
  s.b = dot(s.v, s.r) / s.film_clearance;
  s.spin_part = s.ratio * (s.omega_bearing + s.omega_journal);
  s.attitude_part = centred ? Real(0) : -2 * dot(s.v, s.t) / s.film_clearance;
}

/// Normal force of the contact, before it is kept from pulling.
void find_contact(Solution& s) {
  const bool alone = s.quantities == Quantities::contact;
  if (s.quantities != Quantities::transition && !alone) return;
  const Real distance = std::hypot(s.e.x(), s.e.y());
  s.penetration = distance - s.clearance;
  s.penetration_rate = dot(s.v, s.r);
  s.loss = contact_loss(alone ? s.law : "lankarani_nikravesh"_law, s.restitution) / s.impact_speed;
  const Real depth = std::max(s.penetration, Real(0));
  s.normal = std::max(s.stiffness * depth * std::sqrt(depth) * (1 + s.loss * s.penetration_rate), Real(0));
  s.of_dry = alone ? Real(1) : std::clamp((distance - s.clearance) / s.e0, Real(0), Real(1));
}

void find_total(Solution& s) {
  s.force = Plane(s.radial * s.r.x() + s.tangential * s.t.x(), s.radial * s.r.y() + s.tangential * s.t.y());
  if (s.quantities != Quantities::transition && s.quantities != Quantities::contact) return;
  // Weights of zero switch a part off, also where the film does not exist.
  const Plane film = s.of_dry == 1 ? Plane(0, 0) : Plane(s.force * (1 - s.of_dry));
  const Plane dry = s.of_dry == 0 ? Plane(0, 0) : Plane(s.r * (-s.of_dry * s.normal));
  s.force = film + dry;
}

void find_moments(Solution& s) {
  s.moment_bearing = -cross(s.arm_bearing, s.force) - s.reaction_arm * cross(s.e, s.force);
  s.moment_journal = cross(s.arm_journal, s.force);
}

SteadySlopes slopes_at(const Solution& s, Real ratio, Real gap) {
  return is_solved_film(s.law) ? s.films->slopes(s.law, s.shape, ratio) : published_slopes(s.law, ratio, gap);
}

}  // namespace

void Solution::scale_lengths(Real factor) {
  for (Real* x : {&length, &z, &radius, &clearance, &film_widening, &e0, &e1, &impact_speed}) *x *= factor;
  for (Plane* x : {&e, &v, &arm_bearing, &arm_journal}) *x *= factor;
}

Real contact_loss(Law law, Real c) {
  if (law == "hunt_crossley"_law) return 3 * (1 - c) / 2;
  if (law == "flores"_law) return 8 * (1 - c) / (5 * c);
  if (law != "gonthier"_law) return 3 * (1 - c) * (1 + c) / 4;
  if (c == 1) return 0;
  // log1p(d/c) − log1p(−d) − d(1 + 1/c) begins like −d²(1/c² − 1)/2 and ends at +∞: one root in between.
  const auto excess = [=](Real d) { return std::log1p(d / c) - std::log1p(-d) - d * (1 + 1 / c); };
  Real low = 0, high = 1;
  while (true) {
    const Real middle = (low + high) / 2;
    if (middle == low || middle == high) return high / c;
    (excess(middle) > 0 ? high : low) = middle;
  }
}

void find_rest(Solution& s) {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real wanted = s.rest.load / (s.scale * std::abs(s.rest.spin));
  RestPlace place{nan, nan};
  // A full film has no radial force there to carry a load with.
  if (has_rest(s.law) && !(s.rest.radial_alone && is_full(s.law))) {
    place = place_under_load(
        [&](Real ratio, Real gap) {
          SteadySlopes f = slopes_at(s, ratio, gap);
          if (s.rest.radial_alone) f.tangential = 0;
          return f;
        },
        wanted);
  }
  const bool is_known =
      !is_solved_film(s.law) || (place.ratio >= SolvedFilms::least_ratio && place.ratio <= SolvedFilms::largest_ratio);
  s.ratio = is_known ? place.ratio : nan;
  s.ratio_gap = is_known ? place.gap : nan;
}

void find_polar_coefficients(Solution& s) {
  const Real spin = std::abs(s.rest.spin);
  s.rest.polar = polar_coefficients(s.rest.slopes, s.ratio, s.rest.spin < 0 ? -1 : 1);
  for (Real& k : s.rest.polar.stiffness) k *= s.scale * spin / s.film_clearance;
  for (Real& c : s.rest.polar.damping) c *= s.scale / s.film_clearance;
}

void find_inertial_coefficients(Solution& s) {
  const SteadySlopes& f = s.rest.slopes;
  s.rest.attitude = std::atan2(f.tangential, -f.radial);
  const Real size = f.size(), cosine = -f.radial / size;
  const Real sine = (s.rest.spin < 0 ? -1 : 1) * f.tangential / size;
  s.rest.stiffness = in_inertial_axes(s.rest.polar.stiffness, sine, cosine);
  s.rest.damping = in_inertial_axes(s.rest.polar.damping, sine, cosine);
}

Solution solve(Quantities quantities, Law law, const State& state, std::span<const Change> changes) {
  Solution s;
  s.quantities = quantities;
  s.law = law;
  const auto after = [&](Step step) {
    for (const Change& change : changes) {
      if (change.step == step) change.apply(s);
    }
  };
  read(s, state);
  after(Step::inputs);
  s.film_clearance = s.clearance + s.film_widening;
  s.shape = s.length / (2 * s.radius);
  after(Step::shape);
  const auto find_scale = [&] {
    const Real size = is_short(s.law) ? s.length : s.radius;
    s.scale = s.viscosity * s.length * s.radius * (size / s.film_clearance) * (size / s.film_clearance);
    after(Step::scale);
  };
  if (is_of_load(quantities)) {
    find_scale();
    s.rest.spin = s.omega_journal - s.omega_bearing;
    find_rest(s);
    after(Step::kinematics);
    s.rest.slopes = slopes_at(s, s.ratio, s.ratio_gap);
    after(Step::terms);
    find_polar_coefficients(s);
    after(Step::film);
    find_inertial_coefficients(s);
    after(Step::total);
    s.answer = {s.ratio, s.rest.attitude};
    if (quantities == Quantities::coefficients) {
      std::ranges::copy(s.rest.stiffness, s.answer.begin() + 2);
      std::ranges::copy(s.rest.damping, s.answer.begin() + 6);
    }
    after(Step::answer);
    return s;
  }
  find_kinematics(s);
  after(Step::kinematics);
  if (quantities == Quantities::contact) {
    find_contact(s);
    after(Step::contact);
    find_total(s);
    after(Step::total);
    s.answer = {s.force.x(), s.force.y()};
    after(Step::answer);
    return s;
  }
  s.a = s.spin_part + s.attitude_part;
  after(Step::rates);
  if (facts_of(s.law).squeeze_only) s.a = 0;
  if (quantities == Quantities::extent || quantities == Quantities::pressure) {
    find_extent(s);
    if (quantities == Quantities::pressure) {
      if (is_solved_film(s.law)) find_scale();
      find_pressure(s);
    }
    s.answer = {quantities == Quantities::extent ? s.theta_s : s.pressure,
                quantities == Quantities::extent ? s.theta_e : 0, 0, 0};
    after(Step::answer);
    return s;
  }
  find_terms(s);
  after(Step::terms);
  find_scale();
  s.radial = s.scale * (s.radial_wedge + s.radial_squeeze);
  s.tangential = s.scale * (s.tangential_wedge + s.tangential_squeeze);
  if (s.pulls) s.radial = -s.radial, s.tangential = -s.tangential;
  after(Step::film);
  find_contact(s);
  after(Step::contact);
  find_total(s);
  after(Step::total);
  if (quantities == Quantities::losses) {
    find_costs(s);
    after(Step::moments);
    s.answer = {s.costs.torque_journal, s.costs.torque_bearing, s.costs.power, s.costs.side_flow};
    after(Step::answer);
    return s;
  }
  find_moments(s);
  after(Step::moments);
  s.answer = {s.force.x(), s.force.y(), s.moment_bearing, s.moment_journal};
  after(Step::answer);
  return s;
}

Real size_of_terms(const Solution& s) {
  if (s.quantities == Quantities::contact) {
    const Real depth = std::max(s.penetration, Real(0));
    return s.stiffness * depth * std::sqrt(depth) * (1 + std::abs(s.loss * s.penetration_rate));
  }
  if (s.quantities == Quantities::extent) return turn_half;
  if (s.quantities == Quantities::pressure) return s.pressure_terms;
  const Real film = s.scale * size_of_film_terms(s);
  if (s.quantities != Quantities::transition) return film;
  return (s.of_dry == 1 ? 0 : (1 - s.of_dry) * film) + s.of_dry * s.normal;
}

}  // namespace lubjoint::verify
