#include "lubjoint/scene/equilibrium.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/steady_place.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

namespace {

/// Extended precision: the eigenvalues span 1e-4 to 1e5 1/s.
using Long = long double;

/// Force on the journal at a state, and its exact derivatives.
struct Linearisation {
  Vector2<double> force;
  Eigen::Matrix<Long, 4, 4> jacobian;
};

template <class Law>
Linearisation linearise(const JournalScene& parts, const JournalState<double>& y) {
  const Bearing<double>& b = parts.bearing;
  const Bearing<Long> bearing(b.length(), b.radius(), b.clearance());
  const Lubricant<Long> oil(parts.oil.viscosity());
  const FreeJournal<Law, Long> journal(
      film_of<Law, Long>(parts.law, bearing, oil, parts.table.get()),
      {parts.drive.mass, parts.drive.load.template cast<Long>(), parts.drive.bearing_spin, parts.drive.journal_spin});
  const JournalState<Long> at{y[0], y[1], y[2], y[3]};
  Linearisation result;
  exact_jacobian([&](const auto& x, auto& dxdt) { journal.rate(x, dxdt); }, at, result.jacobian);
  result.force = journal.force(at).template cast<double>();
  return result;
}

/// What a law has to say to an equilibrium; the rest is compiled once for all of them.
struct LawAtRest {
  std::function<PolarForce<double>(const PolarFilmState<double>&)> force_ratio;  ///< F/S
  BearingLimit limit;
  Linearisation (*linearise)(const JournalScene&, const JournalState<double>&);
};

JournalEquilibrium find(const Scene& scene, const LawAtRest& law) {
  const JournalScene parts = journal_scene(scene);
  const double spin_sum = 2 * parts.drive.mean_spin();
  const double load = std::hypot(parts.drive.load.x(), parts.drive.load.y());  // a square would underflow
  if (load > 0 && spin_sum == 0) {
    throw SceneError(scene.file + ":" + std::to_string(scene.bodies.front().line) +
                     ": bodies[0].spin is 0; allowed is a spin other than 0, or nothing carries the load");
  }
  JournalEquilibrium result;
  JournalState<double> y{0, 0, 0, 0};
  double q = 1;
  if (load > 0) {
    const double scale = force_scale(law.limit, parts.bearing, parts.oil);
    const std::optional<SteadyPlace<double>> place =
        steady_place_of(law.force_ratio, load / scale / std::abs(spin_sum));
    if (!place) {
      throw SceneError(
          scene.file + ":" + std::to_string(scene.bodies.front().line) +
          ": bodies[0] has no equilibrium with an eccentricity ratio between 1e-300 and 1 - 1e-15; allowed "
          "is a load that the film carries there");
    }
    const PolarFilmState<double> state = place->film(spin_sum < 0 ? -1 : 1);
    const PolarForce<double> f = law.force_ratio(state);
    result.eccentricity_ratio = state.eccentricity_ratio;
    q = state.q;
    // F = −W fixes the frame: r is −W turned back by the angle of F in it.
    const Vector2<double> up = -parts.drive.load / load;
    const double size = std::hypot(f.radial, f.tangential);
    const double cosine = f.radial / size;
    const double sine = f.tangential / size;
    const Vector2<double> r(cosine * up.x() + sine * up.y(), cosine * up.y() - sine * up.x());
    result.attitude = std::atan2(std::copysign(1.0, spin_sum) * f.tangential, -f.radial);
    y = {state.eccentricity_ratio * r.x(), state.eccentricity_ratio * r.y(), 0, 0};
  }
  result.eccentricity = Vector2<double>(y[0], y[1]);

  const Linearisation linear = law.linearise(parts, y);
  const Eigen::Matrix<Long, 4, 4>& jacobian = linear.jacobian;
  result.force = linear.force;
  const Long mass = parts.drive.mass;
  result.stiffness = (-mass * jacobian.bottomLeftCorner(2, 2)).template cast<double>();
  result.damping = (-mass * jacobian.bottomRightCorner(2, 2)).template cast<double>();

  const auto is_finite = [](const auto& matrix) { return matrix.allFinite(); };
  if (!is_finite(result.force) || !is_finite(result.stiffness) || !is_finite(result.damping) || !is_finite(jacobian)) {
    throw SceneError(scene.file + ":" + std::to_string(scene.bodies.front().line) +
                     ": the stiffness or damping of bodies[0] on its film is beyond the range of double precision; "
                     "allowed are spin, viscosity and bearing for which it is not");
  }
  const Eigen::EigenSolver<Eigen::Matrix<Long, 4, 4>> solver(jacobian, false);
  for (int i = 0; i < 4; ++i) {
    const std::complex<Long> value = solver.eigenvalues()(i);
    result.eigenvalues[static_cast<std::size_t>(i)] = {static_cast<double>(value.real()),
                                                       static_cast<double>(value.imag())};
  }
  std::sort(result.eigenvalues.begin(), result.eigenvalues.end(), [](const auto& a, const auto& b) {
    return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
  });
  // Backward stable: the eigenvalues of a matrix within a few ε of |J|; ê itself is a double, and J changes with it.
  const double norm = static_cast<double>(jacobian.norm());
  result.eigenvalue_rounding = 64 * static_cast<double>(std::numeric_limits<Long>::epsilon()) * norm +
                               8 * std::numeric_limits<double>::epsilon() * std::abs(result.eigenvalues[0]) / q;
  return result;
}

}  // namespace

Stability JournalEquilibrium::stability() const {
  const double leading = eigenvalues.front().real();
  if (leading > eigenvalue_rounding) return Stability::grows;
  if (leading < -eigenvalue_rounding) return Stability::decays;
  return Stability::neutral;
}

JournalEquilibrium journal_equilibrium(const Scene& scene) {
  if (scene.joints.empty()) journal_scene(scene);  // says what is missing
  if (!scene.bodies.empty() && scene.bodies.front().mass == 0) {
    throw SceneError(scene.file + ":" + std::to_string(scene.bodies.front().line) +
                     ": bodies[0].mass is 0, and eigenvalues need one; allowed is a mass above 0: the place of "
                     "equilibrium does not depend on it where the load is given");
  }
  const SceneJoint& joint = scene.joints.front();
  if (is_compiled_law(joint.film)) {
    return with_film_law<CompiledLaws>(joint.film, [&]<class Law>() {
      const Law law(table_of<Law>(joint.table.get()));
      const auto force_ratio = [&law](const PolarFilmState<double>& film) {
        return compiled_polar_force_ratio(law, film);
      };
      return find(scene, {force_ratio, Law::limit, &linearise<RunLaw<Law>>});
    });
  }
  require_law_at_rest(joint.film);
  return with_film_law(joint.film, [&]<class Law>() {
    return find(scene, {&polar_force_ratio<Law, double>, Law::limit, &linearise<Law>});
  });
}

}  // namespace lubjoint
