/// What a scene in space is, and how it becomes a system. SI units, angles in radians.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/multibody/spatial/assembly.hpp"
#include "lubjoint/multibody/spatial/sensor.hpp"
#include "lubjoint/scene/multibody_scene.hpp"

namespace lubjoint {

// Compiled once, in the scene library.
extern template class SpatialOde<double>;
/// assemble_spatial_start of double.
extern template SpatialStart<double> assemble_spatial_start(SpatialSystem<double>& system, const double& t,
                                                            const double& length, std::vector<double>& y,
                                                            RedundantConstraints redundant);

/// A point of a body in space that has a name.
struct SpatialScenePoint {
  std::string name;                ///< unique on its body
  Vector3<double> place{0, 0, 0};  ///< from the mass centre, in the body's axes [m]
};

/// A rigid body in space and its state at t = 0.
struct SpatialSceneBody {
  std::string name;                                   ///< unique
  std::size_t line = 0;                               ///< of the file, for messages
  double mass = 0;                                    ///< [kg]
  Matrix3<double> inertia = Matrix3<double>::Zero();  ///< J′ about the mass centre, in the body's axes [kg m²]
  Vector3<double> position{0, 0, 0};                  ///< of the mass centre [m]
  EulerParameters<double> orientation{1, 0, 0, 0};    ///< |p| = 1
  Vector3<double> velocity{0, 0, 0};                  ///< of the mass centre, inertial [m/s]
  Vector3<double> spin{0, 0, 0};                      ///< ω′, in the body's axes [rad/s]
  bool spin_is_held = false;                          ///< prescribed for the whole run, by whatever torque that takes
  std::vector<SpatialScenePoint> points;              ///< that joints, loads and sensors may name
};

/// What a load in space has from a table of time or of an angle.
struct SpatialSceneTable {
  std::shared_ptr<const TableCurves<6>> curves;  ///< F_x, F_y, F_z [N] and M_x, M_y, M_z [N m]
  bool of_angle = false;                         ///< in place of time?
  std::size_t angle = 0;                         ///< its number in SpatialScene::angles
};

/// A force on a body in space, and a moment: constant, unless it says otherwise.
struct SpatialSceneLoad {
  std::size_t body = 0;                        ///< its number in SpatialScene::bodies
  Vector3<double> force{0, 0, 0};              ///< or its amplitude [N]
  Vector3<double> moment{0, 0, 0};             ///< or its amplitude [N m]
  Vector3<double> point{0, 0, 0};              ///< where the force acts, from the mass centre in the body's axes [m]
  bool turns_with_body = false;                ///< are both given in the body's axes?
  std::optional<SceneHarmonic> harmonic = {};  ///< none: constant
  /// U u of a body whose spin is held, in its axes and across that spin [kg m]; in place of force and moment.
  std::optional<Vector3<double>> unbalance = {};
  std::optional<SpatialSceneTable> table = {};  ///< likewise

