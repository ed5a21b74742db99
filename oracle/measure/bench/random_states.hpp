/// States that the laws' evaluations are timed on.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "lubjoint/film/batch.hpp"

namespace lubjoint::reports {

/// Columns of numbers that go into batches, and room for what comes out.
struct RandomStates {
  std::vector<double> epsilon, ex, ey, ux, uy, first, second;

  /// @param limit  of ε
  RandomStates(std::size_t rows, double limit) : first(rows), second(rows) {
    std::mt19937_64 generator(20090331);
    const auto unit = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
    for (std::size_t i = 0; i < rows; ++i) {
      epsilon.push_back(limit * unit());
      const double attitude = 6.283185307179586 * unit();
      const double course = 6.283185307179586 * unit();
      ex.push_back(epsilon.back() * std::cos(attitude));
      ey.push_back(epsilon.back() * std::sin(attitude));
      ux.push_back(std::cos(course));
      uy.push_back(std::sin(course));
    }
  }

  std::size_t rows() const { return ex.size(); }
  FilmStateArrays in() const { return {ex, ey, ux, uy}; }
  ForceArrays out() { return {first, second}; }
};

inline constexpr std::size_t timed_rows = 512;  ///< inputs and outputs lie in the first cache
inline constexpr int timed_calls = 8;           ///< in a row, so that they do

}  // namespace lubjoint::reports
