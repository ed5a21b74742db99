// Loads from tables over a body's angle, and drivers along a guide: their exact Jacobian, and the integrators' orders
// across knots that a body meets from either side.
#include <array>
#include <boost/math/constants/constants.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>

#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "support/embedded_scene.hpp"
#include "support/scenes.hpp"

namespace table_angle_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

constexpr double revolution = 2 * std::numbers::pi;

/// Straight lines between the rows of (angle, fx, fy, moment).
std::shared_ptr<const TableCurves<3>> lines_between(const std::vector<std::array<double, 4>>& rows) {
  std::vector<double> knots;
  std::vector<std::array<TableCurves<3>::Cubic, 3>> pieces;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    knots.push_back(rows[k][0]);
    if (k == 0) continue;
    std::array<TableCurves<3>::Cubic, 3> piece;
    for (std::size_t i = 0; i < 3; ++i) {
      const double before = rows[k - 1][i + 1];
      piece[i] = {before, (rows[k][i + 1] - before) / (rows[k][0] - rows[k - 1][0]), 0, 0};
    }
    pieces.push_back(piece);
  }
  return std::make_shared<const TableCurves<3>>(knots, pieces, true);
}

/// Rows whose moment drives a body back to about 3 rad, with a kink at each, and goes round.
const std::vector<std::array<double, 4>> well{{0, 0, 0, 0},     {1, 0, 0, 40},    {2.2, 0, 0, 30},      {2.9, 0, 0, 5},
                                              {3.3, 0, 0, -20}, {4.4, 0, 0, -55}, {revolution, 0, 0, 0}};

/// A body of inertia 1 kg m² that the well's moment turns, from an angle at a spin.
Scene in_the_well(double angle, double spin) {
  Scene scene;
  scene.file = scene.name = "well";
  scene.bodies = {body("wheel", 1, 1, {0, 0}, angle)};
  scene.bodies[0].spin = spin;
  SceneLoad load;
  load.table = SceneTable{lines_between(well), true, 0, 0};
  scene.loads = {load};
  scene.run.duration = scene.run.output_interval = 3;
  return scene;
}

/// (φ, φ̇) at the end in closed form from row to row: between two of them φ̈ = f + b u, u the angle from the lower one,
/// so u = −f/b + d cosh(wt) + (φ̇₀/w) sinh(wt), w² = b. A controlled method that does not know the rows would not do:
/// its estimate of a step over a kink is no bound.
std::array<double, 2> reference(const Scene& scene) {
  using Complex = std::complex<long double>;
  const long double whole = 2 * boost::math::constants::pi<long double>();
  const auto row = [&](std::size_t k) { return k + 1 == well.size() ? whole : static_cast<long double>(well[k][0]); };
  long double spin = scene.bodies[0].spin;
  long double u = scene.bodies[0].angle;
  long double turns = std::floor(u / whole) * whole;
  u -= turns;
  std::size_t k = 0;
  while (u >= row(k + 1)) ++k;
  u -= row(k);
  long double left = scene.run.duration;
  while (true) {
    const long double length = row(k + 1) - row(k);
    const long double f = well[k][3];
    const long double b = (static_cast<long double>(well[k + 1][3]) - f) / length;
    const Complex w = std::sqrt(Complex(b));
    const auto at = [&](long double t) {
      const long double d = u + f / b;
      return std::pair{(d * std::cosh(w * t) + spin / w * std::sinh(w * t)).real() - f / b,
                       (d * w * std::sinh(w * t) + spin * std::cosh(w * t)).real()};
    };
    const auto leaves = [&](long double t) { return at(t).first < 0 || at(t).first > length; };
    long double inside = 0;
    long double outside = 0;
    while (inside < left && !leaves(outside)) {
      inside = outside;
      outside = std::min(left, outside + 1e-3L);  // in which no body turns by a tenth of an interval
    }
    if (!leaves(outside)) {
      const auto [angle, rate] = at(left);
      return {static_cast<double>(turns + row(k) + angle), static_cast<double>(rate)};
    }
    for (int i = 0; i < 64; ++i) (leaves((inside + outside) / 2) ? outside : inside) = (inside + outside) / 2;
    const bool upwards = at(outside).first > length;
    spin = at(outside).second;
    left -= outside;
    if (upwards && ++k + 1 == well.size()) {
      k = 0;
      turns += whole;
    } else if (!upwards && k-- == 0) {
      k = well.size() - 2;
      turns -= whole;
    }
    u = upwards ? 0 : row(k + 1) - row(k);
  }
}

