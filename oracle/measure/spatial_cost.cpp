#include <array>
#include <cmath>

#include "lubjoint/motion/in_space.hpp"
#include "lubjoint/motion/independent_ode.hpp"
#include "lubjoint/scene/spatial_coordinates.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/measure/cost_measurement.hpp"
#include "oracle/trajectories/embedded_scene.hpp"

namespace lubjoint::reports {

namespace {

/// A scene's equations in space between two states a millionth of a clearance apart: at the same state again they would
/// not be evaluated.
struct SpatialEquations {
  /// At a state at which no joint is concentric or at rest: there laws have short cuts.
  explicit SpatialEquations(const SpatialScene& scene)
      : prepared(prepare_spatial(scene)), ode(prepared.system, scene.energy_ledger), y(prepared.start) {
    const SceneUnits units = scene_units(scene);
    const std::size_t places = prepared.system.places();
    double shift = 0.3;  // of the units
    do {
      for (std::size_t i = 0; i < prepared.start.size(); ++i) {
        const bool is_place = i < places;
        const std::size_t k = is_place ? i % spatial_coordinates : (i - places) % spatial_velocities;
        const double unit = (k < 3 ? units.length : units.angle) * (is_place ? 1.0 : units.rate);
        y[i] = prepared.start[i] + shift * unit * std::sin(1.0 + 2.4 * static_cast<double>(i));
      }
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        Eigen::Map<EulerParameters<double>>(&y[spatial_coordinates * b + 3]).normalize();
      shift /= 10;
    } while (!has_films() && shift > 1e-6);
    finish(units);
  }
  SpatialEquations(const SpatialScene& scene, const std::vector<double>& state)
      : prepared(prepare_spatial(scene)), ode(prepared.system, scene.energy_ledger), y(state) {
    finish(scene_units(scene));
  }
  SpatialEquations(const SpatialEquations&) = delete;
  SpatialEquations& operator=(const SpatialEquations&) = delete;

  TimedPiece right_hand_side() {
    return repeated([this] {
      ode.rate(turn ? y : near, rate, 0.0);
      turn = !turn;
    });
  }

  PreparedSpatialScene prepared;
  SpatialOde<double> ode;
  std::vector<double> y;
  std::vector<double> near;
  std::vector<double> rate;
  bool turn = false;

