/// Closing the loops of a scene whose bodies' places are rough guesses.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lubjoint/multibody/start_correction.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

/// What an assembly is asked for.
struct AssemblyRequest {
  /// Angles of drivers, or of bodies that are to be held for the assembly alone, by name [rad].
  std::vector<std::pair<std::string, double>> angles = {};
  /// Joints with clearance whose journals stay where they are; all others are closed like pins, their journals at the
  /// centre.
  std::vector<std::string> open_joints = {};
  std::size_t other_starts = 200;  ///< from which other branches are looked for
};

/// One way in which the loops close.
struct AssemblyBranch {
  std::vector<double> state;           ///< (q, q̇) as planar_system has them
  double distance;                     ///< from the guesses, √Σ(m|Δr|² + IΔφ²) [√kg m]
  StartCorrection<double> correction;  ///< by how much it changes them
  std::vector<int> signs;              ///< of each of SceneAssembly::signs: 1, −1; 0 where it is aligned
};

/// A sign that tells branches apart: the sense in which three joints follow each other, or of a way along a guide.
struct AssemblySign {
  std::string name;       ///< "A, B, C", or "A to B along C"
  bool of_guide = false;  ///< forwards and backwards, in place of counter-clockwise and clockwise
};

/// All the ways that were found.
struct SceneAssembly {
  std::vector<AssemblyBranch> branches;  ///< that of the guesses first, then by distance
  std::vector<AssemblySign> signs;       ///< enough to tell them apart, if any can; one where there is one branch
  bool guesses_lead = true;              ///< does Newton's method arrive from the guesses? Else the nearest comes first
  std::size_t freedoms = 0;              ///< that nothing holds; with any, other branches are not looked for
  std::size_t other_starts = 0;          ///< that were tried
  std::size_t arrived = 0;               ///< how many of them led to a branch
};

/// Positions that fulfil all constraints, by damped Gauss–Newton steps of least kinetic-energy norm from the scene's
/// places, and then velocities, changed by as little in that norm. Joints with clearance count as pins.
/// @throws SceneError  a name that the scene has not, constraints that repeat or contradict each other there, or that
/// no
///   position near any start fulfils
SceneAssembly assemble_scene(const Scene& scene, const AssemblyRequest& request = {});

/// The text of the scene's file with the places and velocities of an assembled branch, and with the drivers' angles
/// that were asked for; all else stays. Read again, the text is that scene.
/// @throws SceneError
std::string assembled_text(const SceneFile& file, const Scene& scene, const AssemblyRequest& request,
                           const AssemblyBranch& branch);

/// Numbers of a scene file, at a key of an element of one of its lists.
struct WrittenNumbers {
  std::string table;             ///< "bodies" or "constraints"
  std::size_t element;           ///< which of them
  std::string key;               ///< of the element; added where it is not there
  std::vector<double> numbers;   ///< one, or two of an array
  bool zero_is_default = false;  ///< is a key of zeros that is not there left out?
};

/// The text with those numbers in place of the file's. Comments and all else stay.
/// @throws SceneError
std::string with_numbers(const SceneFile& file, const std::vector<WrittenNumbers>& all);

/// The text with the places and velocities of a state as its start, and with other numbers. What it says is what it
/// reads as.
/// @param state  (q, q̇)
/// @throws SceneError
std::string with_start(const SceneFile& file, const Scene& scene, const std::vector<double>& state,
                       std::vector<WrittenNumbers> numbers = {});

}  // namespace lubjoint
