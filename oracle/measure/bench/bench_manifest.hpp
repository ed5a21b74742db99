/// bench-scenes.json: which program measured the rows beside it, on which machine. No dates, no names of hosts.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oracle/measure/bench/scene_bench.hpp"

namespace lubjoint::reports {

using WordPairs = std::vector<std::pair<std::string, std::string>>;

/// @param csv       the rows, which the manifest belongs to by their checksum
/// @param opponents  "sundials" and "simbody" with their versions; empty where the program was built without
/// @param software  names and versions of what the program was built with
/// @param machine   processor, system
std::string bench_manifest(std::string_view csv, const SceneBenchSettings& settings, const WordPairs& opponents,
                           const WordPairs& software, const WordPairs& machine);

/// One sentence of it: program, opponents, processor, repeats.
/// @param name  of the manifest's file, for messages
/// @throws std::invalid_argument if it is no such manifest, or not of this CSV
std::string measured_by(const std::string& manifest, std::string_view csv, const std::string& name);

}  // namespace lubjoint::reports
