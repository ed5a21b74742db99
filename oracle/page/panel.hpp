/// gnuplot's drawings as parts of the page: lines and text take the page's colours, light or dark, and its width.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports::page {

struct Panel {
  std::string id;           ///< on the page, as in "figure-9a"
  std::string caption;      ///< under the drawing
  std::string description;  ///< what is to be seen, for those who do not see it
  Plot plot;
};

/// One <figure> a panel, one after the other.
/// @throws OutputError if gnuplot is missing or refuses a script
std::string draw_panels(const std::vector<Panel>& panels);

/// A document of gnuplot's SVG terminal as an inline drawing. Pure black, the palette of Okabe and Ito and the pale
/// grid become variables of the style sheet; ids get the panel's id in front, since those of a page are its own.
std::string inline_svg(const std::string& document, const Panel& panel);

}  // namespace lubjoint::reports::page