 private:
  bool has_films() {
    try {
      ode.at(0.0, y);
      return true;
    } catch (const std::domain_error&) {
      return false;
    }
  }
  void finish(const SceneUnits& units) {
    y.resize(ode.dimension(), 0.0);
    near = rate = y;
    near[0] += 1e-6 * units.length;
  }
};

/// Adds the scene with one thing more or less.
void add_variants(const SpatialScene& scene, SceneCost& cost, Measurement& measurement) {
  const auto add = [&](const std::string& feature, bool in_scene, const std::string& change,
                       const SpatialScene& variant) {
    measurement.add(measurement.keep<SpatialEquations>(variant).right_hand_side(),
                    [&cost, feature, in_scene, change](double time, double ratio) {
                      cost.variants.push_back({feature, in_scene, change, time, ratio});
                    });
  };
  SpatialScene ledger = scene;
  ledger.energy_ledger = !scene.energy_ledger;
  add("energy ledger", scene.energy_ledger, "work of each term integrated along", ledger);
  if (std::ranges::any_of(scene.joints, [](const auto& joint) { return has_film(joint.plane); })) {
    const bool in_scene = has_shear(scene);
    add("shear", in_scene, in_scene ? "no friction torque" : "friction torque of every film",
        with_shear_changed(scene));
  }
  if (cost.contacts > 0) {
    add("contact", true, "films alone; dry joints left out", without_contact(scene));
  } else if (!scene.joints.empty()) {
    add("contact", false, "steel, with a transition; journals inside their clearance", with_contact(scene));
  }
  if (!scene.springs.empty()) {
    SpatialScene free = scene;
    free.springs.clear();
    add("springs", true, std::to_string(scene.springs.size()) + " left out", free);
  }
  if (cost.moving_loads > 0) {
    SpatialScene steady = scene;
    std::erase_if(steady.loads, [](const SpatialSceneLoad& load) { return !load.is_constant(); });
    add("moving loads", true, std::to_string(cost.moving_loads) + " left out", steady);
  }
  if (scene.constraints.empty()) return;
  add("Baumgarte's terms", has_baumgarte(scene), "constraints kept by the accelerations", with_upkeep_changed(scene));
}

/// The coordinates that the scene runs in, and what a right-hand side costs in independent ones.
void add_independent(const SpatialScene& scene, SceneCost& cost, Measurement& measurement) {
  SpatialEquations& equations = measurement.keep<SpatialEquations>(scene);
  const CoordinatesChoice choice = choose_coordinates(scene, equations.prepared.system);
  cost.runs_in = choice.independent ? "independent" : "absolute";
  cost.runs_in_reason = choice.reason;
  if (!choice.independent) return;
  using Small = IndependentOde<InSpace<double>, run_time_size>;
  const SceneUnits units = scene_units(scene);
  std::vector<double> start = equations.prepared.start;
  start.resize(equations.ode.dimension(), 0.0);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < equations.prepared.system.velocities(); ++i)
    sizes.push_back(i % spatial_velocities < 3 ? units.length : units.angle);
  const auto small = std::make_shared<Small>(equations.ode, sizes);
  small->choose(0.0, start);
  std::vector<double> state;
  small->take(start, state);
  for (std::size_t i = 0; i < 2 * small->freedoms(); ++i) {
    const double size = small->chart().is_turn(i % small->freedoms()) ? units.angle : units.length;
    state[i] += 0.2 * size * (i < small->freedoms() ? 1.0 : units.rate);
  }
  add_independent_pieces(small, state, 1e-6 * units.length, cost, measurement);
}

/// Parts, Jacobian and upkeep.
void measure(const SpatialScene& scene, SceneCost& cost, Measurement& measurement) {
  SpatialEquations& equations = measurement.keep<SpatialEquations>(scene);
  const SpatialSystem<double>& system = equations.prepared.system;
  SpatialOde<double>& ode = equations.ode;
  cost.coordinates = system.places();
  cost.velocities = system.velocities();
  cost.states = ode.dimension();
  cost.constraint_rows = system.constraint_rows() - system.left_out().size();
  cost.schur_stored = ode.at(0.0, equations.y).schur.stored();
  cost.constraint_nonzeros = nonzeros(detail::scaled_constraint_matrix(system, ode.workspace()));
  cost.jacobian_passes = scene.bodies.size();
  const auto jacobian = std::make_shared<Eigen::MatrixXd>();
  ode.jacobian(equations.y, *jacobian, 0.0);
  cost.rate_nonzeros = nonzeros(*jacobian);

  measurement.add(equations.right_hand_side(), [&cost](double time, double) { cost.nanoseconds = time; });
  const auto part = [&](const std::string& name, TimedPiece piece) {
    measurement.add(std::move(piece), [&cost, name](double time, double share) {
      cost.parts.push_back({name, time, share});
    });
  };
  SpatialWorkspace<double>& w = ode.workspace();
  const double* y = equations.y.data();
  part("frames", repeated([&system, &w, y] { system.place(y, w); }));
  part("loads and joint forces",
       repeated([&system, &ode, &w] { system.apply_forces(0.0, ode.memory(), w, system.every_body); }));
  if (cost.constraint_rows > 0) {
    part("constraint rows", repeated([&system, &w] { system.evaluate_constraints(0.0, w, system.every_body); }));
    part("assembly and factorisation", repeated([&system, &w] { system.factorise(w); }));
  }
  measurement.add(repeated([&equations, &ode, jacobian] { ode.jacobian(equations.y, *jacobian, 0.0); }),
                  [&cost](double time, double ratio) {
                    cost.jacobian_nanoseconds = time;
                    cost.jacobian_ratio = ratio;
                  });
  add_independent(scene, cost, measurement);
  if (cost.constraint_rows == 0) return;
  SpatialEquations& projected = measurement.keep<SpatialEquations>(scene);
  measurement.add(repeated([&projected] {
                    project_onto_constraints(projected.prepared.system, 0.0, projected.y, projected.ode.workspace());
                  }),
                  [&cost](double time, double ratio) {
                    cost.steps.push_back({"projection onto the constraints", time, ratio});
                  });
}

/// The scene in a plane of no special kind; nothing if a body of it has no mass, which there is only in the plane.
std::optional<SpatialScene> embedded(const Scene& flat, const Plane& plane) {
  try {
    SpatialScene scene = Embedding(plane).scene(flat);
    allow_what_is_redundant(scene);
    return scene;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

void add_space(const Scene& scene, const std::vector<double>& y, SceneCost& cost, Measurement& measurement) {
  const Plane plane = some_plane(3);
  const auto space = embedded(scene, plane);
  if (!space) return;
  measurement.add(measurement.keep<SpatialEquations>(*space, Embedding(plane).state(y)).right_hand_side(),
                  [&cost](double time, double ratio) {
                    cost.variants.push_back({"space", false, "the same, its plane turned in space", time, ratio});
                  });
}

SceneCost scene_cost(const SpatialScene& scene, std::size_t rounds) {
  SceneCost cost;
  cost.in_space = true;
  count_scene(scene, cost);
  Measurement measurement;
  measure(scene, cost, measurement);
  add_variants(scene, cost, measurement);
  measurement.run(rounds);
  const std::string copies = cost.ledger_terms > 0 ? "copies and ledger" : "copies";
  add_rest(cost.constraint_rows > 0 ? "solve, " + copies : "accelerations, " + copies, cost);
  return cost;
}

}  // namespace lubjoint::reports
