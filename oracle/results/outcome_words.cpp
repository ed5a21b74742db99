#include "oracle/results/outcome_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lubjoint::reports {

namespace {
const char* status_word(RunStatus status) { return status == RunStatus::finished ? "finished" : "stopped"; }
}  // namespace

nlohmann::ordered_json outcome_json(const std::string& scene, const std::string& law, const RunOutcome& outcome,
                                    double wall_seconds) {
  return {{"scene", scene},
          {"law", law},
          {"integrator", outcome.integrator},
          {"integrator_reason", outcome.integrator_reason},
          {"coordinates", outcome.coordinates.empty() ? "own" : outcome.coordinates},
          {"coordinates_reason", outcome.coordinates_reason},
          {"status", status_word(outcome.status)},
          {"message", outcome.message},
          {"t_end", outcome.t_end},
          {"steps", outcome.steps},
          {"rejected_steps", outcome.rejected_steps},
          {"rhs_evaluations", outcome.rhs_evaluations},
          {"wall_s", wall_seconds}};
}

std::string outcome_text(const std::string& scene, const std::string& law, const RunOutcome& outcome,
                         double wall_seconds) {
  std::string text = fmt::format("scene        {}\nlaw          {}\nintegrator   {}", scene, law, outcome.integrator);
  if (!outcome.integrator_reason.empty()) text += fmt::format(", by auto: {}", outcome.integrator_reason);
  if (!outcome.coordinates.empty()) text += fmt::format("\ncoordinates  {}", outcome.coordinates);
  if (!outcome.coordinates_reason.empty()) text += fmt::format(", by auto: {}", outcome.coordinates_reason);
  text += fmt::format("\nstatus       {} at t = {} s\n", status_word(outcome.status), outcome.t_end);
  if (!outcome.message.empty()) text += fmt::format("message      {}\n", outcome.message);
  text += fmt::format("cost         {} steps, {} rejected, {} evaluations, {:.3g} ms\n", outcome.steps,
                      outcome.rejected_steps, outcome.rhs_evaluations, 1e3 * wall_seconds);
  return text;
}

std::string slide_text(double start, double end) {
  return fmt::format("  sliding    on the half film's jump from {:.6g} s to {:.6g} s\n", start, end);
}

std::string extremes_words(double eccentricity_ratio, double gap, double t_gap, double force, double t_force) {
  return fmt::format("eccentricity ratio {:.6f} ({} {:.4g} um) at {:.6g} s, force {:.6g} N at {:.6g} s",
                     eccentricity_ratio, gap < 0 ? "indentation" : "film", 1e6 * std::abs(gap), t_gap, force, t_force);
}

std::string extremes_text(double eccentricity_ratio, double gap, double t_gap, double force, double t_force) {
  return "  extremes   " + extremes_words(eccentricity_ratio, gap, t_gap, force, t_force) + "\n";
}

}  // namespace lubjoint::reports
