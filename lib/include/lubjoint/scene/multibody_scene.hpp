/// A scene as a multibody system.
#pragma once

#include <cmath>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

// Compiled once, in the scene library: the laws on numbers with and without derivatives, and decompositions.
extern template class MultibodyOde<double>;
/// film_functions of double.
extern template const FilmFunctions<double>& film_functions<double>(std::string_view law);
/// assemble_start of double.
extern template StartCorrection<double> assemble_start(const PlanarSystem<double>& system, const double& t,
                                                       const double& length, std::vector<double>& y);

/// Units in which a run's tolerances are counted.
struct SceneUnits {
  double mechanism;  ///< largest arm of a point of a constraint or joint [m]; 1 where there is none
  double length;     ///< the smallest clearance; without joints, `mechanism` [m]
  double angle;      ///< length over mechanism [rad]
  double rate;       ///< fastest of what the scene names [1/s]
  double energy;     ///< [J]
};

/// A load from a table on any scalar.
template <class R>
TableLoad<R> table_load(const Scene& scene, const SceneLoad& load) {
  const SceneTable& table = *load.table;
  TableLoad<R> result{};
  result.at = {load.body, load.point.template cast<R>()};
  result.turns_with_body = load.turns_with_body;
  result.table = table.curves;
  result.of_angle = table.of_angle;
  result.against = table.against;
  result.delay = R(table.delay);
  result.at_known_times = table.of_angle && even_turn(scene, table.against).has_value();
  return result;
}

/// The scene's bodies, constraints and joints on any scalar.
template <class R>
PlanarSystem<R> planar_system(const Scene& scene) {
  std::vector<PlanarBody<R>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Vector2<R> force(R(0), R(0));
    R moment(0);
    for (const SceneLoad& load : scene.loads) {
      if (load.body != b || !load.is_constant()) continue;
      force += load.force.template cast<R>();
      moment += R(load.moment);
    }
    bodies.emplace_back(R(scene.bodies[b].mass), R(scene.bodies[b].inertia), force, moment);
  }
  std::vector<NamedConstraint<R>> constraints;
  for (const SceneConstraint& each : scene.constraints) constraints.push_back(each.cast<R>());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    if (!body.spin_is_held) continue;
    constraints.push_back({held_spin_name(body), Driver<R>{ground_body, b, R(body.angle), R(body.spin), R(0)}});
  }
  std::vector<JointElement<R>> joints;
  for (const SceneJoint& each : scene.joints) {
    // A dry joint's length enters a cylindrical contact alone, and is then given.
    const R length = each.length > 0 ? R(each.length) : R(each.journal_radius);
    const Bearing<R> bearing(length, R(each.journal_radius), R(each.clearance));
    JointElement<R> joint{each.name, each.bearing.cast<R>(), each.journal.cast<R>(),
                          bearing,   std::nullopt,           std::nullopt};
    if (each.film != no_film) {
      const R widening = each.transition ? R(each.transition->e1) : R(0);
      const Bearing<R> of_film(length, bearing.radius(), R(bearing.clearance() + widening));
      const Lubricant<R> oil{R(each.viscosity)};
      joint.film = make_film<R>(each.film, of_film, oil, each.table.get());
      if (each.shear) joint.shear = make_shear<R>(each.film, of_film, oil, *each.shear);
    }
    if (each.contact) {
      const SceneContact& c = *each.contact;
      const Elasticity<R> of_bearing{R(c.bearing_modulus), R(c.bearing_poisson)};
      const Elasticity<R> of_journal{R(c.journal_modulus), R(c.journal_poisson)};
      const R stiffness =
          c.form == ContactForm::cylinder
              ? cylinder_contact_stiffness<R>(bearing.length(), bearing.clearance(), of_bearing, of_journal)
              : contact_stiffness<R>(bearing.radius(), bearing.clearance(), of_bearing, of_journal);
      joint.contact = JointContact<R>{
          {stiffness, R(c.restitution), R(c.friction), R(c.slow_sliding), c.form}, std::nullopt, R(c.min_impact_speed)};
      if (each.transition) {
        joint.contact->transition = TransitionTolerances<R>(R(each.transition->e0), R(each.transition->e1));
      }
    }
    joints.push_back(std::move(joint));
  }
  ForceElements<R> elements;
  for (const SceneSpring& each : scene.springs) elements.springs.push_back(each.cast<R>());
  for (const SceneLoad& load : scene.loads) {
    if (load.unbalance) {
      using std::cos;
      using std::sin;
      const R phase(load.unbalance->phase);
      elements.loads.push_back(
          Unbalance<R>{load.body, R(load.unbalance->mass_radius), Vector2<R>(R(cos(phase)), R(sin(phase)))});
    } else if (load.table) {
      elements.loads.emplace_back(table_load<R>(scene, load));
    } else if (!load.is_constant()) {
      const SceneHarmonic harmonic = load.harmonic.value_or(SceneHarmonic());
      elements.loads.push_back(PointLoad<R>{{load.body, load.point.template cast<R>()},
                                            load.force.template cast<R>(),
                                            R(load.moment),
                                            load.turns_with_body,
                                            load.harmonic.has_value(),
                                            R(harmonic.rate),
                                            R(harmonic.phase)});
    }
  }
  const SceneStabilisation& keep = scene.stabilisation;
  return PlanarSystem<R>(std::move(bodies), std::move(constraints), std::move(joints), scene.gravity.template cast<R>(),
                         {R(keep.alpha), R(keep.beta)}, std::move(elements));
}
/// Compiled once, in the scene library.
extern template PlanarSystem<double> planar_system(const Scene& scene);

/// (q, q̇) of the scene's start, as the file gives it.
template <class R>
std::vector<R> scene_start(const Scene& scene) {
  std::vector<R> y;
  for (const SceneBody& body : scene.bodies) {
    y.insert(y.end(), {R(body.position.x()), R(body.position.y()), R(body.angle)});
  }
  for (const SceneBody& body : scene.bodies) {
    y.insert(y.end(), {R(body.velocity.x()), R(body.velocity.y()), R(body.spin)});
  }
  return y;
}

/// The units of a scene, from its joints' clearances and its bodies' speeds.
SceneUnits scene_units(const Scene& scene);

/// Tolerance of every state of a run: positions in units of length, angles so that the largest arm's end moves by as
/// much, velocities by the rate, and the ledger's work in units of energy.
template <class R>
std::vector<R> scene_tolerances(const Scene& scene) {
  const SceneUnits units = scene_units(scene);
  const R tolerance(scene.run.absolute_tolerance);
  std::vector<R> result;
  for (const double rate : {1.0, units.rate}) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const R length = tolerance * R(units.length) * R(rate);
      result.insert(result.end(), {length, length, R(tolerance * R(units.angle) * R(rate))});
    }
  }
  if (scene.energy_ledger) result.insert(result.end(), ledger_works(scene), R(tolerance * R(units.energy)));
  return result;
}

}  // namespace lubjoint
