/// Friction torques, power and side flow along the run of a journal whose spin is held.
#pragma once

#include "lubjoint/motion/journal_recorder.hpp"
#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// Losses at a sample of a free journal's run. With the spin held they enter no equation of its motion, so that its
/// four states are all that is integrated.
/// @returns nothing in any field if the joint has no shear
LossSample journal_losses(const Scene& scene, const JournalSample& sample);

}  // namespace lubjoint
