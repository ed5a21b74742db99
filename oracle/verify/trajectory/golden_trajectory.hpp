/// The golden trajectories as a check of our own runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "oracle/verify/trajectory/scene_verification.hpp"

namespace lubjoint::verify {

/// How far a reference is from the golden trajectory of the same scene, at the golden times.
struct GoldenAgreement {
  std::string file;
  std::size_t times = 0;
  double worst = 0;      ///< distance over the signal's scale, the largest of all
  double allowance = 0;  ///< a hundredth of the tolerance that trajectories are judged with
  bool confirms() const { return worst <= allowance; }
};

/// None if the scene is not one that ships, byte for byte, or has a law for which there is no golden trajectory.
/// @param scenes, golden  folders of the shipped scenes and of the golden data
/// @throws UnjudgedError if the golden trajectory can't be read
std::optional<GoldenAgreement> golden_agreement(const SceneReference& reference, const std::filesystem::path& scenes,
                                                const std::filesystem::path& golden);

}  // namespace lubjoint::verify
