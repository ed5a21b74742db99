/// The stability matrix as text and as a heat map.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oracle/measure/stress/stress.hpp"

namespace lubjoint::reports {

/// Cases × integrators, the worst over the laws; then every kind of stop with its count, and every wrong cell.
std::string stress_table(const std::vector<StressCase>& cases, const std::vector<StressCell>& cells);

/// "1842 finished, 3 coarse, 72 unreferenced, 846 stopped, 0 wrong".
std::string stress_counts(const std::vector<StressCell>& cells);

/// The README's sentence: "53 extreme cases with every law and integrator: …".
std::string stress_sentence(const std::vector<StressCell>& cells);

/// Which sources made the cells, and whether they are this program's.
std::string measured_by(const std::vector<StressCell>& cells);

/// Heat map of the same matrix, stress.svg and stress.png. @throws OutputError
void draw_stress(const std::vector<StressCell>& cells, const std::filesystem::path& folder);

/// A message without what differs from cell to cell: numbers as #, without the time and place it starts with.
std::string stop_kind(const std::string& message);

}  // namespace lubjoint::reports
