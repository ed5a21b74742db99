#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "lubjoint/film/law_facts.hpp"
#include "oracle/page/panel.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

constexpr std::array<std::string_view, 5> of_the_paper = {"long_full", "long_half", "short_full", "short_half",
                                                          "pinkus_sternlicht"};
constexpr std::array<std::string_view, 3> beyond_the_paper = {"short_dynamic", "long_dynamic", "long_half_eq5"};

std::size_t place_of(const Example1& example, std::string_view law) {
  for (std::size_t i = 0; i < example.laws.size(); ++i) {
    if (example.laws[i].law == law) return i;
  }
  throw std::invalid_argument("example 1 was run without the law " + std::string(law));
}

const Example1Law& item_of(const Example1& example, std::string_view law) {
  return example.laws[place_of(example, law)];
}

const JournalSample& last_of(const Example1Law& item) {
  if (item.run.samples.empty()) throw std::invalid_argument("the run of " + item.law + " has no samples");
  return item.run.samples.back();
}

std::string decay(const Example1Law& item) { return fmt::format("{:.1f}", -item.rest.eigenvalues[0].real()); }

std::string growth(const Example1Law& item) { return scientific(item.rest.eigenvalues[0].real()); }

std::string slower_or_faster(const Example1Law& one, const Example1Law& other) {
  return one.rest.eigenvalues[0].real() > other.rest.eigenvalues[0].real() ? "slower" : "faster";
}

/// "(a) x, (b) y, …" for the laws of the paper.
template <class Words>
std::string by_letter(const Example1& example, const Words& words) {
  std::string text;
  for (std::size_t i = 0; i < of_the_paper.size(); ++i) {
    text +=
        fmt::format("{}({}) {}", i ? ", " : "", static_cast<char>('a' + i), words(item_of(example, of_the_paper[i])));
  }
  return text;
}

std::string what_it_does(const Example1Law& item) {
  const std::string where = fmt::format("ε = {:.4f}", item.rest.eccentricity_ratio);
  switch (item.found) {
    case Behaviour::rests:
      return "it comes to rest at " + where;
    case Behaviour::circles:
      return "it circles its equilibrium at " + where;
    case Behaviour::neither:
      break;
  }
  return "it neither rests at nor circles its equilibrium at " + where;
}

Panel panel_of(const Figure& figure, const Example1& example, std::string_view law, const std::string& id,
               const std::string& caption, const std::string& quantity, int height) {
  const std::size_t place = place_of(example, law);
  return {id, caption, quantity + ", " + law_words(law) + ": " + what_it_does(example.laws[place]) + ".",
          alone(figure, figure.panels[place], 400, height)};
}

std::vector<Panel> panels_of(const Figure& figure, const Example1& example, int number, const std::string& quantity,
                             int height) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < of_the_paper.size(); ++i) {
    const char letter = static_cast<char>('a' + i);
    panels.push_back(panel_of(figure, example, of_the_paper[i], fmt::format("figure-{}{}", number, letter),
                              fmt::format("({}) {}", letter, law_words(of_the_paper[i])), quantity, height));
  }
  return panels;
}

std::vector<const Verdict*> of_the_paper_verdicts(const Example1& example) {
  std::vector<const Verdict*> verdicts;
  for (const std::string_view law : of_the_paper) verdicts.push_back(&item_of(example, law).verdict);
  return verdicts;
}

/// Paths and forces of the journal with the film of the bearing's real length; nothing where they were not run.
std::string real_film_panels(const Content& content) {
  if (!content.real_films || content.real_films->journal.empty()) return {};
  Example1 real{content.journal.load, {}};
  for (const RealFilmJournal& item : content.real_films->journal) {
    Example1Law law;
    law.law = item.scene.joints.front().film;
    law.scene = item.scene;
    law.run = item.run;
    law.rest = item.rest;
    real.laws.push_back(std::move(law));
  }
  const Figure orbit = journal_orbit_figure(real);
  const Figure horizontal = journal_force_figure(real, ForceComponent::horizontal);
  const Figure vertical = journal_force_figure(real, ForceComponent::vertical);
  std::vector<Panel> panels;
  const auto add = [&](const Figure& figure, std::size_t i, const char* key, const char* quantity, int height) {
    const Example1Law& item = real.laws[i];
    const std::string words = law_words(item.law);
    panels.push_back(
        {"journal-" + item.law + key, words + ": " + quantity,
         fmt::format("{}, {}: its equilibrium is at ε = {:.4f}.", quantity, words, item.rest.eccentricity_ratio),
         alone(figure, figure.panels[i], 400, height)});
  };
  for (std::size_t i = 0; i < real.laws.size(); ++i) {
    add(orbit, i, "-orbit", "path of the centre", 400);
    add(horizontal, i, "-fx", "horizontal force", 300);
    add(vertical, i, "-fy", "vertical force over the load", 300);
  }
  return "<article id=\"journal-real-film\">\n<h3>Figures 9 to 11 with the film of the bearing’s real length</h3>\n"
         "<div class=\"words\">\n<p>Beside the paper’s laws, which take the bearing for short or long: Reynolds’ "
         "equation at its L/D, as a full, a half and a dynamic film and with its free boundary. Where the film is "
         "compared with the laws stands which of the paper’s conclusions change.</p>\n</div>\n"
         "<div class=\"panels\">\n" +
         draw_panels(panels) + "</div>\n</article>\n";
}

