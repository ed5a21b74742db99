#include "oracle/reynolds/smooth_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "oracle/reynolds/strip_mode.hpp"

namespace lubjoint::oracle {

namespace {

/// Degrees of the elements, each the check of the one before.
constexpr std::array<int, 7> degrees{4, 6, 8, 11, 14, 18, 22};
/// More harmonics than any bearing with a useful film needs; a sum cut here says so in its error estimate.
constexpr int most_harmonics = 20000;

double wave_number(int k, double slenderness) { return (2 * k + 1) * std::numbers::pi / (2 * slenderness); }

/// Σ_{j ≥ k} (j + ½)^−m, by Euler and Maclaurin from the 30th term, where the next correction is below rounding.
double power_tail(double m, int k) {
  double sum = 0;
  int j = k;
  for (; j < 30; ++j) sum += std::pow(j + 0.5, -m);
  const double s = j + 0.5;
  const double last = std::pow(s, -m);
  const double third = m * (m + 1) * (m + 2) / (720 * s * s * s);
  return sum + last * (s / (m - 1) + 0.5 + m / (12 * s) - third);
}

template <int N>
struct Sum {
  using Values = typename ScaledResult<N>::Values;
  Values value = Values::Zero();
  Values remainder = Values::Zero();
  int unknowns = 0;
};

/// What the k-th harmonic adds, and what it would add in a short bearing.
template <int N>
struct Harmonic {
  typename ScaledResult<N>::Values part, short_part;
};

/// The force as a sum over the harmonics.
struct ForceSum {
  static constexpr int count = 2;
  static constexpr double short_power = 4;  ///< short parts fall like κ^−4
  static constexpr double least_size = 0;

  /// 4/(κ²Λ) ∫ f (cosθ, sinθ) dθ, with f for the source s.
  static Harmonic<2> harmonic(const Strip& strip, const StripMode& mode, double kappa) {
    const double scale = 4 / (kappa * kappa * strip.film.slenderness);
    return {scale * strip.multiplicity.cwiseProduct(mode.moment()),
            scale / (kappa * kappa) * strip.multiplicity.cwiseProduct(mode.short_moment())};
  }
  /// Of the difference: f − s/(κ²H³) is O(κ^−4), and O(κ^−3) if there is a layer at a cut end.
  static double power(const Strip& strip) {
    const bool layered = strip.open_ends && strip.film.squeeze != 0 && strip.end == 0;
    return layered ? 5 : 6;
  }
  /// Which of the sums a strip has a part in.
  static Eigen::Array<bool, 2, 1> has_part(const Strip& strip) { return strip.multiplicity.array() != 0; }
};

/// The side flow of a film with cut ends likewise.
struct FlowSum {
  static constexpr int count = 1;
  static constexpr double short_power = 2;
  double least_size;

