/// Wrong by a factor: which number it is, in words.
#pragma once

#include <string>
#include <vector>

namespace lubjoint::verify {

/// "1/pi", "-2", "3/4", "pi/2", "60/(2 pi)", "1e+03": ±2^i 3^j π^k with small exponents, powers of ten, and the factors
/// of units of speed; empty if it is none of them.
/// @param precision  relative, of the number given; at most 0.02
std::string factor_words(double factor, double precision);

}  // namespace lubjoint::verify
