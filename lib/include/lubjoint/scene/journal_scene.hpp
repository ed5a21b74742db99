/// Scenes of one free journal in a fixed bearing.
#pragma once

#include "lubjoint/multibody/free_journal.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// The parts of a scene with one body, whose journal runs in a bearing on the ground.
struct JournalScene {
  Bearing<double> bearing;                    ///< L, R, c
  Lubricant<double> oil;                      ///< μ
  JournalDrive<double> drive;                 ///< mass, load with weight, spins
  JournalState<double> start;                 ///< ê and w at t = 0
  std::string law;                            ///< name of the film's law
  std::shared_ptr<const CompiledFilm> table;  ///< of a law that is compiled
};

/// The parts of a scene that is a free journal.
/// @throws SceneError if the scene is no free journal, naming what it has too much or too little of, or if the journal
/// starts outside its bearing
JournalScene journal_scene(const Scene& scene);

}  // namespace lubjoint