struct Observed {
  double steps;
  double error;
};

Observed observed(Scene scene, const std::string& integrator, double tolerance, const std::array<double, 2>& exact) {
  scene.integrator = integrator;
  set_tolerance(scene, tolerance);
  const MultibodyTrajectory run = simulate_multibody(scene);
  INFO(integrator << ": " << run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const std::vector<double>& y = run.samples.back().state;
  return {static_cast<double>(run.outcome.steps), std::hypot(y[2] - exact[0], (y[5] - exact[1]) / 8)};  // 8 rad/s
}

/// The same in a plane of no special direction in space.
Observed observed_in_space(Scene flat, const std::string& integrator, double tolerance,
                           const std::array<double, 2>& exact) {
  flat.integrator = integrator;
  set_tolerance(flat, tolerance);
  SpatialScene scene = Embedding(some_plane(6)).scene(flat);
  scene.coordinates = flat.coordinates;
  scene.sensors = {{"turn", SpatialAngleSensor{0}}};
  const SpatialTrajectory run = simulate_spatial(scene);
  INFO(integrator << " in space: " << run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const std::vector<double>& turn = run.samples.back().sensors;
  return {static_cast<double>(run.outcome.steps), std::hypot(turn[0] - exact[0], (turn[1] - exact[1]) / 8)};
}

/// Of the straight line of least squares through points.
double slope_of(const std::vector<std::array<double, 2>>& points) {
  const auto n = static_cast<double>(points.size());
  double x = 0;
  double y = 0;
  for (const auto& point : points) {
    x += point[0] / n;
    y += point[1] / n;
  }
  double product = 0;
  double square = 0;
  for (const auto& point : points) {
    product += (point[0] - x) * (point[1] - y);
    square += (point[0] - x) * (point[0] - x);
  }
  return product / square;
}

}  // namespace

TEST_CASE("table of an angle: integrators keep their orders across knots that a body meets from either side") {
  struct Expected {
    std::string integrator;
    double order, loose, tight;
  };
  // Swings over three knots and back, and turns that go round the other way. The order is the slope of all errors over
  // all numbers of steps, along tolerances a tenth apart, from steps that are shorter than most rows to errors that are
  // not yet rounding: single ones scatter. A stage of a step that ends at a knot lies beyond it by what the stage is
  // off, and must not read the next row's line there: of order 8, 7 were left.
  struct Case {
    double angle, spin;
    SceneCoordinates coordinates;
    bool in_space;
  };
  constexpr auto absolute = SceneCoordinates::absolute;
  constexpr auto independent = SceneCoordinates::independent;
  for (const Case& start : {Case{2, 0, absolute, false}, Case{3, -14, absolute, false}, Case{2, 0, independent, false},
                            Case{3, -14, independent, false}, Case{2, 0, absolute, true}, Case{3, -14, absolute, true},
                            Case{2, 0, independent, true}, Case{3, -14, independent, true}}) {
    const double angle = start.angle;
    Scene scene = in_the_well(angle, start.spin);
    const std::array<double, 2> exact = reference(scene);
    scene.coordinates = start.coordinates;
    if (start.coordinates == SceneCoordinates::independent)
      scene.constraints = {{"pin", Revolute<double>{{}, {0, {0, 0}}}}};
    for (const Expected& each :
         {Expected{"radau_iia5", 5, 1e-5, 1e-10}, Expected{"rosenbrock4", 4, 1e-5, 1e-9},
          Expected{"dopri5", 5, 1e-7, 1e-12}, Expected{"fehlberg78", 8, 1e-4, 1e-11},
          Expected{"bulirsch_stoer", 5.5, 1e-4, 1e-10}, Expected{"adams_bashforth_moulton", 5.5, 1e-4, 1e-10}}) {
      std::vector<std::array<double, 2>> points;  // ln of steps and error
      std::ostringstream series;
      for (double tolerance = each.loose; tolerance > each.tight / 2; tolerance /= 10) {
        const Observed run = start.in_space ? observed_in_space(scene, each.integrator, tolerance, exact)
                                            : observed(scene, each.integrator, tolerance, exact);
        points.push_back({std::log(run.steps), std::log(run.error)});
        series << run.steps << " steps, error " << run.error << "; ";
      }
      INFO(each.integrator << " from " << angle << (start.in_space ? " in space: " : ": ") << series.str());
      CHECK(slope_of(points) < -(each.order - 0.6));  // half an order of scatter, as in the methods' own tests
    }
  }
}

TEST_CASE("table of an angle, slide driver: the exact Jacobian is that of central differences") {
  Scene scene;
  scene.file = scene.name = "both";
  scene.gravity = {0, -9.81};
  scene.bodies = {body("beam", 2, 0.3, {0.1, 0.2}, 0.3), body("slider", 1, 0.1, {0.6, 0.5}, 0.5),
                  body("wheel", 1, 0.2, {-1, 0}, 2)};
  const BodyPoint<double> guide{0, {0.1, -0.05}};
  const BodyPoint<double> slides{1, {-0.1, 0.2}};
  const Vector2<double> axis(0.8, 0.6);
  SlideDriver<double> driver{guide, axis, slides, 0.1, 0.4, -0.7};
  driver.shape = std::make_shared<const MotionShape<double>>(MotionShape<double>{0.05, 7, 0.3});
  scene.constraints = {{"pin", Revolute<double>{{}, {0, {-0.2, 0.1}}}},
                       {"guide", Translational<double>{guide, axis, slides, 0.2}},
                       {"drive", driver}};
  SceneLoad load;  // on one body, in its axes and at a point of it, over the angle of another
  load.body = 0;
  load.point = {0.2, -0.1};
  load.turns_with_body = true;
  load.table =
      SceneTable{lines_between({{0, 3, 1, 2}, {1.5, -8, 4, 6}, {3, 5, -20, -9}, {revolution, 3, 1, 2}}), true, 2, 0};
  scene.loads = {load};
  scene.energy_ledger = true;
  const auto system = planar_system<double>(scene);
  MultibodyOde<double> ode(system, true);
  std::vector<double> y = scene_start<double>(scene);
  for (std::size_t i = 9; i < y.size(); ++i) y[i] = 0.4 * std::sin(1.0 + 2.0 * static_cast<double>(i));
  y.resize(ode.dimension(), 0.0);
  const double t = 0.2;
  Eigen::MatrixXd jacobian;
  ode.jacobian(y, jacobian, t);
  std::vector<double> low(y.size());
  std::vector<double> high(y.size());
  const double h = 1e-5;
  const auto differences_agree = [&](const auto& exact) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      INFO("row " << i);
      // h² and rounding/h, times 100, of accelerations of some hundreds.
      CHECK(std::abs((high[i] - low[i]) / (2 * h) - exact(i)) < 1e-6 * (1 + std::abs(exact(i))));
    }
  };
  for (std::size_t k = 0; k < ode.mechanical_states(); ++k) {
    INFO("column " << k);
    std::vector<double> at = y;
    at[k] = y[k] - h;
    ode.rate(at, low, t);
    at[k] = y[k] + h;
    ode.rate(at, high, t);
    differences_agree(
        [&](std::size_t i) { return jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)); });
  }
  // What turns the wheel moves the beam: the column of another body's angle.
  CHECK(jacobian.col(8).segment(9, 3).norm() > 1);
  std::vector<double> slope(y.size());
  ode.time_slope(y, slope, t);
  ode.rate(y, low, t - h);
  ode.rate(y, high, t + h);
  differences_agree([&](std::size_t i) { return slope[i]; });
}

}  // namespace table_angle_test
