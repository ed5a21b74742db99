#include "oracle/verify/states/states.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "oracle/verify/states/golden_states.hpp"
#include "oracle/verify/states/single_precision.hpp"
#include "oracle/verify/states/solution.hpp"
#include "oracle/verify/states/steady_slopes.hpp"

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

/// The eccentricity's numbers: exact in single precision, but for films so thin that they are not there.
double of_film(double x, double gap) { return gap > 0 && gap < 5e-5 ? x : in_single(x); }

/// The motion with these polar numbers. Spins differ in size and sign, so that no mistake about them hides.
void set_motion(State& s, double gap, double a, double b, Draw& draw) {
  const double ratio = 1 - gap;
  const double size = std::abs(a) + std::abs(b) + 1;
  s.omega_bearing = in_single(size * draw.between_of_any_sign(0.2, 1));
  s.omega_journal = in_single(size * draw.between_of_any_sign(1.2, 3));
  s.eccentricity_ratio = of_film(ratio, gap);
  s.squeeze_rate = in_single(b);
  s.omega = in_single(size * draw.between_of_any_sign(0.5, 3));
  if (ratio > 0) s.attitude_rate = in_single((s.omega - a / s.eccentricity_ratio) / 2);
  const double angle = draw.between(0, 2 * std::numbers::pi);
  const double r[2] = {std::cos(angle), std::sin(angle)};
  const double slide = (ratio * (s.omega_bearing + s.omega_journal) - a) * s.clearance / 2;
  s.ex = of_film(ratio * s.clearance * r[0], gap);
  s.ey = of_film(ratio * s.clearance * r[1], gap);
  s.vx = in_single(b * s.clearance * r[0] - slide * r[1]);
  s.vy = in_single(b * s.clearance * r[1] + slide * r[0]);
}

/// Directions along which the parts of a motion are zero in any order of operations: the axes and the diagonals.
struct ExactDirection {
  int x, y;
};
constexpr ExactDirection exact_directions[] = {{1, 0}, {-1, -1}, {0, 1}, {-1, 0}, {1, 1}, {0, -1}, {-1, 1}, {1, -1}};

/// A motion of which some parts are exactly zero: e along a direction of the list, v = (along, across) to it.
void set_exact(State& s, double gap, ExactDirection r, double along, double across) {
  const double length = r.x != 0 && r.y != 0 ? std::numbers::sqrt2 : 1;
  const double e = of_film((1 - gap) * s.clearance / length, gap);
  const double v_along = in_single(along * s.clearance / length), v_across = in_single(across * s.clearance / length);
  s.omega_bearing = s.omega_journal = s.omega = s.attitude_rate = 0;
  s.eccentricity_ratio = of_film(1 - gap, gap);
  s.squeeze_rate = in_single(along);
  if (across != 0) s.attitude_rate = in_single(across / s.eccentricity_ratio);
  s.ex = r.x * e + 0.0;
  s.ey = r.y * e + 0.0;
  s.vx = r.x * v_along - r.y * v_across + 0.0;  // no −0
  s.vy = r.y * v_along + r.x * v_across + 0.0;
}

/// Pure squeeze: no spin, motion along the x axis.
void set_squeeze(State& s, double ratio, double b) { set_exact(s, 1 - ratio, {1, 0}, b, 0); }

void set_spins(State& s, double bearing, double journal) {
  s.omega_bearing = bearing;
  s.omega_journal = journal;
  s.omega = journal - bearing;
}

/// Steady rotation, whirl, squeeze: each alone, with both signs, in a bearing that rests and in one that turns.
void add_pure_motions(std::vector<State>& states, double gap, std::size_t& turn, Draw& draw) {
  const auto add = [&](double along, double across, double bearing, double journal) {
    State s = bearing_of(draw);
    set_exact(s, gap, exact_directions[turn++ % std::size(exact_directions)], along, across);
    set_spins(s, bearing, journal);
    states.push_back(s);
  };
  for (const double b : {4.0, -4.0}) {  // where half films jump, on the only axis whose angle has an exact sine
    State s = bearing_of(draw);
    set_exact(s, gap, {1, 0}, b, 0);
    states.push_back(s);
  }
  add(0, 0, 0, 60);  // steady, the bearing at rest
  add(0, 0, 0, -25);
  add(0, 0, 0, 7);
  add(0, 0, 40, 15);  // the bearing turns
  add(0, 0, -30, -12);
  add(0, 0, 50, -20);
  add(20, 0, 0, 0);  // squeeze
  add(-20, 0, 0, 0);
  add(3, 0, -16, 16);  // between walls that turn against each other: no wedge
  add(-3, 0, 16, -16);
  add(0, 12, 0, 0);  // whirl
  add(0, -12, 0, 0);
  add(0, 5, -20, 90);  // whirl and spin
  add(0, -5, 20, 45);
}

