/// What a run of a multibody system leaves behind.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lubjoint/joint/transition.hpp"
#include "lubjoint/number/vector.hpp"

namespace lubjoint {

/// Terms of the energy ledger, integrated along: work since the start [J].
enum class LedgerTerm {
  loads,        ///< of constant forces other than weight, and constant moments
  drivers,      ///< of the drivers' moments
  film,         ///< of the films on their pairs, friction torque included: never positive with shear. Without it whirl
                ///< takes from a spin that pays no torque
  contact,      ///< of dry contact and friction
  constraints,  ///< of the other constraints: zero but for their drift
  dampers       ///< of the dampers of springs, never positive; in systems that have any
};
inline constexpr std::size_t ledger_terms = 5;  ///< number of them without dampers
/// Their names, in order; "dampers" is the last, and only where there are any.
inline constexpr std::array<const char*, ledger_terms + 1> ledger_names = {"loads",   "drivers",     "film",
                                                                           "contact", "constraints", "dampers"};

/// What the oil of a joint with shear costs at an instant; what is not defined (in dry contact; the side flow of a long
/// bearing) is not there.
struct LossSample {
  std::optional<double> torque_journal;  ///< about the journal's centre [N m]
  std::optional<double> torque_bearing;  ///< about the bearing's centre [N m]
  std::optional<double> power;           ///< lost in the film [W]
  std::optional<double> side_flow;       ///< out of both sides [m³/s]
};

/// A joint at an instant.
struct JointSample {
  Vector2<double> eccentricity;  ///< e [m]
  Vector2<double> force;         ///< on the journal [N]
  double eccentricity_ratio;     ///< ε = |e|/c
  double film_thickness;         ///< c − |e|; negative in contact [m]
  LossSample losses = {};        ///< of a joint with shear
};

/// A system at an instant.
struct MultibodySample {
  double t;                             ///< [s]
  std::vector<double> state;            ///< q, q̇ of all bodies
  std::vector<JointSample> joints;      ///< in the scene's order
  std::vector<double> driving_moments;  ///< on each driver's second body [N m]
  std::vector<double> ledger;           ///< kinetic, potential, then the work of each term; empty if not asked for
  std::vector<double> sensors = {};     ///< values of all sensors, in the scene's order
};

/// The largest value of a quantity along a run, from dense output and root finding.
struct Peak {
  double value;  ///< in the quantity's unit
  double t;      ///< when [s]
};

/// Peaks of a joint.
struct JointExtremes {
  Peak eccentricity{0, 0};  ///< |e| [m]
  Peak force{0, 0};         ///< |F| [N]
};

/// Peaks of what a constraint does to its second body at the joint.
struct ReactionExtremes {
  std::size_t constraint = 0;  ///< in the scene's order
  Peak force{0, 0};            ///< |F| [N]
  std::optional<Peak> moment;  ///< |M| [N m]; a pin has none
};

/// A position where constraints are not independent.
struct SingularPosition {
  double t;          ///< [s]
  std::size_t row;   ///< the constraint's row that repeats those before it there
  double how_close;  ///< sine of the angle between them, 0 where it is exact
};

/// Largest and smallest value of a sensor's quantity.
struct SensorExtremes {
  Peak max{0, 0};  ///< in the quantity's unit
  Peak min{0, 0};  ///< likewise
};

/// An interval in which a half film slid on its jump, at a = 0.
struct JointSlide {
  std::size_t joint;  ///< in the scene's order
  double start;       ///< [s]
  double end;         ///< [s]
};

/// Peaks of a driver's moment on its second body [N m], or of the force of one that slides [N].
struct DriverExtremes {
  Peak max_moment{0, 0};  ///< largest
  Peak min_moment{0, 0};  ///< smallest, of either sign
};

/// Largest violation of any constraint at the end of a step.
struct ConstraintDrift {
  double position = 0;  ///< |Φ| [m or rad]
  double velocity = 0;  ///< |Φ̇| [m/s or rad/s]
};

/// An entry or an exit of contact.
struct ContactEvent {
  double t;             ///< [s]
  std::size_t joint;    ///< in the scene's order
  ContactPhase from;    ///< that ends
  ContactPhase to;      ///< that begins
  double normal_speed;  ///< v·r [m/s]
  double force_before;  ///< |F| on the journal, of the piece that ends [N]
  double force_jump;    ///< |ΔF| across the event [N]
};

}  // namespace lubjoint
