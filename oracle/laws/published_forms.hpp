/// The force laws once more, as papers print them: polar, term by term, with powers and angles. Meant for many-digit
/// arithmetic, where the way of writing does not matter: what the library's forms are measured against.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports {

/// Terms of F_r/S and F_t/S. The size of a component's rounding is set by the sum of its terms' magnitudes.
template <class R>
struct PublishedTerms {
  std::vector<R> radial;
  std::vector<R> tangential;
};

namespace detail {

/// J_lm of the dynamic film from θs to θs + π by Sommerfeld's substitution, l + m ≤ 2: with s = sinψ, c = cosψ the
/// integrand is a trigonometric polynomial of degree 2, integrated term by term. Loses digits as ε → 1: needs many.
template <class R>
class DynamicIntegrals {
 public:
  DynamicIntegrals(const R& epsilon, const R& q, const R& a, const R& b) : e_(epsilon), q_(q), root_(root_of(q_)) {
    using std::atan2;
    const R w = root_of(R(a * a + 4 * b * b));
    const R cos_s = a / w;
    const R sin_s = 2 * b / w;
    from_ = end_at(cos_s, sin_s);
    to_ = end_at(R(-cos_s), R(-sin_s));
    from_.angle = atan2(from_.sine, from_.cosine);
    to_.angle = from_.angle + 2 * atan2(root_, R(-e_ * sin_s));
  }

  /// ∫ sin^l θ cos^m θ/H³ dθ = q^{(1+l)/2−3} ∫ sin^l ψ (cosψ − ε)^m (1 − ε cosψ)^{2−l−m} dψ
  R operator()(int l, int m) const {
    // Polynomial in cosψ, times sin^l: coefficients of 1, c, c².
    R p[3] = {R(1), R(0), R(0)};
    const auto multiply = [&p](const R& constant, const R& slope) {
      p[2] = p[2] * constant + p[1] * slope;
      p[1] = p[1] * constant + p[0] * slope;
      p[0] = p[0] * constant;
    };
    for (int i = 0; i < m; ++i) multiply(R(-e_), R(1));
    for (int i = 0; i < 2 - l - m; ++i) multiply(R(1), R(-e_));
    R sum = 0;
    for (int k = 0; k <= 2 - l; ++k) sum += p[k] * (antiderivative(l, k, to_) - antiderivative(l, k, from_));
    const R power = q_ * q_ * (l == 0 ? root_ : l == 1 ? R(1) : R(1 / root_));  // q^{3−(1+l)/2}
    return sum / power;
  }

 private:
  struct End {
    R angle;
    R cosine;
    R sine;
  };

  static R root_of(const R& x) {
    using std::sqrt;
    return sqrt(x);
  }

  /// cosψ and sinψ of an end of the film at θ; the angle is set by the caller.
  End end_at(const R& cos_theta, const R& sin_theta) const {
    const R h = 1 + e_ * cos_theta;
    return {R(0), R((e_ + cos_theta) / h), R(root_ * sin_theta / h)};
  }

  /// ∫ sin^l cos^k, l + k ≤ 2.
  static R antiderivative(int l, int k, const End& x) {
    if (l == 0 && k == 0) return x.angle;
    if (l == 0 && k == 1) return x.sine;
    if (l == 0) return (x.angle + x.sine * x.cosine) / 2;
    if (l == 1 && k == 0) return -x.cosine;
    if (l == 1) return x.sine * x.sine / 2;
    return (x.angle - x.sine * x.cosine) / 2;
  }

  R e_;
  R q_;
  R root_;
  End from_;
  End to_;
};

}  // namespace detail

