/// What every report says first of a run: how it ended, by which integrator, at what cost.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/run/outcome.hpp"

namespace lubjoint::reports {

/// Keys scene, law, integrator (the one that ran), integrator_reason (why `auto` picked it; empty if the scene names
/// it), coordinates ("own" of a journal alone) and coordinates_reason (likewise), status, message, t_end, steps,
/// rejected_steps, rhs_evaluations, wall_s.
nlohmann::ordered_json outcome_json(const std::string& scene, const std::string& law, const RunOutcome& outcome,
                                    double wall_seconds);

/// The same as lines of text.
std::string outcome_text(const std::string& scene, const std::string& law, const RunOutcome& outcome,
                         double wall_seconds);

/// A line that says from when to when a joint's half film slid on its jump [s].
std::string slide_text(double start, double end);

/// A joint's extremes: largest ε with the film there, or the indentation, and when, largest force [N] and when [s].
/// @param gap  c − |e| [m]; below 0 it is an indentation, and there is no film
std::string extremes_words(double eccentricity_ratio, double gap, double t_gap, double force, double t_force);

/// The line of a summary that says so.
std::string extremes_text(double eccentricity_ratio, double gap, double t_gap, double force, double t_force);

}  // namespace lubjoint::reports
