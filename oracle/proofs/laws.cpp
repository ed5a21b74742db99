#include "oracle/proofs/laws.hpp"

namespace lubjoint::proofs {

namespace {

Planar short_full_vector(const PlaneState& y) {
  return -Pi / pow(y.s, 5) * (pow(y.s, 2) * y.u + 3 * y.e_dot_u * y.e_hat);
}

Planar long_full_vector(const PlaneState& y) {
  const ex d = 2 + y.e_e;
  return -12 * Pi / (d * pow(y.s, 3)) * (2 * pow(y.s, 2) * y.u + 3 * y.e_dot_u * y.e_hat);
}

/// (ê × u) r + (ê·u) t: what the cut at 0 and π adds to half the full film, over its coefficient.
Planar cut(const PlaneState& y) { return 1 / y.eps * (y.e_cross_u * y.e_hat + y.e_dot_u * turned_90(y.e_hat)); }

Planar short_half_vector(const PlaneState& y) {
  return frac(1, 2) * short_full_vector(y) + 2 * y.sigma / pow(y.s, 4) * cut(y);
}

Planar long_half_vector(const PlaneState& y) {
  const ex d = 2 + y.e_e;
  const ex relief = 96 * y.e_dot_u / (Pi * d * pow(y.s, 3) * pow(y.eps, 2));
  return frac(1, 2) * long_full_vector(y) + relief * y.e_hat + 24 * y.sigma / (d * pow(y.s, 2)) * cut(y);
}

Planar long_half_eq5_vector(const PlaneState& y) {
  const ex d = 2 + y.e_e;
  const ex radial = 24 * y.sigma * y.e_cross_u / (d * pow(y.s, 2) * y.eps);
  const ex tangential = 24 * y.sigma * y.e_dot_u / ((1 + y.eps) * pow(y.s * y.eps, 2));
  return frac(1, 2) * long_full_vector(y) + radial * y.e_hat + tangential * turned_90(y.e_hat);
}

Planar resisted(const PlaneState& y, Resistance (*law)(const ex&, const ex&, const ex&, const ex&)) {
  const Planar along = 1 / y.speed * y.u;
  const Planar across = turned_90(along);
  const Resistance f = law(y.e_dot_u / y.speed, -y.e_cross_u / y.speed, y.s, y.delta);
  return -y.speed * (f.along * along + f.across * across);
}

}  // namespace

PlaneState PlaneState::with(const Planar& new_e_hat, const Planar& new_u) const {
  PlaneState other = *this;
  other.e_hat = new_e_hat;
  other.u = new_u;
  other.e_e = dot(new_e_hat, new_e_hat);
  other.e_dot_u = dot(new_e_hat, new_u);
  other.e_cross_u = cross(new_e_hat, new_u);
  return other;
}

Planar pinkus_sternlicht_vector(const PlaneState& y, bool closing) {
  const ex es = y.e_dot_u;
  const ex d = 2 + y.e_e;
  const ex k = y.s * y.speed;
  const ex t = closing ? k + frac(3, 2) * es : k - frac(3, 2) * es;
  const ex n = closing ? k + 3 * es : k;
  return -6 / (d * pow(y.s, 3) * t) * ((4 * k * t + 3 * Pi * n * es) * y.e_hat + 2 * Pi * n * pow(y.s, 2) * y.u);
}

const std::vector<Law>& laws() {
  static const std::vector<Law> all = [] {
    const GiNaC::exmap motion = in_dynamic_motion();
    const ex k = sym().s * sym().speed;
    return std::vector<Law>{
        {"short full", "eqs. 6, 7", short_full().subs(motion), short_full_vector},
        {"short half", "eqs. 8, 9", short_half().subs(motion), short_half_vector},
        {"long full", "eqs. 10, 11", long_full().subs(motion), long_full_vector},
        {"long half", "eqs. 12, 13", long_half().subs(motion), long_half_vector},
        {"long half of eq. 5 cut at pi", "eq. 5", long_half_eq5().subs(motion), long_half_eq5_vector},
        {"Pinkus-Sternlicht, b >= 0", "eqs. 14, 15, 18", pinkus_sternlicht(k, true).subs(motion),
         [](const PlaneState& y) { return pinkus_sternlicht_vector(y, true); }},
        {"Pinkus-Sternlicht, b < 0", "eqs. 16 to 18", pinkus_sternlicht(k, false).subs(motion),
         [](const PlaneState& y) { return pinkus_sternlicht_vector(y, false); }},
        {"short dynamic", "exact dynamic film", in_polar_components(short_dynamic),
         [](const PlaneState& y) { return resisted(y, short_dynamic); }},
        {"long dynamic", "exact dynamic film", in_polar_components(long_dynamic),
         [](const PlaneState& y) { return resisted(y, long_dynamic); }},
    };
  }();
  return all;
}

FreeState::FreeState() {
  const symbol s("s"), eps("eps"), speed("speed"), sigma("sigma"), delta("delta");
  state.eps = eps;
  state.s = s;
  state.speed = speed;
  state.sigma = sigma;
  state.delta = delta;
  state = state.with({e_x, e_y}, {u_x, u_y});
  const ex e2 = state.e_e;
  algebra.root(s, 1 - e2).root(eps, e2).root(speed, dot(state.u, state.u)).root(sigma, 1).angle(angle);
}

}  // namespace lubjoint::proofs
