// Runs a scene file: scene_file FILE. The journal of the scene that ships, under its load, stays off the wall.
#include "lubjoint/scene/scene_file.hpp"

#include <cstdio>
#include <exception>

#include "lubjoint/scene/simulate.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const lubjoint::JournalTrajectory run = lubjoint::simulate_journal(lubjoint::load_scene(argv[1]));
  std::printf("scene: largest e/c %.6f\n", run.max_eccentricity_ratio);
  const bool plausible = run.max_eccentricity_ratio > 0 && run.max_eccentricity_ratio < 1;
  return run.outcome.status == lubjoint::RunStatus::finished && plausible ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
