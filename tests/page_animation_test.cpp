// The runs of the animation: what is drawn is what was computed.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/joint/kinematics.hpp"
#include "oracle/page/sections.hpp"
#include "support/packed_numbers.hpp"
#include "support/page_content.hpp"

namespace page_animation_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Json = nlohmann::json;

namespace {

const Json& animation() {
  static const Json data =
      Json::parse(reports::page::animation_json(quick_page_content().journal, quick_page_content().slider_crank));
  return data;
}

struct Frames {
  std::vector<std::int16_t> eccentricity;
  std::vector<std::int16_t> attitude;
  std::vector<float> film;
  std::vector<float> force;
  std::vector<float> peak;
  std::vector<std::int8_t> pressure;
};

Frames frames_of(const Json& run) {
  return {numbers<std::int16_t>(run["eccentricity"]),
          numbers<std::int16_t>(run["attitude"]),
          numbers<float>(run["film"]),
          numbers<float>(run["force"]),
          numbers<float>(run["peak"]),
          numbers<std::int8_t>(run["pressure"])};
}

}  // namespace

TEST_CASE("animation: every run is there, with its frames, places and forces") {
  const Json& runs = animation()["runs"];
  const auto& content = quick_page_content();
  REQUIRE(runs.size() == content.journal.laws.size() + content.slider_crank.cases.size());
  for (std::size_t r = 0; r < content.journal.laws.size(); ++r) {
    const auto& samples = content.journal.laws[r].run.samples;
    const Frames frames = frames_of(runs[r]);
    INFO(runs[r]["name"]);
    REQUIRE(runs[r]["frames"] == samples.size());
    CHECK(frames.pressure.size() == samples.size() * animation()["nodes"].get<std::size_t>());
    bool same = true;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        same = same && std::abs(frames.eccentricity[2 * i + k] / 32767.0 - samples[i].state[k]) <= 0.5 / 32767;
      }
      const double thinnest = 1 - samples[i].eccentricity_ratio();
      same =
          same && std::abs(frames.film[i] / 2e-4 - thinnest) <= 1e-6 * thinnest;  // single precision, and that of 1 − ε
      const double tolerance = 1e-7 * samples[i].force.norm();                    // single precision
      same = same && std::abs(frames.force[2 * i] - samples[i].force.x()) <= tolerance;
      same = same && std::abs(frames.force[2 * i + 1] - samples[i].force.y()) <= tolerance;
    }
    CHECK(same);
  }
  for (std::size_t r = content.journal.laws.size(); r < runs.size(); ++r) {
    const auto& item = content.slider_crank.cases[r - content.journal.laws.size()];
    const auto mechanism = numbers<float>(runs[r]["mechanism"]);
    REQUIRE(mechanism.size() == 3 * item.run.samples.size());
    const auto& last = item.run.samples.back().state;
    CHECK(mechanism[mechanism.size() - 3] == static_cast<float>(last[2]));  // crank's angle
    CHECK(mechanism[mechanism.size() - 1] == static_cast<float>(last[6]));  // slider's place
  }
}

namespace {

/// Force of the film whose pressure is drawn for Pinkus–Sternlicht, at a sample of the slider-crank.
Vector2<double> long_dynamic_force(const Scene& scene, const std::vector<double>& state) {
  const SceneJoint& joint = scene.joints.front();
  const auto motion = [&](std::size_t body) {
    const double* q = &state[3 * body];
    const double* v = q + state.size() / 2;
    return PlanarMotion<double>{{q[0], q[1]}, q[2], {v[0], v[1]}, v[2]};
  };
  const auto kinematics = joint_kinematics(motion(joint.bearing.body), joint.bearing.point, motion(joint.journal.body),
                                           joint.journal.point);
  return film_force<LongDynamic>(Bearing<double>(joint.length, joint.journal_radius, joint.clearance),
                                 Lubricant<double>(joint.viscosity), film_state(kinematics.motion, joint.clearance));
}

/// The same at a sample of the journal.
Vector2<double> long_dynamic_force(const Scene& scene, const JournalState<double>& y) {
  const JournalScene parts = journal_scene(scene);
  const double spin = parts.drive.mean_spin();
  const FilmState<double> film(Vector2<double>(y[0], y[1]), Vector2<double>(y[2] + spin * y[1], y[3] - spin * y[0]));
  return film_force<LongDynamic>(parts.bearing, parts.oil, film);
}

}  // namespace

TEST_CASE("animation: the pressure that is drawn pushes the journal with the force of its film") {
  const std::size_t nodes = animation()["nodes"];
  const double step = 2 * M_PI / static_cast<double>(nodes);
  const auto& content = quick_page_content();
  const SceneJoint& joint = content.journal.laws.front().scene.joints.front();
  const Json& runs = animation()["runs"];
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Json& run = runs[r];
    const std::string law = run["law"];
    INFO(run["name"]);
    const Frames frames = frames_of(run);
    const double clearance = run["clearance"];
    const double radius = run.contains("load") ? joint.journal_radius : 0.01 - clearance;
    const double area = radius * joint.length * (law.starts_with("short") ? 2.0 / 3 : 1.0);  // short: a parabola along
    double worst = 0;
    // While a half film slides on its jump its force is between those of both sides: no pressure drawn has it.
    const auto slides = [&](std::size_t i) {
      if (r >= content.journal.laws.size()) return false;
      const JournalTrajectory& trajectory = content.journal.laws[r].run;
      const double t = trajectory.samples[i].t;
      return std::any_of(trajectory.sliding.begin(), trajectory.sliding.end(),
                         [t](const SlidingInterval& s) { return s.start <= t && t <= s.end; });
    };
    for (std::size_t i = 1; i < run["frames"].get<std::size_t>(); ++i) {
      if (slides(i)) continue;
      const double thinnest = frames.film[i] / clearance;  // 1 − ε
      const double ratio = 1 - thinnest;
      double fx = 0;
      double fy = 0;
      for (std::size_t k = 0; k < nodes; ++k) {
        const double psi = step * static_cast<double>(k);
        const double theta = 2 * std::atan2(std::sqrt((1 + ratio) / thinnest) * std::sin(psi / 2), std::cos(psi / 2));
        const double width = step * std::sqrt(thinnest * (1 + ratio)) / (1 - ratio * std::cos(psi));  // dθ
        const double where = M_PI * frames.attitude[i] / 32767 + M_PI + theta;
        const double p = frames.peak[i] * frames.pressure[nodes * i + k] / 127.0;
        fx -= area * p * std::cos(where) * width;
        fy -= area * p * std::sin(where) * width;
      }
      Vector2<double> expected(frames.force[2 * i], frames.force[2 * i + 1]);
      if (law == "pinkus_sternlicht" && r < content.journal.laws.size()) {
        const auto& item = content.journal.laws[r];
        expected = long_dynamic_force(item.scene, item.run.samples[i].state);
      } else if (law == "pinkus_sternlicht") {
        const auto& item = content.slider_crank.cases[r - content.journal.laws.size()];
        expected = long_dynamic_force(item.scene, item.run.samples[i].state);
      }
      worst = std::max(worst, (Vector2<double>(fx, fy) - expected).norm() / expected.norm());
    }
    // Half of 1/127 of the peak at each node; half films end at a node where their pressure jumps, by half a step of
    // 5°.
    CHECK(worst < (law.find("half") != std::string::npos ? 0.06 : 0.03));
    CHECK(worst > 0);
  }
}

}  // namespace page_animation_test
