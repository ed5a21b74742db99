#include <fmt/format.h>

#include <algorithm>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/joint/kinematics.hpp"
#include "lubjoint/multibody/joint_element.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/multibody_scene.hpp"  // knows that the laws' functions are compiled in the scene library
#include "oracle/laws/median.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/laws/model_error_words.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::reports {

namespace {

/// Error of a joint's law at each of some films.
VisitedModelError error_at(const SceneJoint& joint, const std::vector<FilmState<double>>& films) {
  const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
  const Lubricant<double> oil(joint.viscosity);
  const AnyFilm<double> law = make_film(joint.film, bearing, oil, joint.table.get());
  const double shape = length_to_diameter(bearing);
  const double scale = force_scale(BearingLimit::long_bearing, bearing, oil);
  VisitedModelError result;
  std::vector<double> errors;
  for (const FilmState<double>& film : films) {
    const double ratio = film.eccentricity.norm();
    // A film at rest has no force to be wrong; beyond 0.99 the finite-length film is not resolved cheaply.
    if (is_zero(film.velocity) || is_zero(film.eccentricity) || !(ratio <= 0.99)) continue;
    const Vector2<double> force = scale * finite_force(oracle::FiniteFilm::finite_reynolds, shape, film, {1e-2}).ratio;
    const Vector2<double> given = std::visit([&film](const auto& each) { return each.force(film); }, law);
    const double error = (given - force).norm() / force.norm();
    errors.push_back(error);
    if (error > result.largest) {
      result.largest = error;
      result.eccentricity_ratio_of_largest = ratio;
    }
  }
  result.states = errors.size();
  if (!errors.empty()) result.median = median(errors);
  return result;
}

/// The same at each of some motions of its journal.
VisitedModelError error_along(const SceneJoint& joint, const std::vector<JournalMotion<double>>& motions) {
  if (joint.film == no_film) return {};
  std::vector<FilmState<double>> films;
  for (const JournalMotion<double>& motion : motions) {
    const Vector2<double> e = motion.eccentricity / joint.clearance;
    if (!(one_minus_squared_norm(e.x(), e.y()) > 0)) continue;  // in contact
    films.push_back(film_state(motion, joint.clearance));
  }
  return error_at(joint, films);
}

/// Some samples of a run, evenly spaced, the first left out.
template <class Sample>
std::vector<Sample> some_of(const std::vector<Sample>& samples, std::size_t states) {
  std::vector<Sample> some;
  if (samples.size() < 2) return some;
  for (std::size_t i = 1; i <= states; ++i) some.push_back(samples[i * (samples.size() - 1) / states]);
  return some;
}

}  // namespace

VisitedModelError visited_model_error(const Scene& scene, const JournalTrajectory& run, std::size_t states) {
  const double spin = journal_scene(scene).drive.mean_spin();
  std::vector<FilmState<double>> films;
  for (const JournalSample& sample : some_of(run.samples, states)) {
    const auto& y = sample.state;
    films.emplace_back(Vector2<double>(y[0], y[1]), Vector2<double>(y[2] + spin * y[1], y[3] - spin * y[0]));
  }
  return error_at(scene.joints.front(), films);
}

VisitedModelError visited_model_error(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run,
                                      std::size_t states) {
  const SceneJoint& at = scene.joints[joint];
  std::vector<JournalMotion<double>> motions;
  for (const MultibodySample& sample : some_of(run.samples, states)) {
    motions.push_back(joint_kinematics(motion_in(sample.state, at.bearing.body), at.bearing.point,
                                       motion_in(sample.state, at.journal.body), at.journal.point)
                          .motion);
  }
  return error_along(at, motions);
}

VisitedModelError visited_model_error(const SceneJoint& joint, const std::vector<JournalMotion<double>>& motions,
                                      std::size_t states) {
  return error_along(joint, some_of(motions, states));
}

std::string error_words(double error) {
  return error < 10 ? fmt::format("{:.{}f} %", 100 * error, error < 0.1 ? 1 : 0) : fmt::format("{:.0f} times", error);
}

std::string remedy(double shape) {
  if (!(shape >= least_compiled_shape && shape <= largest_compiled_shape)) return {};
  return fmt::format("The law {} is the film of the real length, compiled for this L/D. ", FiniteReynolds::name);
}

std::string model_warning(const SceneJoint& joint, const VisitedModelError& error) {
  if (error.states == 0 || error.median <= 0.25) return {};
  const double shape = joint.length / (2 * joint.journal_radius);
  return fmt::format(
      "warning: at the states that this run visits, law {} of joint \"{}\" is off the force of a film of the "
      "bearing's real length, L/D = {:.2f}, by {} (median of {} states; largest {}, at eccentricity ratio {:.3f}). {}"
      "lubjoint model-error says more.",
      joint.film, joint.name, shape, error_words(error.median), error.states, error_words(error.largest),
      error.eccentricity_ratio_of_largest, remedy(shape));
}

std::string model_warning(const std::vector<SceneJoint>& joints, const std::vector<VisitedModelError>& errors) {
  std::size_t worst = 0;
  std::size_t doubtful = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (model_warning(joints[i], errors[i]).empty()) continue;
    if (doubtful++ == 0 || errors[i].median > errors[worst].median) worst = i;
  }
  if (doubtful == 0) return {};
  const double shape = joints[worst].length / (2 * joints[worst].journal_radius);
  return fmt::format(
      "warning: {} of the {} laws are more than 25 % off the force of a film of the bearing's real length, L/D = "
      "{:.2f}, "
      "at half of the states that their runs visit; the worst is {}, {} in the median. {}lubjoint model-error says "
      "more.",
      doubtful, joints.size(), shape, joints[worst].film, error_words(errors[worst].median), remedy(shape));
}

}  // namespace lubjoint::reports