std::string sliding_words(const Example1& example) {
  std::string text;
  for (const Example1Law& item : example.laws) {
    for (const SlidingInterval& interval : item.run.sliding) {
      text += fmt::format("{}{} from {:.2g} to {:.3g} ms", text.empty() ? "" : "; ", item.law, 1e3 * interval.start,
                          1e3 * interval.end);
    }
  }
  if (text.empty()) return {};
  return "<p>Half films jump in tangential force at a = 0, and an orbit that starts at rest can slide on the jump: " +
         escaped(text) + ". That is integrated as a mode of its own, with an entry and an exit.</p>\n";
}

}  // namespace

std::string law_words(std::string_view law) { return std::string(law_facts(law).words); }

Section journal_section(const Content& content) {
  const Example1& example = content.journal;
  const Figure orbit = journal_orbit_figure(example);
  const Figure horizontal = journal_force_figure(example, ForceComponent::horizontal);
  const Figure vertical = journal_force_figure(example, ForceComponent::vertical);
  std::vector<Panel> beyond;
  for (const std::string_view law : beyond_the_paper) {
    const std::string id = "journal-" + std::string(law);
    beyond.push_back(
        panel_of(orbit, example, law, id + "-orbit", law_words(law) + ": path", "Path of the centre", 400));
    beyond.push_back(
        panel_of(horizontal, example, law, id + "-fx", law_words(law) + ": horizontal force", "Horizontal force", 300));
    beyond.push_back(
        panel_of(vertical, example, law, id + "-fy", law_words(law) + ": vertical force", "Vertical force", 300));
  }
  const Example1Law& spiral = item_of(example, "pinkus_sternlicht");
  const Example1Law& long_half = item_of(example, "long_half");
  const Example1Law& short_half = item_of(example, "short_half");
  const Scene& scene = spiral.scene;
  return {
      "journal", "Example 1: a journal under a constant load",
      filled(
          "journal.html",
          {{"mass", fmt::format("{:g}", scene.bodies.front().mass)},
           {"clearance", fmt::format("{:g}", 1e3 * scene.joints.front().clearance)},
           {"load", fmt::format("{:.4f}", example.load)},
           {"duration", fmt::format("{:g}", scene.run.duration)},
           {"tolerance", with_powers(fmt::format("{:.0e}", scene.run.relative_tolerance))},
           {"long_full_growth", growth(item_of(example, "long_full"))},
           {"short_full_growth", growth(item_of(example, "short_full"))},
           {"ps_decay", decay(spiral)},
           {"long_half_decay", decay(long_half)},
           {"short_half_decay", decay(short_half)},
           {"ps_to_long", slower_or_faster(spiral, long_half)},
           {"ps_to_short", slower_or_faster(spiral, short_half)},
           {"largest_ratios",
            by_letter(example, [](const auto& i) { return fmt::format("{:.4f}", i.run.max_eccentricity_ratio); })},
           {"last_fx",
            by_letter(example, [](const auto& i) { return scientific(1e3 * last_of(i).force.x()) + " mN"; })},
           {"last_fy", by_letter(example, [](const auto& i) { return fmt::format("{:.5f} N", last_of(i).force.y()); })},
           {"checked_9", checked_words(of_the_paper_verdicts(example),
                                       {"e/c", "largest e/c", "rests or circles", "the paper's words"})},
           {"checked_10", checked_words(of_the_paper_verdicts(example), {"force", "force of each sample"})},
           {"checked_11", checked_words(of_the_paper_verdicts(example),
                                        {"force", "force of each sample", "equilibrium carries the load"})},
           {"sliding", sliding_words(example)},
           {"real_film", real_film_panels(content)},
           {"orbits", draw_panels(panels_of(orbit, example, 9, "Path of the journal’s centre", 400))},
           {"horizontal", draw_panels(panels_of(horizontal, example, 10, "Horizontal force on the journal", 300))},
           {"vertical", draw_panels(panels_of(vertical, example, 11, "Vertical force over the load", 300))},
           {"beyond", draw_panels(beyond)}})};
}

}  // namespace lubjoint::reports::page
