#include "oracle/measure/bench/bench_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "oracle/measure/bench/equal_error.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::string_view own_default = "radau_iia5";
constexpr std::string_view order_nine = "radau_iia9";

/// Two digits, and no exponent.
std::string brief(double value) { return value < 10 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value); }

std::string milliseconds(double seconds) { return brief(1e3 * seconds); }

std::string milliseconds(const std::optional<Contender>& contender) {
  return contender ? milliseconds(contender->seconds) : "-";
}

/// How many times as long as another one; a dash unless both are there.
std::string times_as_long(const std::optional<Contender>& one, const std::optional<Contender>& other) {
  return one && other ? brief(one->seconds / other->seconds) : "-";
}

std::string reference_words(const BenchReference& reference) {
  return fmt::format("{}, its two methods {:.1e} apart",
                     reference.golden ? "the golden trajectory" : "two integrators of extended precision",
                     reference.agreement);
}

void add_race(const std::vector<BenchRow>& rows, const Race& race, std::string& text) {
  text += fmt::format("  {:<26}{:>10}{:>10}{:>10}{:>10}{:>12}{:>12}{:>12}\n", race.formulation + " coordinates", "1e-3",
                      "1e-5", "1e-7", "1e-9", "least error", "Radau x1e-5", "x1e-9");
  for (const std::string& method : integrators_of(rows, race)) {
    const auto at = [&](double error) { return time_at_error(rows, race, method, error); };
    const auto against = [&](double error) {
      return times_as_long(at(error), time_at_error(rows, race, std::string(own_default), error));
    };
    const auto floor = error_floor(rows, race, method);
    text += fmt::format("    {:<24}{:>10}{:>10}{:>10}{:>10}{:>12}{:>12}{:>12}\n", method, milliseconds(at(1e-3)),
                        milliseconds(at(1e-5)), milliseconds(at(1e-7)), milliseconds(at(1e-9)),
                        floor ? fmt::format("{:.1e}", *floor) : "-", against(1e-5), against(1e-9));
  }
  if (race.formulation == embedded_coordinates) return;
  for (const double error : judged_errors) {
    const RaceVerdict verdict = judge_race(rows, race, error);
    text += fmt::format("    use for {:.0e}: {}\n", error, recommendation(verdict));
  }
}

/// Has a mechanism been turned out of its plane?
bool is_embedded(const std::vector<BenchRow>& rows, const std::string& scene) {
  return std::ranges::any_of(
      rows, [&](const BenchRow& row) { return row.scene == scene && row.formulation == embedded_coordinates; });
}

/// What coordinates and space cost the default integrator: how many times as long it takes at each of judged_errors in
/// absolute and in independent coordinates as in minimal ones, and in space as in the plane, both in independent ones;
/// a dash where one of them is not there.
struct FormulationCost {
  std::string scene;
  std::vector<std::string> ratios;
};

std::vector<FormulationCost> formulation_costs(const std::vector<BenchRow>& rows) {
  std::vector<FormulationCost> costs;
  for (const BenchRow& row : rows) {
    if (row.formulation != "minimal" || std::ranges::find(costs, row.scene, &FormulationCost::scene) != costs.end())
      continue;
    FormulationCost& cost = costs.emplace_back(FormulationCost{row.scene, {}});
    for (const auto& [one, other] :
         {std::pair("absolute", "minimal"), {"independent", "minimal"}, {"embedded", "independent"}}) {
      for (const double error : judged_errors) {
        const auto ratio = time_ratio(rows, {row.scene, one}, {row.scene, other}, std::string(own_default), error);
        cost.ratios.push_back(ratio ? brief(*ratio) : "–");
      }
    }
  }
  return costs;
}

