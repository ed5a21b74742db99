// Where the film carries pressure, and how much.
#include <cmath>
#include <limits>

#include "oracle/verify/solution.hpp"

namespace lubjoint::verify {

namespace {

const Real pi_ = pi<Real>();

/// Long film, p(0) = 0, over 6μ(R/c)² (Flores et al. 2009, eq. 5): wedge and squeeze part.
struct LongField {
  Real wedge;
  Real squeeze;
};

LongField long_field(const Solution& s, Real theta) {
  const Real e = s.ratio, cosine = std::cos(theta), h = 1 + e * cosine, widest = 1 + e;
  return {s.a * std::sin(theta) * (2 + e * cosine) / (s.d() * h * h),
          s.b * (1 - cosine) * (2 + e + e * cosine) / (h * h * widest * widest)};
}

/// ∫ dθ/H³ from 0 by Sommerfeld's angle ψ, tan(ψ/2) = √((1−ε)/(1+ε)) tan(θ/2), continuous over all turns.
Real flow_integral(const Solution& s, Real theta) {
  const Real turns = std::round(theta / (2 * pi_));
  const Real half = (theta - 2 * pi_ * turns) / 2;
  const Real psi = 2 * pi_ * turns +
                   2 * std::atan2(std::sqrt(s.ratio_gap) * std::sin(half), std::sqrt(1 + s.ratio) * std::cos(half));
  const Real e = s.ratio, q = s.q();
  const Real sum = psi * (1 + e * e / 2) - 2 * e * std::sin(psi) + e * e / 4 * std::sin(2 * psi);
  return sum / (q * q * std::sqrt(q));
}

}  // namespace

void find_extent(Solution& s) {
  if (is_full(s.law)) {
    s.theta_s = 0;
    s.theta_e = 2 * pi_;
  } else if (is_half(s.law)) {
    s.theta_s = s.mirrors_half && s.a < 0 ? pi_ : 0;
    s.theta_e = s.theta_s + pi_;
  } else {
    s.theta_s = s.a == 0 && s.b == 0 ? 0 : std::atan2(2 * s.b, s.a);
    s.theta_e = s.theta_s + pi_;
  }
}

void find_pressure(Solution& s) {
  if (!(s.q() > 0) || s.law == Law::pinkus_sternlicht) {
    s.pressure = std::numeric_limits<Real>::quiet_NaN();
    return;
  }
  const Real past_start = s.theta - s.theta_s;
  const Real inside = past_start - 2 * pi_ * std::floor(past_start / (2 * pi_));  // in [0, 2π)
  const bool in_film = is_full(s.law) || inside <= s.theta_e - s.theta_s;
  const Real theta = s.theta_s + inside;
  if (is_short(s.law)) {
    const Real h = 1 + s.ratio * std::cos(theta), half = s.length / 2;
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
    if (s.law == Law::long_half || s.law == Law::long_dynamic) {  // zero at both ends: a flow around is added
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