  /// (2/Λ) ∫ H³ f dx
  static Harmonic<1> harmonic(const Strip& strip, const StripMode& mode, double kappa) {
    const double scale = 2 / strip.film.slenderness;
    return {ScaledFlow::Values(scale * mode.volume()),
            ScaledFlow::Values(scale / (kappa * kappa) * mode.short_volume())};
  }
  static double power(const Strip& /*strip*/) { return 4; }
  static Eigen::Array<bool, 1, 1> has_part(const Strip& /*strip*/) { return Eigen::Array<bool, 1, 1>::Constant(true); }
};

/// Sum over the harmonics of one strip.
template <class Of>
Sum<Of::count> sum_of_harmonics(const Of& of, const Strip& strip, StripMode& mode, double relative_tolerance) {
  using Values = typename Sum<Of::count>::Values;
  const double slenderness = strip.film.slenderness;
  const double power = of.power(strip);
  Sum<Of::count> sum;
  std::array<double, 3> excess{};  // |difference from the short bearing| of the last harmonics
  for (int k = 0; k < most_harmonics; ++k) {
    const double kappa = wave_number(k, slenderness);
    mode.solve(strip, kappa);
    sum.unknowns = std::max(sum.unknowns, mode.unknowns());
    const auto [part, short_part] = of.harmonic(strip, mode, kappa);
    const Values difference = part - short_part;
    sum.value += part;
    std::rotate(excess.begin(), excess.begin() + 1, excess.end());
    excess.back() = difference.norm();
    if (k < static_cast<int>(excess.size())) continue;
    const double s = k + 0.5;
    // The decay seen, which is slower than the final one until κ exceeds the inverse of the spike's width.
    double seen = power;
    if (excess[2] > 0 && excess[0] > 0) seen = std::log(excess[0] / excess[2]) / std::log(s / (s - 2));
    seen = std::clamp(seen, 2.0, power);
    const double growth = std::pow(s, seen) * power_tail(seen, k + 1);
    double bound = 0;  // a difference that just passes through zero must not end the sum
    for (std::size_t n = 0; n < excess.size(); ++n) {
      const double before = s - static_cast<double>(excess.size() - 1 - n);
      bound = std::max(bound, excess[n] * std::pow(before / s, power));
    }
    const Values rest =
        short_part * std::pow(s, of.short_power) * power_tail(of.short_power, k + 1) + difference * growth;
    const double size = std::max((sum.value + rest).norm(), of.least_size);
    if (bound * growth > relative_tolerance * size && k + 1 < most_harmonics) continue;
    sum.value += rest;
    using Bounds = Eigen::Array<double, Of::count, 1>;
    sum.remainder = of.has_part(strip).select(Bounds::Constant(bound * growth), 0.0).matrix();
    break;
  }
  return sum;
}

/// The sums of elements of growing degree, until their last change is within the tolerance.
template <class Of>
ScaledResult<Of::count> refined(const Of& of, const std::vector<Strip>& strips, double relative_tolerance) {
  using Values = typename ScaledResult<Of::count>::Values;
  ScaledResult<Of::count> result;
  double last_change = 0;
  for (std::size_t level = 0; level < degrees.size(); ++level) {
    StripMode mode(degrees[level]);
    Sum<Of::count> total;
    for (const Strip& strip : strips) {
      const Sum<Of::count> part = sum_of_harmonics(of, strip, mode, relative_tolerance / 4);
      total.value += part.value;
      total.remainder += part.remainder;
      result.unknowns = std::max(result.unknowns, part.unknowns);
    }
    const Values change = (total.value - result.value).cwiseAbs();
    const double rounding =
        result.unknowns * std::numeric_limits<double>::epsilon() * std::max(total.value.norm(), of.least_size);
    result.value = total.value;
    result.error = change + total.remainder + Values::Constant(rounding);
    if (level >= 2) {
      const double ratio = static_cast<double>(degrees[level]) / degrees[level - 1];
      result.observed_order = std::log(last_change / change.norm()) / std::log(ratio);
      if (result.error.norm() <= relative_tolerance * std::max(result.value.norm(), of.least_size)) break;
    }
    last_change = change.norm();
  }
  return result;
}

}  // namespace

ScaledForce smooth_film_force(FilmExtent extent, const ScaledFilm& film, double relative_tolerance) {
  return refined(ForceSum{}, strips_of(extent, film), relative_tolerance);
}

ScaledFlow smooth_film_flow(FilmExtent extent, const ScaledFilm& film, double relative_tolerance) {
  if (extent == FilmExtent::full) return {};  // what flows out on one side of the circle is drawn in on the other
  return refined(FlowSum{film.displacement()}, strips_of(extent, film), relative_tolerance);
}

std::vector<double> smooth_film_pressure(FilmExtent extent, const ScaledFilm& film, const std::vector<double>& theta,
                                         const std::vector<double>& zeta, double relative_tolerance) {
  std::vector<double> pressure(theta.size() * zeta.size(), 0.0);
  const double half_turn = std::numbers::pi;
  const double span = film.slenderness;
  for (const Strip& strip : strips_of(extent, film)) {
    // Where each angle lies in the strip, and the sign of its mirror image in a full film.
    std::vector<std::size_t> column;
    std::vector<double> place, sign;
    for (std::size_t i = 0; i < theta.size(); ++i) {
      double x = std::remainder(theta[i] - half_turn, 2 * half_turn);
      double factor = 1;
      if (extent == FilmExtent::full && x > 0) {
        x = -x;
        factor = strip.open_ends ? -1 : 1;
      }
      if (x < strip.start) x += 2 * half_turn;
      if (x > strip.end && x - 2 * half_turn >= strip.start) x -= 2 * half_turn;
      const bool inside = strip.open_ends ? x > strip.start && x < strip.end : x >= strip.start && x <= strip.end;
      if (!inside) continue;
      column.push_back(i);
      place.push_back(x);
      sign.push_back(factor);
    }
    StripMode mode(degrees[degrees.size() / 2]);
    double largest = 0;
    std::vector<double> short_curvature(place.size());
    for (std::size_t n = 0; n < place.size(); ++n) {
      const double h = strip.film.thickness(place[n]);
      short_curvature[n] = strip.film.source(place[n]) / (h * h * h);
      for (std::size_t j = 0; j < zeta.size(); ++j) {
        const double axial = (span - zeta[j]) * (span + zeta[j]) / 2;
        pressure[column[n] * zeta.size() + j] += sign[n] * short_curvature[n] * axial;
      }
    }
    std::vector<double> profile(zeta.size());
    for (int k = 0; k < most_harmonics; ++k) {
      const double kappa = wave_number(k, span);
      mode.solve(strip, kappa);
      for (std::size_t j = 0; j < zeta.size(); ++j) profile[j] = std::cos(kappa * zeta[j]);
      const double amplitude = (k % 2 == 0 ? 2 : -2) / (kappa * span);
      double change = 0;
      for (std::size_t n = 0; n < place.size(); ++n) {
        const double f = mode.at(place[n]);
        largest = std::max(largest, std::abs(amplitude * f));
        const double term = amplitude * (f - short_curvature[n] / (kappa * kappa));
        change = std::max(change, std::abs(term));
        double* row = pressure.data() + column[n] * zeta.size();
        for (std::size_t j = 0; j < zeta.size(); ++j) row[j] += sign[n] * term * profile[j];
      }
      // The terms fall like k^−3 at worst, in the layer at a cut end.
      if (k > 2 && change * (k + 1) / 2 <= relative_tolerance * largest) break;
    }
  }
  return pressure;
}

}  // namespace lubjoint::oracle
