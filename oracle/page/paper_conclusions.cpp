// The paper's conclusions, with its own films and with the film of the bearing's real length.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

using Fate = lubjoint::Stability;

constexpr std::string_view real_film = "finite_reynolds";
/// What the paper asks for in its figure 15: 0.00015 mm for each millimetre of the bearing's diameter, 3 µm.
constexpr double safe_film = 3e-6;

const JournalEquilibrium* rest_of(const Example1& example, std::string_view law) {
  const auto found =
      std::find_if(example.laws.begin(), example.laws.end(), [&](const auto& l) { return l.law == law; });
  return found == example.laws.end() ? nullptr : &found->rest;
}
const JournalEquilibrium* rest_of(const RealFilms& films, std::string_view film) {
  const auto found = std::find_if(films.journal.begin(), films.journal.end(),
                                  [&](const auto& j) { return j.scene.joints.front().film == film; });
  return found == films.journal.end() ? nullptr : &found->rest;
}

/// What a small displacement does in the time of the paper's figures: it circles if it changes by less than a
/// hundredth. With a full film it grows, too slowly to be seen there.
struct Motion {
  double duration;  ///< [s]

  Fate fate(const JournalEquilibrium& rest) const {
    return std::abs(rest.eigenvalues[0].real()) * duration < 0.01 ? Fate::neutral : rest.stability();
  }
  /// "circles, and grows at 0.0012 1/s", "comes to rest at 12.3 1/s".
  std::string words(const JournalEquilibrium& rest) const {
    const double rate = rest.eigenvalues[0].real();
    switch (fate(rest)) {
      case Fate::neutral:
        return fmt::format("circles, and {} at {:.2g} 1/s", rate > 0 ? "grows" : "shrinks", std::abs(rate));
      case Fate::grows:
        return fmt::format("moves away at {:.3g} 1/s", rate);
      case Fate::decays:
        return fmt::format("comes to rest at {:.3g} 1/s", -rate);
    }
    return {};
  }
};

/// A run of example 2, whichever film it is with.
struct Crank {
  double clearance, viscosity;
  double least_film;  ///< [m]
  double moment;      ///< largest size [N m]
};

template <class Item>
Crank crank_of(const Item& item) {
  const SceneJoint& joint = item.scene.joints.front();
  const DriverExtremes& moment = item.run.drivers.front();
  return {joint.clearance, joint.viscosity, joint.clearance - item.run.joints.front().eccentricity.value,
          std::max(std::abs(moment.max_moment.value), std::abs(moment.min_moment.value))};
}

std::vector<Crank> cranks_of(const Example2& example) {
  std::vector<Crank> all;
  for (const Example2Case& item : example.cases) all.push_back(crank_of(item));
  return all;
}
std::vector<Crank> cranks_of(const RealFilms& films) {
  std::vector<Crank> all;
  for (const RealFilmCrank& item : films.crank) {
    if (item.scene.joints.front().film == real_film) all.push_back(crank_of(item));
  }
  return all;
}

const Crank* at(const std::vector<Crank>& all, double clearance, double viscosity) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6 * b; };
  const auto found = std::find_if(all.begin(), all.end(), [&](const Crank& c) {
    return near(c.clearance, clearance) && near(c.viscosity, viscosity);
  });
  return found == all.end() ? nullptr : &*found;
}

std::string film_words(const Crank& c) { return fmt::format("{:.2f} µm", 1e6 * c.least_film); }

/// One conclusion: what it says, what shows it with each film, whether it holds with the real one.
struct Conclusion {
  std::string says, with_papers, with_real;
  bool stands;
};

