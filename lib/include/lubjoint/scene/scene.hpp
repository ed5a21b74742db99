/// What a scene is: bodies, loads, joints, and how to run them. SI units, angles in radians.
#pragma once

#include <optional>
#include <string>
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

/// A constant force on a body, inertial, through its mass centre.
struct SceneLoad {
  std::size_t body = 0;
  Vector2<double> force{0, 0};
};

/// One side of a joint: a point fixed to a body, or to the ground.
struct SceneAnchor {
  std::optional<std::size_t> body;  ///< none: ground
  Vector2<double> point{0, 0};      ///< body-fixed, from the mass centre; inertial on the ground
};

/// A journal bearing between two bodies.
struct SceneJoint {
  std::string name;
  std::size_t line = 0;  ///< of the file, for messages
  std::string film;      ///< name of the law
  double viscosity = 0;
  double length = 0;
  double journal_radius = 0;
  double clearance = 0;
  SceneAnchor bearing;
  SceneAnchor journal;
};

struct Scene {
  std::string file;  ///< where it was read from
  std::string name;
  Vector2<double> gravity{0, 0};
  std::vector<SceneBody> bodies;
  std::vector<SceneLoad> loads;
  std::vector<SceneJoint> joints;
  std::string integrator = "radau_iia5";
  RunSettings run;
};

}  // namespace lubjoint
