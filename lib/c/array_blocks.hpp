/// Arrays with strides, handed to the batch evaluation.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "array_rows.hpp"
#include "lubjoint/film/batch.hpp"

namespace lubjoint::c {

/// The bytes from the first element to the end of the last.
struct Extent {
  std::intptr_t begin, end, stride;
};

template <class Array>
Extent extent_of(const Array& array, std::size_t n) {
  const auto first = reinterpret_cast<std::intptr_t>(array.data);
  const std::intptr_t last = first + static_cast<std::ptrdiff_t>(n - 1) * array.stride;
  return {std::min(first, last), std::max(first, last) + static_cast<std::ptrdiff_t>(sizeof(double)), array.stride};
}

/// True unless no element of one array is an element of the other in another row: they lie apart, they are the same, or
/// they are columns of one table.
inline bool rows_may_mix(const Extent& a, const Extent& b) {
  if (a.end <= b.begin || b.end <= a.begin) return false;
  if (a.stride != b.stride) return true;
  if (a.begin == b.begin) return false;
  const std::intptr_t width = std::abs(a.stride);
  if (width == 0) return true;
  const std::intptr_t apart = std::abs(a.begin - b.begin) % width;
  constexpr std::intptr_t element = sizeof(double);
  return apart < element || width - apart < element;
}

/// Calls evaluate(inputs, forces) with spans over all n rows: at once where the arrays have no gaps, otherwise block by
/// block through copies, and row by row, in order, where writing one row could change the input of another.
/// @throws FilmRowError, ForceRowError with the row of the arrays
template <std::size_t inputs, class Evaluate>
void for_blocks(std::size_t n, const std::array<lubjoint_in, inputs>& in, const lubjoint_out& first,
                const lubjoint_out& second, const Evaluate& evaluate) {
  if (n == 0) return;
  constexpr std::ptrdiff_t dense = sizeof(double);
  constexpr std::size_t capacity = 512;
  const Extent to[2] = {extent_of(first, n), extent_of(second, n)};
  bool mix = rows_may_mix(to[0], to[1]) || first.data == second.data;
  bool all_dense = first.stride == dense && second.stride == dense;
  for (const lubjoint_in& array : in) {
    const Extent from = extent_of(array, n);
    mix = mix || rows_may_mix(from, to[0]) || rows_may_mix(from, to[1]);
    all_dense = all_dense && array.stride == dense;
  }
  const std::size_t rows = mix ? 1 : all_dense ? n : std::min(n, capacity);

  std::array<std::array<double, capacity>, inputs> copies;
  std::array<bool, inputs> constant;
  for (std::size_t k = 0; k < inputs; ++k) constant[k] = in[k].stride == 0 && !mix;
  std::array<double, capacity> first_copy;
  std::array<double, capacity> second_copy;
  for (std::size_t begin = 0; begin < n; begin += rows) {
    const std::size_t count = std::min(rows, n - begin);
    std::array<std::span<const double>, inputs> from;
    for (std::size_t k = 0; k < inputs; ++k) {
      from[k] = {in[k].stride == dense && !mix ? in[k].data + begin : copies[k].data(), count};
      if (from[k].data() != copies[k].data() || (constant[k] && begin > 0)) continue;
      for (std::size_t i = 0; i < count; ++i) copies[k][i] = at(in[k], begin + i);
    }
    const bool direct = first.stride == dense && second.stride == dense && !mix;
    const ForceArrays forces = direct ? ForceArrays{{first.data + begin, count}, {second.data + begin, count}}
                                      : ForceArrays{{first_copy.data(), count}, {second_copy.data(), count}};
    const auto answer = [&](std::size_t answered) {
      for (std::size_t i = 0; !direct && i < answered; ++i) {
        put(first, begin + i, first_copy[i]);
        put(second, begin + i, second_copy[i]);
      }
    };
    try {
      evaluate(from, forces);
    } catch (const FilmRowError& error) {
      answer(error.row());
      throw FilmRowError(begin + error.row(), error.reason());
    } catch (const ForceRowError& error) {
      answer(error.row());
      throw ForceRowError(begin + error.row());
    }
    answer(count);
  }
}

}  // namespace lubjoint::c