/// True where a is too near to zero, against the parts that it is the sum of, for its sign to survive rounding.
bool sign_is_doubtful(Quantities quantities, const State& state) {
  const Solution s = solve(quantities, "short_full"_law, state);
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
      set_motion(s, 1 - ratio, draw.sign() * 30, b, draw);
      if (depth == 0 || depth == 1) {  // on the seams themselves
        s.ex = depth == 0 ? s.clearance : in_single(s.clearance + s.e0);
        s.ey = 0;
      }
      if (!sign_is_doubtful(Quantities::transition, s)) states.push_back(s);
    }
  }
}

/// The place of a state, and a motion whose parts are a twentieth of its own, in units of the clearance and of the
/// journal's spin. A state that jumps may lie on its jump: there the part across r is an exact half of x.
State without_dimensions(const State& given) {
  const Solution g = solve(Quantities::cartesian, "short_full"_law, given);
  State s;
  s.clearance = s.omega_journal = 1;
  s.length = s.radius = 2;
  s.viscosity = 1.0 / 16;  // S = 1 of short and of long laws
  const auto gap = static_cast<double>(g.ratio_gap);
  const bool on_axis = g.a == 0 && g.ratio > 0;
  const double rx = on_axis ? (g.r.x() < 0 ? -1 : 1) : static_cast<double>(g.r.x());
  const double ry = on_axis ? 0 : static_cast<double>(g.r.y());
  const auto ratio = static_cast<double>(g.ratio);
  const double along = static_cast<double>(g.b) / 20;
  s.ex = of_film(ratio * rx, gap);
  s.ey = of_film(ratio * ry, gap) + 0.0;
  const double across = on_axis ? std::abs(s.ex) / 2 : (ratio - static_cast<double>(g.a) / 20) / 2;
  const bool centred = ratio == 0;
  s.vx = in_single(along * rx - (centred ? 0 : across * ry)) + 0.0;
  s.vy = in_single(along * ry) + 0.0;
  if (!centred) s.vy = on_axis ? across * rx : in_single(along * ry + across * rx);
  return s;
}

/// A journal in or at its wall: depth over the clearance, rates over the impact speed, along e and across it.
State contact_at(double depth, double along, double across, double angle, Draw& draw) {
  State s = bearing_of(draw);
  const double size = s.clearance * (1 + depth), x = std::cos(angle), y = std::sin(angle);
  s.ex = in_single(size * x);
  s.ey = in_single(size * y);
  s.vx = in_single(s.impact_speed * (along * x - across * y));
  s.vy = in_single(s.impact_speed * (along * y + across * x));
  return s;
}

/// Every quadrant; pressing in, at rest, leaving as slowly and as fast as an impact does, faster than any; inside the
/// clearance, where there is no force.
std::vector<State> designed_contacts() {
  Draw draw(20090411);
  std::vector<State> states;
  for (const double depth : {-0.5, -0.01, 0.003, 0.02, 0.1, 0.5, 3.0}) {
    for (const double along : {-6.0, -0.9, -0.3, 0.0, 0.3, 1.0, 4.0}) {
      for (int quadrant = 0; quadrant < 4; ++quadrant) {
        const double angle = std::numbers::pi / 2 * (quadrant + draw.between(0.1, 0.9));
        const double across = draw.between(-1, 1);
        states.push_back(contact_at(depth, along, across, angle, draw));
      }
    }
  }
  return states;
}

State random_contact(Draw& draw) {
  const bool apart = draw.unit() < 0.1;
  const double depth = apart ? -draw.unit() : draw.decades(1e-3, 1);
  const double along = draw.between(-3, 2), across = draw.between(-2, 2);
  const double angle = draw.between(0, 2 * std::numbers::pi);
  return contact_at(depth, along, across, angle, draw);
}

/// A journal that carries a load, at about this ε by the law's published form; the others answer with another one.
State load_at(Law law, double ratio, double spin, Draw& draw) {
  State s = bearing_of(draw);
  s.omega = in_single(spin * draw.between(0.7, 1.4));
  const SteadySlopes f = published_slopes(law, ratio, 1 - static_cast<Real>(ratio));
  s.load = 1;  // for the scale
  const Solution one = solve(Quantities::equilibrium, law, s);
  s.load = in_single(static_cast<double>(f.size() * one.scale * std::abs(one.rest.spin)));
  return s;
}

