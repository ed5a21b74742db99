/// A spatial slider-crank with a clearance joint in Simbody, a multibody engine that nobody here wrote. In plain
/// numbers, and C++17: Simbody's headers are no C++20. Optional when the program is built.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "oracle/mechanisms/simbody_run.hpp"

namespace lubjoint::mechanisms {

/// Components along three axes.
using SimbodyVector = std::array<double, 3>;

/// A point of a body and two perpendicular unit vectors through it, in the body's axes, from its mass centre.
struct SimbodyAxes {
  SimbodyVector point;  ///< [m]
  SimbodyVector axis;
  SimbodyVector across;
};

/// A rigid body and its state at the start. SI units.
struct SimbodyBody {
  double mass;
  std::array<double, 6> inertia;   ///< Jxx, Jyy, Jzz, Jxy, Jxz, Jyz about the mass centre, in the body's axes
  SimbodyVector position;          ///< of the mass centre, inertial
  std::array<double, 9> rotation;  ///< row by row: takes components in the body's axes to inertial ones
  SimbodyVector velocity;          ///< of the mass centre, inertial
  SimbodyVector spin;              ///< angular velocity, inertial
};

/// The film between journal and bearing as it is seen from the bearing; inertial components.
struct SimbodyFilm {
  SimbodyVector axis;  ///< n of the bearing, a unit vector
  SimbodyVector
      eccentricity;        ///< e = X − P_i, X where the journal's axis pierces the plane through P_i normal to n [m]
  SimbodyVector velocity;  ///< v_B, the rate of e seen from the bearing [m/s]
  double spin;             ///< ω = n·(ω_J − ω_B) [rad/s]
};

/// What the film does: a force on the journal, and its opposite on the bearing, at one point of space.
struct SimbodyFilmForce {
  SimbodyVector force;  ///< [N]
  SimbodyVector point;  ///< where it acts, from P_i [m]
};

/// The law of a film. It may throw where there is none: the step is then tried again, shorter.
using SimbodyFilmLaw = std::function<SimbodyFilmForce(const SimbodyFilm&)>;

/// A crank on the ground, free under gravity; a rod with a ball at the crank; a slider on a guide about which it turns.
/// Thrust faces hold rod and slider parallel and level along their axes; across them there is the film alone, the
/// bearing on the rod and the journal on the slider.
struct SimbodySpatialProblem {
  SimbodyBody crank;
  SimbodyBody rod;
  SimbodyBody slider;
  SimbodyVector gravity;
  SimbodyAxes main_bearing;         ///< of the ground
  SimbodyAxes main_journal;         ///< of the crank
  SimbodyVector crank_pin;          ///< the ball, on the crank
  SimbodyVector rod_end;            ///< the ball, on the rod
  SimbodyAxes guide;                ///< of the ground
  SimbodyAxes guided;               ///< of the slider
  SimbodyAxes thrust_of_rod;        ///< the faces on the rod: their axis, and a point at their height
  SimbodyAxes thrust_of_slider;     ///< those of the slider
  SimbodyVector bearing_centre;     ///< P_i, on the rod
  SimbodyVector bearing_direction;  ///< n, on the rod
  SimbodyVector journal_centre;     ///< P_j, on the slider
  SimbodyVector journal_direction;  ///< n_J, on the slider
  SimbodyFilmLaw film;
};

/// Slider (Cylinder on the ground), rod (Planar on the slider) and crank (Pin on the ground), a Ball between rod and
/// crank, and the film a custom force: six coordinates and three constraints. The journal's place is among the
/// coordinates, so that no digit of it is lost to those of the bodies.
class SimbodySpatialEngine {
 public:
  explicit SimbodySpatialEngine(const SimbodySpatialProblem& problem);
  ~SimbodySpatialEngine();
  SimbodySpatialEngine(const SimbodySpatialEngine&) = delete;
  SimbodySpatialEngine& operator=(const SimbodySpatialEngine&) = delete;

  /// By CPodes' BDF with Newton's iteration, as SimbodyEngine. The ball is closed by projection at the end of every
  /// step: where it is only closed when it is off by more than Simbody allows, a tenth of the accuracy, those few ends
  /// disturb the steps that follow, and runs take up to five times the steps or stop with a state that is not finite.
  /// @param accuracy  Simbody's only tolerance, the same for all states
  /// @param duration  [s]
  /// @param times     to be looked at, ascending; none: only the end is reached, for its run time
  /// @param seconds   of processor time after which the run is given up
  SimbodyRun<SimbodyFilm> run(double accuracy, double duration, const std::vector<double>& times, double seconds);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace lubjoint::mechanisms
