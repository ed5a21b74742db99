/// What a scene is: bodies, loads, joints, and how to run them. SI units, angles in radians.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lubjoint/film/compiled_law.hpp"
#include "lubjoint/film/shear_extent.hpp"
#include "lubjoint/joint/dry_contact.hpp"
#include "lubjoint/multibody/constraint.hpp"
#include "lubjoint/multibody/sensor.hpp"
#include "lubjoint/multibody/spring.hpp"
#include "lubjoint/multibody/table_curves.hpp"
#include "lubjoint/number/vector.hpp"
#include "lubjoint/run/outcome.hpp"

namespace lubjoint {

/// A point of a body that has a name.
struct ScenePoint {
  std::string name;             ///< unique on its body
  Vector2<double> place{0, 0};  ///< from the mass centre, in the body's axes [m]
};

/// A rigid body in the plane and its state at t = 0.
struct SceneBody {
  std::string name;                ///< unique
  std::size_t line = 0;            ///< of the file, for messages
  double mass = 0;                 ///< [kg]
  double inertia = 0;              ///< about the mass centre [kg m²]
  Vector2<double> position{0, 0};  ///< of the mass centre [m]
  double angle = 0;                ///< [rad]
  Vector2<double> velocity{0, 0};  ///< of the mass centre [m/s]
  double spin = 0;                 ///< [rad/s]
  bool spin_is_held = false;       ///< prescribed for the whole run, by whatever torque that takes
  std::vector<ScenePoint> points;  ///< that anchors, loads and sensors may name
};

/// What the driver is called that holds a body's spin; its moment is the one that this takes.
inline std::string held_spin_name(const SceneBody& body) { return body.name + ".spin"; }

/// A load that is a multiple of cos(ωt + ψ).
struct SceneHarmonic {
  double rate = 0;   ///< ω [rad/s]
  double phase = 0;  ///< ψ [rad]
};

/// The unbalance of a body whose spin is held.
struct SceneUnbalance {
  double mass_radius = 0;  ///< U [kg m]
  double phase = 0;        ///< from the body's x axis [rad]
};

/// What a load has from a table of time or of a body's angle.
struct SceneTable {
  std::shared_ptr<const TableCurves<3>> curves;  ///< F_x, F_y [N] and M [N m]
  bool of_angle = false;                         ///< of the angle of `against`, in place of time?
  std::size_t against = 0;                       ///< number of that body
  double delay = 0;                              ///< a table of time is read at t + delay [s]
};

/// A force on a body, and a moment: constant, unless it says otherwise.
struct SceneLoad {
  std::size_t body = 0;                          ///< its number in Scene::bodies
  Vector2<double> force{0, 0};                   ///< or its amplitude [N]
  double moment = 0;                             ///< or its amplitude, counter-clockwise positive [N m]
  Vector2<double> point{0, 0};                   ///< where the force acts, from the mass centre in the body's axes [m]
  bool turns_with_body = false;                  ///< is the force given in the body's axes?
  std::optional<SceneHarmonic> harmonic = {};    ///< none: constant
  std::optional<SceneUnbalance> unbalance = {};  ///< in place of force and moment
  std::optional<SceneTable> table = {};          ///< likewise

