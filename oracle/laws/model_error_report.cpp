#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "oracle/files/files.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/laws/model_error_words.hpp"
#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports {

namespace {

constexpr double degrees = 180 / boost::math::constants::pi<double>();

/// "a, b and c", or "none".
std::string joined(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

/// Which laws are within a bound, at how many of the states, and in which directions of motion.
std::string within_sentences(const std::vector<ModelErrorSummary>& summaries, oracle::FiniteFilm film) {
  std::string text;
  const std::array<const char*, 3> bounds = {"5 %", "10 %", "25 %"};
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    std::vector<const ModelErrorSummary*> within;
    for (const ModelErrorSummary& summary : summaries) {
      if (summary.film == film && summary.share_within[i] >= 0.005) within.push_back(&summary);
    }
    std::sort(within.begin(), within.end(),
              [i](const auto* x, const auto* y) { return x->share_within[i] > y->share_within[i]; });
    std::vector<std::string> named;
    named.reserve(within.size());
    for (const ModelErrorSummary* s : within) {
      named.push_back(fmt::format("{} at {:.0f} % of the states (closing {:.0f} %, sliding {:.0f} %, opening {:.0f} %)",
                                  s->law, 100 * s->share_within[i], 100 * s->by_direction[i][0],
                                  100 * s->by_direction[i][1], 100 * s->by_direction[i][2]));
    }
    text += fmt::format("Within {} of {}: {}.\n", bounds[i], name_of(film), named.empty() ? "no law" : joined(named));
  }
  return text;
}

const LoadedState* find_state(const std::vector<LoadedState>& loaded, std::string_view name) {
  const auto found = std::ranges::find_if(loaded, [name](const LoadedState& each) { return each.name == name; });
  return found == loaded.end() ? nullptr : &*found;
}

/// The law with the least median against the film that ruptures as oil does, and what that costs at the load.
std::string verdict(const Bearing<double>& bearing, const std::vector<ModelErrorSummary>& summaries,
                    const std::vector<LoadedState>& loaded) {
  constexpr oracle::FiniteFilm truth = oracle::FiniteFilm::finite_reynolds;
  const auto least = [&](const auto& counts) {
    const ModelErrorSummary* best = nullptr;
    for (const ModelErrorSummary& summary : summaries) {
      if (summary.film != truth || !counts(summary.law)) continue;
      if (best == nullptr || summary.median < best->median) best = &summary;
    }
    return best;
  };
  const auto has_rest = [](std::string_view law) { return std::ranges::count(film_law_names, law) > 0; };
  const ModelErrorSummary* best = least(has_rest);  // a film, and a place of rest on it; fits are named behind
  if (best == nullptr) return {};
  std::string text = fmt::format("least wrong for this bearing: {}, median {}", best->law, error_words(best->median));
  const LoadedState* rest = find_state(loaded, best->law);
  const LoadedState* real = find_state(loaded, name_of(truth));
  const LoadedState* pinned = find_state(loaded, std::string(name_of(truth)) + ", onset at the maximum film");
  if (rest != nullptr && real != nullptr && pinned != nullptr) {
    const double c = bearing.clearance();
    text += fmt::format(
        "; rests at e/c {:.3f} instead of {:.3f} (Swift-Stieber, free onset; {:.3f} with the onset at the maximum "
        "film); "
        "least film {:.3g} um instead of {:.3g} ({:.3g})",
        rest->eccentricity_ratio, real->eccentricity_ratio, pinned->eccentricity_ratio,
        1e6 * c * (1 - rest->eccentricity_ratio), 1e6 * c * (1 - real->eccentricity_ratio),
        1e6 * c * (1 - pinned->eccentricity_ratio));
  }
  const ModelErrorSummary* fit =
      least([](std::string_view law) { return std::ranges::count(names_of_laws<ShapedFilmLaws>, law) > 0; });
  if (fit != nullptr && fit->median < best->median) {
    text += fmt::format(". A fit is nearer: {}, median {}", fit->law, error_words(fit->median));
  }
  const std::string compiled = remedy(length_to_diameter(bearing));
  return text + "." + (compiled.empty() ? "" : " ") + compiled.substr(0, compiled.find_last_not_of(' ') + 1) + "\n\n";
}

}  // namespace

