#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/page/panel.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

/// A parameter set by what the paper's captions say: c [mm], μ [Pa s].
struct Parameters {
  double clearance;
  double viscosity;
};

constexpr Parameters base{0.2, 0.4};
constexpr Parameters wide{0.5, 0.4};
constexpr Parameters narrow{0.1, 0.4};
constexpr Parameters thin_wide{0.5, 0.04};
constexpr Parameters thin{0.2, 0.04};

std::size_t place_of(const Example2& example, const Parameters& sought) {
  for (std::size_t i = 0; i < example.cases.size(); ++i) {
    const SceneJoint& joint = example.cases[i].scene.joints.at(0);
    const bool same_clearance = std::abs(1e3 * joint.clearance - sought.clearance) < 1e-9;
    if (same_clearance && std::abs(joint.viscosity - sought.viscosity) < 1e-9) return i;
  }
  throw std::invalid_argument(
      fmt::format("example 2 was run without c = {} mm, {} Pa s", sought.clearance, sought.viscosity));
}

const Example2Case& case_of(const Example2& example, const Parameters& sought) {
  return example.cases[place_of(example, sought)];
}

double largest_ratio(const Example2Case& item) {
  return item.run.joints[0].eccentricity.value / item.scene.joints[0].clearance;
}

double least_film(const Example2Case& item) {
  return 1e6 * (item.scene.joints[0].clearance - item.run.joints[0].eccentricity.value);
}

std::string ratio_words(const Example2Case& item) { return fmt::format("{:.4f}", largest_ratio(item)); }
std::string film_words(const Example2Case& item) { return fmt::format("{:.3g}", least_film(item)); }

/// "3038 N at ε = 0.97, 12 % above the ideal joint's".
std::string force_words(const Example2& example, const Parameters& sought) {
  const double force = case_of(example, sought).run.joints[0].force.value;
  return fmt::format("{:.0f} N, {} above the ideal joint’s", force, percent(force / example.ideal_force - 1));
}

std::string moment_words(const Example2& example, const Parameters& sought) {
  const DriverExtremes& moment = case_of(example, sought).run.drivers[0];
  return fmt::format("{} to {:.2f} N·m (ideal ±{:.2f})", with_minus(fmt::format("{:.2f}", moment.min_moment.value)),
                     moment.max_moment.value, example.ideal_moment);
}

const char* words_of(SliderCrankQuantity quantity) {
  switch (quantity) {
    case SliderCrankQuantity::force:
      return "joint force";
    case SliderCrankQuantity::moment:
      return "driving moment";
    case SliderCrankQuantity::orbit:
      return "orbit of the journal’s centre";
    case SliderCrankQuantity::film:
      break;
  }
  return "film thickness";
}

/// Draws panels of the four quantities.
class Drawer {
 public:
  /// @param real  runs with the film of the bearing's real length, or none
  Drawer(const Example2& example, std::vector<const MultibodyTrajectory*> real)
      : example_(example), real_(std::move(real)) {}

  /// @param single  it stands alone, as wide as the text
  Panel panel(const std::string& id, const std::string& letter, SliderCrankQuantity quantity, const Parameters& set,
              bool single = false) const {
    const bool is_orbit = quantity == SliderCrankQuantity::orbit;
    const Figure figure = slider_crank_figure(example_, quantity, single ? 1.5 : 1, real_);
    const std::size_t place = place_of(example_, set);
    const Example2Case& item = example_.cases[place];
    const std::string title =
        fmt::format("{}{}, c = {:g} mm, μ = {:g} Pa·s", letter, words_of(quantity), set.clearance, set.viscosity);
    std::string extremes = fmt::format(
        " over two revolutions: largest force {:.0f} N, largest eccentricity ratio {:.4f}, least film "
        "{:.3g} µm.",
        item.run.joints[0].force.value, largest_ratio(item), least_film(item));
    if (!real_.empty()) {
      const double farthest = real_[place]->joints[0].eccentricity.value;
      extremes += fmt::format(
          " Green, the film of the bearing’s real length: largest force {:.0f} N, largest eccentricity ratio {:.4f}, "
          "least film {:.3g} µm.",
          real_[place]->joints[0].force.value, farthest / item.scene.joints[0].clearance,
          1e6 * (item.scene.joints[0].clearance - farthest));
    }
    const int width = single ? 720 : 400;
    const int height = is_orbit ? (single ? 500 : 400) : (single ? 360 : 300);
    return {id, title, title + extremes, alone(figure, figure.panels[place], width, height)};
  }

  /// A figure with panels (a) and (b) of one quantity.
  std::string pair(int number, SliderCrankQuantity quantity, const Parameters& a, const Parameters& b) const {
    const std::string id = fmt::format("figure-{}", number);
    return draw_panels({panel(id + "a", "(a) ", quantity, a), panel(id + "b", "(b) ", quantity, b)});
  }

  std::string draw(const std::vector<Panel>& panels) const { return draw_panels(panels); }

 private:
  const Example2& example_;
  std::vector<const MultibodyTrajectory*> real_;
};

