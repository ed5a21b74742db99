#include "oracle/measure/bench/equal_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lubjoint::reports {

namespace {

bool is_of_race(const BenchRow& row, const Race& race) {
  const bool independent = race.formulation == "independent";
  const bool simbodys = (independent || race.formulation == "absolute") && row.formulation == "joint";
  const bool sundials = independent && row.formulation == "absolute" && camp_of(row.integrator) == Camp::sundials;
  return row.scene == race.scene && (row.formulation == race.formulation || simbodys || sundials);
}

}  // namespace

Camp camp_of(std::string_view integrator) {
  if (integrator.starts_with("simbody")) return Camp::simbody;
  return integrator.starts_with("cvode") || integrator == "ida" ? Camp::sundials : Camp::own;
}

std::vector<Race> races(const std::vector<BenchRow>& rows) {
  std::vector<Race> found;
  for (const BenchRow& row : rows) {
    if (row.formulation == embedded_coordinates) continue;
    const Race race{row.scene, row.formulation == "joint" ? "absolute" : row.formulation};
    if (std::ranges::find(found, race) == found.end()) found.push_back(race);
  }
  return found;
}

std::vector<std::string> integrators_of(const std::vector<BenchRow>& rows, const Race& race) {
  std::vector<std::string> names;
  for (const BenchRow& row : rows) {
    if (is_of_race(row, race) && std::ranges::find(names, row.integrator) == names.end())
      names.push_back(row.integrator);
  }
  return names;
}

std::vector<const BenchRow*> finished_runs(const std::vector<BenchRow>& rows, const Race& race,
                                           const std::string& integrator) {
  std::vector<const BenchRow*> runs;
  for (const BenchRow& row : rows) {
    if (is_of_race(row, race) && row.integrator == integrator && row.run.finished) runs.push_back(&row);
  }
  std::sort(runs.begin(), runs.end(), [](const auto* a, const auto* b) { return a->tolerance > b->tolerance; });
  return runs;
}

std::optional<Contender> time_at_error(const std::vector<BenchRow>& rows, const Race& race,
                                       const std::string& integrator, double error) {
  std::optional<Contender> least;
  const auto consider = [&](double seconds, double spread) {
    if (!least || seconds < least->seconds) least = Contender{integrator, seconds, spread};
  };
  const MethodRun* before = nullptr;
  for (const BenchRow* row : finished_runs(rows, race, integrator)) {
    const MethodRun& run = row->run;
    if (run.error <= error) {
      consider(run.seconds, run.spread);
      const bool logarithms =
          before && before->error > error && run.error > 0 && run.seconds > 0 && before->seconds > 0;
      if (logarithms) {
        const double share = std::log(before->error / error) / std::log(before->error / run.error);
        consider(before->seconds * std::pow(run.seconds / before->seconds, share),
                 std::max(before->spread, run.spread));
      }
    }
    before = &run;
  }
  return least;
}

std::optional<double> error_floor(const std::vector<BenchRow>& rows, const Race& race, const std::string& integrator) {
  std::optional<double> least;
  for (const BenchRow* row : finished_runs(rows, race, integrator)) {
    least = least ? std::min(*least, row->run.error) : row->run.error;
  }
  return least;
}

std::optional<double> time_ratio(const std::vector<BenchRow>& rows, const Race& race, const Race& other,
                                 const std::string& integrator, double error) {
  const auto time = time_at_error(rows, race, integrator, error);
  const auto other_time = time_at_error(rows, other, integrator, error);
  if (!time || !other_time) return std::nullopt;
  return time->seconds / other_time->seconds;
}

std::vector<Contender> RaceVerdict::winners() const {
  std::vector<Contender> found;
  for (const Contender& each : order) {
    const Contender& first = order.front();
    if (each.seconds <= first.seconds * (1 + std::max(first.spread, each.spread))) found.push_back(each);
  }
  return found;
}

std::optional<Contender> RaceVerdict::fastest(Camp camp) const {
  for (const Contender& each : order) {
    if (camp_of(each.integrator) == camp) return each;
  }
  return std::nullopt;
}

std::optional<Contender> RaceVerdict::of(std::string_view integrator) const {
  for (const Contender& each : order) {
    if (each.integrator == integrator) return each;
  }
  return std::nullopt;
}

RaceVerdict judge_race(const std::vector<BenchRow>& rows, const Race& race, double error) {
  RaceVerdict verdict{race, error, {}};
  for (const std::string& integrator : integrators_of(rows, race)) {
    if (const auto contender = time_at_error(rows, race, integrator, error)) verdict.order.push_back(*contender);
  }
  std::stable_sort(verdict.order.begin(), verdict.order.end(),
                   [](const Contender& a, const Contender& b) { return a.seconds < b.seconds; });
  return verdict;
}

std::string recommendation(const RaceVerdict& verdict) {
  if (verdict.order.empty()) return "none reaches it";
  std::string own;
  for (const Contender& each : verdict.winners()) {
    if (camp_of(each.integrator) == Camp::own) own += (own.empty() ? "" : " or ") + each.integrator;
  }
  if (!own.empty()) return own;
  const Contender& first = verdict.order.front();
  const auto best = verdict.fastest(Camp::own);
  if (!best) return first.integrator + "; none of lubjoint's own ran and reaches it";
  return fmt::format("{}; of lubjoint's own {}, {:.1f} times as long", first.integrator, best->integrator,
                     best->seconds / first.seconds);
}

}  // namespace lubjoint::reports
