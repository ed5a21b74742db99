// Scenes in space against oracles that share no formula with them: closed forms, energy integrals, minimal coordinates.
#include <boost/numeric/odeint.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/mechanisms/bricard.hpp"
#include "oracle/mechanisms/flyball_governor.hpp"
#include "oracle/mechanisms/free_rigid_body.hpp"
#include "oracle/mechanisms/heavy_top.hpp"
#include "oracle/mechanisms/lobatto.hpp"
#include "oracle/mechanisms/lubricated_spatial_slider_crank.hpp"
#include "support/run_program.hpp"

namespace space_oracles_test {

using namespace lubjoint;
using namespace lubjoint::mechanisms;
using lubjoint::test::read_text;

namespace {

using Real = long double;

SpatialScene shipped(const std::string& name) {
  return load_spatial_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/" + name + ".toml");
}

/// A finished run's columns by name.
class Columns {
 public:
  explicit Columns(const SpatialScene& scene) : run_(simulate_spatial(scene)), table_(trajectory_table(scene, run_)) {
    INFO(run_.outcome.message);
    REQUIRE(run_.outcome.status == RunStatus::finished);
  }
  std::size_t rows() const { return table_.rows.size(); }
  double operator()(const std::string& name, std::size_t row) const {
    const auto found = std::find(table_.columns.begin(), table_.columns.end(), name);
    if (found == table_.columns.end()) throw std::logic_error("no column " + name);
    return table_.rows[row][static_cast<std::size_t>(found - table_.columns.begin())].value();
  }
  double t(std::size_t row) const { return table_.rows[row][0].value(); }
  Eigen::Vector3d vector(const std::string& name, const std::array<const char*, 3>& parts, std::size_t row) const {
    return {(*this)(name + parts[0], row), (*this)(name + parts[1], row), (*this)(name + parts[2], row)};
  }
  Eigen::Vector3d position(const std::string& body, std::size_t row) const {
    return vector(body, {".x", ".y", ".z"}, row);
  }
  Eigen::Vector3d spin(const std::string& body, std::size_t row) const {
    return vector(body, {".wx", ".wy", ".wz"}, row);
  }
  Eigen::Matrix3d orientation(const std::string& body, std::size_t row) const {
    return Eigen::Quaterniond((*this)(body + ".e0", row), (*this)(body + ".e1", row), (*this)(body + ".e2", row),
                              (*this)(body + ".e3", row))
        .toRotationMatrix();
  }
  const SpatialTrajectory& run() const { return run_; }

 private:
  SpatialTrajectory run_;
  TrajectoryTable table_;
};

void set_tolerance(SpatialScene& scene, double tolerance) {
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
}

}  // namespace

namespace {

SpatialScene free_body(const Eigen::Vector3d& spin) {
  SpatialScene scene = parse_spatial_scene(R"(
dimension = 3
name = "free"
duration = 300.0  # a hundred turns
joints = []
[[bodies]]
name = "body"
mass = 1.0
inertia = [1.0, 2.0, 2.5]
position = [0.0, 0.0, 0.0]
[integrator]
name = "fehlberg78"
relative_tolerance = 1e-14
absolute_tolerance = 1e-14
[output]
interval = 30.0
)",
                                           "free");
  scene.bodies[0].spin = spin;
  return scene;
}

}  // namespace

