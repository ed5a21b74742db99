#include "oracle/paper/journal_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/laws/published_forms.hpp"
#include "oracle/reynolds/film_integral.hpp"

namespace lubjoint::reports {

namespace {

/// Largest difference of two runs at their samples; infinite if they were not sampled at the same times.
template <class Difference>
double largest_difference(const JournalTrajectory& one, const JournalTrajectory& other, const Difference& difference) {
  if (one.samples.empty() || one.samples.size() != other.samples.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    if (one.samples[i].t != other.samples[i].t) return std::numeric_limits<double>::infinity();
    const double found = difference(one.samples[i], other.samples[i]);
    if (!(found <= largest)) largest = found;
    if (std::isnan(found)) break;
  }
  return largest;
}

double sliding_difference(const JournalTrajectory& one, const JournalTrajectory& other) {
  if (one.sliding.size() != other.sliding.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < one.sliding.size(); ++i) {
    largest = std::max({largest, std::abs(one.sliding[i].start - other.sliding[i].start),
                        std::abs(one.sliding[i].end - other.sliding[i].end)});
  }
  return largest;
}

bool jumps(const std::string& law) {
  return with_film_law(law, []<class Law>() { return HalfFilmLaw<Law>; });
}

bool integrates_a_pressure(const std::string& law) {
  return std::any_of(oracle::one_dimensional_films.begin(), oracle::one_dimensional_films.end(),
                     [&](const auto& entry) { return entry.name == law; });
}

/// S of page and paper: μRL³/c² or μLR³/c².
long double published_scale(const std::string& law, const JournalScene& parts) {
  const long double r = parts.bearing.radius();
  const long double l = parts.bearing.length();
  const long double c = parts.bearing.clearance();
  const bool is_short = law_facts(law).is_short();
  return parts.oil.viscosity() * (is_short ? r * l * l * l : l * r * r * r) / (c * c);
}

/// Force on the journal by quadrature, or by the published formula where there is no pressure.
/// @param y  not at the centre, and u ≠ 0
Vector2<double> independent_force(const std::string& law, const JournalScene& parts, const JournalState<double>& y) {
  const double epsilon = std::hypot(y[0], y[1]);
  const Vector2<double> r(y[0] / epsilon, y[1] / epsilon);
  const Vector2<double> t(-r.y(), r.x());
  const double spin = parts.drive.mean_spin();
  const Vector2<double> u(y[2] + spin * y[1], y[3] - spin * y[0]);
  const double a = -2 * dot(u, t);
  const double b = dot(u, r);
  if (integrates_a_pressure(law)) {
    const PolarFilmState<double> state(epsilon, a, b, one_minus_squared_norm(y[0], y[1]));
    const auto force =
        oracle::film_force_by_quadrature(oracle::one_dimensional_film(law), parts.bearing, parts.oil, state);
    return force.radial.value * r + force.tangential.value * t;
  }
  using R = long double;
  const PublishedTerms<R> terms = published_terms<R>(law, R(epsilon), R(a), R(b));
  const auto sum = [](const std::vector<R>& values) { return std::accumulate(values.begin(), values.end(), R(0)); };
  const R scale = published_scale(law, parts);
  return static_cast<double>(scale * sum(terms.radial)) * r + static_cast<double>(scale * sum(terms.tangential)) * t;
}

const char* film_oracle(const std::string& law) {
  return integrates_a_pressure(law) ? "quadrature of the film's pressure (Pinkus-Sternlicht: the paper's formula)"
                                    : "the paper's formula, written anew";
}

}  // namespace

std::vector<Check> compare_runs(const Scene& scene, const JournalTrajectory& run, const JournalTrajectory& other,
                                const std::string& other_name) {
  const JournalScene parts = journal_scene(scene);
  const double load = parts.drive.load.norm();
  const double spin = std::abs(parts.drive.mean_spin());
  const std::string at_outputs = other_name + " at every output time";
  std::vector<Check> checks;
  const bool both = run.outcome.status == RunStatus::finished && other.outcome.status == RunStatus::finished;
  const std::string message = run.outcome.status == RunStatus::finished ? other.outcome.message : run.outcome.message;
  checks.push_back(Check::holds("runs", "the scene's duration", both, both ? "both end" : message,
                                "the run and " + other_name + "'s reach the end of the scene"));
  checks.push_back(Check::at_most("e/c", at_outputs,
                                  largest_difference(run, other,
                                                     [](const JournalSample& p, const JournalSample& q) {
                                                       return std::hypot(p.state[0] - q.state[0],
                                                                         p.state[1] - q.state[1]);
                                                     }),
                                  1e-8, "c", "some 500 steps of 1e-12 each, and the cubic between them"));
  checks.push_back(
      Check::at_most("velocity", at_outputs,
                     largest_difference(run, other,
                                        [&](const JournalSample& p, const JournalSample& q) {
                                          return std::hypot(p.state[2] - q.state[2], p.state[3] - q.state[3]) / spin;
                                        }),
                     1e-6, "c spin", "the rate of a cubic over a step of 1/100 turn: a hundred times e/c"));
  checks.push_back(Check::at_most(
      "force", at_outputs,
      largest_difference(
          run, other,
          [&](const JournalSample& p, const JournalSample& q) { return (p.force - q.force).norm() / load; }),
      1e-6, "W", "a velocity of c spin costs about W; a hundredth of what figure 10 shows"));
  checks.push_back(Check::at_most("film thickness", at_outputs,
                                  largest_difference(run, other,
                                                     [](const JournalSample& p, const JournalSample& q) {
                                                       return std::abs(p.eccentricity_ratio() - q.eccentricity_ratio());
                                                     }),
                                  1e-8, "c", "h = c (1 - e/c): as e/c"));
  checks.push_back(Check::at_most("largest e/c", other_name, run.max_eccentricity_ratio - other.max_eccentricity_ratio,
                                  1e-8, "c", "as e/c"));
  const double c = scene.joints.front().clearance;
  checks.push_back(Check::at_most("least film", other_name, (run.min_film_thickness - other.min_film_thickness) / c,
                                  1e-8, "c", "as e/c"));
  checks.push_back(Check::at_most("time of both", other_name,
                                  run.t_max_eccentricity_ratio - other.t_max_eccentricity_ratio, 1e-6, "s",
                                  "the velocity's 1e-6 c spin over the peak's curvature, 0.1 c spin^2 or more"));
  checks.push_back(
      Check::at_most("largest force", other_name, (run.max_force - other.max_force) / load, 1e-6, "W", "as the force"));
  checks.push_back(Check::at_most("time of it", other_name, run.t_max_force - other.t_max_force, 5e-4, "s",
                                  "1e-8 W in a peak 1e-4 W high: the root of their ratio, as a part of 1/spin"));
  if (jumps(scene.joints.front().film)) {
    checks.push_back(Check::at_most("sliding", other_name + ": as many intervals, entry and exit",
                                    sliding_difference(run, other), 1e-8, "s",
                                    "events are found to 1e-12 of a step, on states that differ by 1e-10"));
  } else {
    checks.push_back(Check::not_checked("sliding", "the law has no jump to slide on"));
  }
  return checks;
}

Check sampled_force_check(const Scene& scene, const JournalTrajectory& run) {
  const std::string& law = scene.joints.front().film;
  const JournalScene parts = journal_scene(scene);
  double largest = run.samples.size() > 1 ? 0 : std::numeric_limits<double>::infinity();
  for (const JournalSample& sample : run.samples) {
    const bool slides = std::any_of(run.sliding.begin(), run.sliding.end(), [&](const SlidingInterval& interval) {
      return sample.t >= interval.start && sample.t <= interval.end;
    });
    if (slides || sample.eccentricity_ratio() == 0) continue;  // at the start no motion, and no force
    const Vector2<double> expected = independent_force(law, parts, sample.state);
    const double difference = (sample.force - expected).norm() / expected.norm();
    if (!(difference <= largest)) largest = difference;
    if (std::isnan(difference)) break;
  }
  return Check::at_most("force of each sample", film_oracle(law), largest, 1e-13, "|F|",
                        "rounding of both: some ten roundings of terms up to ten times |F|");
}

Check equilibrium_check(const Scene& scene, const JournalEquilibrium& rest) {
  const std::string& law = scene.joints.front().film;
  const JournalScene parts = journal_scene(scene);
  const double load = parts.drive.load.norm();
  const Vector2<double> force = independent_force(law, parts, {rest.eccentricity.x(), rest.eccentricity.y(), 0.0, 0.0});
  return Check::at_most("equilibrium carries the load", film_oracle(law), (force + parts.drive.load).norm() / load,
                        1e-12, "W", "rounding of e and of the quadrature");
}

std::vector<Check> rate_checks(const std::optional<MotionRate>& motion, std::complex<double> eigenvalue) {
  const char* names[] = {"growth or decay", "frequency"};
  if (eigenvalue.imag() == 0) {
    const char* reason = "the leading eigenvalue is real: the motion does not come round";
    return {Check::not_checked(names[0], reason), Check::not_checked(names[1], reason)};
  }
  const double none = std::numeric_limits<double>::infinity();  // a path that does not come round agrees with nothing
  const double rate = motion ? motion->rate / eigenvalue.real() - 1 : none;
  const double frequency = motion ? motion->frequency / std::abs(eigenvalue.imag()) - 1 : none;
  const char* against = "the leading eigenvalue; measured on a run from 1e-3 c off the equilibrium";
  return {
      Check::at_most(
          names[0], against, rate, 1e-3, "",
          "a law is linear up to the square of the distance: where the motion decays it is measured from 1e-4 c on; "
          "where it hardly does, every turn from 1e-3 c errs alike"),
      Check::at_most(names[1], against, frequency, 1e-3, "", "as the rate")};
}

Check behaviour_check(Behaviour found, std::complex<double> eigenvalue, double duration) {
  const char* what = "rests or circles";
  const double exponent = eigenvalue.real() * duration;
  std::optional<Behaviour> foretold;
  if (exponent * 2 / 3 < std::log(rest_share)) foretold = Behaviour::rests;
  if (std::abs(exponent) < circling_share && eigenvalue.imag() != 0) foretold = Behaviour::circles;
  if (!foretold)
    return Check::not_checked(what, "the eigenvalue decays or grows too slowly for one, too fast for the other");
  return Check::holds(
      what, "the eigenvalue", found == *foretold,
      fmt::format("it {}, the eigenvalue says {}", behaviour_word(found), behaviour_word(*foretold)),
      "over three times the run: rests, if from two thirds on it stays within 1e-3 of its first distance; "
      "circles, if it turns on and on, three turns or more, and each within 1 % of the first turn's reach");
}

Check paper_check(Behaviour found, const std::string& paper) {
  const char* what = "the paper's words";
  if (paper == "-") return Check::not_checked(what, "the paper has no such law");
  return Check::holds(what, "figures 9 to 11", paper == behaviour_word(found),
                      fmt::format("it {}, the paper says {}", behaviour_word(found), paper),
                      "what the paper says the journal does: rests or circles");
}

}  // namespace lubjoint::reports
