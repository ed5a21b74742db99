/// The certified golden data as questions to a program, with the certified answers.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

/// What the golden data say about one state.
struct GoldenAnswers {
  struct Row {
    std::array<Real, most_answers> answer{};  ///< the 30 digits, rounded to what Real holds
    std::size_t line = 0;                     ///< of the file, the header being 1
  };
  std::string file;                                     ///< "film_force.csv"
  std::array<std::optional<Row>, every_law_count> row;  ///< by law; none where the file does not say
};

/// Largest magnitude of a number that a program in double precision is asked about, and one over the smallest: its
/// fourth power is still a double, so that no product in a plain program overflows.
inline constexpr double largest_in_double = 1e75;

/// The states of the golden table that has these quantities, each once, in the table's order; there is none without
/// dimensions. Left out are rows that a state can't say (a slip rate at ε = 0 in polar quantities), numbers beyond
/// largest_in_double, and pressures within 1e-3 of θ = 0 or π, where a half film may count as its inside or its
/// outside. A slip rate a is handed over as ω and γ̇ such that ε(ω − 2γ̇) is a, to twice the digits of a double.
/// @param folder  of the golden data
/// @throws std::invalid_argument that names the file, if it is missing or not what it should be
std::vector<State> golden_states(Quantities quantities, const std::filesystem::path& folder);

}  // namespace lubjoint::verify