std::string formulations_table(const std::vector<BenchRow>& rows) {
  const auto costs = formulation_costs(rows);
  if (costs.empty()) return {};
  std::string text = fmt::format(
      "\nHow many times as long radau_iia5 takes at equal error\n"
      "  {:<28}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n  {:<28}{:>20}{:>20}{:>20}\n",
      "", "1e-5", "1e-9", "1e-5", "1e-9", "1e-5", "1e-9", "", "absolute/minimal", "independent/min.", "space/plane");
  for (const FormulationCost& cost : costs) {
    text += fmt::format("  {:<28}", cost.scene);
    for (const std::string& ratio : cost.ratios) text += fmt::format("{:>10}", ratio);
    text += "\n";
  }
  return text;
}

/// Nothing where no mechanism was turned out of its plane.
std::string formulations_markdown(const std::vector<BenchRow>& rows) {
  const auto costs = formulation_costs(rows);
  if (std::ranges::none_of(costs, [&](const FormulationCost& cost) { return is_embedded(rows, cost.scene); }))
    return {};
  std::string text =
      "\nHow many times as long `radau_iia5` takes at equal error in absolute and in independent coordinates as in\n"
      "minimal ones, and in space, the plane turned anywhere, as in the plane, both in independent coordinates:\n\n| "
      "scene |";
  std::string rule = "|---|";
  for (const char* what : {"absolute over minimal", "independent over minimal", "space over plane"}) {
    for (const double error : judged_errors) {
      text += fmt::format(" {}, {:.0e} |", what, error);
      rule += "---|";
    }
  }
  text += "\n" + rule + "\n";
  for (const FormulationCost& cost : costs) {
    text += "| " + cost.scene + " |";
    for (const std::string& ratio : cost.ratios) text += " " + ratio + " |";
    text += "\n";
  }
  return text;
}

/// The faster of the two orders of Radau IIA.
std::optional<Contender> radau_of(const RaceVerdict& verdict) {
  for (const Contender& each : verdict.order) {
    if (each.integrator == own_default || each.integrator == order_nine) return each;
  }
  return std::nullopt;
}

/// "2.8", "1.9 (9)": its time, and which order where it is not 5.
std::string radau_words(const std::optional<Contender>& radau) {
  if (!radau) return "–";
  return milliseconds(radau->seconds) + (radau->integrator == order_nine ? " (9)" : "");
}

std::string winners_words(const RaceVerdict& verdict) {
  std::string names;
  for (const Contender& each : verdict.winners()) names += (names.empty() ? "" : " = ") + each.integrator;
  if (names.empty()) return "–";
  const std::string& first = verdict.order.front().integrator;
  if (first == own_default || first == order_nine) return names;
  return fmt::format("{}, {} ms", names, milliseconds(verdict.order.front().seconds));
}

/// "2.4 ida": how many times as long as Radau the fastest of a camp takes.
std::string opponent_words(const RaceVerdict& verdict, Camp camp) {
  const auto opponent = verdict.fastest(camp);
  const auto radau = radau_of(verdict);
  if (!opponent) return "–";
  const std::string name = camp == Camp::simbody ? "" : " " + opponent->integrator;
  if (!radau) return milliseconds(opponent->seconds) + " ms" + name;
  return times_as_long(opponent, radau) + name;
}

/// "radau_iia5 19, cvode_adams 4, ..." of all verdicts, the most frequent first.
std::string wins(const std::vector<RaceVerdict>& verdicts) {
  std::map<std::string, int> count;
  for (const RaceVerdict& verdict : verdicts) {
    for (const Contender& each : verdict.winners()) ++count[each.integrator];
  }
  std::vector<std::pair<std::string, int>> order(count.begin(), count.end());
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, times] : order) text += fmt::format("{}`{}` {}", text.empty() ? "" : ", ", name, times);
  return text.empty() ? "none" : text;
}

}  // namespace

