/// Values as a page prints them: a number agrees if it rounds to the digits that are there.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string>

namespace lubjoint::test {

/// Distance of a number from a printed one, in units of the last digit printed: at most 0.5 where all digits are right.
template <class R>
double units_of_last_digit(const R& value, std::string printed) {
  using boost::multiprecision::abs;
  using boost::multiprecision::pow;
  const auto exponent_at = printed.find('e');
  const int exponent = exponent_at == std::string::npos ? 0 : std::stoi(printed.substr(exponent_at + 1));
  const std::string digits = printed.substr(0, exponent_at);
  const auto point = digits.find('.');
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(digits.size() - point - 1);
  const R unit = pow(R(10), exponent - decimals);
  return static_cast<double>(R(abs(R(value - R(printed))) / unit));
}

}  // namespace lubjoint::test