std::string model_error_table(const Bearing<double>& bearing, const std::vector<ModelErrorSummary>& summaries,
                              const std::vector<LoadedState>& loaded) {
  std::string text = verdict(bearing, summaries, loaded);
  text += fmt::format(
      "Force laws against the film of finite length, L/D = {:.4g}\n"
      "error: |F_law - F|/|F| at the states of a grid, with equal weight: eccentricity ratios 0.05, 0.15 ... 0.95, "
      "each\n"
      "with 13 directions of motion from opening over wedge to closing; from 10 on as a multiple\n\n"
      "{:<17} {:<18} {:>8} {:>12} {:>8} {:>8} {:>8} {:>16}\n",
      bearing.length() / (2 * bearing.radius()), "film", "law", "median", "largest", "<= 5 %", "<= 10 %", "<= 25 %",
      "b >= 0, <= 25 %");
  for (const ModelErrorSummary& s : summaries) {
    const std::string safe = s.safe_ratio ? fmt::format("to e/c {:.2f}", *s.safe_ratio) : "nowhere";
    text += fmt::format("{:<17} {:<18} {:>8} {:>12} {:>7.0f}% {:>7.0f}% {:>7.0f}% {:>16}\n", name_of(s.film), s.law,
                        error_words(s.median), error_words(s.largest), 100 * s.share_within[0], 100 * s.share_within[1],
                        100 * s.share_within[2], safe);
  }
  text += '\n';
  for (const oracle::FiniteFilm film : compared_films) text += within_sentences(summaries, film);
  text += "closing, sliding, opening: u within 60 deg of e, across it, within 60 deg against it.\n";
  if (loaded.empty()) return text;
  text +=
      fmt::format("\nEquilibrium under the given load\n{:<44} {:>10} {:>16}\n", "law or film", "e/c", "attitude [deg]");
  for (const LoadedState& state : loaded) {
    text +=
        fmt::format("{:<44} {:>10.4f} {:>16.2f}\n", state.label(), state.eccentricity_ratio, degrees * state.attitude);
  }
  return text;
}

std::string model_error_csv(const std::vector<ModelErrorEntry>& map) {
  std::string csv = "law,film,eccentricity_ratio,direction_deg,error,uncertainty\n";
  for (const ModelErrorEntry& entry : map) {
    csv += fmt::format("{},{},{},{},{},{}\n", entry.law, name_of(entry.film), entry.eccentricity_ratio,
                       degrees * entry.direction, entry.error, entry.uncertainty);
  }
  return csv;
}

std::vector<std::string> draw_model_error(const std::vector<ModelErrorEntry>& map,
                                          const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const oracle::FiniteFilm film : compared_films) {
    Plot plot;
    plot.width = 1500;
    plot.height = 720;
    plot.script =
        "set multiplot layout 2,4 title 'Error of each law against " + std::string(name_of(film)) +
        ", by eccentricity ratio and direction of motion (0: closing, -90: wedge, -180: opening)' noenhanced\n"
        "set xlabel 'e/c [-]'\nset ylabel 'direction [deg]'\nset xrange [0:1]\nset yrange [-187.5:7.5]\n"
        "set ytics 45\nset logscale cb\nset cbrange [0.01:10]\nset cblabel 'error [-]'\n"
        "set format cb '%g'\nset palette defined (0 '#fde725', 1 '#35b779', 2 '#31688e', 3 '#440154')\n"
        "unset key\nset tics out nomirror\n";
    for (const std::string_view law : film_law_names) {
      plot.script += "set title '" + std::string(law) + "' noenhanced\n$data << EOD\n";
      double last = -1;
      for (const ModelErrorEntry& entry : map) {
        if (entry.law != law || entry.film != film) continue;
        if (last >= 0 && entry.eccentricity_ratio != last) plot.script += '\n';
        last = entry.eccentricity_ratio;
        plot.script += fmt::format("{} {} {}\n", entry.eccentricity_ratio, degrees * entry.direction,
                                   std::clamp(entry.error, 0.01, 10.0));
      }
      plot.script += "EOD\nplot $data using 1:2:3 with image\n";
    }
    plot.script += "unset multiplot\n";
    const std::string name = "model-error-" + std::string(name_of(film));
    draw(plot, folder, name);
    files.push_back(name + ".svg");
    files.push_back(name + ".png");
  }
  return files;
}

}  // namespace lubjoint::reports
