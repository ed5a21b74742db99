/// From balls to decimal digits that are guaranteed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/certified/ball.hpp"

namespace lubjoint::certified {

/// A decimal number and a bound of its distance from the true one.
struct CertifiedNumber {
  std::string value;        ///< 30 significant digits, scientific; fewer where they are exact
  std::string uncertainty;  ///< 0.51 units of the 30th digit; 0 where the value is exact
};

inline constexpr int printed_digits = 30;

/// Evaluates balls with more and more bits until each determines 30 digits, and prints them. The distance of the
/// printed number from the whole ball is checked in ball arithmetic.
/// @param evaluate  the balls at the working precision; may throw Undecided
/// @throws std::runtime_error if thousands of bits are not enough (a result that is zero without being known as zero)
std::vector<CertifiedNumber> certify(const std::function<std::vector<Ball>()>& evaluate);

/// Bits that a ball must determine before it is printed: the printed digits and a millionth of the last.
inline constexpr slong required_bits = 120;

}  // namespace lubjoint::certified
