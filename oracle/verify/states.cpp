#include "oracle/verify/states.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "oracle/verify/golden_states.hpp"
#include "oracle/verify/single_precision.hpp"
#include "oracle/verify/solution.hpp"

namespace lubjoint::verify {

namespace {

/// Numbers of a seeded generator that are the same on every machine (the standard's distributions are not).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}
  double unit() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  double decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  double sign() { return unit() < 0.5 ? -1 : 1; }
  double between_of_any_sign(double low, double high) {
    const double side = sign();  // drawn first: the order of a product's factors is the compiler's affair
    return side * between(low, high);
  }

 private:
  std::mt19937_64 generator_;
};

State bearing_of(Draw& draw) {
  State s;
  s.viscosity = in_single(draw.decades(1e-3, 1));
  s.radius = in_single(draw.decades(2e-3, 0.1));
  s.length = in_single(s.radius * draw.decades(0.3, 5));
  s.clearance = in_single(s.radius * draw.decades(1e-3, 2e-2));
  s.sx_i = in_single(draw.between(-0.2, 0.2));
  s.sy_i = in_single(draw.between(-0.2, 0.2));
  s.sx_j = in_single(draw.between(-0.2, 0.2));
  s.sy_j = in_single(draw.between(-0.2, 0.2));
  s.e0 = in_single(s.clearance * draw.between(0.01, 0.1));
  s.e1 = in_single(s.e0 * draw.between(2, 5));
  s.contact_stiffness = in_single(draw.decades(1e8, 1e11));
  s.restitution = in_single(draw.between(0.2, 0.95));
  s.impact_speed = in_single(draw.decades(1e-2, 1));
  do {
    s.theta = in_single(draw.between(0, 2 * std::numbers::pi));
  } while (std::abs(std::sin(s.theta)) < 1e-3);  // the short half film's pressure jumps at its ends
  s.z = in_single(draw.between(-0.5, 0.5) * s.length);
  return s;
}

/// The motion with these polar numbers. Spins differ in size and sign, so that no mistake about them hides.
void set_motion(State& s, double ratio, double a, double b, Draw& draw) {
  const double size = std::abs(a) + std::abs(b) + 1;
  s.omega_bearing = in_single(size * draw.between_of_any_sign(0.2, 1));
  s.omega_journal = in_single(size * draw.between_of_any_sign(1.2, 3));
  s.eccentricity_ratio = in_single(ratio);
  s.squeeze_rate = in_single(b);
  s.omega = in_single(size * draw.between_of_any_sign(0.5, 3));
  if (ratio > 0) s.attitude_rate = in_single((s.omega - a / s.eccentricity_ratio) / 2);
  const double angle = draw.between(0, 2 * std::numbers::pi);
  const double r[2] = {std::cos(angle), std::sin(angle)};
  const double slide = (ratio * (s.omega_bearing + s.omega_journal) - a) * s.clearance / 2;
  s.ex = in_single(ratio * s.clearance * r[0]);
  s.ey = in_single(ratio * s.clearance * r[1]);
  s.vx = in_single(b * s.clearance * r[0] - slide * r[1]);
  s.vy = in_single(b * s.clearance * r[1] + slide * r[0]);
}

/// Pure squeeze: no spin, motion along the x axis, so that a is zero in any order of operations.
void set_squeeze(State& s, double ratio, double b) {
  s.omega_bearing = s.omega_journal = s.omega = s.attitude_rate = 0;
  s.eccentricity_ratio = in_single(ratio);
  s.squeeze_rate = in_single(b);
  s.ex = in_single(ratio * s.clearance);
  s.vx = in_single(b * s.clearance);
  s.ey = s.vy = 0;
}

/// True where a is too near to zero, against the parts that it is the sum of, for its sign to survive rounding.
bool sign_is_doubtful(Quantities quantities, const State& state) {
  const Solution s = solve(quantities, Law::short_full, state);
  return s.a != 0 && std::abs(s.a) < 1e-3L * (std::abs(s.spin_part) + std::abs(s.attitude_part));
}

/// A turning frame hides a pure squeeze: ω_B + ω_J and 2γ̇ are equal powers of two times the same number.
State turning_squeeze(State s) {
  set_squeeze(s, 0.5, 3);
  s.omega_journal = 64;
  s.vy = 32 * s.ex;
  s.omega = 64;
  s.attitude_rate = 32;
  return s;
}

void add_contact(std::vector<State>& states, Draw& draw) {
  for (const double depth : {0.0, 0.1, 0.5, 0.9, 1.0, 1.5, 4.0}) {
    for (const double part : {-6.0, -0.5, 0.0, 0.5, 2.0}) {
      State s = bearing_of(draw);
      const double b = part * s.impact_speed / s.clearance;
      const double ratio = 1 + depth * s.e0 / s.clearance;
      set_motion(s, ratio, draw.sign() * 30, b, draw);
      if (depth == 0 || depth == 1) {  // on the seams themselves
        s.ex = depth == 0 ? s.clearance : in_single(s.clearance + s.e0);
        s.ey = 0;
      }
      if (!sign_is_doubtful(Quantities::transition, s)) states.push_back(s);
    }
  }
}

}  // namespace