TEST_CASE("space: a free body keeps to Jacobi's functions over a hundred turns") {
  for (const Eigen::Vector3d& spin :
       {Eigen::Vector3d(2, 0.1, -0.3), Eigen::Vector3d(0.2, -0.5, 2), Eigen::Vector3d(1, 1, -1)}) {
    CAPTURE(spin.transpose());
    const SpatialScene scene = free_body(spin);
    const FreeRigidBody body({1, 2, 2.5}, spin);
    const Columns run(scene);
    // What limits double precision is the sum of the steps: each of n rounds a spin of 2 rad/s by up to 2.2e-16, which
    // adds up as sqrt(n) and turns the body by that times t. 5 for the three spins and the truncation at 1e-14.
    const double rounding = 5 * 2.2e-16 * std::sqrt(static_cast<double>(run.run().outcome.steps));
    for (std::size_t row = 0; row < run.rows(); ++row) {
      const double allowed = rounding * run.t(row) + 1e-15;  // 2e-11 at the end; measured up to 1.1e-11
      CHECK((run.spin("body", row) - body.spin(run.t(row))).norm() < allowed);
      CHECK((run.orientation("body", row) - body.orientation(run.t(row))).norm() < allowed);
    }
    // The same rates, in double precision, with steps that are summed in extended precision: 1e-12.
    const SpatialSystem<double> system = spatial_system<double>(scene);
    SpatialOde<double> ode(system, false);
    const std::vector<double> start = scene_start<double>(scene);
    std::vector<Real> y(start.begin(), start.end());
    std::vector<double> at(y.size()), slope(y.size());
    const auto in_double = [&](const std::vector<Real>& x, std::vector<Real>& rate, Real t) {
      std::copy(x.begin(), x.end(), at.begin());
      ode.rate(at, slope, static_cast<double>(t));
      rate.assign(slope.begin(), slope.end());
    };
    boost::numeric::odeint::runge_kutta_fehlberg78<std::vector<Real>, Real> steps;
    constexpr int n = 8000;  // from here on shorter ones change nothing
    for (int i = 0; i < n; ++i) steps.do_step(in_double, y, Real(300) * i / n, Real(300) / n);
    const Eigen::Matrix3d turned =
        Eigen::Quaternion<Real>(y[3], y[4], y[5], y[6]).normalized().toRotationMatrix().cast<double>();
    CHECK((turned - body.orientation(300)).norm() < 1e-12);  // what is asked for
    for (int k = 0; k < 3; ++k)
      CHECK(std::abs(static_cast<double>(y[10 + static_cast<std::size_t>(k)]) - body.spin(300)[k]) <
            1e-12);  // likewise
  }
}

TEST_CASE("space: the top that ships precesses steadily, and off that angle it nods as its three integrals say") {
  SpatialScene scene = shipped("top");
  scene.integrator = "fehlberg78";
  set_tolerance(scene, 1e-12);
  const double tilt = 0.5;
  {
    const Columns run(scene);
    for (std::size_t row = 0; row < run.rows(); row += 50)
      CHECK(std::abs(std::acos(run.orientation("top", row)(2, 2)) - tilt) <
            1e-9);  // of the tolerance, a thousand steps
  }
  // From rest but for its spin.
  const HeavyTop<double> top{0.5, 0.06, 3.125e-4, 6.25e-4};
  scene.bodies[0].spin = Vector3<double>(0, 0, 200);
  scene.bodies[0].velocity = Vector3<double>(0, 0, 0);
  const Columns run(scene);
  const HeavyTopMotion<double> motion(top, tilt, 0, 200);
  double off = 0;
  for (std::size_t row = 0; row < run.rows(); row += 50) {
    const auto at = motion.angles(run.t(row));
    using Axis = Eigen::AngleAxisd;
    const Eigen::Matrix3d expected = (Axis(at[0], Eigen::Vector3d::UnitZ()) * Axis(at[1], Eigen::Vector3d::UnitX()) *
                                      Axis(at[2], Eigen::Vector3d::UnitZ()))
                                         .toRotationMatrix();
    off = std::max(off, (run.orientation("top", row) - expected).norm());
  }
  CHECK(off < 1e-8);  // likewise
}

TEST_CASE(
    "space: the published slider-crank follows the energy's quadrature, and the ideal twin of the lubricated one") {
  for (const std::string name : {"published-slider-crank", "spatial-slider-crank-ideal"}) {
    CAPTURE(name);
    SpatialScene scene = shipped(name);
    set_tolerance(scene, 1e-11);
    SpatialSliderCrank<Real> mechanism;
    if (name != "published-slider-crank") {
      mechanism.crank_centre = 0;
      mechanism.slider_inertia = 1e-4L;
    }
    const SpatialSliderCrankMotion<Real> motion(mechanism, 0, 6);
    const Columns run(scene);
    Real off = 0;
    for (std::size_t row = 0; row < run.rows(); row += 10)
      off = std::max(off, std::abs(run("slider.x", row) - mechanism.slider(motion.angle(run.t(row))).value));
    CHECK(off < 1e-9L);  // eight revolutions' steps of 1e-11
  }
}

namespace {

/// How far the rods' mass centres are from where the closed curve has them [m].
double off_closed_curve(const Columns& run) {
  const Bricard<Real> m;
  auto y = Bricard<Real>::start();
  double off = 0;
  for (std::size_t row = 1; row < run.rows(); ++row) {
    boost::numeric::odeint::integrate_adaptive(
        boost::numeric::odeint::make_controlled(
            1e-15L, 1e-15L, boost::numeric::odeint::runge_kutta_fehlberg78<Bricard<Real>::State, Real>()),
        std::cref(m), y, Real(run.t(row - 1)), Real(run.t(row)), 1e-3L);
    const auto pins = m.pins(y);
    for (std::size_t k = 0; k < Bricard<Real>::bodies; ++k) {
      const Eigen::Vector3d centre = ((pins[k] + pins[k + 1]) / 2).cast<double>();
      off = std::max(off, (run.position("rod-" + std::to_string(k + 1), row) - centre).norm());
    }
  }
  return off;
}

}  // namespace

