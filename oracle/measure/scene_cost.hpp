/// What a scene pays for in one right-hand side, what it leaves out, and what that would cost.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/scene/spatial_scene.hpp"

namespace lubjoint::reports {

/// A part of one right-hand side. The last one is what the others leave: a difference of times, of either sign.
struct CostPart {
  std::string name;
  double nanoseconds;
  double share;  ///< of the whole
};

/// The same scene with one thing switched on or off.
struct CostVariant {
  std::string feature;
  bool in_scene;       ///< then it is switched off here
  std::string change;  ///< what was done to the scene
  double nanoseconds;  ///< of its right-hand side
  double ratio;        ///< to the scene's own right-hand side
};

/// A time beside that of the right-hand side.
struct OtherCost {
  std::string what;
  double nanoseconds;
  double ratio;  ///< to one right-hand side
};

struct SceneCost {
  std::string scene;
  bool free_journal = false;  ///< its own equations, without multipliers and without a solve
  bool in_space = false;
  std::size_t bodies = 0;
  std::size_t coordinates = 0;
  std::size_t velocities = 0;  ///< columns of the constraints' Jacobian
  std::size_t states = 0;      ///< with the ledger's
  std::size_t constraints = 0;
  std::size_t constraint_rows = 0;  ///< as many multipliers
  std::size_t constraint_nonzeros = 0;
  std::size_t rate_nonzeros = 0;  ///< of the Jacobian of the right-hand side
  std::size_t schur_stored = 0;
  std::vector<std::pair<std::string, std::size_t>> films;  ///< law, number of joints
  std::size_t contacts = 0;
  std::size_t loads = 0;         ///< of any kind
  std::size_t moving_loads = 0;  ///< those that are not constant, inertial and through the mass centre
  std::size_t springs = 0;
  std::size_t weights = 0;
  std::size_t contact_seams = 0;  ///< at which a run looks for events
  std::size_t film_jumps = 0;     ///< of half films, followed event by event
  std::size_t ledger_terms = 0;
  double nanoseconds = 0;  ///< one right-hand side
  std::vector<CostPart> parts;
  std::size_t jacobian_passes = 0;
  double jacobian_nanoseconds = 0;
  double jacobian_ratio = 0;           ///< to one right-hand side
  std::string runs_in;                 ///< "independent" or "absolute" coordinates; empty of a free journal
  std::string runs_in_reason;          ///< empty if the scene names them
  std::vector<OtherCost> independent;  ///< the right-hand side and its Jacobian in independent ones, if it runs in them
  std::vector<CostVariant> variants;
  std::vector<OtherCost> phases;  ///< the right-hand side in the phases of a contact that the scene has
  std::vector<OtherCost> steps;   ///< what is paid once a step if it is asked for
};

/// Counts, and times of this machine at a state near the scene's start: medians of rounds in which all pieces run in
/// turn. Ratios are medians of the ratios in a round.
/// @throws SceneError  the scene can't start
SceneCost scene_cost(const Scene& scene, std::size_t rounds);
SceneCost scene_cost(const SpatialScene& scene, std::size_t rounds);  ///< likewise

nlohmann::ordered_json cost_json(const SceneCost& cost);
std::string cost_text(const SceneCost& cost);

}  // namespace lubjoint::reports
