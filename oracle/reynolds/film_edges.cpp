#include "oracle/reynolds/film_edges.hpp"

#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace lubjoint::oracle {

namespace {

using std::numbers::pi;

/// p H³ of the short bearing: the pressure without the positive factor that makes it steep, so the same zeros.
double pressure_times_h3(const NarrowGap& gap, double phi) { return gap.at(phi).source(); }

double zero_between(const NarrowGap& gap, double low, double high) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  const double resolution = gap.dip_width() / 100;
  const auto close = [&](double lo, double hi) {
    return std::abs(hi - lo) <= 2 * unit * std::max(std::min(std::abs(lo), std::abs(hi)), resolution);
  };
  std::uintmax_t most_steps = 200;
  const auto [lo, hi] = boost::math::tools::toms748_solve([&](double phi) { return pressure_times_h3(gap, phi); }, low,
                                                          high, close, most_steps);
  const double at_lo = std::abs(pressure_times_h3(gap, lo));
  const double at_hi = std::abs(pressure_times_h3(gap, hi));
  return at_lo <= at_hi ? lo : hi;
}

/// Eight samples of the pressure a turn separate its two zeros, which are half a turn apart.
std::optional<FilmWindow> window_from_samples(const NarrowGap& gap, double first) {
  constexpr int samples = 8;
  double begins = 0;
  double ends = 0;
  int zeros = 0;
  double left = first;
  for (int i = 1; i <= samples; ++i) {
    const double right = first + i * (2 * pi / samples);
    const bool was_positive = pressure_times_h3(gap, left) > 0;
    const bool is_positive = pressure_times_h3(gap, right) > 0;
    if (was_positive != is_positive) {
      (is_positive ? begins : ends) = zero_between(gap, left, right);
      ++zeros;
    }
    left = right;
  }
  if (zeros != 2) return std::nullopt;
  if (begins < ends) return FilmWindow{begins, ends};
  // The film lies around the maximum film. Of its two images the one whose edge is nearer to the minimum film.
  if (std::abs(ends) <= std::abs(begins)) return FilmWindow{begins - 2 * pi, ends};
  return FilmWindow{begins, ends + 2 * pi};
}

FilmWindow dynamic_window(const NarrowGap& gap) {
  if (gap.slip() == 0 && gap.squeeze() == 0) return {-pi, 0};
  // Two offsets of the samples, so that a zero that falls on a sample of the first is between samples of the second.
  for (const double offset : {0.3, 0.55}) {
    const std::optional<FilmWindow> window = window_from_samples(gap, -pi + offset);
    if (window) return *window;
  }
  throw std::logic_error("the pressure of the short bearing has not two zeros around the bearing");
}

}  // namespace

FilmWindow film_window(FilmExtent extent, const NarrowGap& gap) {
  switch (extent) {
    case FilmExtent::full:
      return {-pi, pi};
    case FilmExtent::half:
      return gap.slip() < 0 ? FilmWindow{0, pi} : FilmWindow{-pi, 0};
    case FilmExtent::dynamic:
      break;
  }
  return dynamic_window(gap);
}

}  // namespace lubjoint::oracle
