#include "oracle/trajectories/multibody_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/files/files.hpp"
#include "oracle/trajectories/disagreement.hpp"
#include "oracle/trajectories/extended_run.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"
#include "oracle/trajectories/trajectory_columns.hpp"

namespace lubjoint::reports {

namespace {

using Values = TrajectoryValues<double>;

std::vector<double> row_of(const Scene& scene, const MultibodySample& sample) {
  std::vector<double> row;
  for (std::size_t j = 0; j < sample.joints.size(); ++j) {
    const Vector2<double> ratio = sample.joints[j].eccentricity / scene.joints[j].clearance;
    row.insert(row.end(), {ratio.x(), ratio.y(), sample.joints[j].force.x(), sample.joints[j].force.y()});
  }
  if (sample.joints.empty()) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      row.insert(row.end(), {sample.state[3 * b], sample.state[3 * b + 1]});
    }
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) row.push_back(sample.state[3 * b + 2]);
  }
  row.insert(row.end(), sample.driving_moments.begin(), sample.driving_moments.end());
  return row;
}

constexpr int outputs = 100;

/// Of a step: what rounding to 64 bits leaves of it is of the same size.
constexpr double tolerance = 1e-17;

/// Into so many pieces each output interval is cut for Fehlberg's pair, a step at most a piece: its estimate sees
/// little of the kink of a Pinkus–Sternlicht film at ε̇ = 0. Radau's sees it.
constexpr int fehlberg_pieces = 1000;

double interval_of(const Scene& scene) { return scene.run.duration / outputs; }

/// Rows at the output times, of a run with so many samples between.
Values rows_of(const Scene& scene, const std::vector<MultibodySample>& samples, std::size_t pieces) {
  Values rows;
  for (std::size_t i = 1; i <= outputs; ++i) rows.push_back(row_of(scene, samples.at(i * pieces)));
  return rows;
}

Values fehlberg_rows(const Scene& scene) {
  const int pieces =
      scene.joints.empty() ? 1 : fehlberg_pieces;  // ideal joints have no kink, and short steps round more
  const ExtendedRun run =
      extended_multibody_run(scene, interval_of(scene) / pieces, ExtendedMethod::fehlberg, tolerance);
  return rows_of(scene, run.samples, static_cast<std::size_t>(pieces));
}

/// @param times  the outputs, the first 0
Values minimal_rows(const Scene& scene, const std::vector<double>& times, const std::vector<long double>& start) {
  std::vector<double> stops;
  for (std::size_t i = 0; i < outputs; ++i) {
    for (int piece = 0; piece < fehlberg_pieces; ++piece) {
      stops.push_back(times[i] + (times[i + 1] - times[i]) * piece / fehlberg_pieces);
    }
  }
  stops.push_back(times.back());
  const std::vector<ReferenceSample> samples = minimal_coordinates_run(scene, stops, tolerance, start);
  Values rows;
  for (std::size_t i = 1; i <= outputs; ++i) {
    const ReferenceSample& sample = samples[i * fehlberg_pieces];
    rows.push_back({sample.eccentricity_ratio.x(), sample.eccentricity_ratio.y(), sample.force.x(), sample.force.y(),
                    sample.driving_moment});
  }
  return rows;
}

bool is_ideal_slider_crank(const Scene& scene) {
  if (!scene.joints.empty()) return false;
  try {
    slider_crank_of(scene);
    return crank_speed_of(scene) > 0;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// The driven crank turns by θ = Ωt, and everything else is a function of θ.
std::vector<double> closed_form(const Scene& scene, double t) {
  using R = long double;
  const auto m = mechanism_of<R>(scene);
  const R speed(crank_speed_of(scene));
  const mechanisms::Motion<R> crank{speed * R(t), speed, R(0)};
  const auto ideal = mechanisms::ideal_motion<R>(m, crank);
  const R cosine = m.crank_length * std::cos(crank.value);
  const R sine = m.crank_length * std::sin(crank.value);
  const R half = m.rod_length / 2;
  std::vector<R> row;
  for (const SceneBody& body : scene.bodies) {
    if (body.name == "crank") row.insert(row.end(), {cosine / 2, sine / 2});
    if (body.name == "rod") {
      row.insert(row.end(), {cosine + half * std::cos(ideal.rod.value), sine + half * std::sin(ideal.rod.value)});
    }
    if (body.name == "slider") row.insert(row.end(), {ideal.slider.value, R(0)});
  }
  for (const SceneBody& body : scene.bodies) {
    row.push_back(body.name == "crank" ? crank.value : body.name == "rod" ? ideal.rod.value : R(0));
  }
  row.push_back(mechanisms::ideal_reactions<R>(m, crank).driving_moment);
  return {row.begin(), row.end()};
}

/// To the 16th digit of the size given: digits below that are noise of the integration.
std::string rounded(double value, double size) {
  if (value == 0) return "0";
  const auto decade = [](double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); };
  const int digits = 16 + decade(value) - decade(size);
  return digits < 1 ? "0" : fmt::format("{:.{}e}", value, std::min(digits, 16) - 1);
}

}  // namespace

ReferenceCsv multibody_reference(const Scene& scene) {
  const ExtendedRun run = extended_multibody_run(scene, interval_of(scene), ExtendedMethod::radau, tolerance);
  std::vector<double> times;
  for (const MultibodySample& sample : run.samples) times.push_back(sample.t);
  const Values radau = rows_of(scene, run.samples, 1);
  Values printed;
  std::vector<Values> others;
  if (has_minimal_coordinates(scene)) {
    printed = minimal_rows(scene, times, run.start);
    others = {radau};
  } else if (is_ideal_slider_crank(scene)) {
    for (std::size_t i = 1; i <= outputs; ++i) printed.push_back(closed_form(scene, times[i]));
    others = {radau, fehlberg_rows(scene)};
  } else {
    printed = radau;
    others = {fehlberg_rows(scene)};
  }
  const TrajectoryColumns columns = multibody_columns(scene);
  std::vector<double> apart(printed.size(), 0.0);
  for (const Values& other : others) {
    const std::vector<double> each = disagreements(printed, other, columns.vectors);
    for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = std::max(apart[i], each[i]);
  }
  const std::vector<double> sizes = largest_sizes(printed, columns.vectors);
  std::string csv = "t";
  for (const std::string& name : columns.names) csv += "," + name;
  csv += ",disagreement\n";
  for (std::size_t i = 0; i < printed.size(); ++i) {
    csv += number(times[i + 1]);
    std::size_t k = 0;
    for (std::size_t v = 0; v < columns.vectors.size(); ++v) {
      for (const std::size_t end = k + columns.vectors[v]; k < end; ++k) csv += "," + rounded(printed[i][k], sizes[v]);
    }
    csv += fmt::format(",{:.0e}\n", apart[i]);
  }
  return {csv, agreed_digits(apart)};
}

}  // namespace lubjoint::reports