void add_journal(const Content& content, std::vector<Conclusion>& all) {
  const RealFilms& films = *content.real_films;
  if (content.journal.laws.empty()) return;
  const Motion motion{content.journal.laws.front().scene.run.duration};
  const auto compare = [&](const std::string& says, std::string_view law, std::string_view film, Fate expected) {
    const JournalEquilibrium* paper = rest_of(content.journal, law);
    const JournalEquilibrium* real = rest_of(films, film);
    if (paper == nullptr || real == nullptr) return;
    all.push_back({says, fmt::format("{}: {}", law, motion.words(*paper)),
                   fmt::format("{}: {}", film, motion.words(*real)), motion.fate(*real) == expected});
  };
  compare("With Sommerfeld’s full film the journal circles undamped (figs. 9a, 9c)", "long_full", "finite_full",
          Fate::neutral);
  compare("With Gümbel’s half film it comes to rest (figs. 9b, 9d)", "short_half", "finite_half", Fate::decays);
  compare("With Pinkus and Sternlicht’s it does, too (fig. 9e)", "pinkus_sternlicht", real_film, Fate::decays);
  const JournalEquilibrium* half = rest_of(content.journal, "long_half");
  const JournalEquilibrium* dynamic = rest_of(content.journal, "pinkus_sternlicht");
  const JournalEquilibrium* real_half = rest_of(films, "finite_half");
  const JournalEquilibrium* real_dynamic = rest_of(films, "finite_dynamic");
  if (half != nullptr && dynamic != nullptr && real_half != nullptr && real_dynamic != nullptr) {
    all.push_back(
        {"A film that ruptures where its pressure says is less damped than a half film (fig. 9e)",
         fmt::format("pinkus_sternlicht {}; long_half {}", motion.words(*dynamic), motion.words(*half)),
         fmt::format("finite_dynamic {}; finite_half {}", motion.words(*real_dynamic), motion.words(*real_half)),
         real_dynamic->eigenvalues[0].real() > real_half->eigenvalues[0].real()});
  }
  const JournalEquilibrium* real = rest_of(films, real_film);
  if (dynamic != nullptr && real != nullptr) {
    all.push_back({"Pinkus and Sternlicht’s film says where the journal rests (fig. 9e), to 10 %",
                   fmt::format("ε = {:.4f}", dynamic->eccentricity_ratio),
                   fmt::format("ε = {:.4f}", real->eccentricity_ratio),
                   std::abs(dynamic->eccentricity_ratio / real->eccentricity_ratio - 1) < 0.1});
  }
}

void add_crank(const Content& content, std::vector<Conclusion>& all) {
  const std::vector<Crank> papers = cranks_of(content.slider_crank), reals = cranks_of(*content.real_films);
  const Crank* paper = at(papers, 2e-4, 0.4);
  const Crank* real = at(reals, 2e-4, 0.4);
  if (paper != nullptr && real != nullptr) {
    all.push_back({"c = 0.2 mm, 0.4 Pa s: the film is always thicker than the 3 µm that are safe (fig. 15)",
                   "at least " + film_words(*paper), "at least " + film_words(*real), real->least_film > safe_film});
    const double ideal = content.slider_crank.ideal_moment;
    all.push_back({"The driving moment is of the same order as with an ideal joint (fig. 13b), to a factor of two",
                   fmt::format("{:.1f} N m, ideal {:.1f} N m", paper->moment, ideal),
                   fmt::format("{:.1f} N m", real->moment), real->moment < 2 * ideal && ideal < 2 * real->moment});
  }
  const Crank* thin_paper = at(papers, 2e-4, 0.04);
  const Crank* thin_real = at(reals, 2e-4, 0.04);
  if (paper != nullptr && real != nullptr && thin_paper != nullptr && thin_real != nullptr) {
    all.push_back({"A thinner oil brings the journal nearer to the wall (figs. 18, 21)",
                   film_words(*thin_paper) + " with a tenth of the viscosity",
                   film_words(*thin_real) + " with a tenth of it", thin_real->least_film < real->least_film});
  }
  std::string unsafe_papers, unsafe_reals;
  bool same = true;
  for (const Crank& each : papers) {
    const Crank* other = at(reals, each.clearance, each.viscosity);
    if (other == nullptr) continue;
    const auto note = [](std::string& words, const Crank& c) {
      if (c.least_film > safe_film) return;
      words += fmt::format("{}{:g} mm, {:g} Pa s: {}", words.empty() ? "" : "; ", 1e3 * c.clearance, c.viscosity,
                           film_words(c));
    };
    note(unsafe_papers, each);
    note(unsafe_reals, *other);
    same = same && (each.least_film > safe_film) == (other->least_film > safe_film);
  }
  if (papers.empty() || reals.empty()) return;
  all.push_back({"Which of the five bearings come below the 3 µm (figs. 18 to 21)",
                 unsafe_papers.empty() ? "none" : unsafe_papers, unsafe_reals.empty() ? "none" : unsafe_reals, same});
}

}  // namespace

std::string paper_conclusions(const Content& content) {
  if (!content.real_films) return {};
  std::vector<Conclusion> all;
  add_journal(content, all);
  add_crank(content, all);
  if (all.empty()) return {};
  Table table("What the paper’s conclusions would have been with the film of the bearing’s real length",
              {{"the paper says", {}, false},
               {"with its films", {}, false},
               {"with the real one", {}, false},
               {"it stands", {}, false}});
  for (const Conclusion& each : all)
    table.row({each.says, each.with_papers, each.with_real, each.stands ? "yes" : "no"});
  return table.as_cards().html();
}

}  // namespace lubjoint::reports::page