  /// Is it constant, inertial and through the mass centre, whatever the motion?
  bool is_constant() const { return !turns_with_body && !harmonic && !unbalance && !table && is_zero(point); }
};

/// One side of a joint: a point fixed to a body, from its mass centre, or to the ground, inertial.
using SceneAnchor = BodyPoint<double>;

/// Widths of the transition from film to contact: 0 < e₀ < e₁ [m].
struct SceneTransition {
  double e0 = 0;  ///< width of the blend [m]
  double e1 = 0;  ///< what the film's clearance is widened by [m]
};

/// Dry contact of journal and bearing.
struct SceneContact {
  double bearing_modulus = 0;             ///< Young's [Pa]
  double bearing_poisson = 0;             ///< Poisson's ratio
  double journal_modulus = 0;             ///< Young's [Pa]
  double journal_poisson = 0;             ///< Poisson's ratio
  double restitution = 0;                 ///< c_r, from 0 to 1
  double min_impact_speed = 0;            ///< least δ̇₀ [m/s]
  double friction = 0;                    ///< Coulomb's coefficient
  double slow_sliding = 1e-3;             ///< sliding speed below which friction fades [m/s]
  ContactForm form = ContactForm::point;  ///< of the elastic force
};

/// In place of a law's name: a dry joint.
inline constexpr const char* no_film = "none";

/// A journal bearing between two bodies. A film alone, a film with transition to contact, or (film "none") contact.
struct SceneJoint {
  std::string name;                           ///< unique
  std::size_t line = 0;                       ///< of the file, for messages
  std::string film;                           ///< name of the law, or "none"
  double viscosity = 0;                       ///< μ [Pa s]
  double length = 0;                          ///< L [m]
  double journal_radius = 0;                  ///< R [m]
  double clearance = 0;                       ///< c, radial [m]
  SceneAnchor bearing;                        ///< its centre
  SceneAnchor journal;                        ///< its centre
  std::optional<SceneTransition> transition;  ///< none: film alone, or contact alone
  std::optional<SceneContact> contact;        ///< none: the run stops at ε = 1
  std::optional<ShearExtent> shear;           ///< none: no friction torque
  std::optional<double> density;              ///< ρ of the oil [kg/m³], for its Reynolds number alone
  /// Of a law that is compiled for the bearing's L/D: no scene file has it, whoever runs the scene gives it. Other laws
  /// do not ask.
  std::shared_ptr<const CompiledFilm> table;
};

/// A constraint of any kind, in double precision.
using SceneConstraint = NamedConstraint<double>;

/// A spring with a damper, in double precision.
using SceneSpring = NamedSpring<double>;

/// How constraints are kept: Baumgarte's α and β, or projection of every step.
struct SceneStabilisation {
  bool projection = false;       ///< in place of Baumgarte's terms
  double alpha = 5;              ///< [1/s]; common values in the literature lie from 1 to 20
  double beta = 5;               ///< [1/s]
  bool passes_singular = false;  ///< does a run go on where constraints are not independent?
  bool asked = false;            ///< does the scene ask for it, or is it the default?
};

/// The coordinates that a mechanism is integrated in.
enum class SceneCoordinates {
  automatic,    ///< independent ones where they are few, absolute ones else
  independent,  ///< as many functions of the bodies' coordinates as there are degrees of freedom
  absolute      ///< all coordinates of all bodies, with multipliers (eq. 41)
};

/// A mechanism, what acts on it, and how it is to be run.
struct Scene {
  std::string file;                                            ///< where it was read from
  std::string name;                                            ///< as the file gives it
  Vector2<double> gravity{0, 0};                               ///< [m/s²]
  std::vector<SceneBody> bodies;                               ///< in the file's order, as all lists are
  std::vector<SceneLoad> loads;                                ///< forces and moments
  std::vector<SceneJoint> joints;                              ///< with clearance
  std::vector<SceneConstraint> constraints;                    ///< ideal joints, guides and drivers
  std::vector<SceneSpring> springs;                            ///< with dampers
  std::vector<Sensor> sensors;                                 ///< what is measured beside bodies, joints and drivers
  SceneStabilisation stabilisation;                            ///< how the constraints are kept in absolute coordinates
  SceneCoordinates coordinates = SceneCoordinates::automatic;  ///< that a mechanism is integrated in
  bool energy_ledger = false;                                  ///< keep account of work and energy?
  std::string integrator = "radau_iia5";                       ///< its name
  RunSettings run;                                             ///< duration, tolerances, output
};

/// Does the scene hold just one journal in a bearing on the ground, without contact, constraint, spring, sensor or
/// ledger, under constant loads? It then runs by its own short path: four states, no constraints.
bool is_free_journal(const Scene& scene);

/// Is it one whose mass is 0? Its film carries the load at every moment: two states.
bool is_massless_journal(const Scene& scene);

/// What prescribes a motion in a scene that runs as a mechanism.
struct SceneDriver {
  std::string name;               ///< of the constraint, or of a body's held spin
  const char* effort = "moment";  ///< what it does to its second body: "moment" or, along a guide, "force"
  const char* unit = "N m";       ///< of that
};

/// All drivers, in the order of a run's results: constraints, then held spins. None of a free journal.
std::vector<SceneDriver> scene_drivers(const Scene& scene);

/// The angle start + speed t of a body that turns evenly for the whole run.
struct EvenTurn {
  double start;  ///< [rad]
  double speed;  ///< [rad/s]
};

/// How a body turns whose spin is held, or that a driver on the ground turns at a constant speed; nothing of others.
std::optional<EvenTurn> even_turn(const Scene& scene, std::size_t body);

/// Times within the run at which tables have knots, ascending [s]: those of time, and those over the angle of a body
/// that turns evenly.
std::vector<double> scene_knots(const Scene& scene);

/// Number of works in the scene's ledger, if it has one: those of dampers only where there are any.
std::size_t ledger_works(const Scene& scene);

}  // namespace lubjoint
