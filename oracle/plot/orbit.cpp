#include "oracle/plot/orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lubjoint::reports {

const char* const orbit_axes =
    "set size ratio -1\nset xlabel 'e_x/c [-]'\nset ylabel 'e_y/c [-]'\n"
    "set parametric\nset trange [0:2*pi]\nset samples 241\n";

const char* const orbit_words = "small: the clearance circle, with the part that is drawn";

namespace {

/// Round, and about a quarter of a window's height: five labels at most find room beside each other.
double tick_step(double half) {
  const double raw = half / 2;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace

OrbitWindow orbit_window(const std::vector<PlotPoint>& places, double aspect) {
  constexpr double room = 1.12;         // around the orbit
  constexpr double inset_share = 0.17;  // of the smaller half, the inset's radius
  constexpr double whole_from = 0.75;   // clearances: a part of this half height is no part any more
  constexpr double smallest = 1e-3;     // clearances, of an orbit that hardly moves
  OrbitWindow whole;
  double farthest_place = 1;  // beyond the circle in contact
  for (const PlotPoint& p : places) farthest_place = std::max(farthest_place, std::hypot(p[0], p[1]));
  whole.half_height *= farthest_place;
  whole.half_width = whole.half_height * std::max(1.0, aspect);
  if (places.empty()) return whole;
  PlotPoint low = places.front();
  PlotPoint high = low;
  for (const PlotPoint& p : places) {
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  OrbitWindow window;
  window.centre = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
  double half = room * std::max({(high[1] - low[1]) / 2, (high[0] - low[0]) / 2 / aspect, smallest});
  // As wide as it must be for a corner to be free for the inset.
  for (; half < whole_from; half *= 1.03) {
    const double radius = inset_share * half;
    double farthest = 0;
    for (const double sx : {1.0, -1.0}) {
      for (const double sy : {1.0, -1.0}) {
        const PlotPoint corner{window.centre[0] + sx * (half * aspect - 1.2 * radius),
                               window.centre[1] + sy * (half - 1.2 * radius)};
        double nearest = std::numeric_limits<double>::infinity();
        for (const PlotPoint& p : places) nearest = std::min(nearest, std::hypot(p[0] - corner[0], p[1] - corner[1]));
        if (nearest <= farthest) continue;
        farthest = nearest;
        window.inset = corner;
      }
    }
    if (farthest < 1.15 * radius) continue;
    window.half_height = half;
    window.half_width = half * aspect;
    window.has_inset = true;
    window.inset_radius = radius;
    return window;
  }
  return whole;
}

std::string orbit_script(const std::vector<PlotPoint>& places, const std::optional<PlotPoint>& rest, double aspect,
                         const std::vector<PlotPoint>& other) {
  std::vector<PlotPoint> all = places;
  all.insert(all.end(), other.begin(), other.end());
  const OrbitWindow w = orbit_window(all, aspect);
  const auto block = [](const char* name, const std::vector<PlotPoint>& points) {
    std::string data = fmt::format("${} << EOD\n", name);
    for (const PlotPoint& p : points) data += fmt::format("{:.7g} {:.7g}\n", p[0], p[1]);
    return data + "EOD\n";
  };
  std::string script = block("data", places);
  if (!other.empty()) script += block("other", other);
  const auto [x, y] = w.centre;
  script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", x - w.half_width, x + w.half_width,
                        y - w.half_height, y + w.half_height);
  script += fmt::format("set xtics {0:.3g}\nset ytics {0:.3g}\n", tick_step(w.half_height));
  script += rest ? fmt::format("set label 1 at {},{} point pt 1 ps 1 lc rgb '#d55e00'\n", (*rest)[0], (*rest)[1])
                 : std::string("unset label\n");
  std::string plot =
      "plot cos(t),sin(t) with lines lw 1 lc rgb '#555555' notitle, "
      "$data with lines lw 1.5 lc rgb '#0072b2' notitle";
  if (!other.empty()) plot += ", $other with lines lw 1.3 lc rgb '#009e73' notitle";
  if (w.has_inset) {
    const auto small = [&](double px, double py) {
      return fmt::format("{:.6g} {:.6g}\n", w.inset[0] + w.inset_radius * px, w.inset[1] + w.inset_radius * py);
    };
    script += "$part << EOD\n";
    for (const auto& [sx, sy] :
         {PlotPoint{-1, -1}, PlotPoint{1, -1}, PlotPoint{1, 1}, PlotPoint{-1, 1}, PlotPoint{-1, -1}}) {
      script += small(x + sx * w.half_width, y + sy * w.half_height);
    }
    script += "EOD\n";
    const std::string at = fmt::format("({:.6g}+{:.6g}*", w.inset[0], w.inset_radius);
    const std::string up = fmt::format("({:.6g}+{:.6g}*", w.inset[1], w.inset_radius);
    plot += fmt::format(
        ", {0}cos(t)),{1}sin(t)) with lines lw 1 lc rgb '#555555' notitle, $data every {2} using {0}$1):{1}$2) with "
        "lines lw 0.7 lc rgb '#0072b2' notitle, $part with lines lw 1 lc rgb '#d55e00' notitle",
        at, up, 1 + places.size() / 200);  // so small that no more points show
  }
  return script + plot + "\n";
}

}  // namespace lubjoint::reports
