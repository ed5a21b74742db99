#include "oracle/plot/figure.hpp"

#include <fmt/format.h>

namespace lubjoint::reports {

const char* const plain_axes = "set border lw 0.5\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\n";

Plot on_one_sheet(const Figure& figure, int rows, int columns, int width, int height) {
  std::string script = fmt::format("set multiplot layout {},{} title '{}'\n", rows, columns, figure.title);
  script += figure.axes;
  for (const FigurePanel& panel : figure.panels) {
    script += fmt::format("set title '{}'\n", panel.subject) + panel.script;
  }
  return {script + "unset multiplot\n", width, height};
}

Plot alone(const Figure& figure, const FigurePanel& panel, int width, int height) {
  // Narrow margins: a page sets its titles itself.
  return {"set bmargin 3.2\nset tmargin 0.8\nset rmargin 3\n" + figure.axes + panel.script, width, height};
}

}  // namespace lubjoint::reports
