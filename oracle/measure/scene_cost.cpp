#include "oracle/measure/scene_cost.hpp"

#include <algorithm>
#include <cmath>

#include "lubjoint/motion/in_plane.hpp"
#include "lubjoint/motion/independent_ode.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_coordinates.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/start_check.hpp"
#include "oracle/measure/cost_measurement.hpp"

namespace lubjoint::reports {

namespace {

/// A scene's general equations at a state at which no joint is concentric or at rest: there laws have short cuts.
struct GeneralEquations {
  GeneralEquations(const Scene& scene)
      : system(planar_system<double>(scene)), ode(system, scene.energy_ledger), y(scene_start<double>(scene)) {
    const std::vector<double> start = y;
    const SceneUnits units = scene_units(scene);
    double shift = 0.3 * units.length;
    do {
      const std::size_t n = system.coordinates();
      for (std::size_t i = 0; i < n; ++i) {
        const double each =
            std::sin(1.0 + 2.4 * static_cast<double>(i)) * (i % 3 == 2 ? units.angle / units.length : 1.0);
        y[i] = start[i] + shift * each;
        y[n + i] = start[n + i] + shift * units.rate * each;
      }
      shift /= 10;
    } while (!has_films() && shift > 1e-6 * units.length);
    y.resize(ode.dimension(), 0.0);
    rate = y;
  }
  GeneralEquations(const GeneralEquations&) = delete;
  GeneralEquations& operator=(const GeneralEquations&) = delete;

  /// Moves a joint's journal (or bearing) so that |e| is a distance, and says which phase of its contact holds.
  void put(std::size_t joint, double distance, ContactPhase phase) {
    const JointElement<double>& element = system.joints()[joint];
    const Vector2<double> e = ode.at(0.0, y).joints[joint].kinematics.motion.eccentricity;
    const bool journal_moves = element.journal_at.body != ground_body;
    const std::size_t body = journal_moves ? element.journal_at.body : element.bearing_at.body;
    const Vector2<double> move = (journal_moves ? 1.0 : -1.0) * (distance / e.norm() - 1.0) * e;
    y[3 * body] += move.x();
    y[3 * body + 1] += move.y();
    ode.memory()[joint].phase = phase;
  }

  TimedPiece right_hand_side() {
    return repeated([this] { ode.rate(y, rate, 0.0); });
  }

  std::vector<double> mechanical_state() const {
    return {y.begin(), y.begin() + static_cast<std::ptrdiff_t>(2 * system.coordinates())};
  }

  PlanarSystem<double> system;
  MultibodyOde<double> ode;
  std::vector<double> y;
  std::vector<double> rate;

