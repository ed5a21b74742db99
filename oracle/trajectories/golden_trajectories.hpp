/// The golden trajectories: one file for each law of the free journal, one for each other scene.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "oracle/files/golden_files.hpp"
#include "oracle/trajectories/multibody_trajectory.hpp"
#include "oracle/trajectories/second_derivation.hpp"

namespace lubjoint::reports {

struct GoldenTrajectory {
  std::string file;
  double duration;  ///< of the scene, and the time of the last row [s]
  std::function<ReferenceCsv()> make;
  std::function<SecondAgreement(const CsvTable&)> second;  ///< compares a file with its second derivation
};

/// Of all scenes of a folder, in the order of their names.
/// @throws SceneError
std::vector<GoldenTrajectory> golden_trajectories(const std::filesystem::path& scenes);

struct TrajectoryRun {
  unsigned threads = 0;                            ///< 0: one a core
  bool fresh = false;                              ///< writing: also those that are there already
  std::function<void(const std::string&)> report;  ///< one line for each file, from one thread at a time
};

/// Writes the files that are not there (each when it is done: an interrupted run goes on where it was), then the
/// manifest of all. A trajectory that disagrees with its second derivation is not written.
/// @throws OutputError, std::runtime_error; std::invalid_argument if a file that is there is cut off
void write_golden_trajectories(const std::filesystem::path& folder, const std::vector<GoldenTrajectory>& trajectories,
                               const TrajectoryRun& run);

/// Makes all of them again and compares byte for byte; compares the files with their second derivations.
std::vector<GoldenDifference> check_golden_trajectories(const std::filesystem::path& folder,
                                                        const std::vector<GoldenTrajectory>& trajectories,
                                                        const TrajectoryRun& run);

}  // namespace lubjoint::reports
