/// Figures of several panels with the same axes: drawn on one sheet, or each panel by itself.
#pragma once

#include <string>
#include <vector>

#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports {

struct FigurePanel {
  std::string subject;  ///< the law or the parameter set that it shows
  std::string script;   ///< data blocks and plot command
};

struct Figure {
  std::string title;
  std::string axes;  ///< gnuplot settings of all panels
  std::vector<FigurePanel> panels;
};

/// All panels in rows, each under its subject. @param width, height  of the sheet [px]
Plot on_one_sheet(const Figure& figure, int rows, int columns, int width, int height);

/// One panel without a title, for pages that set titles themselves.
Plot alone(const Figure& figure, const FigurePanel& panel, int width, int height);

/// What all figures have in common: thin borders and a pale grid.
extern const char* const plain_axes;

}  // namespace lubjoint::reports