TEST_CASE("space: Bricard's mechanism follows its closed curve for two periods") {
  SpatialScene scene = shipped("bricard");
  const Columns run(scene);
  CHECK(run.run().left_out.empty());
  CHECK(off_closed_curve(run) < 1e-8);  // of the tolerance, two periods
}

TEST_CASE("space: Bricard's mechanism with all six pins follows it, too, with one row left out") {
  const std::string file = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/bricard.toml";
  std::string text = read_text(file);
  const std::size_t at = text.find("type = \"cylindrical\"");
  REQUIRE(at != std::string::npos);
  text.replace(at, 20, "type = \"revolute\"");
  text.insert(text.find("[[bodies]]"), "redundant = \"allow\"\n");
  SpatialScene scene = parse_spatial_scene(text, "bricard");
  scene.run.duration = 1.2;
  const Columns run(scene);
  CHECK(run.run().left_out.size() == 1);
  CHECK(off_closed_curve(run) < 1e-8);  // of the tolerance, two periods
}

TEST_CASE("space: the flyball governor follows its three coordinates") {
  SpatialScene scene = shipped("flyball-governor");
  // Radau's order is reduced by the stiff springs: two decades of tolerance are one of error.
  set_tolerance(scene, 1e-11);
  scene.run.duration = 2;  // two periods
  const Columns run(scene);
  struct System {
    FlyballGovernor<Real> m;
    std::size_t states() const { return 6; }
    void rate(const Real& t, const ShortState<Real, 6>& y, ShortState<Real, 6>& dydt) const { m(y, dydt, t); }
    void weights(const ShortState<Real, 6>&, ShortState<Real, 6>& w) const { w.fill(1); }
    void increments(const ShortState<Real, 6>&, ShortState<Real, 6>& d) const { d.fill(1e-10L); }
  };
  const System system{};
  auto y = system.m.start(2 * std::acos(Real(-1)));
  Lobatto<Real, 6> steps(1e-11L);
  Real off = 0;
  for (std::size_t row = 1; row < run.rows(); ++row) {
    steps.reach(system, Real(run.t(row - 1)), y, Real(run.t(row)));
    off = std::max(off, std::abs(run("slider.z", row) - y[1]));
  }
  CHECK(off < 1e-7L);  // 7e-9 after the first
}

TEST_CASE("space: the lubricated slider-crank that ships is that of minimal coordinates, in parts of a clearance") {
  SpatialScene scene = shipped("spatial-slider-crank");
  set_tolerance(scene, 1e-10);
  scene.run.duration = 0.6;  // a revolution
  SpatialSliderCrank<Real> mechanism;
  mechanism.crank_centre = 0;
  mechanism.slider_inertia = 1e-4L;
  const LubricatedSpatialSliderCrank<PinkusSternlicht, Real> m(mechanism, Bearing<Real>(0.04L, 0.0098L, 0.0002L),
                                                               Lubricant<Real>(0.4L));
  auto y = m.start(0, 6);
  Lobatto<Real, 6> steps(1e-10L);
  const Columns run(scene);
  Real off = 0;
  Real force_off = 0;
  Real largest = 0;
  for (std::size_t row = 10; row < run.rows(); row += 10) {
    steps.reach(m, Real(run.t(row - 10)), y, Real(run.t(row)));
    const auto pin = m.pin(y);
    const Eigen::Vector3d e = run.vector("gudgeon-pin", {".ex", ".ey", ".ez"}, row);
    const Eigen::Vector3d f = run.vector("gudgeon-pin", {".fx", ".fy", ".fz"}, row);
    for (int k = 0; k < 3; ++k) {
      off = std::max(off, std::abs(e[k] / 0.0002L - pin.eccentricity[static_cast<std::size_t>(k)]));
      force_off = std::max(force_off, std::abs(f[k] - pin.force[static_cast<std::size_t>(k)]));
      largest = std::max(largest, std::abs(pin.force[static_cast<std::size_t>(k)]));
    }
    CHECK(run("gudgeon-pin.tilt", row) < 1e-6);  // drift of the constraints, which are kept to 1e-8
  }
  CHECK(off < 1e-9L);                  // what is asked for of the plane; ten tolerances
  CHECK(force_off < 1e-7L * largest);  // a film's stiffness times that
}

}  // namespace space_oracles_test
