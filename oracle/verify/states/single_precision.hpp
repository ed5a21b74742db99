/// Numbers of single precision, by their bits: GCC 12 at -O2 drops pairs of conversions double → float → double that
/// stand beside each other.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace lubjoint::verify {

inline constexpr std::uint64_t bits_below_single = (std::uint64_t{1} << 29) - 1;

/// x with its significand cut to 24 bits; |x| in the range of single precision's normal numbers, or 0.
inline double in_single(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~bits_below_single);
}

/// True for 0 and the normal numbers of single precision.
inline bool is_single(double x) {
  const double size = std::abs(x);
  if (size != 0 && !(size >= 0x1p-126 && size < 0x1p128)) return false;
  return (std::bit_cast<std::uint64_t>(x) & bits_below_single) == 0;
}

}  // namespace lubjoint::verify
