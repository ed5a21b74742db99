/// What a scene is: bodies, loads, joints, and how to run them. SI units, angles in radians.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lubjoint/dynamics/outcome.hpp"
#include "lubjoint/film/vector.hpp"

namespace lubjoint {

/// A rigid body in the plane and its state at t = 0.
struct SceneBody {
  std::string name;
  std::size_t line = 0;  ///< of the file, for messages
  double mass = 0;       ///< [kg]
  double inertia = 0;    ///< about the mass centre [kg m²]
  Vector2<double> position{0, 0};
  double angle = 0;
  Vector2<double> velocity{0, 0};
  double spin = 0;
};

/// A constant force on a body, inertial, through its mass centre, and a constant moment.
struct SceneLoad {
  std::size_t body = 0;
  Vector2<double> force{0, 0};
  double moment = 0;  ///< counter-clockwise positive [N m]
};

/// One side of a joint: a point fixed to a body, or to the ground.
struct SceneAnchor {
  std::optional<std::size_t> body;  ///< none: ground
  Vector2<double> point{0, 0};      ///< body-fixed, from the mass centre; inertial on the ground
};

/// Widths of the transition from film to contact: 0 < e₀ < e₁ [m].
struct SceneTransition {
  double e0 = 0;
  double e1 = 0;
};

/// Dry contact of journal and bearing.
struct SceneContact {
  double bearing_modulus = 0;  ///< Young's [Pa]
  double bearing_poisson = 0;
  double journal_modulus = 0;
  double journal_poisson = 0;
  double restitution = 0;
  double min_impact_speed = 0;  ///< [m/s]
  double friction = 0;          ///< Coulomb's coefficient
  double slow_sliding = 1e-3;   ///< sliding speed below which friction fades [m/s]
};

inline constexpr const char* no_film = "none";

/// A journal bearing between two bodies. A film alone, a film with transition to contact, or (film "none") contact.
struct SceneJoint {
  std::string name;
  std::size_t line = 0;  ///< of the file, for messages
  std::string film;      ///< name of the law, or "none"
  double viscosity = 0;
  double length = 0;
  double journal_radius = 0;
  double clearance = 0;
  SceneAnchor bearing;
  SceneAnchor journal;
  std::optional<SceneTransition> transition;
  std::optional<SceneContact> contact;
};

/// A body held where it is.
struct SceneGround {
  std::size_t body = 0;
  Vector2<double> position{0, 0};
  double angle = 0;
};

/// An ideal pin.
struct SceneRevolute {
  SceneAnchor first;
  SceneAnchor second;
};

/// A slider (second) on a straight guide (first).
struct SceneTranslational {
  SceneAnchor first;
  Vector2<double> axis{1, 0};
  SceneAnchor second;
  double angle = 0;  ///< of the slider to the guide's body
};

/// A motor: the body's angle against another's, φ₀ + ωt + ½αt².
struct SceneDriver {
  std::size_t body = 0;
  std::optional<std::size_t> against;  ///< none: ground
  double angle = 0;
  double speed = 0;
  double acceleration = 0;
};

struct SceneConstraint {
  std::string name;
  std::variant<SceneGround, SceneRevolute, SceneTranslational, SceneDriver> kind;
};

/// How constraints are kept: Baumgarte's α and β, or projection of every step.
struct SceneStabilisation {
  bool projection = false;
  double alpha = 5;  ///< [1/s]; common values in the literature lie from 1 to 20
  double beta = 5;   ///< [1/s]
};

struct Scene {
  std::string file;  ///< where it was read from
  std::string name;
  Vector2<double> gravity{0, 0};
  std::vector<SceneBody> bodies;
  std::vector<SceneLoad> loads;
  std::vector<SceneJoint> joints;
  std::vector<SceneConstraint> constraints;
  SceneStabilisation stabilisation;
  bool energy_ledger = false;
  std::string integrator = "radau_iia5";
  RunSettings run;
};

}  // namespace lubjoint