/// Loads from the centre to the wall, of short and of long films, both spins.
std::vector<State> designed_loads() {
  Draw draw(20090410);
  std::vector<State> states;
  for (const double ratio :
       {1e-4, 1e-3, 0.01, 0.04, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.93, 0.96, 0.98, 0.99, 0.995}) {
    for (const Law law : {"short_half"_law, "long_half"_law}) {
      for (const double spin : {300.0, -300.0, 40.0, -1500.0}) states.push_back(load_at(law, ratio, spin, draw));
    }
  }
  return states;
}

State random_load(Draw& draw) {
  const Law law = draw.unit() < 0.5 ? "short_half"_law : "long_half"_law;
  const double kind = draw.unit();
  double ratio = draw.between(0.05, 0.95);
  if (kind < 0.15) ratio = draw.decades(1e-5, 0.05);
  if (kind > 0.85) ratio = 1 - draw.decades(2e-3, 0.05);
  return load_at(law, ratio, draw.sign() * draw.decades(10, 3000), draw);
}

/// Losses are asked for where the gap's shear has its digits: an input's rounding leaves few of them in a thinner film.
bool is_asked_for_losses(const State& state) {
  return state.clearance - std::hypot(state.ex, state.ey) >= 5e-5 * state.clearance;
}

}  // namespace

Regime regime_at_rest(Real ratio, double omega) {
  if (ratio < 0.05L) return Regime::near_concentric;
  if (ratio > 0.9L) return Regime::thin_film;
  return omega < 0 ? Regime::reversing : Regime::moderate;
}

Regime regime_of(Quantities quantities, const State& state) {
  if (is_of_load(quantities)) {
    const Solution s = solve(quantities, "short_full"_law, state);
    return regime_at_rest(s.ratio, state.omega);
  }
  const Solution s = solve(quantities, "short_full"_law, state);
  const double distance = std::hypot(state.ex, state.ey);
  if (quantities == Quantities::contact) {
    if (distance <= state.clearance) return Regime::moderate;
    return s.penetration_rate < 0 ? Regime::separating : Regime::contact;
  }
  if (quantities == Quantities::transition && distance > state.clearance) return Regime::contact;
  const Real ratio = is_polar(quantities) ? s.ratio : distance / state.clearance;
  if (ratio < 0.05L) return Regime::near_concentric;
  if (ratio > 0.9L) return Regime::thin_film;
  if (s.b < 0) return Regime::separating;
  return s.a < 0 ? Regime::reversing : Regime::moderate;
}