std::string tables_of(const Example2& example) {
  const Column set{"clearance, viscosity", {}, false};
  Table extremes("Extremes of both revolutions, for each parameter set", {set,
                                                                          {"verdict", {}, false},
                                                                          {"largest ε", "–"},
                                                                          {"least film", "µm"},
                                                                          {"largest force", "N"},
                                                                          {"largest moment", "N·m"},
                                                                          {"least moment", "N·m"}});
  Table changes("How much the two revolutions differ, and what it matters which body carries the bearing",
                {set,
                 {"change of e from the first revolution to the second", "c"},
                 {"share of a deviation that a revolution leaves", "–"},
                 {"change of ε with the bearing on the slider", "–"}});
  for (const Example2Case& item : example.cases) {
    const SceneJoint& joint = item.scene.joints[0];
    const DriverExtremes& moment = item.run.drivers[0];
    const std::string name = fmt::format("{:g} mm, {:g} Pa·s", 1e3 * joint.clearance, joint.viscosity);
    extremes.row({name, agreement(item.verdict), fmt::format("{:.6f}", largest_ratio(item)),
                  fmt::format("{:.3f}", least_film(item)), fmt::format("{:.2f}", item.run.joints[0].force.value),
                  fmt::format("{:.3f}", moment.max_moment.value), fmt::format("{:.3f}", moment.min_moment.value)});
    changes.row({name, scientific(item.repeat_difference),
                 scientific(item.orbit.multipliers.empty() ? 0 : std::abs(item.orbit.multipliers[0])),
                 scientific(item.swapped_ratio)});
  }
  return extremes.html() + changes.html();
}

}  // namespace

Section slider_crank_section(const Content& content) {
  using Quantity = SliderCrankQuantity;
  const Example2& example = content.slider_crank;
  std::vector<const MultibodyTrajectory*> real;
  if (content.real_films) real = drawn_runs(*content.real_films, example);
  const char* const green = real.empty() ? ""
                                         : " Green lines: the film of the bearing’s real length, with its free "
                                           "boundary; below it stands which of the paper’s conclusions it changes.";
  const Drawer drawer(example, std::move(real));
  const Example2Case& usual = case_of(example, base);
  Fields fields = {
      {"green", green},
      {"ideal_force", fmt::format("{:.2f}", example.ideal_force)},
      {"ideal_moment", fmt::format("{:.2f}", example.ideal_moment)},
      {"repeat", fmt::format("{:.2f}", usual.repeat_difference)},
      {"multiplier", usual.orbit.multipliers.empty() ? "?" : percent(std::abs(usual.orbit.multipliers[0]))},
      {"distance", scientific(usual.orbit.distance)},
      {"figure_13", drawer.draw({drawer.panel("figure-13a", "(a) ", Quantity::force, base),
                                 drawer.panel("figure-13b", "(b) ", Quantity::moment, base)})},
      {"figure_14", drawer.draw({drawer.panel("figure-14-orbit", "", Quantity::orbit, base, true)})},
      {"figure_15", drawer.draw({drawer.panel("figure-15-orbit", "", Quantity::film, base, true)})},
      {"figure_16", drawer.pair(16, Quantity::force, wide, narrow)},
      {"figure_17", drawer.pair(17, Quantity::moment, wide, narrow)},
      {"figure_18", drawer.pair(18, Quantity::orbit, wide, narrow)},
      {"figure_19", drawer.pair(19, Quantity::force, thin_wide, thin)},
      {"figure_20", drawer.pair(20, Quantity::moment, thin_wide, thin)},
      {"figure_21", drawer.pair(21, Quantity::orbit, thin_wide, thin)},
      {"films", drawer.draw({drawer.panel("film-wide", "", Quantity::film, wide),
                             drawer.panel("film-narrow", "", Quantity::film, narrow),
                             drawer.panel("film-thin-wide", "", Quantity::film, thin_wide),
                             drawer.panel("film-thin", "", Quantity::film, thin)})},
      {"table", tables_of(example)},
      {"checks", checks_table("Example 2: what the letters of a verdict stand for", example.verdicts())},
      {"checks_csv", csv_block("csv-slider-crank-checks", "slider-crank-checks.csv", example_2_checks_csv(example))},
      {"csv", csv_block("csv-slider-crank", "slider-crank-summary.csv", example_2_csv(example))},
      {"film_base", film_words(usual)},
      {"film_thin", film_words(case_of(example, thin))},
      {"film_thin_wide", film_words(case_of(example, thin_wide))},
  };
  const auto checked = [&](int figure, const std::vector<Parameters>& figure_sets,
                           const std::vector<std::string>& whats) {
    std::vector<const Verdict*> verdicts;
    for (const Parameters& set : figure_sets) verdicts.push_back(&case_of(example, set).verdict);
    fields[fmt::format("checked_{}", figure)] = checked_words(verdicts, whats);
  };
  const std::vector<std::string> of_force{"joint force", "largest force"};
  const std::vector<std::string> of_moment{"driving moment", "moment's extremes"};
  checked(13, {base}, {"joint force", "driving moment", "largest force", "moment's extremes", "times of these"});
  checked(14, {base}, {"e/c"});
  checked(15, {base}, {"film thickness", "least film"});
  checked(16, {wide, narrow}, of_force);
  checked(17, {wide, narrow}, of_moment);
  checked(18, {wide, narrow}, {"e/c"});
  checked(19, {thin_wide, thin}, {"joint force", "largest force", "times of these"});
  checked(20, {thin_wide, thin}, of_moment);
  checked(21, {thin_wide, thin}, {"e/c"});
  const std::pair<const char*, Parameters> sets[] = {
      {"base", base}, {"wide", wide}, {"narrow", narrow}, {"thin_wide", thin_wide}, {"thin", thin}};
  for (const auto& [name, set] : sets) {
    fields[std::string("force_") + name] = force_words(example, set);
    fields[std::string("moment_") + name] = moment_words(example, set);
    fields[std::string("ratio_") + name] = ratio_words(case_of(example, set));
  }
  return {"slider-crank", "Example 2: slider-crank with a lubricated gudgeon pin", filled("slider-crank.html", fields)};
}

}  // namespace lubjoint::reports::page
