#include <fmt/format.h>

#include <cmath>

#include "oracle/files/files.hpp"
#include "oracle/paper/example_2.hpp"
#include "oracle/plot/orbit.hpp"
#include "oracle/results/angles.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/trajectory_csv.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"

namespace lubjoint::reports {

namespace {

/// One panel a parameter set; `script(item, place)` is what it plots.
template <class Script>
Figure figure_of(const Example2& example, const std::string& title, const std::string& axes, const Script& script) {
  Figure figure{title, plain_axes + axes, {}};
  for (std::size_t i = 0; i < example.cases.size(); ++i) {
    const SceneJoint& joint = example.cases[i].scene.joints[0];
    figure.panels.push_back(
        {fmt::format("c = {:g} mm, {:g} Pa s", 1e3 * joint.clearance, joint.viscosity), script(example.cases[i], i)});
  }
  return figure;
}

/// Rows "x y" of a data block. @param point  point(sample) gives x and y
template <class Point>
std::string block(const char* name, const std::vector<MultibodySample>& samples, const Point& point) {
  std::string data = fmt::format("${} << EOD\n", name);
  for (const MultibodySample& sample : samples) {
    const auto [x, y] = point(sample);
    data += fmt::format("{:.7g} {:.7g}\n", x, y);
  }
  return data + "EOD\n";
}

const std::string against_angle = "set xlabel 'crank angle φ [°]'\nset xrange [0:720]\nset xtics 90\n";
const std::string lubricated = "$data with lines lw 1.3 lc rgb '#0072b2' notitle";
// Broad and below: seen where the film's curve lies on it, too.
const std::string ideal_joint = "$ideal with lines lw 5 lc rgb '#e69f00' notitle";

// Above and thin.
const std::string of_real_film = "$real with lines lw 1.3 lc rgb '#009e73' notitle";

std::vector<PlotPoint> orbit_places(const Example2Case& item, const MultibodyTrajectory& run) {
  const double c = item.scene.joints[0].clearance;
  std::vector<PlotPoint> places;
  for (const MultibodySample& s : run.samples) {
    places.push_back({s.joints[0].eccentricity.x() / c, s.joints[0].eccentricity.y() / c});
  }
  return places;
}

}  // namespace

Figure slider_crank_figure(const Example2& example, SliderCrankQuantity quantity, double aspect,
                           const std::vector<const MultibodyTrajectory*>& real) {
  if (example.cases.empty()) return {};
  const double speed = crank_speed_of(example.cases.front().scene);
  const auto mechanism = slider_crank_of(example.cases.front().scene);
  const auto angle = [&](const MultibodySample& s) { return degrees * speed * s.t; };
  const auto closed = [&](const MultibodySample& s) {
    return mechanisms::ideal_reactions<double>(mechanism, {speed * s.t, speed, 0});
  };
  const auto curve = [&](const char* name, const std::vector<MultibodySample>& samples, const auto& value) {
    return block(name, samples, [&](const auto& s) { return std::pair(angle(s), value(s)); });
  };
  /// Data of a case by value(sample), with the other film's, then the plot: first, both curves, last.
  const auto both = [&](const Example2Case& item, std::size_t place, const auto& value, const std::string& before,
                        const std::string& after) {
    std::string script = curve("data", item.run.samples, value);
    if (!real.empty()) script += curve("real", real[place]->samples, value);
    return script + "plot " + before + lubricated + (real.empty() ? "" : ", " + of_real_film) + after + "\n";
  };
  const auto against_ideal = [&](const Example2Case& item, std::size_t place, const auto& ideal, const auto& value) {
    return curve("ideal", example.ideal.samples, ideal) + both(item, place, value, ideal_joint + ", ", "");
  };
  switch (quantity) {
    case SliderCrankQuantity::force:
      return figure_of(example, "Force in the gudgeon pin (broad: ideal joint)",
                       against_angle + "set ylabel '|F| [kN]'\n", [&](const Example2Case& item, std::size_t place) {
                         return against_ideal(
                             item, place, [&](const auto& s) { return closed(s).gudgeon_pin.norm() / 1e3; },
                             [](const auto& s) { return s.joints[0].force.norm() / 1e3; });
                       });
    case SliderCrankQuantity::moment:
      return figure_of(example, "Driving moment on the crank (broad: ideal joint)",
                       against_angle + "set ylabel 'M [N·m]'\n", [&](const Example2Case& item, std::size_t place) {
                         return against_ideal(
                             item, place, [&](const auto& s) { return closed(s).driving_moment; },
                             [](const auto& s) { return s.driving_moments[0]; });
                       });
    case SliderCrankQuantity::orbit:
      return figure_of(example, std::string("Journal centre, e/c (") + orbit_words + ")", orbit_axes,
                       [&](const Example2Case& item, std::size_t place) {
                         std::vector<PlotPoint> other;
                         if (!real.empty()) other = orbit_places(item, *real[place]);
                         return orbit_script(orbit_places(item, item.run), std::nullopt, aspect, other);
                       });
    case SliderCrankQuantity::film:
      break;
  }
  return figure_of(example, "Film thickness (dashed: safe film, 3 µm)",
                   against_angle + "set ylabel 'h_{min} [µm]'\nset logscale y\nset format y '%g'\n",
                   [&](const Example2Case& item, std::size_t place) {
                     return both(
                         item, place, [](const auto& s) { return 1e6 * s.joints[0].film_thickness; }, "",
                         ", 3 with lines lw 1.2 dt 2 lc rgb '#d55e00' notitle");
                   });
}

std::vector<std::string> write_example_2(const Example2& example, const std::filesystem::path& folder) {
  prepare_folder(folder);
  std::vector<std::string> files;
  for (const Example2Case& item : example.cases) {
    files.push_back(item.scene.name + ".csv");
    write_file(folder / files.back(), trajectory_csv(item.scene, item.run));
  }
  files.push_back("slider-crank-summary.csv");
  write_file(folder / files.back(), example_2_csv(example));
  files.push_back("slider-crank-checks.csv");
  write_file(folder / files.back(), example_2_checks_csv(example));
  if (example.cases.empty()) return files;
  const auto sheet = [&](SliderCrankQuantity quantity, const char* name) {
    draw(on_one_sheet(slider_crank_figure(example, quantity), 2, 3, 1400, 800), folder, name);
    for (const char* extension : {".svg", ".png"}) files.push_back(std::string(name) + extension);
  };
  sheet(SliderCrankQuantity::force, "slider-crank-force");
  sheet(SliderCrankQuantity::moment, "slider-crank-moment");
  sheet(SliderCrankQuantity::orbit, "slider-crank-orbit");
  sheet(SliderCrankQuantity::film, "slider-crank-film");
  return files;
}

}  // namespace lubjoint::reports
