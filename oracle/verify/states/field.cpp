// Where the film carries pressure, and how much.
#include <cmath>
#include <limits>

#include "oracle/verify/states/solution.hpp"
#include "oracle/verify/states/solved_films.hpp"

namespace lubjoint::verify {

namespace {

const Real half_turn = pi<Real>();

/// 1 + ε cosθ without cancellation at the thinnest film.
Real thickness(const Solution& s, Real theta) {
  const Real half_cosine = std::cos(theta / 2);
  return s.ratio_gap + 2 * s.ratio * half_cosine * half_cosine;
}

/// Long film, p(0) = 0, over 6μ(R/c)² (Flores et al. 2009, eq. 5): wedge and squeeze part.
struct LongField {
  Real wedge;
  Real squeeze;
};

LongField long_field(const Solution& s, Real theta) {
  const Real e = s.ratio, cosine = std::cos(theta), h = thickness(s, theta), widest = 1 + e;
  return {s.a * std::sin(theta) * (2 + e * cosine) / (s.d() * h * h),
          s.b * (1 - cosine) * (2 + e + e * cosine) / (h * h * widest * widest)};
}

/// ∫(1 − cos u) du and ∫(1 − cos u)² du from 0 to ψ; of third and fifth order where ψ is small.
struct CosineGaps {
  Real first;
  Real second;
};

CosineGaps cosine_gaps(Real psi) {
  if (std::abs(psi) > 1) {
    return {psi - std::sin(psi), 1.5L * psi - 2 * std::sin(psi) + std::sin(2 * psi) / 4};
  }
  // Σ (−1)^{n+1} ψ^{2n+1}/(2n+1)! and Σ (−1)^n (2^{2n−1} − 2) ψ^{2n+1}/(2n+1)!
  CosineGaps sum{0, 0};
  Real power = -psi, fours = 0.5L;
  for (int n = 1; n <= 16; ++n) {
    power *= -psi * psi / static_cast<Real>(2 * n * (2 * n + 1));
    fours *= 4;
    sum.first += power;
    sum.second -= (fours - 2) * power;
  }
  return sum;
}

/// ∫ dθ/H³ from 0 by Sommerfeld's angle ψ, tan(ψ/2) = √((1−ε)/(1+ε)) tan(θ/2), continuous over all turns.
Real flow_integral(const Solution& s, Real theta) {
  const Real turns = std::round(theta / (2 * half_turn));
  const Real half = (theta - 2 * half_turn * turns) / 2;
  const Real psi = 2 * half_turn * turns +
                   2 * std::atan2(std::sqrt(s.ratio_gap) * std::sin(half), std::sqrt(1 + s.ratio) * std::cos(half));
  // ∫(1 − ε cos u)² du = ∫((1 − ε) + ε(1 − cos u))² du: no term is negative.
  const Real e = s.ratio, gap = s.ratio_gap, q = s.q();
  const CosineGaps gaps = cosine_gaps(psi);
  return (gap * gap * psi + 2 * e * gap * gaps.first + e * e * gaps.second) / (q * q * std::sqrt(q));
}

}  // namespace

void find_extent(Solution& s) {
  if (is_full(s.law)) {
    s.theta_s = 0;
    s.theta_e = 2 * half_turn;
  } else if (is_half(s.law)) {
    s.theta_s = s.mirrors_half && s.a < 0 ? half_turn : 0;
    s.theta_e = s.theta_s + half_turn;
  } else {
    s.theta_s = s.a == 0 && s.b == 0 ? 0 : std::atan2(2 * s.b, s.a);
    s.theta_e = s.theta_s + half_turn;
  }
}

void find_pressure(Solution& s) {
  if (!(s.q() > 0) || s.law == "pinkus_sternlicht"_law) {
    s.pressure = std::numeric_limits<Real>::quiet_NaN();
    return;
  }
  if (is_solved_film(s.law)) {
    const Real pull = s.pull();
    const SolvedPressure p =
        s.films->pressure(s.law, s.shape, s.ratio, pull * s.a, pull * s.b, s.theta, s.z / s.radius);
    const Real unit = s.scale / (s.length * s.radius);  // S/(LR) = μ(R/c)²
    s.pressure = (s.pulls ? -1 : 1) * pull * unit * p.pressure;
    s.pressure_terms = unit * p.largest;
    s.pressure_error = p.error;
    return;
  }
  const Real past_start = s.theta - s.theta_s;
  const Real inside = past_start - 2 * half_turn * std::floor(past_start / (2 * half_turn));  // in [0, 2π)
  const bool in_film = is_full(s.law) || inside <= s.theta_e - s.theta_s;
  const Real theta = s.theta_s + inside;
  if (is_short(s.law)) {
    const Real h = thickness(s, theta), half = s.length / 2;
    const Real scale = 3 * s.viscosity / (s.clearance * s.clearance * h * h * h) * (half - s.z) * (half + s.z);
    const Real wedge = s.a * std::sin(theta), squeeze = -2 * s.b * std::cos(theta);
    s.pressure = in_film ? scale * (wedge + squeeze) : 0;
    s.pressure_terms = std::abs(scale) * (std::abs(wedge) + std::abs(squeeze));
  } else {
    const Real slenderness = s.radius / s.clearance;
    const Real scale = 6 * s.viscosity * slenderness * slenderness;
    const LongField here = long_field(s, theta);
    Real field = here.wedge + here.squeeze;
    Real terms = std::abs(here.wedge) + std::abs(here.squeeze);
    if (s.law == "long_half"_law || s.law == "long_dynamic"_law ||
        s.law == "squeeze_long"_law) {  // zero at both ends: a flow around is added
      const LongField from = long_field(s, s.theta_s), to = long_field(s, s.theta_e);
      const Real start = from.wedge + from.squeeze, end = to.wedge + to.squeeze;
      const Real flow = (flow_integral(s, theta) - flow_integral(s, s.theta_s)) /
                        (flow_integral(s, s.theta_e) - flow_integral(s, s.theta_s));
      field += -start - (end - start) * flow;
      terms += std::abs(from.wedge) + std::abs(from.squeeze) + std::abs(to.wedge) + std::abs(to.squeeze);
    }
    s.pressure = in_film ? scale * field : 0;
    s.pressure_terms = scale * terms;
  }
  if (s.pulls) s.pressure = -s.pressure;
}

}  // namespace lubjoint::verify
