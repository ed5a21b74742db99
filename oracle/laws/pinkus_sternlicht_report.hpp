/// The Pinkus–Sternlicht law's difference from the long dynamic film: CSV, summary, picture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oracle/laws/pinkus_sternlicht_difference.hpp"

namespace lubjoint::reports {

/// Medians and maxima over directions of motion at one ε, for b > 0 and b < 0.
struct DifferenceByRatio {
  double eccentricity_ratio;
  DifferenceSummary closing;
  DifferenceSummary opening;
};

std::vector<DifferenceByRatio> by_ratio(const std::vector<PinkusSternlichtDifference>& differences);

std::string difference_csv(const std::vector<DifferenceByRatio>& rows);
std::string difference_text(const std::vector<PinkusSternlichtDifference>& differences);
/// NAME.svg and NAME.png in a folder.
void draw_difference(const std::vector<DifferenceByRatio>& rows, const std::filesystem::path& folder,
                     const std::string& name);

}  // namespace lubjoint::reports
