#include "oracle/paper/example_1.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "lubjoint/film/law_list.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/paper/journal_checks.hpp"
#include "oracle/results/angles.hpp"
#include "oracle/results/journal_report.hpp"

namespace lubjoint::reports {

namespace {

double distance(const JournalState<double>& y, const Vector2<double>& e) {
  return std::hypot(y[0] - e.x(), y[1] - e.y());
}

std::string paper_says(std::string_view law) {
  if (law == "long_full" || law == "short_full") return "circles";
  if (law == "long_half" || law == "short_half" || law == "pinkus_sternlicht") return "rests";
  return "-";
}

/// The leading eigenvector's displacement, turned so that its real part is as long as can be: (mλ² + λC + K) v = 0.
Eigen::Vector2cd leading_eigenvector(double mass, const JournalEquilibrium& rest) {
  const std::complex<double> lambda = rest.eigenvalues[0];
  const Eigen::Matrix2cd matrix = mass * lambda * lambda * Eigen::Matrix2cd::Identity() +
                                  lambda * rest.damping.cast<std::complex<double>>() +
                                  rest.stiffness.cast<std::complex<double>>();
  Eigen::Vector2cd vector(-matrix(0, 1), matrix(0, 0));
  const Eigen::Vector2cd other(-matrix(1, 1), matrix(1, 0));
  if (other.norm() > vector.norm()) vector = other;
  const std::complex<double> square = vector(0) * vector(0) + vector(1) * vector(1);
  if (std::abs(square) > 0) vector /= std::sqrt(square / std::abs(square));
  return vector / vector.real().norm();
}

/// Decay as fast as this in a turn is followed down to the floor; slower, and growth, for forty turns.
constexpr double slow_decay_of_a_turn = 0.1;
constexpr double displacement = 1e-3;  // in clearances
constexpr double displacement_floor = 1e-8;

bool decays_fast(std::complex<double> eigenvalue) {
  return eigenvalue.real() * two_pi < -slow_decay_of_a_turn * std::abs(eigenvalue.imag());
}

JournalTrajectory run_by(Scene scene, const std::string& integrator, double times) {
  scene.integrator = integrator;
  scene.run.duration *= times;
  return simulate_journal(scene);
}

std::optional<MotionRate> rate_near_rest(const Scene& scene, const JournalEquilibrium& rest) {
  if (rest.eigenvalues[0].imag() == 0) return {};
  const JournalTrajectory run = simulate_journal(displaced_from(scene, rest));
  // Linear to within the distance: where it decays, it is measured from a tenth of the displacement on.
  const double below = decays_fast(rest.eigenvalues[0]) ? displacement / 10 : 2 * displacement;
  return rate_of_motion(run.samples, rest.eccentricity, below, displacement_floor);
}

Example1Law run_law(const Scene& scene, std::string_view law) {
  Example1Law item;
  item.law = law;
  item.scene = scene;
  item.scene.name = fmt::format("journal-{}", law);
  item.scene.joints.front().film = law;
  item.scene.integrator = "radau_iia5";
  item.scene.run.relative_tolerance = item.scene.run.absolute_tolerance = 1e-12;
  item.paper = paper_says(law);
  item.run = simulate_journal(item.scene);
  item.rest = journal_equilibrium(item.scene);
  item.verdict.checks = compare_runs(item.scene, item.run, run_by(item.scene, "fehlberg78", 1), "Fehlberg 7(8)");
  item.verdict.checks.push_back(sampled_force_check(item.scene, item.run));
  item.verdict.checks.push_back(equilibrium_check(item.scene, item.rest));
  item.near_rest = rate_near_rest(item.scene, item.rest);
  for (Check& check : rate_checks(item.near_rest, item.rest.eigenvalues[0])) {
    item.verdict.checks.push_back(std::move(check));
  }
  const JournalTrajectory long_run = run_by(item.scene, "radau_iia5", 3);
  item.end_distance = distance(item.run.samples.back().state, item.rest.eccentricity);
  item.long_run_distance = distance(long_run.samples.back().state, item.rest.eccentricity);
  item.found = behaviour_of(long_run.samples, item.rest.eccentricity);
  item.from_the_start = rate_of_motion(long_run.samples, item.rest.eccentricity, 2, displacement_floor);
  item.verdict.checks.push_back(behaviour_check(item.found, item.rest.eigenvalues[0], 3 * item.scene.run.duration));
  item.verdict.checks.push_back(paper_check(item.found, item.paper));
  return item;
}

}  // namespace

std::vector<const Verdict*> Example1::verdicts() const {
  std::vector<const Verdict*> all;
  for (const Example1Law& item : laws) all.push_back(&item.verdict);
  return all;
}

bool Example1::passed() const {
  return std::all_of(laws.begin(), laws.end(), [](const Example1Law& item) { return item.verdict.agrees(); });
}

Scene displaced_from(const Scene& scene, const JournalEquilibrium& rest) {
  Scene near = scene;
  SceneBody& body = near.bodies.front();
  const double c = near.joints.front().clearance;
  const std::complex<double> lambda = rest.eigenvalues[0];
  const Eigen::Vector2cd vector = displacement * leading_eigenvector(body.mass, rest);
  const Eigen::Vector2d offset = vector.real();
  const Eigen::Vector2d velocity = (lambda * vector).real();
  body.position = near.joints.front().bearing.point + c * (rest.eccentricity + Vector2<double>(offset));
  body.velocity = c * Vector2<double>(velocity);
  const double turn = two_pi / std::abs(lambda.imag());
  near.run.output_interval = turn / 250;
  near.run.duration = decays_fast(lambda) ? std::log(displacement / displacement_floor) / -lambda.real()
                      : lambda.real() > 0 ? std::min(40 * turn, std::log(10) / lambda.real())
                                          : 40 * turn;
  near.run.duration += 2 * turn;  // the twelve directions start within one turn, and the last needs its return
  near.run.relative_tolerance = near.run.absolute_tolerance = 1e-13;  // of 1e-8 c, what is left of the decay: 1e-5
  return near;
}

Example1 run_example_1(const Scene& scene) {
  Example1 example;
  example.laws.resize(film_law_names.size());
  run_parallel(film_law_names.size(), available_cores(),
               [&](std::size_t i) { example.laws[i] = run_law(scene, film_law_names[i]); });
  example.load = example.laws.front().rest.force.norm();
  return example;
}

std::string example_1_table(const Example1& example) {
  std::string text = fmt::format("Example 1: journal under a constant load of {:.4f} N\n\n", example.load);
  const auto heading = [&text](const std::array<const char*, 11>& words, const char* last) {
    constexpr std::array<int, 11> widths{-18, -8, -8, 10, 9, 10, 9, 22, 12, 12, 9};
    for (std::size_t i = 0; i < widths.size(); ++i) {
      text +=
          widths[i] < 0 ? fmt::format("{:<{}} ", words[i], -widths[i]) : fmt::format("{:>{}} ", words[i], widths[i]);
    }
    text += fmt::format(" {}\n", last);
  };
  heading({"", "the", "", "", "", "", "", "leading", "rate near", "rate from", "distance"}, "agreement:");
  heading(
      {"", "paper", "", "e/c at", "attitude", "F_Y at", "largest", "eigenvalue", "the rest", "the start", "after 3"},
      "checks that");
  heading({"law", "says", "found", "rest [-]", "[deg]", "end [N]", "e/c [-]", "[1/s]", "[1/s]", "[1/s]", "runs [c]"},
          "passed");
  const auto rate = [](const std::optional<MotionRate>& motion) {
    return motion ? fmt::format("{:+.4e}", motion->rate) : std::string("–");
  };
  for (const Example1Law& item : example.laws) {
    const std::complex<double> leading = item.rest.eigenvalues[0];
    const JournalSample& last = item.run.samples.back();
    text += fmt::format(
        "{:<18} {:<8} {:<8} {:>10.6f} {:>9.4f} {:>10.5f} {:>9.6f} {:>+12.4e} {:>+8.4f}i {:>12} {:>12} {:>9.1e}  {}\n",
        item.law, item.paper == "-" ? "–" : item.paper, behaviour_word(item.found), item.rest.eccentricity_ratio,
        degrees * item.rest.attitude, last.force.y(), item.run.max_eccentricity_ratio, leading.real(),
        std::abs(leading.imag()), rate(item.near_rest), rate(item.from_the_start), item.long_run_distance,
        item.verdict.in_letters());
  }
  text +=
      "\nDoes the journal come to rest or circle its equilibrium? The paper's words are those on figures 9 to 11.\n"
      "Attitude: from the load to e, positive with the spin. Leading: of largest real part, of the journal on its "
      "film.\n"
      "Rate: growth of the distance from the equilibrium, measured on a run from 1e-3 c off it, and on the scene's "
      "own\n"
      "run from the start, where amplitude shows in it (mean over directions; not judged). Distance: from the\n"
      "equilibrium after three times the run (not judged).\n\n"
      "agreement: a letter for each check that passed, a dash for each that was not made. The run is by Radau\n"
      "IIA(5), tolerance 1e-12; Fehlberg 7(8) shares its equations of motion and its search for peaks and events.\n" +
      check_legend(example.verdicts());
  for (const Example1Law& item : example.laws) {
    for (const SlidingInterval& interval : item.run.sliding) {
      text += fmt::format("{} slides on the jump of its half film from {:.3g} s to {:.5f} s.\n", item.law,
                          interval.start, interval.end);
    }
  }
  return text;
}

std::string example_1_csv(const Example1& example) {
  std::string csv =
      "law,paper,found,equilibrium_ratio,attitude_deg,fy_end,max_ratio,t_max_ratio,max_force,t_max_force,eigenvalue_re,"
      "eigenvalue_im,stability,rate_near,frequency_near,rate_from_start,least_rate_from_start,most_rate_from_start,"
      "distance_end,distance_3x,sliding_s,checks_passed,checks_failed,checks_not_made,agrees\n";
  for (const Example1Law& item : example.laws) {
    double sliding = 0;
    for (const SlidingInterval& interval : item.run.sliding) sliding += interval.end - interval.start;
    const std::complex<double> leading = item.rest.eigenvalues[0];
    const auto of = [](const std::optional<MotionRate>& motion, double MotionRate::*value) {
      return motion ? fmt::format("{}", (*motion).*value) : std::string();
    };
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", item.law,
                       item.paper, behaviour_word(item.found), item.rest.eccentricity_ratio,
                       degrees * item.rest.attitude, item.run.samples.back().force.y(), item.run.max_eccentricity_ratio,
                       item.run.t_max_eccentricity_ratio, item.run.max_force, item.run.t_max_force, leading.real(),
                       std::abs(leading.imag()), stability_word(item.rest.stability()),
                       of(item.near_rest, &MotionRate::rate), of(item.near_rest, &MotionRate::frequency),
                       of(item.from_the_start, &MotionRate::rate), of(item.from_the_start, &MotionRate::least_rate),
                       of(item.from_the_start, &MotionRate::most_rate), item.end_distance, item.long_run_distance,
                       sliding, item.verdict.count(CheckOutcome::passed), item.verdict.count(CheckOutcome::failed),
                       item.verdict.count(CheckOutcome::not_checked), item.verdict.in_a_word());
  }
  return csv;
}

std::string example_1_checks_csv(const Example1& example) {
  std::vector<std::string> laws;
  for (const Example1Law& item : example.laws) laws.push_back(item.law);
  return checks_csv(laws, example.verdicts());
}

}  // namespace lubjoint::reports
