/// The path of a journal's centre in its clearance circle, drawn as large as it fits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lubjoint::reports {

using PlotPoint = std::array<double, 2>;  ///< x, y

/// What part of the plane an orbit's panel shows, and where its inset stands: the whole clearance circle in small, with
/// that part marked.
struct OrbitWindow {
  PlotPoint centre{0, 0};
  double half_width = 1.05;
  double half_height = 1.05;
  bool has_inset = false;  ///< not where the whole circle is shown
  PlotPoint inset{0, 0};   ///< its centre
  double inset_radius = 0;
};

/// @param places  of the centre, in clearances
/// @param aspect  width over height of the panel's inner part
OrbitWindow orbit_window(const std::vector<PlotPoint>& places, double aspect = 1);

/// Script of a panel: the orbit, the clearance circle where it is in sight, the inset, a cross at the point of rest.
/// @param other  places of another orbit, drawn green, or none
std::string orbit_script(const std::vector<PlotPoint>& places, const std::optional<PlotPoint>& rest, double aspect = 1,
                         const std::vector<PlotPoint>& other = {});

/// Axes of such panels.
extern const char* const orbit_axes;

/// What a caption says of them.
extern const char* const orbit_words;

}  // namespace lubjoint::reports
