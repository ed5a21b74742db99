#include "lubjoint/scene/scene_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <random>

#include "assembly_signs.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/text/nearest_name.hpp"

namespace lubjoint {

namespace {

using State = std::vector<double>;
using Matrix = detail::DenseMatrix<double>;
using Vector = detail::DenseVector<double>;

/// A step turns no body by more [rad]: beyond it a linearisation says nothing of an angle.
constexpr double largest_turn = 0.5;

/// The names that an assembly may hold at an angle.
std::vector<std::string> names_with_angles(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneConstraint& each : scene.constraints) {
    if (std::holds_alternative<Driver<double>>(each.constraint)) names.push_back(each.name);
  }
  for (const SceneBody& body : scene.bodies) names.push_back(body.name);
  return names;
}

[[noreturn]] void refuse_name(const Scene& scene, const std::string& what, const std::string& name,
                              const std::vector<std::string>& names) {
  throw SceneError(scene.file + ": " + what + " \"" + name + "\" is not there; allowed is " +
                   (names.empty() ? "none: the scene has none" : one_of(names, name)));
}

/// The scene with its journals at the centres of pins, and with the angles that are asked for.
Scene with_closed_joints(const Scene& scene, const AssemblyRequest& request) {
  Scene closed = scene;
  closed.joints.clear();
  std::vector<std::string> joints;
  for (const SceneJoint& joint : scene.joints) joints.push_back(joint.name);
  for (const std::string& name : request.open_joints) {
    if (std::find(joints.begin(), joints.end(), name) == joints.end()) refuse_name(scene, "joint", name, joints);
  }
  for (const SceneJoint& joint : scene.joints) {
    const auto& open = request.open_joints;
    if (std::find(open.begin(), open.end(), joint.name) != open.end()) continue;
    closed.constraints.push_back({joint.name, Revolute<double>{joint.bearing, joint.journal}});
  }
  for (const auto& [name, angle] : request.angles) {
    const auto driver = std::find_if(
        closed.constraints.begin(), closed.constraints.end(),
        [&, &n = name](const auto& c) { return c.name == n && std::holds_alternative<Driver<double>>(c.constraint); });
    const auto body =
        std::find_if(closed.bodies.begin(), closed.bodies.end(), [&, &n = name](const auto& b) { return b.name == n; });
    if (driver != closed.constraints.end()) {
      auto& motor = std::get<Driver<double>>(driver->constraint);
      if (motor.shape) {
        throw SceneError(
            scene.file + ": driver \"" + name +
            "\" has a motion of its own, a swing or a table; allowed is the angle of another driver, or of "
            "a body");
      }
      motor.angle = angle;
    } else if (body != closed.bodies.end()) {
      const auto number = static_cast<std::size_t>(body - closed.bodies.begin());
      closed.constraints.push_back({name, Driver<double>{ground_body, number, angle, body->spin, 0}});
    } else {
      refuse_name(scene, "driver or body", name, names_with_angles(scene));
    }
  }
  return closed;
}

/// Closes the loops of a system, from any start.
class Closing {
 public:
  explicit Closing(const PlanarSystem<double>& system) : system_(system), w_(system.workspace<double>()) {}

  /// Damped Gauss–Newton steps of least kinetic-energy norm, each of which must make the next one shorter.
  /// @returns whether they arrive where all constraints are nearly fulfilled
  bool approach(double length, State& y) {
    for (int iteration = 0; iteration < 200; ++iteration) {
      const Vector residual = residual_at(y);
      if (residual.cwiseAbs().maxCoeff() <= 1e-10 * length) return true;
      Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
      decomposition.setThreshold(1e-9);
      decomposition.compute(detail::scaled_constraint_matrix(system_, w_));
      const Vector step = decomposition.solve(residual);
      double share = std::min(1.0, largest_turn / turn_of(step));
      State trial;
      for (;; share /= 2) {
        if (share < 1e-6) return false;
        trial = moved(y, step, share);
        // The same factors measure both: no unit of a row counts.
        if (decomposition.solve(residual_at(trial)).norm() <= (1 - share / 4) * step.norm()) break;
      }
      y = trial;
    }
    return false;
  }

