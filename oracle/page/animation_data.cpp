// The runs of the animation. For each: name, law, words on the pressure, clearance [m], end [s], frames, and for each
// frame, in base64 of little-endian numbers:
//   eccentricity  int16 x, y: e/c times 32767
//   attitude      int16: angle of e from the x axis over π, times 32767
//   film          float32: least film thickness [m]
//   force         float32 x, y [N]
//   peak          float32: largest |p| [Pa]
//   pressure      int8, `nodes` of them: p/peak times 127 at ψ = 0°, 360°/nodes, … of Sommerfeld's angle, which gathers
//                 nodes where the film is thin: tan(θ/2) = √((1 + ε)/(1 − ε)) tan(ψ/2); for short bearings in the
//                 middle of the length
//   mechanism     float32 crank angle, rod angle [rad], slider [m]; only of the slider-crank
#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/film/law_facts.hpp"
#include "lubjoint/joint/kinematics.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/page/packed_numbers.hpp"
#include "oracle/page/sections.hpp"
#include "oracle/reynolds/film_integral.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"

namespace lubjoint::reports::page {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t nodes = 72;
constexpr double node_step = boost::math::constants::two_pi<double>() / nodes;

/// The film whose pressure is drawn for a law: Pinkus–Sternlicht has none and gets the one that it approximates.
oracle::OneDimensionalFilm drawn_film(const std::string& law) {
  return oracle::one_dimensional_film(law_facts(law).has_pressure ? law : "long_dynamic");
}

std::string pressure_words(const std::string& law) {
  if (!law_facts(law).has_pressure) {
    return "Pinkus and Sternlicht’s force is the integral of no pressure. Drawn is the pressure of the long dynamic "
           "film at the same state, which the law approximates; the arrow is the law’s own force.";
  }
  const bool is_short = law_facts(law).is_short();
  return std::string("The pressure is the one that the law integrates") +
         (is_short ? ", in the middle of the bearing’s length." : ", the same all along the bearing.");
}

/// Collects the frames of a run.
class Frames {
 public:
  Frames(const SceneJoint& joint, const std::string& law)
      : film_(drawn_film(law)), bearing_(joint.length, joint.journal_radius, joint.clearance), oil_(joint.viscosity) {}

  void add(const FilmState<double>& state, const Vector2<double>& force) {
    ++count_;
    const double x = state.eccentricity.x();
    const double y = state.eccentricity.y();
    eccentricity_.int16(32767 * x);
    eccentricity_.int16(32767 * y);
    film_thickness_.float32(bearing_.clearance() * state.q / (1 + std::hypot(x, y)));  // 1 − ε without cancellation
    force_.float32(force.x());
    force_.float32(force.y());
    std::array<double, nodes> pressure{};
    double peak = 0;
    double attitude = std::atan2(y, x);
    if (!is_zero(state.velocity)) {
      const PolarView<double> view = polar_view(state);
      attitude = std::atan2(view.radial.y(), view.radial.x());
      for (std::size_t i = 0; i < nodes; ++i) pressure[i] = pressure_at(view.state, node_step * static_cast<double>(i));
      peak = largest_pressure(view.state, pressure);
    }
    attitude_.int16(32767 / boost::math::constants::pi<double>() * attitude);
    peak_.float32(peak);
    for (const double p : pressure) pressure_.int8(peak > 0 ? 127 * p / peak : 0);
  }

  Json json(const std::string& name, const std::string& law, double end) const {
    return {{"name", name},
            {"law", law},
            {"words", pressure_words(law)},
            {"clearance", bearing_.clearance()},
            {"end", end},
            {"frames", count_},
            {"eccentricity", eccentricity_.base64()},
            {"attitude", attitude_.base64()},
            {"film", film_thickness_.base64()},
            {"force", force_.base64()},
            {"peak", peak_.base64()},
            {"pressure", pressure_.base64()}};
  }

 private:
  /// At Sommerfeld's angle ψ, 0 to 2π.
  double pressure_at(const PolarFilmState<double>& state, double psi) const {
    const double stretch = (1 + state.eccentricity_ratio) / std::sqrt(state.q);
    double theta = 2 * std::atan2(stretch * std::sin(psi / 2), std::cos(psi / 2));
    if (theta < 0) theta += boost::math::constants::two_pi<double>();
    return oracle::film_pressure_by_quadrature(film_, bearing_, oil_, state, theta).value;
  }

