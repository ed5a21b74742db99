/// Forces over arrays, and how many of them are not those of one state after the other.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "lubjoint/film/batch.hpp"

namespace lubjoint::test {

inline constexpr double untouched = 12345;  ///< what no batch has written to

/// Components of forces, untouched.
struct Forces {
  std::vector<double> first, second;
  explicit Forces(std::size_t n) : first(n, untouched), second(n, untouched) {}
  operator ForceArrays() { return {first, second}; }
};

inline bool same_bits(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }

/// Rows whose bits differ from what force(i) gives.
template <class Force>
std::size_t differing_rows(const Forces& found, const Force& force) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < found.first.size(); ++i) {
    const Vector2<double> one = force(i);
    differing += !same_bits(found.first[i], one.x()) || !same_bits(found.second[i], one.y());
  }
  return differing;
}

}  // namespace lubjoint::test
