#include "oracle/verify/trajectory/trajectory_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace lubjoint::verify {

namespace {

std::string headline(const TrajectoryVerification& v) {
  const auto failing = std::ranges::count_if(v.deviations, [](const Deviation& d) { return !d.agrees(); });
  if (failing == 0) {
    return fmt::format("agrees: scene {} with {}, in all of {} quantities", v.scene, v.law, v.deviations.size());
  }
  return fmt::format("disagrees: scene {} with {}, in {} of {} quantities", v.scene, v.law, failing,
                     v.deviations.size());
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Times that are not judged as the scene enlarges errors too much.
bool cut_off(const Deviation& d, const TrajectoryVerification& v) {
  return d.judged_until < v.duration * (1 - 1e-9) && d.horizon < v.duration;
}

/// The worst error and what is allowed there, in the signal's unit.
struct Worst {
  double time, error, allowed;
};

Worst worst_of(const Deviation& d) {
  if (d.t.empty()) return {0, 0, 0};
  return {d.t[d.worst], d.error(d.worst) / d.signal.unit, d.allowed[d.worst] / d.signal.unit};
}

}  // namespace

std::string text_report(const TrajectoryVerification& v, const std::optional<GoldenAgreement>& golden) {
  std::string text = headline(v) + '\n';
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\n{:<34}{:<12}{:>10}{:>10}{:>12}{:>10}\n", "quantity", "unit", "error", "allowed", "at [s]",
                 "rms");
  for (const Deviation& d : v.deviations) {
    const Worst worst = worst_of(d);
    fmt::format_to(out, "{:<34}{:<12}{:>10.1e}{:>10.1e}{:>12.6g}{:>10.1e}{}\n", d.signal.name(), d.signal.unit_name,
                   worst.error, worst.allowed, worst.time, d.rms / d.signal.unit, d.agrees() ? "" : "  disagrees");
  }
  for (const Deviation& d : v.deviations) {
    if (!cut_off(d, v)) continue;
    fmt::format_to(out, "{} is judged until {:.4g} s: then our own runs at tolerances {} and {} part, too\n",
                   d.signal.name(), d.judged_until, v.reference_tolerance, v.sensitivity_tolerance);
  }
  fmt::format_to(
      out,
      "\nReference: our own run at tolerance {}. Allowed: {} clearances, or of the largest value; four times "
      "what a run\nat tolerance {} loses; the interpolation between the given rows.\n",
      v.reference_tolerance, v.tolerance, v.sensitivity_tolerance);
  if (golden) {
    fmt::format_to(
        out, "It is within {:.1e} clearances, or of the largest value, of the golden trajectory {} at {} times.\n",
        golden->worst, golden->file, golden->times);
  }
  if (!v.not_given.empty()) text += "Not given: " + listed(v.not_given) + '\n';
  if (!v.not_read.empty()) text += "Not compared: " + listed(v.not_read) + '\n';
  if (v.agrees()) return text;
  text += '\n';
  for (std::size_t i = 0; i < v.deviations.size(); ++i) {
    if (v.deviations[i].agrees()) continue;
    const auto& e = v.explanations[i];
    fmt::format_to(out, "{}: {}\n", v.deviations[i].signal.name(),
                   e ? fmt::format("{} ({:.3g} % of the error)", e->words, 100 * e->share)
                     : "neither a phase shift nor an amplitude error alone");
  }
  if (v.suspects.empty()) {
    text += "\nNo known mistake, alone, gives this trajectory.\n";
    return text;
  }
  text += "\nLikely mistakes, with the share of the error that each explains:\n";
  for (const Suspect& suspect : v.suspects) {
    fmt::format_to(out, "  {}  {}\n", suspect.share > 0 ? fmt::format("{:5.1f} %", 100 * suspect.share) : "      -",
                   suspect.words);
  }
  return text;
}

nlohmann::ordered_json json_report(const TrajectoryVerification& v, const std::optional<GoldenAgreement>& golden) {
  nlohmann::ordered_json quantities = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < v.deviations.size(); ++i) {
    const Deviation& d = v.deviations[i];
    const Worst worst = worst_of(d);
    nlohmann::ordered_json words = nullptr;
    if (v.explanations[i]) words = v.explanations[i]->words;
    quantities.push_back({{"quantity", d.signal.name()},
                          {"columns", d.signal.columns},
                          {"unit", d.signal.unit_name},
                          {"agrees", d.agrees()},
                          {"times", d.t.size()},
                          {"judged_until", d.judged_until},
                          {"worst_error", worst.error},
                          {"worst_allowed", worst.allowed},
                          {"worst_time", worst.time},
                          {"rms_error", d.rms / d.signal.unit},
                          {"explanation", words}});
  }
  nlohmann::ordered_json suspects = nlohmann::ordered_json::array();
  for (const Suspect& s : v.suspects) suspects.push_back({{"words", s.words}, {"share", s.share}});
  nlohmann::ordered_json certified = nullptr;
  if (golden) {
    certified = {{"file", golden->file}, {"times", golden->times}, {"worst", golden->worst}};
  }
  return {{"verdict", v.agrees() ? "agrees" : "disagrees"},
          {"message", headline(v)},
          {"scene", v.scene},
          {"law", v.law},
          {"tolerance", v.tolerance},
          {"reference_tolerance", v.reference_tolerance},
          {"sensitivity_tolerance", v.sensitivity_tolerance},
          {"golden", certified},
          {"quantities", quantities},
          {"not_given", v.not_given},
          {"not_compared", v.not_read},
          {"mistakes", suspects}};
}

}  // namespace lubjoint::verify