std::vector<State> designed_states(Quantities quantities) {
  if (quantities == Quantities::contact) return designed_contacts();
  if (is_of_load(quantities)) return designed_loads();
  if (quantities == Quantities::losses) {
    std::vector<State> states = designed_states(Quantities::cartesian);
    std::erase_if(states, [](const State& state) { return !is_asked_for_losses(state); });
    return states;
  }
  if (quantities == Quantities::dimensionless) {
    std::vector<State> states;
    for (const State& each : designed_states(Quantities::cartesian)) {
      const State s = without_dimensions(each);
      if (!sign_is_doubtful(quantities, s) && in_single(s.vy) == s.vy) states.push_back(s);
    }
    return states;
  }
  const bool of_force = is_film_force(quantities);
  Draw draw(20090409);
  std::vector<State> states;
  std::size_t turn = 0;
  const auto add = [&](double gap, double a, double b) {
    State s = bearing_of(draw);
    do {
      set_motion(s, gap, a, b, draw);
    } while (sign_is_doubtful(quantities, s));
    states.push_back(s);
  };
  for (const double ratio : {1e-6, 1e-3, 0.02, 0.1, 0.3, 0.5, 0.7, 0.85, 0.95, 0.99, 0.999, 0.9999}) {
    for (const double a : {-40.0, -2.0, 2.0, 40.0}) {
      for (const double b : {-30.0, -1.0, 0.0, 1.0, 30.0}) add(1 - ratio, a, b);
    }
    if (of_force) {
      add_pure_motions(states, 1 - ratio, turn, draw);
      continue;
    }
    for (const double b : {-5.0, 5.0}) {
      State s = bearing_of(draw);
      set_squeeze(s, ratio, b);
      states.push_back(s);
    }
  }
  if (of_force) {  // each decade towards the wall; where the film opens, published forms lose their digits
    for (const double gap : {3e-5, 3e-6, 3e-7, 3e-8, 3e-10}) {
      for (const double a : {-40.0, -2.0, 2.0, 40.0}) {
        for (const double b : {-30.0, -1.0, 1.0, 30.0}) add(gap, a, b);
      }
      add_pure_motions(states, gap, turn, draw);
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

std::vector<State> covering_states(Quantities quantities, std::vector<State> states, std::size_t most) {
  if (states.size() <= most) return states;
  const auto sign = [](Real x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
  std::map<int, std::map<std::pair<int, int>, std::vector<std::size_t>>> kinds;  // by regime, then by signs
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Solution s = solve(quantities, "short_full"_law, states[i]);
    const std::pair signs = is_of_load(quantities) ? std::pair(sign(s.rest.spin), 0) : std::pair(sign(s.a), sign(s.b));
    kinds[static_cast<int>(regime_of(quantities, states[i]))][signs].push_back(i);
  }
  // Of each kind, its middle, then the middles of both halves, and so on.
  const auto spread = [](const std::vector<std::size_t>& all) {
    std::vector<std::size_t> order;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, all.size()}};
    for (std::size_t next = 0; next < open.size(); ++next) {
      const auto [begin, end] = open[next];
      if (begin == end) continue;
      const std::size_t middle = begin + (end - begin) / 2;
      order.push_back(all[middle]);
      open.emplace_back(begin, middle);
      open.emplace_back(middle + 1, end);
    }
    return order;
  };
  std::vector<std::vector<std::size_t>> by_regime;  // each: its kinds in turn
  for (const auto& [regime, of_signs] : kinds) {
    std::vector<std::vector<std::size_t>> rows;
    for (const auto& [signs, all] : of_signs) rows.push_back(spread(all));
    std::vector<std::size_t> in_turn;
    for (std::size_t round = 0; in_turn.size() < most; ++round) {
      const std::size_t before = in_turn.size();
      for (const auto& row : rows) {
        if (round < row.size()) in_turn.push_back(row[round]);
      }
      if (in_turn.size() == before) break;
    }
    by_regime.push_back(std::move(in_turn));
  }
  std::vector<std::size_t> chosen;
  for (std::size_t round = 0; chosen.size() < most; ++round) {
    for (const auto& row : by_regime) {
      if (round < row.size() && chosen.size() < most) chosen.push_back(row[round]);
    }
  }
  std::ranges::sort(chosen);
  std::vector<State> some;
  some.reserve(chosen.size());
  for (const std::size_t i : chosen) some.push_back(std::move(states[i]));
  return some;
}

std::vector<State> states_to_verify(Quantities quantities, const std::filesystem::path& golden, std::size_t random,
                                    std::uint64_t seed, const Conjunction& domain) {
  std::vector<State> states = golden_states(quantities, golden);
  for (State& state : designed_states(quantities)) states.push_back(std::move(state));
  std::erase_if(states, [&](const State& state) { return !holds(domain, state); });
  Draw draw(seed);
  const bool may_be_thin = is_film_force(quantities);
  const std::size_t all = states.size() + random;
  for (std::size_t tries = 0; states.size() < all && tries < 20 * random; ++tries) {
    if (is_of_load(quantities) || quantities == Quantities::contact) {
      State s = is_of_load(quantities) ? random_load(draw) : random_contact(draw);
      if (holds(domain, s)) states.push_back(std::move(s));
      continue;
    }
    State s = bearing_of(draw);
    const double kind = draw.unit();
    double gap = draw.between(0.1, 0.95);
    if (kind < 0.15) gap = 1 - draw.decades(1e-6, 0.05);
    if (kind > 0.8) gap = draw.decades(kind > 0.9 && may_be_thin ? 1e-9 : 1e-4, 0.1);
    const double direction = draw.between(0, 2 * std::numbers::pi);
    const double size = draw.decades(0.1, 300);
    double b = size * std::sin(direction);
    if (quantities == Quantities::transition && draw.unit() < 0.3) {
      gap = -draw.between(0, 2) * s.e0 / s.clearance;
      b = draw.between(-6, 3) * s.impact_speed / s.clearance;  // fast enough for the contact's loss to show
    }
    set_motion(s, gap, 2 * size * std::cos(direction), b, draw);
    if (quantities == Quantities::dimensionless) s = without_dimensions(s);
    if (quantities == Quantities::losses && !is_asked_for_losses(s)) continue;
    if (!sign_is_doubtful(quantities, s) && holds(domain, s)) states.push_back(s);
  }
  if (states.empty()) {
    throw std::invalid_argument("no state fulfils the domain \"" + words(domain) + "\"; allowed is one that some do");
  }
  return states;
}

}  // namespace lubjoint::verify
