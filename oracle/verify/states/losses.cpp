// Torques, power and flow the way programs have them.
#include <cmath>
#include <limits>

#include "oracle/verify/states/solution.hpp"
#include "oracle/verify/states/solved_films.hpp"

namespace lubjoint::verify {

namespace {

/// ∫dθ/H over the part of the gap that is sheared.
Real couette_integral(const Solution& s) {
  const Real half_turn = pi<Real>(), root = std::sqrt(s.q());
  if (s.costs.shear == ShearExtent::flooded || is_full(s.law)) return 2 * half_turn / root;
  if (s.costs.shear == ShearExtent::striated) return half_turn / root * (1 + 1 / (1 + s.ratio));
  if (is_half(s.law) || (s.a == 0 && s.b == 0)) return half_turn / root;
  if (s.law == "finite_reynolds"_law) return s.moving_costs.couette_integral;
  return 2 / root * std::atan2(root, -s.ratio * 2 * s.b / std::hypot(s.a, 2 * s.b));
}

/// ∫(a sinθ − 2b cosθ)dθ/2 over the film, which a short bearing loses; of a real length what leaves by its ends.
Real flow_ratio(const Solution& s) {
  if (is_solved_film(s.law)) return s.moving_costs.side_flow;
  if (is_full(s.law)) return 0;
  return is_half(s.law) ? std::abs(s.a) : std::hypot(s.a, 2 * s.b);
}

}  // namespace

void find_costs(Solution& s) {
  Costs& c = s.costs;
  if (is_solved_film(s.law)) s.moving_costs = s.films->costs(s.law, s.shape, s.ratio, s.a, s.b);
  c.relative_spin = s.omega_journal - s.omega_bearing;
  c.couette_integral = couette_integral(s);
  c.couette_rate = s.viscosity * s.length * s.radius * s.radius * (s.radius / s.film_clearance) * c.couette_integral;
  c.couette = c.couette_rate * c.relative_spin;
  c.moment = s.ratio * s.film_clearance * s.tangential;
  c.torque_journal = -c.couette - c.moment / 2;
  c.torque_bearing = c.couette - c.moment / 2;
  c.squeeze_power = -s.film_clearance * (s.radial * s.b - s.tangential * s.a / 2);
  c.power = c.relative_spin * c.couette + c.squeeze_power;
  c.side_flow = loses_oil_by_its_sides(s.law) ? s.film_clearance * s.radius * s.length * flow_ratio(s)
                                              : std::numeric_limits<Real>::quiet_NaN();
}

std::array<Real, 4> size_of_costs(const Solution& s) {
  const Real force = std::hypot(s.radial, s.tangential), e = s.ratio * s.film_clearance;
  const Real torque = std::abs(s.costs.couette) + e * force / 2;
  const Real power =
      std::abs(s.costs.relative_spin * s.costs.couette) + s.film_clearance * force * std::hypot(s.b, s.a / 2);
  const Real flow = std::hypot(std::abs(s.spin_part) + std::abs(s.attitude_part), 2 * s.b);
  return {torque, torque, power, s.film_clearance * s.radius * s.length * flow};
}

}  // namespace lubjoint::verify
