#include "oracle/verify/states/solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/verify/states/film_terms.hpp"

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
  if (s.quantities != Quantities::transition) return;
  s.e0 = state.e0;
  s.e1 = state.e1;
  s.film_widening = s.e1;
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
  if (s.quantities != Quantities::transition) return;
  const Real distance = std::hypot(s.e.x(), s.e.y());
  s.penetration = distance - s.clearance;
  s.penetration_rate = dot(s.v, s.r);
  s.loss = 3 * (1 - s.restitution * s.restitution) / (4 * s.impact_speed);
  const Real depth = std::max(s.penetration, Real(0));
  s.normal = std::max(s.stiffness * depth * std::sqrt(depth) * (1 + s.loss * s.penetration_rate), Real(0));
  s.of_dry = std::clamp((distance - s.clearance) / s.e0, Real(0), Real(1));
}

void find_total(Solution& s) {
  s.force = Plane(s.radial * s.r.x() + s.tangential * s.t.x(), s.radial * s.r.y() + s.tangential * s.t.y());
  if (s.quantities != Quantities::transition) return;
  // Weights of zero switch a part off, also where the film does not exist.
  const Plane film = s.of_dry == 1 ? Plane(0, 0) : Plane(s.force * (1 - s.of_dry));
  const Plane dry = s.of_dry == 0 ? Plane(0, 0) : Plane(s.r * (-s.of_dry * s.normal));
  s.force = film + dry;
}

void find_moments(Solution& s) {
  s.moment_bearing = -cross(s.arm_bearing, s.force) - s.reaction_arm * cross(s.e, s.force);
  s.moment_journal = cross(s.arm_journal, s.force);
}

}  // namespace

void Solution::scale_lengths(Real factor) {
  for (Real* x : {&length, &z, &radius, &clearance, &film_widening, &e0, &e1, &impact_speed}) *x *= factor;
  for (Plane* x : {&e, &v, &arm_bearing, &arm_journal}) *x *= factor;
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
  find_kinematics(s);
  after(Step::kinematics);
  s.a = s.spin_part + s.attitude_part;
  after(Step::rates);
  if (facts_of(s.law).squeeze_only) s.a = 0;
  if (quantities == Quantities::extent || quantities == Quantities::pressure) {
    find_extent(s);
    if (quantities == Quantities::pressure) find_pressure(s);
    s.answer = {quantities == Quantities::extent ? s.theta_s : s.pressure,
                quantities == Quantities::extent ? s.theta_e : 0, 0, 0};
    after(Step::answer);
    return s;
  }
  find_terms(s);
  after(Step::terms);
  const Real size = is_short(s.law) ? s.length : s.radius;
  s.scale = s.viscosity * s.length * s.radius * (size / s.film_clearance) * (size / s.film_clearance);
  after(Step::scale);
  s.radial = s.scale * (s.radial_wedge + s.radial_squeeze);
  s.tangential = s.scale * (s.tangential_wedge + s.tangential_squeeze);
  if (s.pulls) s.radial = -s.radial, s.tangential = -s.tangential;
  after(Step::film);
  find_contact(s);
  after(Step::contact);
  find_total(s);
  after(Step::total);
  find_moments(s);
  after(Step::moments);
  s.answer = {s.force.x(), s.force.y(), s.moment_bearing, s.moment_journal};
  after(Step::answer);
  return s;
}

Real size_of_terms(const Solution& s) {
  if (s.quantities == Quantities::extent) return turn_half;
  if (s.quantities == Quantities::pressure) return s.pressure_terms;
  const Real film = s.scale * size_of_film_terms(s);
  if (s.quantities != Quantities::transition) return film;
  return (s.of_dry == 1 ? 0 : (1 - s.of_dry) * film) + s.of_dry * s.normal;
}

}  // namespace lubjoint::verify
