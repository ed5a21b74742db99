/// Simbody on the same mechanism, in its own coordinates: what a user would otherwise pick. Optional when the program
/// is built.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/measure/bench/bench_case.hpp"
#include "oracle/mechanisms/simbody_run.hpp"

namespace lubjoint::reports {

/// simbody_cpodes. Empty if Simbody was not built in.
std::vector<std::string_view> simbody_methods();

/// @param scene  one that has_minimal_coordinates()
/// @returns nothing if Simbody was not built in
std::unique_ptr<BenchCase> simbody_case(const Scene& scene, const std::vector<double>& times,
                                        const Reference& reference);

/// A run of Simbody as a row of the race; where it was built in.
MethodRun method_run(const mechanisms::SimbodyOutcome& run);

/// "3.7.0"; empty if Simbody was not built in.
std::string simbody_version();

}  // namespace lubjoint::reports
