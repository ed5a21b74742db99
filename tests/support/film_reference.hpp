/// Film states for the oracle's tests, and the laws in 50 digits as their reference.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "lubjoint/film/law_list.hpp"
#include "oracle/reynolds/film_integral.hpp"

namespace lubjoint::test {

using FiftyDigits =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

inline const Bearing<double> bearing(0.04, 0.01, 2e-4);  // exact inputs: these doubles, not the decimals
inline const Lubricant<double> oil(0.04);

/// The closed form of the film of that name in 50 digits, for the same doubles.
inline PolarForce<FiftyDigits> reference_force(std::string_view film, const PolarFilmState<FiftyDigits>& state) {
  const Bearing<FiftyDigits> same_bearing(bearing.length(), bearing.radius(), bearing.clearance());
  const Lubricant<FiftyDigits> same_oil(oil.viscosity());
  return with_film_law(film, [&]<class Law>() { return film_force<Law, FiftyDigits>(same_bearing, same_oil, state); });
}

inline PolarFilmState<FiftyDigits> in_fifty_digits(const PolarFilmState<double>& s) {
  return {FiftyDigits(s.eccentricity_ratio), FiftyDigits(s.slip_rate), FiftyDigits(s.squeeze_rate)};
}

/// True errors of an estimate against the reference [N].
struct TrueError {
  double radial;
  double tangential;
  double size;  ///< |F|
};

inline TrueError true_error(const oracle::FilmForceEstimate& f, const PolarForce<FiftyDigits>& exact) {
  return {static_cast<double>(abs(exact.radial - f.radial.value)),
          static_cast<double>(abs(exact.tangential - f.tangential.value)),
          static_cast<double>(sqrt(exact.radial * exact.radial + exact.tangential * exact.tangential))};
}

/// Seeded random states. ε: uniform on [0, 1), or 1 − ε or ε itself uniform in its logarithm (to 1e-15 and 1e-12).
/// Direction: uniform over the turn, or near a = 0 or b = 0 with the smaller rate down to 1e-10, or on them.
class RandomStates {
 public:
  explicit RandomStates(std::uint64_t seed) : generator_(seed) {}

  PolarFilmState<double> operator()() {
    const double kind = part();
    double epsilon = part();
    if (kind < 0.4) epsilon = 1 - std::pow(10, -15 * epsilon);
    if (kind > 0.9) epsilon = std::pow(10, -12 * epsilon);
    const double angle = 2 * std::numbers::pi * part();
    double a = 2 * std::cos(angle);
    double b = std::sin(angle);
    const double special = part();
    if (special < 0.25) {
      b *= std::pow(10, -10 * part());
    } else if (special < 0.5) {
      a *= std::pow(10, -10 * part());
    } else if (special < 0.55) {
      (special < 0.525 ? a : b) = 0;
    }
    return {epsilon, a, b};
  }

 private:
  double part() { return std::uniform_real_distribution<double>(0, 1)(generator_); }
  std::mt19937_64 generator_;
};

}  // namespace lubjoint::test
