#include "oracle/reports/example_1.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "lubjoint/film/law_list.hpp"
#include "oracle/reports/journal_report.hpp"

namespace lubjoint::reports {

namespace {

constexpr double degrees = 180 / boost::math::constants::pi<double>();

double distance(const JournalState<double>& y, const Vector2<double>& e) {
  return std::hypot(y[0] - e.x(), y[1] - e.y());
}

std::string paper_says(std::string_view law) {
  if (law == "long_full" || law == "short_full") return "circles";
  if (law == "long_half" || law == "short_half" || law == "pinkus_sternlicht") return "rests";
  return "-";
}

double largest_difference(const JournalTrajectory& one, const JournalTrajectory& other) {
  double largest = 0;
  const std::size_t count = std::min(one.samples.size(), other.samples.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& y = other.samples[i].state;
    largest = std::max(largest, distance(one.samples[i].state, Vector2<double>(y[0], y[1])));
  }
  return largest;
}

/// Same scene, steps that end on the output times, so that no interpolant is compared.
JournalTrajectory sampled_at_the_end(Scene scene, const std::string& integrator, double duration) {
  scene.integrator = integrator;
  scene.run.duration = duration;
  scene.run.output_interval = duration;
  return simulate_journal(scene);
}

void check(Example1Law& item, double load) {
  const auto fail = [&](const std::string& what) { item.failures.push_back(what); };
  if (item.run.outcome.status != RunStatus::finished) {
    fail(item.run.outcome.message);
    return;
  }
  // The equilibrium is a root of |F| to rounding; its force in extended precision carries ê's rounding.
  const Vector2<double> residual(item.rest.force.x(), item.rest.force.y() - load);
  if (residual.norm() > 1e-12 * load) fail(fmt::format("equilibrium leaves {:.1e} N", residual.norm()));
  // Tolerance 1e-10 a step, some hundred steps, and the jumps' events: 1e-7 of a clearance is generous for neither.
  if (item.integrator_difference > 1e-7) {
    fail(fmt::format("integrators differ by {:.1e} clearances", item.integrator_difference));
  }
  if (item.paper == "rests" && !item.rests) fail("the paper says it comes to rest");
  if (item.paper == "circles" && item.rests) fail("the paper says it circles");
  const bool should_rest = item.rest.stability() == Stability::decays && item.rest.eigenvalues[0].real() < -1;
  if (should_rest != item.rests) fail("the eigenvalue contradicts the orbit");
  // Linear theory holds to a few times the distance squared over the distance; half film and Pinkus–Sternlicht are
  // linear only to first order. Within 10 % of the decay's exponent, or at the tolerance of the integration.
  if (item.rests && item.end_distance > 1e-8 && item.long_run_distance > 1e-8) {
    const double found = std::log(item.long_run_distance / item.end_distance);
    const double predicted = std::log(item.predicted_distance / item.end_distance);
    if (std::abs(found / predicted - 1) > 0.1) fail("decay differs from the eigenvalue");
  }
}

}  // namespace

bool Example1::passed() const {
  return std::all_of(laws.begin(), laws.end(), [](const Example1Law& item) { return item.failures.empty(); });
}

Example1 run_example_1(const Scene& scene) {
  Example1 example;
  for (const std::string_view name : film_law_names) {
    Example1Law item;
    item.law = name;
    item.scene = scene;
    item.scene.name = fmt::format("journal-{}", name);
    item.scene.joints.front().film = name;
    item.scene.integrator = "radau_iia5";
    item.scene.run.relative_tolerance = item.scene.run.absolute_tolerance = 1e-10;
    item.paper = paper_says(name);
    item.run = simulate_journal(item.scene);
    item.rest = journal_equilibrium(item.scene);
    example.load = item.rest.force.norm();
    if (!item.run.samples.empty()) {
      item.start_distance = distance(item.run.samples.front().state, item.rest.eccentricity);
      item.end_distance = distance(item.run.samples.back().state, item.rest.eccentricity);
      item.rests = item.end_distance < 0.1 * item.start_distance;
    }
    const double duration = item.scene.run.duration;
    const JournalTrajectory explicit_run = sampled_at_the_end(item.scene, "fehlberg78", duration);
    item.integrator_difference =
        largest_difference(sampled_at_the_end(item.scene, "radau_iia5", duration), explicit_run);
    const JournalTrajectory long_run = sampled_at_the_end(item.scene, "radau_iia5", 3 * duration);
    item.long_run_distance = distance(long_run.samples.back().state, item.rest.eccentricity);
    item.predicted_distance = item.end_distance * std::exp(item.rest.eigenvalues[0].real() * 2 * duration);
    check(item, example.load);
    example.laws.push_back(std::move(item));
  }
  return example;
}

std::string example_1_table(const Example1& example) {
  std::string text = fmt::format(
      "Example 1: journal under a constant load of {:.4f} N\n\n{:<18} {:<8} {:<8} {:>10} {:>9} {:>10} {:>9} {:>12} "
      "{:>11} {:>9}  {}\n",
      example.load, "law", "paper", "found", "e/c rest", "attitude", "F_Y end", "max e/c", "eigenvalue", "", "after 3x",
      "agreement");
  text += fmt::format("{:<18} {:<8} {:<8} {:>10} {:>9} {:>10} {:>9} {:>24} {:>9}\n", "", "", "", "[-]", "[deg]", "[N]",
                      "[-]", "[1/s]", "[-]");
  for (const Example1Law& item : example.laws) {
    const std::complex<double> leading = item.rest.eigenvalues[0];
    const JournalSample& last = item.run.samples.back();
    std::string verdict = "yes: orbit " + stability_word(item.rest.stability());
    if (!item.failures.empty()) {
      verdict = "NO:";
      for (const std::string& failure : item.failures) verdict += " " + failure + ";";
    }
    text += fmt::format("{:<18} {:<8} {:<8} {:>10.6f} {:>9.4f} {:>10.5f} {:>9.6f} {:>+12.4e} {:>+9.4f}i {:>9.1e}  {}\n",
                        item.law, item.paper, item.rests ? "rests" : "circles", item.rest.eccentricity_ratio,
                        degrees * item.rest.attitude, last.force.y(), item.run.max_eccentricity_ratio, leading.real(),
                        std::abs(leading.imag()), item.long_run_distance, verdict);
  }
  text +=
      "\npaper, found: does the journal come to rest within the run or circle its equilibrium; the paper's words on\n"
      "figures 9 to 11. attitude: from the load to e, positive with the spin. eigenvalue: the one of largest real "
      "part\n"
      "of the journal on its film. after 3x: distance from the equilibrium, in clearances, after three times the run.\n"
      "agreement: with the paper, of two integrators of different families (1e-7 clearances), of the final decay with\n"
      "the eigenvalue (10 %), of the equilibrium's force with the load (1e-12).\n";
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
      "law,paper,found,equilibrium_ratio,attitude_deg,fy_end,max_ratio,eigenvalue_re,eigenvalue_im,stability,"
      "integrator_difference,distance_end,distance_3x,sliding_s,agrees\n";
  for (const Example1Law& item : example.laws) {
    double sliding = 0;
    for (const SlidingInterval& interval : item.run.sliding) sliding += interval.end - interval.start;
    const std::complex<double> leading = item.rest.eigenvalues[0];
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", item.law, item.paper,
                       item.rests ? "rests" : "circles", item.rest.eccentricity_ratio, degrees * item.rest.attitude,
                       item.run.samples.back().force.y(), item.run.max_eccentricity_ratio, leading.real(),
                       std::abs(leading.imag()), stability_word(item.rest.stability()), item.integrator_difference,
                       item.end_distance, item.long_run_distance, sliding, item.failures.empty() ? "yes" : "no");
  }
  return csv;
}

}  // namespace lubjoint::reports