Regime regime_of(Quantities quantities, const State& state) {
  const Solution s = solve(quantities, Law::short_full, state);
  const double distance = std::hypot(state.ex, state.ey);
  if (quantities == Quantities::transition && distance > state.clearance) return Regime::contact;
  const Real ratio = is_polar(quantities) ? s.ratio : distance / state.clearance;
  if (ratio < 0.05L) return Regime::near_concentric;
  if (ratio > 0.9L) return Regime::thin_film;
  if (s.b < 0) return Regime::separating;
  return s.a < 0 ? Regime::reversing : Regime::moderate;
}

std::vector<State> designed_states(Quantities quantities) {
  Draw draw(20090409);
  std::vector<State> states;
  for (const double ratio : {1e-6, 1e-3, 0.02, 0.1, 0.3, 0.5, 0.7, 0.85, 0.95, 0.99, 0.999, 0.9999}) {
    for (const double a : {-40.0, -2.0, 2.0, 40.0}) {
      for (const double b : {-30.0, -1.0, 0.0, 1.0, 30.0}) {
        State s = bearing_of(draw);
        do {
          set_motion(s, ratio, a, b, draw);
        } while (sign_is_doubtful(quantities, s));
        states.push_back(s);
      }
    }
    for (const double b : {-5.0, 5.0}) {
      State s = bearing_of(draw);
      set_squeeze(s, ratio, b);
      states.push_back(s);
    }
  }
  states.push_back(turning_squeeze(bearing_of(draw)));
  State rest = bearing_of(draw);
  set_squeeze(rest, 0, 0);
  states.push_back(rest);  // centred, at rest: where most simulations start
  set_squeeze(rest, 0.5, 0);
  states.push_back(rest);
  set_squeeze(rest, 0, 2);
  states.push_back(rest);  // leaves the centre
  if (quantities == Quantities::transition) add_contact(states, draw);
  return states;
}

std::vector<State> states_to_verify(Quantities quantities, const std::filesystem::path& golden, std::size_t random,
                                    std::uint64_t seed) {
  std::vector<State> states = golden_states(quantities, golden);
  for (State& state : designed_states(quantities)) states.push_back(std::move(state));
  Draw draw(seed);
  const std::size_t all = states.size() + random;
  while (states.size() < all) {
    State s = bearing_of(draw);
    const double kind = draw.unit();
    double ratio = draw.between(0.05, 0.9);
    if (kind < 0.15) ratio = draw.decades(1e-6, 0.05);
    if (kind > 0.8) ratio = 1 - draw.decades(1e-4, 0.1);
    const double direction = draw.between(0, 2 * std::numbers::pi);
    const double size = draw.decades(0.1, 300);
    double b = size * std::sin(direction);
    if (quantities == Quantities::transition && draw.unit() < 0.3) {
      ratio = 1 + draw.between(0, 2) * s.e0 / s.clearance;
      b = draw.between(-6, 3) * s.impact_speed / s.clearance;  // fast enough for the contact's loss to show
    }
    set_motion(s, ratio, 2 * size * std::cos(direction), b, draw);
    if (!sign_is_doubtful(quantities, s)) states.push_back(s);
  }
  return states;
}

}  // namespace lubjoint::verify
