/// What the race says, in words: for the terminal, and for the README.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/measure/bench/scene_bench.hpp"

namespace lubjoint::reports {

/// By race: each integrator's times at equal error, its least error, and how many times as long as Radau IIA(5) it
/// takes; then the fastest of all and what to use.
/// @param references  of the scenes, as far as they are known
std::string scene_bench_table(const std::vector<BenchRow>& rows, const std::vector<BenchReference>& references = {});

/// The table of the README: for each race and each of judged_errors Radau's time, how many times as long the fastest of
/// CVODE and IDA and Simbody took, and the winner; then how often each integrator wins. A dash where one was not run or
/// does not reach the error. Where mechanisms were turned out of their planes, a second table: Radau's times in
/// absolute over those in minimal coordinates, and in space over those in the plane.
std::string scene_bench_markdown(const std::vector<BenchRow>& rows);

inline constexpr std::string_view bench_block_begin = "<!-- bench scenes -->\n";
inline constexpr std::string_view bench_block_end = "<!-- end of bench scenes -->\n";

/// The text with what stands between the two marks replaced.
/// @throws std::invalid_argument unless each mark is there once, in this order
std::string with_bench_block(std::string_view text, const std::string& block);

}  // namespace lubjoint::reports