 private:
  Vector residual_at(const State& y) {
    system_.evaluate_kinematics(0.0, y.data(), w_);
    Vector residual(static_cast<Eigen::Index>(w_.rows.size()));
    for (std::size_t i = 0; i < w_.rows.size(); ++i) residual(static_cast<Eigen::Index>(i)) = w_.rows[i].value;
    return residual;
  }
  double scale(std::size_t i) const { return std::sqrt(system_.inverse_mass(i / 3)[i % 3]); }
  double turn_of(const Vector& step) const {
    double turn = 1e-300;
    for (std::size_t i = 2; i < system_.coordinates(); i += 3)
      turn = std::max(turn, std::abs(step(static_cast<Eigen::Index>(i))) * scale(i));
    return turn;
  }
  State moved(State y, const Vector& step, double share) const {
    for (std::size_t i = 0; i < system_.coordinates(); ++i)
      y[i] -= share * step(static_cast<Eigen::Index>(i)) * scale(i);
    return y;
  }

  const PlanarSystem<double>& system_;
  SystemWorkspace<double> w_;
};

/// The same place: angles may differ by whole turns.
bool is_same(const State& a, const State& b, double length) {
  const std::size_t n = a.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    const double difference = a[i] - b[i];
    if (i % 3 == 2 ? std::abs(std::remainder(difference, 2 * std::numbers::pi)) > 1e-6
                   : std::abs(difference) > 1e-6 * length)
      return false;
  }
  return true;
}

/// How large the scene is: arms, and distances of the guesses.
double extent_of(const Scene& scene, double mechanism) {
  double extent = mechanism;
  for (const SceneBody& body : scene.bodies) {
    extent = std::max(extent, (body.position - scene.bodies.front().position).norm());
  }
  return extent;
}

/// Distance from the guesses in the norm of the kinetic energy; angles by the nearest turn.
double distance_between(const PlanarSystem<double>& system, const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size() / 2; ++i) {
    const double difference = i % 3 == 2 ? std::remainder(a[i] - b[i], 2 * std::numbers::pi) : a[i] - b[i];
    sum += difference * difference / system.inverse_mass(i / 3)[i % 3];
  }
  return std::sqrt(sum);
}

/// The largest changes from one state to another, of each kind.
StartCorrection<double> correction_of(const State& from, const State& to) {
  StartCorrection<double> correction;
  const std::size_t n = from.size() / 2;
  const auto change = [&](std::size_t i) { return to[i] - from[i]; };
  for (std::size_t i = 0; i < n; i += 3) {
    correction.position = std::max(correction.position, std::hypot(change(i), change(i + 1)));
    correction.angle = std::max(correction.angle, std::abs(change(i + 2)));
    correction.velocity = std::max(correction.velocity, std::hypot(change(n + i), change(n + i + 1)));
    correction.spin = std::max(correction.spin, std::abs(change(n + i + 2)));
  }
  return correction;
}

/// A start somewhere else, its velocities those of the guesses.
State another_start(const State& guesses, double extent, std::mt19937& random) {
  const auto share = [&] { return 2 * (static_cast<double>(random()) / 4294967295.0) - 1; };  // from −1 to 1
  State y = guesses;
  for (std::size_t i = 0; i < y.size() / 2; ++i) y[i] += (i % 3 == 2 ? std::numbers::pi : extent) * share();
  return y;
}

}  // namespace