/// Terms of the law of that name for a caller that knows q = 1 − ε² better than ε can say.
template <class R>
PublishedTerms<R> published_terms_at(std::string_view law, const R& epsilon, const R& q, const R& a, const R& b,
                                     int side) {
  using std::abs;
  using std::pow;
  using std::sqrt;
  const R& pi = boost::math::constants::pi<R>();
  const R d = 2 + epsilon * epsilon;
  const R q12 = sqrt(q);
  const R q32 = q * q12;
  const R q52 = q * q * q12;
  const R sgn = side ? R(side) : a < 0 ? R(-1) : R(1);
  const R short_squeeze = pi * b * (1 + 2 * epsilon * epsilon) / q52;
  if (law == "short_full") return {{-short_squeeze}, {pi * a / (2 * q32)}};
  if (law == "short_half") {
    return {{-epsilon * sgn * a / (q * q), -short_squeeze / 2}, {pi * a / (4 * q32), sgn * 2 * epsilon * b / (q * q)}};
  }
  if (law == "long_full") return {{-12 * pi * b / q32}, {12 * pi * a / (d * q12)}};
  if (law == "long_half") {
    return {{-12 * epsilon * sgn * a / (d * q), -6 * pi * b / q32, 96 * b / (pi * d * q32)},
            {6 * pi * a / (d * q12), sgn * 24 * epsilon * b / (d * q)}};
  }
  if (law == "long_half_eq5") {
    return {{-12 * epsilon * sgn * a / (d * q), -6 * pi * b / q32},
            {6 * pi * a / (d * q12), sgn * 24 * b / ((1 + epsilon) * q)}};
  }
  if (law == "pinkus_sternlicht") {
    const R k = sqrt(q * (a * a / 4 + b * b));
    const R big_b = epsilon * abs(b);
    const R phi = b < 0 ? R(k / (k + 3 * big_b / 2)) : R((k + 3 * big_b) / (k + 3 * big_b / 2));
    return {{-24 * epsilon * k / (d * q32), -6 * pi * b * phi / q32}, {6 * pi * a * phi / (d * q12)}};
  }
  if (law == "squeeze_short_full") return {{-short_squeeze}, {R(0)}};
  if (law == "squeeze_long_full") return {{-12 * pi * b / q32}, {R(0)}};
  if (law == "squeeze_short" || law == "squeeze_long") {
    using std::atan2;
    const bool opens = side ? side < 0 : b < 0;
    const R arc = atan2(q12, epsilon);  // arccos ε
    const R angle = opens ? arc : R(pi - arc);
    const R rest = opens ? R(-epsilon) : epsilon;
    if (law == "squeeze_long") return {{-12 * b * angle / q32, -12 * b * rest / q}, {R(0)}};
    return {{-b * (1 + 2 * epsilon * epsilon) * angle / q52, -3 * b * rest / (q * q)}, {R(0)}};
  }
  const detail::DynamicIntegrals<R> j(epsilon, q, a, b);
  if (law == "short_dynamic") {
    return {{(a * j(1, 1) - 2 * b * j(0, 2)) / 2}, {(a * j(2, 0) - 2 * b * j(1, 1)) / 2}};
  }
  const R constant = -(a * j(0, 1) + 2 * b * j(1, 0)) / j(0, 0);
  if (law != "long_dynamic") throw std::invalid_argument("no form of the law " + std::string(law) + " is published");
  return {{-6 * (a * j(1, 1) + 2 * b * j(2, 0) + constant * j(1, 0))},
          {6 * (a * j(0, 2) + 2 * b * j(1, 1) + constant * j(0, 1))}};
}

/// Terms of the law of that name. The dynamic laws have one term a component: their accuracy is stated against |F|.
/// @param epsilon  0 ≤ ε < 1;  @param a, b  not both zero
/// @param side  half films: +1 film on 0…π, −1 on π…2π, 0: where the sign of a says; squeeze_short and squeeze_long:
///              +1 closing, −1 opening, 0: as the sign of b says
template <class R>
PublishedTerms<R> published_terms(std::string_view law, const R& epsilon, const R& a, const R& b, int side = 0) {
  return published_terms_at<R>(law, epsilon, R((1 - epsilon) * (1 + epsilon)), a, b, side);
}

}  // namespace lubjoint::reports
