#include "oracle/verify/states/steady_slopes.hpp"

#include <cmath>

#include "lubjoint/number/dual.hpp"
#include "oracle/verify/states/film_places.hpp"

namespace lubjoint::verify {

namespace {

const Real half_turn = pi<Real>();

/// From the slopes of a film on 0…π: of one on 0…2π if whole, and the force, which is a times the slopes by a.
SteadySlopes of_wedge(SteadySlopes s, Real e, bool whole) {
  if (whole) {
    s.tangential_by_slip *= 2;
    s.tangential_by_ratio *= 2;
    s.radial_by_slip = s.radial_by_ratio = 0;
  }
  s.radial = e * s.radial_by_slip;
  s.tangential = e * s.tangential_by_slip;
  return s;
}

/// F_r and F_t of a film on 0…π or, if whole, on 0…2π where a = ε, b = 0; the squeeze's slopes are the law's own.
SteadySlopes short_wedge(Real e, Real q, bool whole) {
  const Real root = std::sqrt(q), q2 = q * q;
  SteadySlopes s;
  s.tangential_by_slip = half_turn / (4 * q * root);
  s.tangential_by_ratio = 3 * half_turn * e * e / (4 * q2 * root);
  s.radial_by_slip = -e / q2;
  s.radial_by_ratio = -e * (1 + 3 * e * e) / (q2 * q);
  return of_wedge(s, e, whole);
}

SteadySlopes long_wedge(Real e, Real q, bool whole) {
  const Real root = std::sqrt(q), d = 2 + e * e;
  SteadySlopes s;
  s.tangential_by_slip = 6 * half_turn / (d * root);
  s.tangential_by_ratio = 6 * half_turn * e * e * (d - 2 * q) / (d * d * q * root);
  s.radial_by_slip = -12 * e / (d * q);
  s.radial_by_ratio = -12 * e * (d * q + 2 * e * e * (d - q)) / (d * d * q * q);
  return of_wedge(s, e, whole);
}

/// ∂_bF_r and ∂_bF_t over S.
void set_squeeze(Law law, Real e, Real q, SteadySlopes& s) {
  const Real root = std::sqrt(q), d = 2 + e * e;
  if (is_short(law)) {
    s.radial_by_squeeze = -half_turn * (1 + 2 * e * e) / (q * q * root) * (is_full(law) ? 1 : 0.5L);
    s.tangential_by_squeeze = is_full(law) ? 0 : 2 * e / (q * q);
    return;
  }
  s.radial_by_squeeze = -6 * half_turn / (q * root);
  if (is_full(law)) {
    s.radial_by_squeeze *= 2;
  } else if (law == "long_half"_law) {
    s.radial_by_squeeze = -6 / (q * root) * (half_turn - 16 / (half_turn * d));
    s.tangential_by_squeeze = 24 * e / (d * q);
  } else if (law == "long_half_eq5"_law) {
    s.tangential_by_squeeze = 24 / ((1 + e) * q);
  } else if (law == "long_dynamic"_law) {
    s.radial_by_squeeze = -6 / (q * root) * (half_turn - 16 * e * e / (half_turn * d * d));
    s.tangential_by_squeeze = 48 * e * (1 + e * e) / (d * d * q);
  } else {
    s.tangential_by_squeeze = 18 * half_turn * e / (d * q);
  }
}

using Places = std::vector<FilmPlace>;

SteadySlopes short_slopes(Real e, const Places& film) {
  const Real sc = sum(film, [](const FilmPlace& at) { return at.sine * at.cosine / cube(at.thickness); });
  const Real ss = sum(film, [](const FilmPlace& at) { return at.sine * at.sine / cube(at.thickness); });
  const Real cc = sum(film, [](const FilmPlace& at) { return at.cosine * at.cosine / cube(at.thickness); });
  // dH/dε = cosθ
  const auto by_ratio = [&](const auto& weight) {
    return -1.5L * e * sum(film, [&](const FilmPlace& at) {
      return at.sine * weight(at) * at.cosine / (cube(at.thickness) * at.thickness);
    });
  };
  SteadySlopes s;
  s.radial = e * sc / 2;
  s.tangential = e * ss / 2;
  s.radial_by_ratio = by_ratio([](const FilmPlace& at) { return at.cosine; });
  s.tangential_by_ratio = by_ratio([](const FilmPlace& at) { return at.sine; });
  s.radial_by_slip = sc / 2;
  s.tangential_by_slip = ss / 2;
  s.radial_by_squeeze = -cc;
  s.tangential_by_squeeze = -sc;
  return s;
}

/// With w = 1 + cosθ, m its mean with the weight 1/H³ and s̄ that of sinθ, H³ dp/dθ ∝ a(w − m) + 2b(sinθ − s̄): small
/// where the film is thin. Where the film ends at p = 0 the integral of dp/dθ vanishes and F_t = 6∫w dp; where it is
/// cut at the minimum film, p(π) adds the same.
SteadySlopes long_slopes(Law law, Real e, Real gap, const Places& film) {
  const bool of_whole = is_full(law) || law == "long_half_eq5"_law;
  const Places whole = of_whole ? film_places(e, gap, 0, 2 * half_turn) : film;
  const Real weight = sum(whole, [](const FilmPlace& at) { return 1 / cube(at.thickness); });
  const auto mean = [&](const auto& f) {
    return sum(whole, [&](const FilmPlace& at) { return f(at) / cube(at.thickness); }) / weight;
  };
  const Real wall = mean([](const FilmPlace& at) { return at.wall; });
  const Real sine = mean([](const FilmPlace& at) { return at.sine; });
  const Real wall_by_ratio =
      mean([&](const FilmPlace& at) { return -3 * (at.wall - wall) * at.cosine / at.thickness; });
  Real constant_by_squeeze = -2 * sine;
  Real end_tangential = 0;
  if (law == "long_dynamic"_law) {
    const Real motion = 2 / e;  // dθ/db of both ends, with a = ε
    const Real at_begin = e * (2 - wall) / cube(1 + e), at_end = -e * wall / cube(gap);
    constant_by_squeeze -= motion * (at_end - at_begin) / weight;
    end_tangential = -motion * 6 * 2 * at_begin;  // w is 2 at the maximum film and 0 at the minimum
  }
  const auto force = [&](const auto& slope) {
    return Plane(-6 * sum(film, [&](const FilmPlace& at) { return at.sine * slope(at) / cube(at.thickness); }),
                 6 * sum(film, [&](const FilmPlace& at) { return at.wall * slope(at) / cube(at.thickness); }));
  };
  const auto along = [&](const FilmPlace& at) { return at.wall - wall; };
  const Plane by_slip = force(along);
  const Plane by_ratio =
      force([&](const FilmPlace& at) { return -e * (wall_by_ratio + 3 * at.cosine * along(at) / at.thickness); });
  const Plane by_squeeze = force([&](const FilmPlace& at) { return 2 * at.sine + constant_by_squeeze; });
  return {e * by_slip.x(), e * by_slip.y(), by_ratio.x(),   by_ratio.y(),
          by_slip.x(),     by_slip.y(),     by_squeeze.x(), by_squeeze.y() + end_tangential};
}

/// F_r = −(6/(D q^{3/2}))[4εK + πDbφ], F_t = (6πa/(D√q))φ with b from above: B = εb, φ = (K + 3B)/(K + 3B/2).
SteadySlopes pinkus_sternlicht_slopes(Real ratio, Real gap) {
  using D = Dual<Real, 3>;
  using std::sqrt;
  const D e = D::variable(ratio, 0), a = D::variable(ratio, 1), b = D::variable(0, 2);
  D q(gap * (1 + ratio));
  q.derivatives()[0] = -2 * ratio;
  const D root = sqrt(q), d = 2 + e * e, k = sqrt(D(q * (a * a / Real(4) + b * b))), big_b = e * b;
  const D phi = (k + Real(3) * big_b) / (k + Real(1.5L) * big_b);
  const D radial = -Real(6) * (Real(4) * e * k + half_turn * d * b * phi) / (d * q * root);
  const D tangential = Real(6) * half_turn * a * phi / (d * root);
  const auto &r = radial.derivatives(), &t = tangential.derivatives();
  return {radial.value(), tangential.value(), r[0], t[0], r[1], t[1], r[2], t[2]};
}

}  // namespace

bool has_rest(Law law) { return !facts_of(law).squeeze_only; }

SteadySlopes published_slopes(Law law, Real ratio, Real gap) {
  const Real q = gap * (1 + ratio);
  SteadySlopes s = is_short(law) ? short_wedge(ratio, q, is_full(law)) : long_wedge(ratio, q, is_full(law));
  set_squeeze(law, ratio, q, s);
  return s;
}

SteadySlopes slopes_by_quadrature(Law law, Real ratio, Real gap) {
  if (law == "pinkus_sternlicht"_law) return pinkus_sternlicht_slopes(ratio, gap);
  const Places film = film_places(ratio, gap, 0, is_full(law) ? 2 * half_turn : half_turn);
  return is_short(law) ? short_slopes(ratio, film) : long_slopes(law, ratio, gap, film);
}

}  // namespace lubjoint::verify