std::string scene_bench_table(const std::vector<BenchRow>& rows, const std::vector<BenchReference>& references) {
  std::string text =
      "Milliseconds to reach an error, between tolerances on a log-log line; processor time of the integration alone,\n"
      "medians at the machine's usual pace. The error is the largest |e - e_ref|/c at the reference's times, or with\n"
      "ideal joints of a position over the mechanism's size and of an angle. Radau x: how many times as long as\n"
      "radau_iia5. -: does not get there, or was not run.\n";
  std::string scene;
  const std::vector<Race> all = races(rows);
  for (const Race& race : all) {
    if (race.scene != scene) {
      scene = race.scene;
      text += "\n" + scene;
      const auto known = std::ranges::find(references, scene, &BenchReference::scene);
      if (known != references.end()) text += ": " + reference_words(*known);
      text += "\n";
    }
    add_race(rows, race, text);
    const bool last = &race == &all.back() || (&race + 1)->scene != race.scene;
    if (last && is_embedded(rows, scene)) add_race(rows, {scene, std::string(embedded_coordinates)}, text);
  }
  text += formulations_table(rows);
  const auto ran = [&](Camp camp) {
    return std::ranges::any_of(rows, [&](const BenchRow& row) { return camp_of(row.integrator) == camp; });
  };
  if (!ran(Camp::sundials)) text += "\nCVODE and IDA did not race (cmake -DLUBJOINT_SUNDIALS=ON builds them in)\n";
  if (!ran(Camp::simbody)) text += "\nSimbody did not race (cmake -DLUBJOINT_SIMBODY=ON builds it in)\n";
  return text;
}

std::string scene_bench_markdown(const std::vector<BenchRow>& rows) {
  std::string text = "| scene | coordinates |";
  std::string rule = "|---|---|";
  for (const double error : judged_errors) {
    text += fmt::format(" {:.0e}: Radau, ms | CVODE, IDA | Simbody | fastest |", error);
    rule += "---|---|---|---|";
  }
  text += "\n" + rule + "\n";
  std::vector<RaceVerdict> verdicts;
  for (const Race& race : races(rows)) {
    text += fmt::format("| {} | {} |", race.scene, race.formulation == "journal" ? "own" : race.formulation);
    for (const double error : judged_errors) {
      const RaceVerdict verdict = judge_race(rows, race, error);
      text +=
          fmt::format(" {} | {} | {} | {} |", radau_words(radau_of(verdict)), opponent_words(verdict, Camp::sundials),
                      opponent_words(verdict, Camp::simbody), winners_words(verdict));
      verdicts.push_back(verdict);
    }
    text += "\n";
  }
  text += fmt::format("\nFastest, in how many of these {} cells: {}.\n", verdicts.size(), wins(verdicts));
  std::string elsewhere;
  for (const RaceVerdict& verdict : verdicts) {
    const std::vector<Contender> first = verdict.winners();
    if (std::ranges::any_of(first, [](const Contender& c) { return camp_of(c.integrator) == Camp::own; })) continue;
    if (first.empty()) continue;
    elsewhere += fmt::format("- {}, {} coordinates, {:.0e}: {}\n", verdict.race.scene, verdict.race.formulation,
                             verdict.error, recommendation(verdict));
  }
  if (!elsewhere.empty()) text += "Where none of lubjoint's own is the fastest:\n\n" + elsewhere;
  return text + formulations_markdown(rows);
}

std::string with_bench_block(std::string_view text, const std::string& block) {
  const std::size_t begin = text.find(bench_block_begin);
  const std::size_t end = text.find(bench_block_end);
  const bool once = begin != text.npos && end != text.npos && begin < end &&
                    text.find(bench_block_begin, begin + 1) == text.npos &&
                    text.find(bench_block_end, end + 1) == text.npos;
  if (!once) {
    throw std::invalid_argument("the marks of the table are missing or there twice; allowed is a text with the lines " +
                                std::string(bench_block_begin.substr(0, bench_block_begin.size() - 1)) + " and " +
                                std::string(bench_block_end.substr(0, bench_block_end.size() - 1)) +
                                ", once each and in this order");
  }
  std::string result(text.substr(0, begin + bench_block_begin.size()));
  return result + block + std::string(text.substr(end));
}

}  // namespace lubjoint::reports