  /// Is it constant, inertial and through the mass centre, whatever the motion?
  bool is_constant() const { return !turns_with_body && !harmonic && !unbalance && !table && is_zero(point); }
};

/// A journal bearing between two bodies in space.
struct SpatialSceneJoint {
  SceneJoint plane;          ///< all but where it is: its two anchors are not looked at
  BodyAxes<double> bearing;  ///< centre and axis of the bearing
  BodyAxes<double> journal;  ///< those of the journal
};

/// A constraint of any kind in space, in double precision.
using SpatialSceneConstraint = NamedSpatialConstraint<double>;

/// A mechanism in space, what acts on it, and how it is to be run.
struct SpatialScene {
  std::string file;                                            ///< where it was read from
  std::string name;                                            ///< as the file gives it
  Vector3<double> gravity{0, 0, 0};                            ///< [m/s²]
  std::vector<SpatialSceneBody> bodies;                        ///< in the file's order, as all lists are
  std::vector<SpatialSceneLoad> loads;                         ///< forces and moments
  std::vector<SpatialSceneJoint> joints;                       ///< with clearance
  std::vector<SpatialSceneConstraint> constraints;             ///< ideal joints and drivers
  std::vector<CountedAngle<double>> angles;                    ///< that springs, tables and sensors name by number
  std::vector<NamedSpatialSpring<double>> springs;             ///< with dampers
  std::vector<SpatialSensor> sensors;                          ///< what is measured beside bodies and joints
  SceneStabilisation stabilisation;                            ///< how the constraints are kept in absolute coordinates
  SceneCoordinates coordinates = SceneCoordinates::automatic;  ///< that a mechanism is integrated in
  RedundantConstraints redundant = RedundantConstraints::refuse;  ///< what is done about rows that others imply
  bool energy_ledger = false;                                     ///< keep account of work and energy?
  std::string integrator = "radau_iia5";                          ///< its name
  RunSettings run;                                                ///< duration, tolerances, output
};

/// Number of works in the scene's ledger, if it has one: those of dampers only where there are any.
std::size_t ledger_works(const SpatialScene& scene);

/// What the driver is called that holds a body's spin; its moment is the one along the axis.
inline std::string held_spin_name(const SpatialSceneBody& body) { return body.name + ".spin"; }

/// The constraint that holds a body's spin: it turns about the axis of its spin at t = 0, or keeps its orientation.
HeldSpin<double> held_spin(const SpatialScene& scene, std::size_t body);

/// Times within the run at which tables of time have knots, ascending [s].
std::vector<double> scene_knots(const SpatialScene& scene);

/// The units of a scene in space: as those of one in the plane.
SceneUnits scene_units(const SpatialScene& scene);

/// Bearing, film, contact and shear of a scene's joint, on any scalar; its anchors are not looked at.
template <class R>
JointElement<R> scene_joint_in_its_plane(const SceneJoint& joint) {
  Scene alone;  // the plane's own rules, of a joint alone
  alone.joints.push_back(joint);
  alone.joints.back().bearing = alone.joints.back().journal = SceneAnchor();
  return planar_system<R>(alone).joints().front();
}

/// The scene's bodies, constraints and joints on any scalar; all rows of the constraints are kept.
/// @throws std::invalid_argument  an inertia that no body has
template <class R>
SpatialSystem<R> spatial_system(const SpatialScene& scene) {
  std::vector<SpatialBody<R>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Vector3<R> force = zero_vector<R>();
    Vector3<R> moment = zero_vector<R>();
    for (const SpatialSceneLoad& load : scene.loads) {
      if (load.body != b || !load.is_constant()) continue;
      force += load.force.template cast<R>();
      moment += load.moment.template cast<R>();
    }
    bodies.emplace_back(R(scene.bodies[b].mass), Matrix3<R>(scene.bodies[b].inertia.template cast<R>()), force, moment);
  }
  std::vector<NamedSpatialConstraint<R>> constraints;
  for (const SpatialSceneConstraint& each : scene.constraints) constraints.push_back(each.template cast<R>());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (scene.bodies[b].spin_is_held)
      constraints.push_back({held_spin_name(scene.bodies[b]), held_spin(scene, b).template cast<R>()});
  }
  std::vector<SpatialJointElement<R>> joints;
  for (const SpatialSceneJoint& each : scene.joints) {
    joints.push_back(
        {scene_joint_in_its_plane<R>(each.plane), each.bearing.template cast<R>(), each.journal.template cast<R>()});
  }
  SpatialForceElements<R> elements;
  for (const CountedAngle<double>& each : scene.angles) elements.angles.push_back(each.template cast<R>());
  for (const NamedSpatialSpring<double>& each : scene.springs) elements.springs.push_back(each.template cast<R>());
  for (const SpatialSceneLoad& load : scene.loads) {
    const SpatialBodyPoint<R> at{load.body, load.point.template cast<R>()};
    if (load.unbalance) {
      elements.loads.push_back(SpatialUnbalance<R>{load.body, load.unbalance->template cast<R>()});
    } else if (load.table) {
      elements.loads.push_back(
          SpatialTableLoad<R>{at, load.turns_with_body, load.table->curves, load.table->of_angle, load.table->angle});
    } else if (!load.is_constant()) {
      const SceneHarmonic harmonic = load.harmonic.value_or(SceneHarmonic());
      elements.loads.push_back(SpatialPointLoad<R>{at, load.force.template cast<R>(), load.moment.template cast<R>(),
                                                   load.turns_with_body, load.harmonic.has_value(), R(harmonic.rate),
                                                   R(harmonic.phase)});
    }
  }
  const SceneStabilisation& keep = scene.stabilisation;
  return SpatialSystem<R>(std::move(bodies), std::move(constraints), std::move(joints),
                          scene.gravity.template cast<R>(), {R(keep.alpha), R(keep.beta)}, std::move(elements));
}

/// (r, p; ṙ, ω′) of the scene's start, as the file gives it.
template <class R>
std::vector<R> scene_start(const SpatialScene& scene) {
  std::vector<R> y;
  const auto put = [&](const auto& values) {
    for (Eigen::Index k = 0; k < values.size(); ++k) y.push_back(R(values(k)));
  };
  for (const SpatialSceneBody& body : scene.bodies) {
    put(body.position);
    put(body.orientation);
  }
  for (const SpatialSceneBody& body : scene.bodies) {
    put(body.velocity);
    put(body.spin);
  }
  return y;
}

/// Tolerance of every state of a run, in units as in the plane; Euler parameters change by half an angle.
std::vector<double> scene_tolerances(const SpatialScene& scene);

/// Frame of a body at t = 0, or of the ground.
SpatialFrame<double> frame_at_start(const SpatialScene& scene, std::size_t body);

}  // namespace lubjoint
