#include "oracle/certified/golden_states.hpp"

#include <cmath>

namespace lubjoint::certified {

namespace {

constexpr std::array<std::array<double, 2>, 8> directions = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 0.5}, {0.75, -1}, {-2, 1}, {-0.5, -0.25}}};

}  // namespace

double Draw::size(int binary_decades) {
  const double mantissa = 1 + part();
  const int exponent = static_cast<int>(part() * binary_decades) - binary_decades / 2;
  const double sign = part() < 0.5 ? -1 : 1;
  return sign * std::ldexp(mantissa, exponent);  // exact
}

std::vector<PolarState> polar_states() {
  std::vector<PolarState> states;
  const auto all_directions = [&](double epsilon) {
    for (const auto& [a, b] : directions) states.push_back({epsilon, 50 * a, 50 * b});
  };
  for (const double epsilon : {0.0, 0.05, 0.125, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99}) {
    all_directions(epsilon);
  }
  for (const double epsilon : {1e-300, 1e-200, 1e-100, 1e-30, 1e-16, 1e-8, 1e-4, 0.01}) all_directions(epsilon);
  for (const double gap : {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) all_directions(1 - gap);
  for (const double epsilon : {0.25, 0.75, 0.96875}) {
    for (const double small : {1e-2, 1e-5, 1e-9, 1e-16, 1e-100}) {
      for (const double sign : {1.0, -1.0}) {
        states.push_back({epsilon, 100, sign * small});  // beside b = 0, where Pinkus-Sternlicht is only once smooth
        states.push_back({epsilon, -100, sign * small});
        states.push_back({epsilon, sign * small, 50});  // beside a = 0, where half films jump
        states.push_back({epsilon, sign * small, -50});
      }
    }
    states.push_back({epsilon, 0, 0});
  }
  states.push_back({0, 0, 0});
  for (const double rate : {1e-150, 1e-12, 1e12, 1e150}) {
    states.push_back({0.5, rate, rate});
    states.push_back({0.875, -rate, -rate});
  }
  Draw draw(20090501);
  for (int i = 0; i < 100; ++i) {
    double epsilon = draw.part();
    // One draw a statement: in what order a compiler evaluates the arguments of a call is its own affair.
    const auto small = [&](int binary_decades) {
      const int exponent = -3 - static_cast<int>(binary_decades * draw.part());
      return std::ldexp(1 + draw.part(), exponent);
    };
    if (i % 4 == 1) epsilon = 1 - small(30);
    if (i % 4 == 2) epsilon = small(60);
    states.push_back({epsilon, draw.size(24), draw.size(24)});
  }
  return states;
}

std::vector<WrenchState> wrench_states() {
  std::vector<WrenchState> states;
  const JointArms plain{0.125, -0.0625, -0.25, 0.03125};
  const auto add = [&](const BearingValues& values, double omega_i, double omega_j, double ex, double ey, double vx,
                       double vy, const JointArms& arms) {
    const double c = values.clearance;
    states.push_back(
        {{values.viscosity, values.length, values.radius, c, omega_i, omega_j, ex * c, ey * c, vx * c, vy * c}, arms});
  };
  for (const BearingValues& values : bearings) {
    // Concentric: at rest, and leaving the centre.
    add(values, 3, 50, 0, 0, 0, 0, plain);
    add(values, 0, 50, 0, 0, 1.5, -2, plain);
    // Steady: the journal turns, then the bearing, then both as one body (no film force but for e turning with them).
    add(values, 0, 50, 0.5, 0, 0, 0, plain);
    add(values, 50, 0, 0.5, 0, 0, 0, plain);
    add(values, 20, 20, 0, -0.75, 0, 0, plain);
    add(values, 0, -50, -0.25, 0.125, 0, 0, plain);
    // Whirl at half the speed: the wedge vanishes exactly. Then pure squeeze, closing and opening.
    add(values, 0, 50, 0.5, 0, 0, 12.5, plain);
    add(values, 0, 0, 0.5, 0.25, 4, 2, plain);
    add(values, 0, 0, 0.5, 0.25, -4, -2, plain);
    // Near-concentric and thin.
    add(values, 5, 60, 1e-280, -2e-280, 1, 2, plain);
    add(values, 5, 60, 1e-9, 1e-10, -3, 2, plain);
    add(values, 0, 60, 0.75, 0.66, 2, 1, plain);
    add(values, 0, 60, -0.99999, 0, -2, 1, plain);
    add(values, 0, 60, 0, 0.99999999, 1, -2, plain);
    add(values, 0, 60, 0.5, 0.5, 1, 1, {0, 0, 0, 0});
  }
  Draw draw(1886);
  for (int i = 0; i < 45; ++i) {
    const BearingValues& values = bearings[static_cast<std::size_t>(i) % bearings.size()];
    double x = 1;
    double y = 1;
    while (x * x + y * y > 0.98) {
      x = draw.sign_part();
      y = draw.sign_part();
    }
    const double omega_i = 300 * draw.sign_part();
    const double omega_j = 300 * draw.sign_part();
    const double vx = 100 * draw.sign_part();
    const double vy = 100 * draw.sign_part();
    const JointArms arms{draw.sign_part(), draw.sign_part(), draw.sign_part(), draw.sign_part()};
    add(values, omega_i, omega_j, x, y, vx, vy, arms);
  }
  return states;
}

std::vector<TransitionState> transition_states() {
  // c = 5 · 2^-15 m and directions of (3, 4)/5: |e| = c and |e| = c + e₀ hold exactly in doubles.
  constexpr double unit = 0x1p-15;
  constexpr double c = 5 * unit;
  const ContactState smooth{unit / 2, unit, 1e11, 0.5, 0.125};
  std::vector<TransitionState> states;
  const auto add = [&](double size, double x, double y, const std::array<double, 2>& v, const ContactState& contact) {
    states.push_back({{0.375, 0.03125, 0.015625, c, 2, 50, size * x, size * y, v[0], v[1]}, contact});
  };
  constexpr double tiny = 0x1p-40;
  const std::array<double, 11> sizes = {0.5, 0.9, 1 - tiny, 1, 1 + tiny, 1.025, 1.05, 1.0999, 1.1 - tiny, 1.125, 1.25};
  const std::array<std::array<double, 2>, 4> velocities = {
      {{0.0625, 0.03125}, {-0.0625, -0.125}, {0, 0}, {0.5, -0.25}}};
  for (const auto& v : velocities) {
    for (const double size : sizes) add(5 * unit * size, 0.6, 0.8, v, smooth);
    for (const double part : {1.0, 1 + tiny}) {
      add(unit * part, 3, -4, v, smooth);        // |e| = c exactly, and a little more
      add(unit * 1.1 * part, -5, 0, v, smooth);  // |e| = c + e₀ but for the rounding of 1.1
      add(unit * 5.5 * part, 0, 1, v, smooth);   // |e| = c + e₀ exactly, and a little more
    }
  }
  // Separation so fast that the bracket is negative: no adhesion. Soft, elastic and grazing contact.
  add(6 * unit, 1, 0, {-1, 0}, {unit / 2, unit, 1e11, 0.5, 0.125});
  add(5.25 * unit, 1, 0, {-1, 0.25}, {unit / 2, unit, 1e11, 0.5, 0.125});
  add(5.25 * unit, 0, 1, {0.25, 0.0625}, {unit / 2, unit, 1e6, 0.9, 1e-3});
  add(5.25 * unit, 0, -1, {0.25, -0.0625}, {unit / 2, unit, 6.61e10, 1, 0.5});
  add(5.25 * unit, -1, 0, {0, 0.25}, {unit, 4 * unit, 6.61e10, 0, 0.5});
  return states;
}

std::vector<EquilibriumState> equilibrium_states() {
  std::vector<EquilibriumState> states;
  for (const BearingValues& values : bearings) {
    const auto& [viscosity, length, radius, clearance] = values;
    for (const double load : {1e-6, 1.0, 31.2753, 1e3, 1e5}) {
      states.push_back({viscosity, length, radius, clearance, 52.35987755982989, 0, -load});
    }
    states.push_back({viscosity, length, radius, clearance, -200, 30, 40});
    states.push_back({viscosity, length, radius, clearance, 1000, -12, 5});
  }
  return states;
}

std::vector<LoadedJournal> loaded_journals() {
  std::vector<LoadedJournal> journals;
  for (const BearingValues& values : bearings) {
    const auto& [viscosity, length, radius, clearance] = values;
    for (const double load : {0.01, 31.2753, 1e4}) {
      for (const double omega : {52.35987755982989, -400.0}) {
        journals.push_back({viscosity, length, radius, clearance, omega, load});
      }
    }
  }
  return journals;
}

}  // namespace lubjoint::certified