 private:
  bool has_films() {
    try {
      ode.at(0.0, y);
      return true;
    } catch (const std::domain_error&) {
      return false;
    }
  }
};

// Variants of a scene.

bool is_pin(const SceneConstraint& each) { return std::holds_alternative<Revolute<double>>(each.constraint); }

Scene with_lubricated_pins(Scene scene) {
  SceneJoint model;
  model.film = PinkusSternlicht::name;
  model.viscosity = 0.4;
  model.length = 0.04;
  model.journal_radius = 0.0098;
  model.clearance = 0.0002;
  for (const SceneConstraint& each : scene.constraints) {
    if (!is_pin(each)) continue;
    const auto& pin = std::get<Revolute<double>>(each.constraint);
    model.name = each.name;
    model.bearing = pin.first;
    model.journal = pin.second;
    scene.joints.push_back(model);
  }
  std::erase_if(scene.constraints, is_pin);
  return scene;
}

Scene with_ideal_joints(Scene scene) {
  for (const SceneJoint& joint : scene.joints) {
    scene.constraints.push_back({joint.name, Revolute<double>{joint.bearing, joint.journal}});
  }
  scene.joints.clear();
  return scene;
}

/// Adds the right-hand side in the transition and in the dry contact of the first joint that has them.
void add_phases(const Scene& scene, SceneCost& cost, Measurement& measurement) {
  const auto joint =
      std::ranges::find_if(scene.joints, [](const SceneJoint& each) { return each.contact.has_value(); });
  if (joint == scene.joints.end()) return;
  const double e0 = joint->transition ? joint->transition->e0 : joint->clearance / 40;
  const bool in_scene = cost.contacts > 0;
  const auto add = [&](const std::string& what, double depth, ContactPhase phase) {
    GeneralEquations& equations = measurement.keep<GeneralEquations>(scene);
    equations.put(static_cast<std::size_t>(joint - scene.joints.begin()), joint->clearance + depth, phase);
    const std::string name = what + " of joint \"" + joint->name + "\"";
    measurement.add(equations.right_hand_side(), [&cost, name, in_scene](double time, double ratio) {
      if (in_scene) {
        cost.phases.push_back({"in the " + name, time, ratio});
      } else {
        cost.variants.push_back({"contact", false, "the same, in the " + name, time, ratio});
      }
    });
  };
  if (joint->transition) add("transition", e0 / 2, ContactPhase::blend);
  add("dry contact", 2 * e0, ContactPhase::dry);
}

/// Adds the scene with one thing more or less.
void add_variants(const Scene& scene, SceneCost& cost, Measurement& measurement) {
  const auto add = [&](const std::string& feature, bool in_scene, const std::string& change, const Scene& variant) {
    measurement.add(measurement.keep<GeneralEquations>(variant).right_hand_side(),
                    [&cost, feature, in_scene, change](double time, double ratio) {
                      cost.variants.push_back({feature, in_scene, change, time, ratio});
                    });
  };
  if (cost.free_journal) {
    add("constrained equations", false, "three coordinates a body, forces at arms, in place of the journal's own",
        scene);
  }
  Scene ledger = scene;
  ledger.energy_ledger = !scene.energy_ledger;
  add("energy ledger", scene.energy_ledger, "work of each term integrated along", ledger);
  if (std::ranges::any_of(scene.joints, has_film)) {
    const bool in_scene = has_shear(scene);
    add("shear", in_scene, in_scene ? "no friction torque" : "friction torque of every film",
        with_shear_changed(scene));
  }
  if (cost.contacts > 0) {
    add("contact", true, "films alone; dry joints left out", without_contact(scene));
  } else if (!scene.joints.empty()) {
    add("contact", false, "steel, with a transition; journals inside their clearance", with_contact(scene));
  }
  add_phases(cost.contacts > 0 ? scene : with_contact(scene), cost, measurement);
  const std::size_t pins = static_cast<std::size_t>(std::ranges::count_if(scene.constraints, is_pin));
  if (pins > 0)
    add("film in ideal pins", false, std::to_string(pins) + " pins lubricated", with_lubricated_pins(scene));
  if (!scene.joints.empty()) {
    add("joints with clearance", true, std::to_string(scene.joints.size()) + " made ideal pins",
        with_ideal_joints(scene));
  }
  if (!scene.springs.empty()) {
    Scene free = scene;
    free.springs.clear();
    add("springs", true, std::to_string(scene.springs.size()) + " left out", free);
  }
  if (cost.moving_loads > 0) {
    Scene steady = scene;
    std::erase_if(steady.loads, [](const SceneLoad& load) { return !load.is_constant(); });
    add("moving loads", true, std::to_string(cost.moving_loads) + " left out", steady);
  }
  const std::vector<double> y = measurement.keep<GeneralEquations>(scene).mechanical_state();
  add_space(scene, y, cost, measurement);
  if (scene.constraints.empty()) return;
  add("Baumgarte's terms", has_baumgarte(scene), "constraints kept by the accelerations", with_upkeep_changed(scene));
}

/// The coordinates that the scene runs in, and what a right-hand side costs in independent ones.
void add_independent(const Scene& scene, GeneralEquations& equations, SceneCost& cost, Measurement& measurement) {
  const CoordinatesChoice choice = choose_coordinates(scene, equations.system);
  cost.runs_in = choice.independent ? "independent" : "absolute";
  cost.runs_in_reason = choice.reason;
  if (!choice.independent) return;
  using Small = IndependentOde<InPlane<double>, run_time_size>;
  const SceneUnits units = scene_units(scene);
  std::vector<double> start = scene_start<double>(scene);
  assemble_start(equations.system, 0.0, units.mechanism, start);
  start.resize(equations.ode.dimension(), 0.0);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < equations.system.coordinates(); ++i)
    sizes.push_back(i % 3 == 2 ? units.angle : units.length);
  const auto small = std::make_shared<Small>(equations.ode, sizes);
  small->choose(0.0, start);
  std::vector<double> state;
  small->take(start, state);
  for (std::size_t i = 0; i < 2 * small->freedoms(); ++i) {
    const std::size_t k = i % small->freedoms();
    const double size = small->chart().is_of_joint(k) ? units.length : sizes[small->chart().coordinate_of(k)];
    state[i] += 0.2 * size * (i < small->freedoms() ? 1.0 : units.rate);
  }
  add_independent_pieces(small, state, 1e-6 * units.length, cost, measurement);
}

/// Parts, Jacobian and upkeep of the general equations.
void measure_general(const Scene& scene, SceneCost& cost, Measurement& measurement) {
  GeneralEquations& equations = measurement.keep<GeneralEquations>(scene);
  PlanarSystem<double>& system = equations.system;
  MultibodyOde<double>& ode = equations.ode;
  cost.coordinates = cost.velocities = system.coordinates();
  cost.states = ode.dimension();
  cost.constraint_rows = system.constraint_rows();
  cost.schur_stored = ode.at(0.0, equations.y).schur.stored();
  cost.constraint_nonzeros = nonzeros(detail::scaled_constraint_matrix(system, ode.workspace()));
  auto jacobian = std::make_shared<Eigen::MatrixXd>();
  ode.jacobian(equations.y, *jacobian, 0.0);
  cost.rate_nonzeros = nonzeros(*jacobian);
  const std::size_t group = MultibodyOde<double>::jacobian_group;
  cost.jacobian_passes = (ode.mechanical_states() + group - 1) / group;

  measurement.add(equations.right_hand_side(), [&cost](double time, double) { cost.nanoseconds = time; });
  const auto part = [&](const std::string& name, TimedPiece piece) {
    measurement.add(std::move(piece), [&cost, name](double time, double share) {
      cost.parts.push_back({name, time, share});
    });
  };
  SystemWorkspace<double>& w = ode.workspace();
  const double* y = equations.y.data();
  part("frames", repeated([&system, &w, y] { system.place(y, w); }));
  part("loads and joint forces", repeated([&system, &ode, &w] { system.apply_forces(ode.memory(), w); }));
  if (!system.elements().empty()) {
    part("springs and moving loads", repeated([&system, &w] { system.apply_elements(0.0, w); }));
  }
  if (cost.constraint_rows > 0) {
    part("constraint rows", repeated([&system, &w] { system.evaluate_constraints(0.0, w); }));
    part("assembly and factorisation", repeated([&system, &w] { system.factorise(w); }));
    part("solve", repeated([&system, &w] { system.solve(w); }));
  }
  measurement.add(repeated([&equations, &ode, jacobian] { ode.jacobian(equations.y, *jacobian, 0.0); }),
                  [&cost](double time, double ratio) {
                    cost.jacobian_nanoseconds = time;
                    cost.jacobian_ratio = ratio;
                  });
  if (cost.constraint_rows == 0) return;
  add_independent(scene, equations, cost, measurement);
  GeneralEquations& projected = measurement.keep<GeneralEquations>(scene);
  measurement.add(repeated([&projected] {
                    project_onto_constraints(projected.system, 0.0, projected.y, projected.ode.workspace());
                  }),
                  [&cost](double time, double ratio) {
                    cost.steps.push_back({"projection onto the constraints", time, ratio});
                  });
}

template <class Law>
void measure_journal(const Scene& scene, SceneCost& cost, Measurement& measurement) {
  const JournalScene parts = journal_scene(scene);
  const auto journal = std::make_shared<FreeJournal<Law>>(
      film_of<Law, double>(parts.law, parts.bearing, parts.oil, parts.table.get()), parts.drive);
  cost.coordinates = cost.velocities = 2;
  cost.states = 4;
  cost.film_jumps = FilmOf<Law, double>::jumps ? 1 : 0;
  const double rate = std::max(1.0, std::abs(parts.drive.mean_spin()));
  const auto y = std::make_shared<JournalState<double>>(JournalState<double>{0.3, 0.2, 0.1 * rate, -0.2 * rate});
  const auto dydt = std::make_shared<JournalState<double>>();
  const auto jacobian = std::make_shared<Eigen::Matrix4d>();
  const auto fill_jacobian = [journal, y, jacobian] {
    exact_jacobian([&](const auto& x, auto& dxdt) { journal->rate(x, dxdt); }, *y, *jacobian);
  };
  fill_jacobian();
  cost.rate_nonzeros = nonzeros(*jacobian);
  cost.jacobian_passes = 1;
  measurement.add(repeated([journal, y, dydt] { journal->rate(*y, *dydt); }),
                  [&cost](double time, double) { cost.nanoseconds = time; });
  const auto force = std::make_shared<Vector2<double>>();
  measurement.add(repeated([journal, y, force] { *force = journal->force(*y); }), [&cost](double time, double share) {
    cost.parts.push_back({"film force", time, share});
  });
  measurement.add(repeated(fill_jacobian), [&cost](double time, double ratio) {
    cost.jacobian_nanoseconds = time;
    cost.jacobian_ratio = ratio;
  });
}

}  // namespace

SceneCost scene_cost(const Scene& scene, std::size_t rounds) {
  require_start(scene);
  SceneCost cost;
  cost.free_journal = is_free_journal(scene);
  count_scene(scene, cost);
  Measurement measurement;
  if (cost.free_journal) {
    with_film_law<NamedFilmLaws>(scene.joints.front().film,
                                 [&]<class Law>() { measure_journal<RunLaw<Law>>(scene, cost, measurement); });
  } else {
    measure_general(scene, cost, measurement);
  }
  add_variants(scene, cost, measurement);
  measurement.run(rounds);
  add_rest(cost.ledger_terms > 0 ? "copies and ledger" : "copies", cost);
  return cost;
}

}  // namespace lubjoint::reports
