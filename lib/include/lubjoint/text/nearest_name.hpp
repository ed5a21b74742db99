/// What a misspelt name may have meant.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lubjoint {

/// Levenshtein's distance: how many letters to insert, remove or replace.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, substituted}));
    }
  }
  return row.back();
}

/// The name that differs least from the one given; empty if none is close (more than one letter and a third of them
/// off).
template <class Names>
std::string nearest_name(const Names& names, std::string_view given) {
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return edit_distance(a, given) < edit_distance(b, given);
  });
  if (nearest == names.end() || edit_distance(*nearest, given) > 1 + given.size() / 3) return {};
  return std::string(*nearest);
}

/// "one of A, B, C", and which of them was probably meant.
template <class Names>
std::string one_of(const Names& names, std::string_view given) {
  std::string words = "one of ";
  bool first = true;
  for (const auto& name : names) {
    words += (std::exchange(first, false) ? "" : ", ") + std::string(name);
  }
  const std::string nearest = nearest_name(names, given);
  return nearest.empty() ? words : words + "; did you mean " + nearest + "?";
}

}  // namespace lubjoint
