/// Is the tolerance of a run small against the thinnest film in it?
#pragma once

#include <string>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// A run's tolerance of places may be so large a share of its thinnest film: the force and the rate at which a journal
/// creeps along the wall follow the thickness, to a power of ½ to 5/2.
inline constexpr double coarse_share = 1e-3;
/// Below this, steps are bound by rounding and not by the tolerance.
inline constexpr double tightest_tolerance = 1e-13;
/// The film's force follows its thickness to this power at most: the radial force of a short film.
inline constexpr double film_power = 2.5;

/// The tolerance of a run's places [clearances]. Next to its wall a free journal's state is 1 clearance: the relative
/// tolerance is of its place, too.
double tolerance_of_places(const Scene& scene);

/// The thinnest film of a joint, over its clearance; 1 for a joint without a film. A film that gives way to contact is
/// widened by the transition's e₁, and no thinner.
double thinnest_film(const Scene& scene, const JournalTrajectory& run);
/// The same of one of several joints.
double thinnest_film(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run);

/// The same of a joint whose journal came so far.
/// @param farthest  largest |e| [m]
double thinnest_film(const SceneJoint& joint, double farthest);

/// May the error of one step, τ, change the film's force by more than a tenth, 5τ/2h > 1/10? Then no digit of the
/// force is known, nor of the velocity that follows it.
/// @param thinnest  h, as above
bool leaves_no_digit(const Scene& scene, double thinnest);

/// Says that the tolerance is too coarse for the film, whether it leaves a digit of forces and velocities, and which
/// would do; empty if it is not too coarse.
/// @param thinnest  as above
std::string resolution_warning(const Scene& scene, const SceneJoint& joint, double thinnest);

/// What Fehlberg's estimate may leave unseen, in places [clearances]; 0 for another integrator. It looks at the step's
/// ends alone. A kink of the force inside, as Pinkus and Sternlicht's where ε̇ changes sign, leaves 1e-9 clearances in a
/// run of the impact, whatever the tolerance: ten times that, where a tolerance is below 1e-11. Steps through a film
/// that gives way to contact leave up to 4e-3 at a tolerance of 1e-6 and 1e-5 at 1e-8: 1e4 tolerances, at most 0.1,
/// where the run has come so far.
/// @param integrator  that made the run;  @param thinnest  as above
double unseen_error(const Scene& scene, const SceneJoint& joint, const std::string& integrator, double thinnest);

/// Says so, with what keeps the tolerance; empty where nothing is left unseen.
/// @param integrator, thinnest  as above
std::string unseen_warning(const Scene& scene, const SceneJoint& joint, const std::string& integrator, double thinnest);

}  // namespace lubjoint::reports
