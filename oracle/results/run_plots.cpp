#include "oracle/results/run_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lubjoint/film/film_state.hpp"
#include "oracle/plot/figure.hpp"
#include "oracle/plot/orbit.hpp"

namespace lubjoint::reports {

namespace {

/// A joint at an output time.
struct Look {
  double t;               ///< [s]
  PlotPoint place;        ///< e/c
  Vector2<double> force;  ///< on the journal [N]
  double film;            ///< [m]
};

/// A name for gnuplot, which reads _ and ^ as indices and ends a text at a quotation mark.
std::string plain(std::string name) {
  for (const char special : {'_', '^', '{', '}', '\'', '"', '\\', '@', '&', '~'}) {
    std::replace(name.begin(), name.end(), special, ' ');
  }
  return name;
}

std::string block(const std::string& name, const std::vector<Look>& looks,
                  const std::function<double(const Look&)>& value) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const Look& look : looks) text += fmt::format("{:.7g} {:.7g}\n", 1e3 * look.t, value(look));
  return text + "EOD\n";
}

std::string orbit_of(const std::vector<Look>& looks) {
  std::vector<PlotPoint> places;
  for (const Look& look : looks) places.push_back(look.place);
  return orbit_script(places, std::nullopt);
}

std::string force_of(const std::vector<Look>& looks) {
  return block("x", looks, [](const Look& l) { return l.force.x(); }) +
         block("y", looks, [](const Look& l) { return l.force.y(); }) +
         block("size", looks, [](const Look& l) { return l.force.norm(); }) +
         "plot $size with lines lw 5 lc rgb '#bbbbbb' title '|F|', $x with lines lw 1.3 lc rgb '#0072b2' title 'F_x', "
         "$y with lines lw 1.8 dt 2 lc rgb '#d55e00' title 'F_y'\n";
}

std::string film_of(const std::vector<Look>& looks) {
  // A film that is gone in contact has no place on a logarithmic axis, and leaves a gap.
  return block("data", looks, [](const Look& l) { return 1e6 * l.film; }) +
         "plot $data with lines lw 1.5 lc rgb '#0072b2' notitle\n";
}

std::vector<std::string> write(const Scene& scene, const std::vector<std::vector<Look>>& looks,
                               const std::filesystem::path& folder) {
  const std::string against_time = std::string(plain_axes) + "set xlabel 't [ms]'\nset autoscale\nset format y '%g'\n";
  const std::string name = plain(scene.name);
  Figure orbit{name + ": journal centre, e/c (" + orbit_words + ")", std::string(plain_axes) + orbit_axes, {}};
  Figure force{name + ": force on the journal",
               against_time + "set ylabel 'F [N]'\nset key outside center bottom horizontal samplen 2\n",
               {}};
  Figure film{name + ": film thickness", against_time + "set ylabel 'h_{min} [µm]'\nset logscale y\n", {}};
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    orbit.panels.push_back({plain(joint.name), orbit_of(looks[j])});
    force.panels.push_back({plain(joint.name), force_of(looks[j])});
    if (joint.film != no_film) film.panels.push_back({plain(joint.name), film_of(looks[j])});
  }
  std::vector<std::string> files;
  const auto sheet = [&](const Figure& figure, const char* what, int height) {
    const int count = static_cast<int>(figure.panels.size());
    if (count == 0) return;
    const int columns = std::min(count, 3);
    const int rows = (count + columns - 1) / columns;
    const std::string file = scene.name + "-" + what;
    draw(on_one_sheet(figure, rows, columns, columns == 1 ? 720 : 480 * columns, rows * height), folder, file);
    for (const char* extension : {".svg", ".png"}) files.push_back(file + extension);
  };
  sheet(orbit, "orbit", 520);
  sheet(force, "force", 400);
  sheet(film, "film", 400);
  return files;
}

}  // namespace

std::vector<std::string> write_run_plots(const Scene& scene, const JournalTrajectory& run,
                                         const std::filesystem::path& folder) {
  const double c = scene.joints.front().clearance;
  std::vector<Look> looks;
  for (const JournalSample& s : run.samples) {
    const double ratio = s.eccentricity_ratio();
    const double film = c * one_minus_squared_norm(s.state[0], s.state[1]) / (1 + ratio);  // c(1 − ε)
    looks.push_back({s.t, {s.state[0], s.state[1]}, s.force, film});
  }
  return write(scene, {looks}, folder);
}

std::vector<std::string> write_run_plots(const Scene& scene, const MultibodyTrajectory& run,
                                         const std::filesystem::path& folder) {
  std::vector<std::vector<Look>> looks(scene.joints.size());
  for (const MultibodySample& s : run.samples) {
    for (std::size_t j = 0; j < s.joints.size(); ++j) {
      const JointSample& joint = s.joints[j];
      const double c = scene.joints[j].clearance;
      looks[j].push_back(
          {s.t, {joint.eccentricity.x() / c, joint.eccentricity.y() / c}, joint.force, joint.film_thickness});
    }
  }
  return write(scene, looks, folder);
}

}  // namespace lubjoint::reports