  /// Between the nodes beside the largest.
  double largest_pressure(const PolarFilmState<double>& state, const std::array<double, nodes>& pressure) const {
    const auto larger = [](double p, double q) { return std::abs(p) < std::abs(q); };
    const auto at = std::max_element(pressure.begin(), pressure.end(), larger);
    const double psi = node_step * static_cast<double>(at - pressure.begin());
    const double first = std::max(psi - node_step, 0.0);
    const double last = std::min(psi + node_step, boost::math::constants::two_pi<double>());
    const auto found = boost::math::tools::brent_find_minima(
        [&](double angle) { return -std::abs(pressure_at(state, angle)); }, first, last, 12);
    return std::max(std::abs(*at), -found.second);
  }

  oracle::OneDimensionalFilm film_;
  Bearing<double> bearing_;
  Lubricant<double> oil_;
  std::size_t count_ = 0;
  PackedNumbers eccentricity_, attitude_, film_thickness_, force_, peak_, pressure_;
};

Json journal_run(const Example1Law& item) {
  const JournalDrive<double> drive = journal_scene(item.scene).drive;
  const double spin = drive.mean_spin();
  Frames frames(item.scene.joints.front(), item.law);
  const auto& samples = item.run.samples;
  const std::size_t stride = stride_for(samples.size(), 500);
  double end = 0;
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    const auto& y = samples[i].state;
    frames.add(FilmState<double>(Vector2<double>(y[0], y[1]), Vector2<double>(y[2] + spin * y[1], y[3] - spin * y[0])),
               samples[i].force);
    end = samples[i].t;
  }
  Json run = frames.json("Journal under a load, " + law_words(item.law), item.law, end);
  run["load"] = {drive.load.x(), drive.load.y()};
  run["journal_spin"] = drive.journal_spin;
  return run;
}

std::size_t body_named(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const SceneBody& body) { return body.name == name; });
  if (found == scene.bodies.end()) throw std::invalid_argument(scene.name + " has no body " + name);
  return static_cast<std::size_t>(found - scene.bodies.begin());
}

Json slider_crank_run(const Example2Case& item) {
  const SceneJoint& joint = item.scene.joints.front();
  const std::size_t crank = body_named(item.scene, "crank");
  const std::size_t rod = body_named(item.scene, "rod");
  const std::size_t slider = body_named(item.scene, "slider");
  Frames frames(joint, joint.film);
  PackedNumbers mechanism;
  const auto& samples = item.run.samples;
  const std::size_t stride = stride_for(samples.size(), 720);
  double end = 0;
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    const std::vector<double>& state = samples[i].state;
    const auto kinematics = joint_kinematics(motion_in(state, joint.bearing.body), joint.bearing.point,
                                             motion_in(state, joint.journal.body), joint.journal.point);
    frames.add(film_state(kinematics.motion, joint.clearance), samples[i].joints.front().force);
    mechanism.float32(state[3 * crank + 2]);
    mechanism.float32(state[3 * rod + 2]);
    mechanism.float32(state[3 * slider]);
    end = samples[i].t;
  }
  const std::string viscosity = nlohmann::json(joint.viscosity).dump();
  const std::string clearance = nlohmann::json(std::round(1e7 * joint.clearance) / 1e4).dump();
  Json run = frames.json("Slider-crank, c = " + clearance + " mm, μ = " + viscosity + " Pa·s", joint.film, end);
  const auto lengths = slider_crank_of(item.scene);
  run["crank_length"] = lengths.crank_length;
  run["rod_length"] = lengths.rod_length;
  run["mechanism"] = mechanism.base64();
  return run;
}

}  // namespace

std::string animation_json(const Example1& journal, const Example2& slider_crank) {
  Json runs = Json::array();
  for (const Example1Law& item : journal.laws) {
    if (!item.run.samples.empty()) runs.push_back(journal_run(item));
  }
  for (const Example2Case& item : slider_crank.cases) {
    if (!item.run.samples.empty()) runs.push_back(slider_crank_run(item));
  }
  return Json{{"nodes", nodes}, {"runs", std::move(runs)}}.dump();
}

Section motion_section(const Content& content) {
  return {"motion", "The journal in its film",
          filled("motion.html",
                 {{"player", filled("player.html", {{"name", "motion"}})},
                  {"data", json_block("motion-data", animation_json(content.journal, content.slider_crank))}})};
}

}  // namespace lubjoint::reports::page
