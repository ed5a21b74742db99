#include "oracle/verify/terms/factor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace lubjoint::verify {

namespace {

using std::numbers::pi;

std::string power_of_pi(int k) { return k == 1 ? "pi" : fmt::format("pi^{}", k); }

/// ±2^i 3^j π^k as a fraction.
std::string fraction(int i, int j, int k) {
  const long over = (i > 0 ? 1L << i : 1) * std::lround(std::pow(3, j > 0 ? j : 0));
  const long under = (i < 0 ? 1L << -i : 1) * std::lround(std::pow(3, j < 0 ? -j : 0));
  std::string top = over == 1 && k > 0 ? "" : std::to_string(over);
  if (k > 0) top += (top.empty() ? "" : " ") + power_of_pi(k);
  std::string bottom = under == 1 ? "" : std::to_string(under);
  if (k < 0) bottom += (bottom.empty() ? "" : " ") + power_of_pi(-k);
  if (bottom.empty()) return top;
  return top + "/" + (bottom.find(' ') == std::string::npos ? bottom : "(" + bottom + ")");
}

bool near(double x, double y, double precision) { return std::abs(x - y) <= precision * std::abs(y); }

}  // namespace

std::string factor_words(double factor, double precision) {
  const double size = std::abs(factor);
  const std::string sign = factor < 0 ? "-" : "";
  if (!(size > 0) || !std::isfinite(size) || precision > 0.02) return "";
  // The simplest first: by the sum of the exponents' sizes. The less precise the number, the fewer are told apart.
  const int most = precision < 1e-6 ? 9 : precision < 1e-3 ? 5 : 3;
  for (int sum = 0; sum <= most; ++sum) {
    for (int k = 0; k <= std::min(sum, 3); ++k) {
      for (int j = 0; j <= std::min(sum - k, 3); ++j) {
        const int i = sum - k - j;
        for (int signs = 0; signs < 8; ++signs) {
          const int si = signs & 1 ? -i : i, sj = signs & 2 ? -j : j, sk = signs & 4 ? -k : k;
          if (near(size, std::pow(2.0, si) * std::pow(3.0, sj) * std::pow(pi, sk), precision)) {
            return sign + fraction(si, sj, sk);
          }
        }
      }
    }
  }
  for (int n = -12; n <= 12; ++n) {
    if (n != 0 && near(size, std::pow(10.0, n), precision)) {
      return sign + (std::abs(n) <= 3 && n > 0 ? fmt::format("{}", std::lround(std::pow(10.0, n)))
                                               : fmt::format("1e{:+03d}", n));
    }
  }
  if (near(size, 30 / pi, precision)) return sign + "60/(2 pi)";
  if (near(size, pi / 30, precision)) return sign + "2 pi/60";
  if (near(size, 180 / pi, precision)) return sign + "180/pi";
  if (near(size, pi / 180, precision)) return sign + "pi/180";
  return "";
}

}  // namespace lubjoint::verify