SceneAssembly assemble_scene(const Scene& scene, const AssemblyRequest& request) {
  for (const SceneBody& body : scene.bodies) {
    if (body.mass > 0) continue;
    throw SceneError(scene.file + ":" + std::to_string(body.line) + ": body \"" + body.name +
                     "\" has mass 0; allowed is a mechanism, whose bodies have masses: a journal alone on its film has "
                     "nothing to assemble");
  }
  const Scene closed = with_closed_joints(scene, request);
  const PlanarSystem<double> system = planar_system<double>(closed);
  const double length = scene_units(closed).mechanism;
  const State guesses = scene_start<double>(closed);
  SceneAssembly result;
  Closing closing(system);
  const auto arrive = [&](State y) {
    if (!closing.approach(length, y)) return std::optional<State>();
    assemble_start(system, 0.0, length, y);
    return std::optional<State>(std::move(y));
  };
  const auto add = [&](State y) {
    const double distance = distance_between(system, guesses, y);
    result.branches.push_back({std::move(y), distance, {}, {}});
  };
  if (system.constraint_rows() == 0) {
    throw SceneError(scene.file + ": the scene has no constraint and no joint to close; allowed is one with a loop");
  }
  std::optional<ConstraintError> failure;
  try {
    if (std::optional<State> y = arrive(guesses)) {
      add(std::move(*y));
    } else {
      result.guesses_lead = false;
    }
  } catch (const ConstraintError& error) {
    result.guesses_lead = false;
    failure = error;
  }
  const std::size_t rows = system.constraint_rows();
  result.freedoms = system.coordinates() > rows ? system.coordinates() - rows : 0;
  if (result.freedoms == 0 || result.branches.empty()) {
    std::mt19937 random;  // the same numbers everywhere
    const double extent = extent_of(closed, length);
    for (result.other_starts = 0; result.other_starts < request.other_starts; ++result.other_starts) {
      try {
        const std::optional<State> y = arrive(another_start(guesses, extent, random));
        if (!y) continue;
        ++result.arrived;
        const bool known = std::any_of(result.branches.begin(), result.branches.end(),
                                       [&](const AssemblyBranch& b) { return is_same(b.state, *y, length); });
        if (!known) add(*y);
      } catch (const ConstraintError& error) {
        if (!failure) failure = error;
      }
      if (result.freedoms > 0 && !result.branches.empty()) break;  // one of many: any will do
    }
  }
  if (result.branches.empty()) {
    std::string reason = failure ? failure->what() : "";
    if (!failure) {  // the words of the last steps, from where the guesses lead nearest
      try {
        State y = guesses;
        assemble_start(system, 0.0, length, y);
      } catch (const ConstraintError& error) {
        reason = error.what();
      }
    }
    throw SceneError(scene.file + ": constraints: " + reason + "; neither did " + std::to_string(result.other_starts) +
                     " other starts lead to a position that fulfils them");
  }
  const auto others = result.branches.begin() + (result.guesses_lead ? 1 : 0);
  std::sort(others, result.branches.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  for (AssemblyBranch& branch : result.branches) {
    // A whole turn more or less is the same place: the one nearest to the guesses, unless a driver's angle counts
    // turns.
    State nearer = branch.state;
    for (std::size_t i = 2; i < nearer.size() / 2; i += 3) {
      nearer[i] = guesses[i] + std::remainder(nearer[i] - guesses[i], 2 * std::numbers::pi);
    }
    SystemWorkspace<double> w = system.workspace<double>();
    system.evaluate_kinematics(0.0, nearer.data(), w);
    const bool fits = std::all_of(w.rows.begin(), w.rows.end(),
                                  [&](const auto& row) { return std::abs(row.value) <= 1e-9 * length; });
    if (fits) branch.state = nearer;
    branch.correction = correction_of(guesses, branch.state);
  }
  detail::find_signs(closed, length, result);
  return result;
}

std::string assembled_text(const SceneFile& file, const Scene& scene, const AssemblyRequest& request,
                           const AssemblyBranch& branch) {
  std::vector<WrittenNumbers> angles;
  for (const auto& [name, angle] : request.angles) {
    for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
      const SceneConstraint& each = scene.constraints[c];
      if (each.name == name && std::holds_alternative<Driver<double>>(each.constraint))
        angles.push_back({"constraints", c, "angle", {angle}});
    }
  }
  return with_start(file, scene, branch.state, angles);
}

std::string with_start(const SceneFile& file, const Scene& scene, const std::vector<double>& state,
                       std::vector<WrittenNumbers> numbers) {
  const std::size_t n = state.size() / 2;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const double* q = &state[3 * b];
    const double* v = q + n;
    numbers.push_back({"bodies", b, "position", {q[0], q[1]}, true});
    numbers.push_back({"bodies", b, "angle", {q[2]}, true});
    numbers.push_back({"bodies", b, "velocity", {v[0], v[1]}, true});
    if (!scene.bodies[b].spin_is_held) numbers.push_back({"bodies", b, "spin", {v[2]}, true});
  }
  std::string text = with_numbers(file, numbers);
  const std::vector<double> again = scene_start<double>(SceneFile(text, file.name()).rough_scene());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const bool is_held = i >= n && (i - n) % 3 == 2 && scene.bodies[(i - n) / 3].spin_is_held;
    if (is_held || again[i] == state[i]) continue;
    throw SceneError(file.name() +
                     ": the places of its bodies can't be written into it; allowed is a file with its bodies in "
                     "[[bodies]] tables of plain numbers");
  }
  return text;
}

}  // namespace lubjoint
