#include "oracle/laws/model_error_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lubjoint/film/every_law.hpp"
#include "oracle/laws/median.hpp"
#include "oracle/laws/model_error.hpp"

namespace lubjoint::reports {

namespace {

/// What a row says of one law at one ε.
struct Errors {
  std::vector<double> all;
  std::array<double, 3> largest{};  ///< closing, sliding, opening

  void add(const ModelErrorEntry& entry) {
    all.push_back(entry.error);
    const double along = std::cos(entry.direction);
    double& worst = largest[along >= 0.5 - 1e-9 ? 0 : along <= -0.5 + 1e-9 ? 2 : 1];
    worst = std::max(worst, entry.error);
  }
};

/// Two digits, and none beyond the solver's bound of 1e-3.
std::string shown(double error) { return error < 0.01 ? fmt::format("{:.3f}", error) : fmt::format("{:.2g}", error); }

}  // namespace

std::string model_error_lookup() {
  constexpr std::array shapes = {0.125, 0.25, 0.5, 1.0, 0.04 / (2 * 0.0098), 4.0};
  ModelErrorGrid grid;
  grid.eccentricity_ratios = {0.1, 0.3, 0.5, 0.7, 0.9};
  std::string csv = "length_over_diameter,eccentricity_ratio,law,median,closing,sliding,opening\n";
  for (const double shape : shapes) {
    const auto map = model_error_map(Bearing<double>(2 * shape, 1, 1e-3), grid);
    for (const double epsilon : grid.eccentricity_ratios) {
      for (const std::string_view law : every_law_names) {
        Errors errors;
        for (const ModelErrorEntry& entry : map) {
          const bool meant = entry.film == oracle::FiniteFilm::finite_reynolds && entry.law == law;
          if (meant && entry.eccentricity_ratio == epsilon) errors.add(entry);
        }
        if (errors.all.empty()) continue;
        csv += fmt::format("{:.5g},{:g},{},{},{},{},{}\n", shape, epsilon, law, shown(median(errors.all)),
                           shown(errors.largest[0]), shown(errors.largest[1]), shown(errors.largest[2]));
      }
    }
  }
  return csv;
}

}  // namespace lubjoint::reports
