/// Extreme cases by name, and how tests run them.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "oracle/measure/stress/stress.hpp"

namespace lubjoint::test {

using namespace lubjoint::reports;

/// In the order of the matrix.
inline std::vector<StressCase> cases_named(const std::set<std::string>& names) {
  std::vector<StressCase> wanted;
  for (StressCase& each : stress_cases(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes")) {
    if (names.count(each.name)) wanted.push_back(std::move(each));
  }
  REQUIRE(wanted.size() == names.size());
  return wanted;
}

/// The scene of one.
inline Scene scene_named(const std::string& name) { return cases_named({name}).front().scene; }

/// Folder with the stored references.
inline const std::filesystem::path measured = std::string(LUBJOINT_SOURCE_DIR) + "/data/measured";

/// Read once.
inline const StressReferences& stored_references() {
  static const StressReferences references = StressReferences::read(measured);
  return references;
}

/// Few laws, integrators and steps.
inline StressSettings small_settings() {
  StressSettings settings = stress_settings(true);
  settings.integrators = {"radau_iia5", "dopri5", "auto"};
  settings.most_steps = 2000;
  settings.threads = 2;
  settings.references = stored_references();
  return settings;
}

}  // namespace lubjoint::test
