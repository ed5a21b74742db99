/// Plots by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// A gnuplot script without its terminal and output lines, and the size of the picture.
struct Plot {
  std::string script;
  int width = 1200;  ///< [px]
  int height = 700;
};

/// Draws a plot as NAME.svg and NAME.png in a folder; both, or neither.
/// @throws OutputError if gnuplot is missing or refuses the script, with what it said
void draw(const Plot& plot, const std::filesystem::path& folder, const std::string& name);

/// The plots as SVG documents, in their order, without a background.
/// @throws OutputError as above
std::vector<std::string> svg_of(const std::vector<Plot>& plots);

}  // namespace lubjoint::reports
