#include "lubjoint/scene/equilibrium.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "lubjoint/dynamics/exact_jacobian.hpp"
#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

namespace {

/// ε of a logistic variable, with q: 1 − ε keeps its digits on the whole line.
PolarFilmState<double> steady_state(double logit, double spin_sum) {
  const double epsilon = 1 / (1 + std::exp(-logit));
  const double gap = 1 / (1 + std::exp(logit));
  return PolarFilmState<double>(epsilon, epsilon * spin_sum, 0.0, gap * (1 + epsilon));
}

/// Extended precision: the eigenvalues span 1e-4 to 1e5 1/s.
using Long = long double;

/// Force on the journal at a state, and its exact derivatives.
struct Linearisation {
  Vector2<double> force;
  Eigen::Matrix<Long, 4, 4> jacobian;
};

template <FilmLaw Law>
Linearisation linearise(const JournalScene& parts, const JournalState<double>& y) {
  const auto& bearing = parts.bearing;
  const FreeJournal<Law, Long> journal(
      LubricatedJoint<Law, Long>(Bearing<Long>(bearing.length(), bearing.radius(), bearing.clearance()),
                                 Lubricant<Long>(parts.oil.viscosity())),
      {parts.drive.mass, parts.drive.load.template cast<Long>(), parts.drive.bearing_spin, parts.drive.journal_spin});
  const JournalState<Long> at{y[0], y[1], y[2], y[3]};
  Linearisation result;
  exact_jacobian([&](const auto& x, auto& dxdt) { journal.rate(x, dxdt); }, at, result.jacobian);
  result.force = journal.force(at).template cast<double>();
  return result;
}

/// What a law has to say to an equilibrium; the rest is compiled once for all of them.
struct LawAtRest {
  PolarForce<double> (*force)(const JournalScene&, const PolarFilmState<double>&);
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
  const auto force_at = [&](double logit) { return law.force(parts, steady_state(logit, spin_sum)); };
  // |F| grows from 0 to infinity with ε for every law: one root. ε = 1e-300 … 1 − 1e-15.
  const auto excess = [&](double logit) {
    const PolarForce<double> f = force_at(logit);
    return std::log(std::hypot(f.radial, f.tangential)) - std::log(load);
  };

  JournalEquilibrium result;
  JournalState<double> y{0, 0, 0, 0};
  double q = 1;
  if (load > 0) {
    const double lowest = -690;
    const double highest = 34.5;
    if (excess(lowest) > 0 || excess(highest) < 0) {
      throw SceneError(
          scene.file + ":" + std::to_string(scene.bodies.front().line) +
          ": bodies[0] has no equilibrium with an eccentricity ratio between 1e-300 and 1 - 1e-15; allowed "
          "is a load that the film carries there");
    }
    std::uintmax_t iterations = 200;
    const boost::math::tools::eps_tolerance<double> tolerance(52);
    const auto bracket = boost::math::tools::toms748_solve(excess, lowest, highest, tolerance, iterations);
    const double logit = (bracket.first + bracket.second) / 2;
    const PolarFilmState<double> state = steady_state(logit, spin_sum);
    const PolarForce<double> f = force_at(logit);
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
  const LawAtRest law = with_film_law(scene.joints.front().film, []<class Law>() {
    return LawAtRest{[](const JournalScene& parts, const PolarFilmState<double>& state) {
                       return film_force<Law>(parts.bearing, parts.oil, state);
                     },
                     &linearise<Law>};
  });
  return find(scene, law);
}

}  // namespace lubjoint
