/// The search of steady_film.hpp.
#pragma once

#include <cmath>
#include <limits>

#include "oracle/verify/states/steady_film.hpp"

namespace lubjoint::verify {

template <class Slopes>
RestPlace place_under_load(const Slopes& slopes, long double wanted, long double start) {
  constexpr long double nan = std::numeric_limits<long double>::quiet_NaN();
  if (!(wanted > 0) || !std::isfinite(wanted)) return {nan, nan};
  const auto place = [](long double x) { return RestPlace{1 / (1 + std::exp(-x)), 1 / (1 + std::exp(x))}; };
  long double low = -100, high = 60;  // ε from 1e-43 to 1 − 1e-26
  long double x = start > low && start < high ? start : 0;
  for (int trial = 0; trial < 200; ++trial) {
    const RestPlace here = place(x);
    const SteadySlopes s = slopes(here.ratio, here.gap);
    const long double off = std::log(s.size() / wanted);
    (off > 0 ? high : low) = x;
    const long double slope = s.size_by_ratio() / s.size() * here.ratio * here.gap;
    long double next = x - off / slope;
    if (!(next > low && next < high)) next = (low + high) / 2;  // where Newton's step leaves the bracket
    const long double step = std::abs(next - x);
    x = next;
    if (step <= 4 * std::numeric_limits<long double>::epsilon() * (1 + std::abs(x))) {
      return x < -99 || x > 59 ? RestPlace{nan, nan} : place(x);
    }
  }
  return {nan, nan};
}

}  // namespace lubjoint::verify
