// The oracles of mechanisms in space by themselves: against other derivations, what is conserved, and published
// numbers.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "oracle/mechanisms/bricard.hpp"
#include "oracle/mechanisms/flyball_governor.hpp"
#include "oracle/mechanisms/free_rigid_body.hpp"
#include "oracle/mechanisms/heavy_top.hpp"
#include "oracle/mechanisms/lobatto.hpp"
#include "oracle/mechanisms/lubricated_spatial_slider_crank.hpp"
#include "support/csv.hpp"

namespace spatial_oracles_test {

using namespace lubjoint;
using namespace lubjoint::mechanisms;
using namespace lubjoint::test;

namespace {

using Real = long double;
using Vector3r = Eigen::Matrix<Real, 3, 1>;
using Quaternion = Eigen::Quaternion<Real>;

/// In extended precision by steps of Fehlberg: what is compared with takes another way.
template <class State, class System>
void reach(const System& system, State& y, Real from, Real to, Real tolerance) {
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(
      odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<State, Real>()), system, y, from, to,
      Real(1e-4));
}

/// A body about its mass centre or a fixed point, by Hamilton's quaternion: J ω̇ = Jω × ω + moment, q̇ = ½ q ω.
using Turning = std::array<Real, 7>;  // q (w, x, y, z), ω′

template <class Moment>
Turning turned_by_steps(const Vector3r& j, const Turning& start, Real to, const Moment& moment) {
  Turning y = start;
  reach(
      [&](const Turning& at, Turning& rate, Real) {
        const Quaternion q(at[0], at[1], at[2], at[3]);
        const Vector3r w(at[4], at[5], at[6]);
        const Quaternion half = q * Quaternion(0, w.x() / 2, w.y() / 2, w.z() / 2);
        const Vector3r jw = j.cwiseProduct(w);
        const Vector3r turning = (jw.cross(w) + moment(q)).cwiseQuotient(j);
        rate = {half.w(), half.x(), half.y(), half.z(), turning.x(), turning.y(), turning.z()};
      },
      y, 0, to, 1e-17L);
  return y;
}

Eigen::Matrix3d matrix_of(const Turning& y) {
  return Quaternion(y[0], y[1], y[2], y[3]).normalized().toRotationMatrix().cast<double>();
}

double published(const std::string& mechanism, const std::string& solution, const std::string& quantity, double t) {
  for (const CsvRow& row : read_csv(std::string(LUBJOINT_SOURCE_DIR) + "/data/literature/spatial-mechanisms.csv")) {
    const bool same = row.at("mechanism") == mechanism && row.at("solution") == solution;
    if (same && row.at("quantity") == quantity && std::abs(number(row.at("t")) - t) < 1e-9)  // nine decimals
      return number(row.at("published"));
  }
  FAIL(mechanism << " " << solution << " " << quantity << " at " << t);
  return 0;
}

}  // namespace

TEST_CASE("free rigid body: spin and orientation over a hundred turns are those of the equations of motion") {
  struct Case {
    Eigen::Vector3d moments;
    Eigen::Vector3d spin;
  };
  // Both sides of the separatrix in each order of the moments; symmetric and spherical bodies; spins about one axis.
  const std::vector<Case> cases = {
      {{1, 2, 2.5}, {2, 0.1, -0.3}}, {{1, 2, 2.5}, {0.2, -0.5, 2}}, {{2.5, 1, 2}, {-2, 0.3, 0.4}},
      {{2, 2.5, 1}, {0.4, 1, -3}},   {{2.5, 2, 1}, {0.1, 2, -0.1}}, {{1, 2.5, 2}, {-1, -1, -1}},
      {{2, 1, 2.5}, {1, 2, -0.5}},   {{1, 1, 1.5}, {1, -0.5, 2}},   {{1.5, 1, 1}, {1, -0.5, 2}},
      {{1, 1.5, 1}, {1, 0.5, -2}},   {{1, 1, 1}, {1, 0.5, -2}},     {{1, 2, 2.5}, {0, 2, 0}},
      {{1, 2, 2.5}, {0, 0, -2}},     {{1, 2, 2.5}, {0.5, 1, 0}},    {{1, 2, 2.5}, {0, 1, 0.5}},
      {{1, 1, 1.5}, {1, 0.5, 0}}};
  const double end = 300;  // a hundred turns at 2 rad/s
  for (const Case& given : cases) {
    CAPTURE(given.moments.transpose(), given.spin.transpose());
    const FreeRigidBody body(given.moments, given.spin);
    // An elliptic integral and its inverse; one case is near the separatrix, where rounding is divided by 1 - k² =
    // 9e-4.
    const bool near = body.from_separatrix() < 0.01;
    const double at_start = near ? 1e-12 : 4e-15;  // some units of rounding; over 1 - k² near the separatrix
    CHECK((body.spin(0) - given.spin).norm() < at_start);
    CHECK((body.orientation(0) - Eigen::Matrix3d::Identity()).norm() < at_start);
    const Vector3r j = given.moments.cast<Real>();
    Turning y{1, 0, 0, 0, given.spin[0], given.spin[1], given.spin[2]};
    y = turned_by_steps(j, y, end, [](const Quaternion&) { return Vector3r(Vector3r::Zero()); });
    const Eigen::Vector3d expected(Eigen::Matrix<Real, 3, 1>(y[4], y[5], y[6]).cast<double>());
    const double allowed = near ? 1e-10 : 1e-12;  // rounding of p t = 600
    CHECK((body.spin(end) - expected).norm() < allowed);
    const Eigen::Matrix3d a = body.orientation(end);
    CHECK((a - matrix_of(y)).norm() < allowed);
    const Eigen::Vector3d momentum = given.moments.cwiseProduct(given.spin);
    // Conserved, but for the rounding of a turn of 600 rad.
    CHECK((a * given.moments.cwiseProduct(body.spin(end)) - momentum).norm() < 1e-12 * momentum.norm());
  }
}

TEST_CASE("free rigid body: on the separatrix the spin goes over to the other end of the middle axis, and stays") {
  // L² = 2T J_m: high (high − middle) ω_h² = low (middle − low) ω_l², here 3·1·ω_h² = 1·1·ω_l² with exact squares.
  const Eigen::Vector3d moments(1, 2, 3);
  const double h = 0.5;
  const double l = std::sqrt(3.0) * h;
  const FreeRigidBody body(moments, {l, -1, h});
  // sech: the closed form by its own differential equation ω_m = M tanh(pt + τ₀), M = ± L/J_m.
  const double size = moments.cwiseProduct(Eigen::Vector3d(l, -1, h)).norm() / 2;
  CHECK(std::abs(std::abs(body.spin(40)[1]) - size) < 1e-6);  // rounding at the start grows like e^{pt}, to t = 40
  Turning y{1, 0, 0, 0, Real(l), -1, Real(h)};
  y = turned_by_steps(moments.cast<Real>(), y, 4, [](const Quaternion&) { return Vector3r(Vector3r::Zero()); });
  const FreeRigidBody near(moments, {l, -1, h});
  for (int k = 0; k < 3; ++k)
    CHECK(std::abs(near.spin(4)[k] - static_cast<double>(y[4 + k])) < 1e-12);  // rounding, e^{4p} times
  CHECK((near.orientation(4) - matrix_of(y)).norm() < 1e-11);  // its integral over 4 s, through an elliptic integral
}

TEST_CASE("free rigid body: another moment or another spin is another motion") {
  const FreeRigidBody body({1, 2, 2.5}, {2, 0.1, -0.3});
  const FreeRigidBody heavier({1, 2, 2.5 * (1 + 1e-9)}, {2, 0.1, -0.3});
  CHECK((body.spin(300) - heavier.spin(300)).norm() > 1e-9);                // a thousand times what the other test
  CHECK((body.orientation(300) - heavier.orientation(300)).norm() > 1e-9);  // allows
}

namespace {

const HeavyTop<Real> top{0.5L, 0.06L, 3.125e-4L, 6.25e-4L};

/// φ, θ, ψ and the axis of a top by steps of its quaternion about the point; starts as HeavyTopMotion does.
Turning top_by_steps(Real theta, Real precession, Real spin, Real t) {
  const Vector3r j(top.about_point(), top.about_point(), top.inertia_along);
  const Real half = theta / 2;
  const Turning start{std::cos(half), std::sin(half), 0, 0, 0, precession * std::sin(theta), spin};
  return turned_by_steps(j, start, t, [&](const Quaternion& q) {
    const Vector3r weight = q.conjugate() * Vector3r(0, 0, -top.mass * top.gravity);
    return Vector3r(Vector3r(0, 0, top.distance).cross(weight));
  });
}

Eigen::Matrix3d matrix_of(const HeavyTopMotion<Real>::Angles& at) {
  using Axis = Eigen::AngleAxis<Real>;
  return (Axis(at[0], Vector3r::UnitZ()) * Axis(at[1], Vector3r::UnitX()) * Axis(at[2], Vector3r::UnitZ()))
      .toRotationMatrix()
      .cast<double>();
}

}  // namespace

TEST_CASE("heavy top: steady precession keeps its angle in the equations of motion, slow and fast") {
  for (const Real theta : {0.5L, 2.0L}) {
    const auto [slow, fast] = top.steady(theta, 200);
    CHECK(std::abs(slow) < std::abs(fast));
    for (const Real precession : {slow, fast}) {
      const Turning y = top_by_steps(theta, precession, 200, 1);
      const Eigen::Matrix3d a = matrix_of(y);
      CHECK(std::abs(std::acos(a(2, 2)) - static_cast<double>(theta)) < 1e-13);  // rounding of a matrix, over sine
      const double turned = static_cast<double>(std::remainder(precession, 2 * std::acos(Real(-1))));
      // The fast one turns by a hundred radians, in steps of 1e-17 and of rounding.
      CHECK(std::abs(std::remainder(std::atan2(a(0, 2), -a(1, 2)) - turned, 2 * std::acos(-1.0))) < 1e-11);
    }
    // The weight's moment turns the momentum: J₃ω₃Ω − (J₁ + ml²)Ω² cosθ = mgl.
    CHECK(std::abs(top.inertia_along * 200 * slow - top.about_point() * slow * slow * std::cos(theta) -
                   top.mass * top.gravity * top.distance) < 1e-17L);  // rounding of a root and of 0.3 N m
  }
  CHECK_THROWS_AS(top.steady(0.5L, 30), std::domain_error);
}

TEST_CASE("heavy top: nutation between its turning points, rising, falling, with loops and cusps") {
  struct Case {
    Real theta, precession, spin;
  };
  for (const Case& given :
       {Case{0.5L, 0, 200}, {0.5L, 10, 200}, {1.2L, -5, 150}, {0.5L, 2, 250}, {2.0L, 3, 100}, {1.0L, 0, 20}}) {
    CAPTURE(double(given.theta), double(given.precession), double(given.spin));
    const HeavyTopMotion<Real> motion(top, given.theta, given.precession, given.spin);
    const auto half = motion.angles(motion.half_period());
    CHECK(std::abs(half[1] - motion.other_angle()) < 1e-15L);  // an angle by its cosine, in extended precision
    const Turning at_turn = top_by_steps(given.theta, given.precession, given.spin, motion.half_period());
    CHECK(std::abs(std::acos(matrix_of(at_turn)(2, 2)) - static_cast<double>(half[1])) <
          1e-13);  // rounding of a matrix
    for (const Real t : {0.013L, 0.4L, 2.0L}) {
      const Turning y = top_by_steps(given.theta, given.precession, given.spin, t);
      CHECK((matrix_of(y) - matrix_of(motion.angles(t))).norm() < 1e-12);  // the quadrature's 1e-14 of 400 rad
    }
  }
}

TEST_CASE(
    "spatial slider-crank: two published solutions are two mechanisms, each a little off the energy's quadrature") {
  SpatialSliderCrank<Real> mechanism;
  {
    const SpatialSliderCrankMotion<Real> motion(mechanism, 0, 6);
    Real largest = 0;
    for (const double t : {0.5, 1.0, 2.0, 3.0, 4.0, 5.0}) {
      const Real off = mechanism.slider(motion.angle(t)).value - published("slider-crank", "gonzalez", "slider.x", t);
      largest = std::max(largest, std::abs(off));
    }
    CHECK(largest < 4.3e-5L);  // as it was found: 4.2e-5 m, which
    CHECK(largest > 4.1e-5L);  // its nine decimals do not explain
  }
  // The other one has the rod's moment about its own axis and that about the third axis exchanged.
  std::swap(mechanism.rod_inertia_along, mechanism.rod_inertia_third);
  const SpatialSliderCrankMotion<Real> motion(mechanism, 0, 6);
  Real x_off = 0;
  Real angle_off = 0;
  for (const int k : {1, 6, 30, 60, 120, 180, 240, 299}) {
    const Real t = 5 * Real(k) / 299;
    const Real angle = motion.angle(t);
    x_off = std::max(
        x_off, std::abs(mechanism.slider(angle).value - published("slider-crank", "masoudi", "slider.x", double(t))));
    angle_off = std::max(angle_off, std::abs(angle - published("slider-crank", "masoudi", "crank.angle", double(t))));
  }
  CHECK(x_off < 1.1e-5L);  // as it was found, from both sides
  CHECK(x_off > 1.0e-5L);
  CHECK(angle_off < 2.5e-4L);  // as it was found: the slider's, over an arm of 4 cm
}

TEST_CASE("spatial slider-crank: its kinetic energy is that of the bodies' velocities by differences") {
  SpatialSliderCrank<Real> m;
  m.slider_inertia = 1e-3L;
  m.rod_inertia_third = 2e-3L;
  const Real h = 1e-6L;
  const auto rod = [&](Real angle) {  // its frame: along, the cross's axis, the third
    const auto b = m.crank_pin(angle);
    const Vector3r u = Vector3r(m.slider(angle).value, -b[1].value, -b[2].value) / m.rod_length;
    const Vector3r n = Vector3r(Vector3r::UnitX().cross(u)).normalized();
    Eigen::Matrix<Real, 3, 3> frame;
    frame << u, n, u.cross(n);
    return frame;
  };
  for (const Real angle : {0.0L, 1.0L, 2.5L, 4.0L, 5.5L}) {
    // Aᵀ A', to second order.
    const Eigen::Matrix<Real, 3, 3> turning = rod(angle).transpose() * (rod(angle + h) - rod(angle - h)) / (2 * h);
    const Vector3r spin(turning(2, 1), turning(0, 2), turning(1, 0));
    const auto centre = [&](Real at) {
      const auto b = m.crank_pin(at);
      return Vector3r((m.slider(at).value) / 2, b[1].value / 2, b[2].value / 2);
    };
    const Vector3r v = (centre(angle + h) - centre(angle - h)) / (2 * h);
    const Real slider = (m.slider(angle + h).value - m.slider(angle - h).value) / (2 * h);
    const auto pin = [&](Real at) { return std::atan2(m.crank_pin(at)[2].value, m.crank_pin(at)[1].value); };
    const Real swivel = (pin(angle + h) - pin(angle - h)) / (2 * h);
    const Vector3r j(m.rod_inertia_along, m.rod_inertia_cross, m.rod_inertia_third);
    const Real expected = m.crank_inertia + m.crank_mass * m.crank_centre * m.crank_centre +
                          m.rod_mass * v.squaredNorm() + spin.dot(j.cwiseProduct(spin)) +
                          m.slider_mass * slider * slider + m.slider_inertia * swivel * swivel;
    CHECK(std::abs(m.inertia(angle) - expected) < 1e-10L * expected);  // h² of the differences, rounding over h
  }
}

TEST_CASE("Bricard's mechanism: its closed curve holds all six pins, energy is kept, and the published figure is met") {
  const Bricard<Real> m;
  auto y = Bricard<Real>::start();
  CHECK(m.open(y) < 1e-18L);  // rounding
  const Real before = m.energy(y);
  Real t = 0;
  for (const double next : {1.25, 2.5, 3.75, 5.0, 10.0}) {
    reach(std::cref(m), y, t, next, 1e-17L);
    t = next;
    CHECK(m.open(y) < 1e-15L);                            // no condition is imposed: what the steps leave
    CHECK(std::abs(Bricard<Real>::closing(y)) < 1e-15L);  // likewise
    CHECK(std::abs(m.energy(y) - before) < 1e-14L);       // likewise, times forces of some newtons
    const auto p3 = m.pins(y)[Bricard<Real>::published_point];
    for (int k = 0; k < 3; ++k) {
      const std::string quantity = std::string("P3.") + "xyz"[k];
      CHECK(std::abs(p3[k] - published("bricard", "figure", quantity, next)) < 0.02);  // two pixels across and along
    }
  }
}

TEST_CASE("Bricard's mechanism: the sum of squares that another program prints at 1 s is reached to its step's error") {
  const Bricard<Real> m;
  const auto start = Bricard<Real>::start();
  auto y = start;
  reach(std::cref(m), y, 0, 1, 1e-17L);
  const auto pins = m.pins(y);
  const auto pins_before = m.pins(start);
  const auto axes = m.axes(y);
  const auto axes_before = m.axes(start);
  Real squares = 0;
  for (std::size_t k = 0; k < Bricard<Real>::bodies; ++k) {
    squares += (pins[k] - pins_before[k]).squaredNorm();
    const Vector3r along = pins[k + 1] - pins[k];
    const Vector3r along_before = pins_before[k + 1] - pins_before[k];
    const Real cosines = along.dot(along_before) + axes[k].dot(axes_before[k]) +
                         along.cross(axes[k]).dot(along_before.cross(axes_before[k]));
    const Real half_angle = std::acos((cosines - 1) / 2) / 2;  // trace = 1 + 2 cos
    squares += 2 - 2 * std::cos(half_angle);                   // |p − p₀|² of Euler parameters
  }
  // Beside the norm it counts a degree of freedom and a redundant constraint.
  CHECK(std::abs(std::sqrt(squares) - (published("bricard", "exudyn", "norm", 1) - 2)) < 1.4e-6);  // its 1e-3 s
}

TEST_CASE("flyball governor: energy goes into the dampers alone, steps of two sizes agree, and the figure is met") {
  const FlyballGovernor<Real> m;
  struct System {
    FlyballGovernor<Real> m;
    std::size_t states() const { return 7; }
    // With the dampers' work as the seventh state.
    void rate(const Real& t, const ShortState<Real, 7>& y, ShortState<Real, 7>& dydt) const {
      FlyballGovernor<Real>::State at{}, slope{};
      std::copy_n(y.begin(), 6, at.begin());
      m(at, slope, t);
      std::copy_n(slope.begin(), 6, dydt.begin());
      dydt[6] = m.dissipation(at);
    }
    void weights(const ShortState<Real, 7>&, ShortState<Real, 7>& w) const { w.fill(1); }
    void increments(const ShortState<Real, 7>&, ShortState<Real, 7>& d) const { d.fill(1e-10L); }
  };
  const System system{m};
  const auto ends = [&](Real tolerance) {
    ShortState<Real, 7> y{};
    const auto start = m.start(2 * std::acos(Real(-1)));
    std::copy_n(start.begin(), 6, y.begin());
    Lobatto<Real, 7> steps(tolerance);
    Real t = 0;
    std::vector<ShortState<Real, 7>> seen{y};
    for (const double next : {0.5, 4.1, 8.2, 10.0}) {
      steps.reach(system, t, y, next);
      t = next;
      seen.push_back(y);
    }
    return seen;
  };
  const auto fine = ends(1e-13L);
  const auto coarse = ends(1e-11L);
  const auto energy = [&](const ShortState<Real, 7>& y) {
    FlyballGovernor<Real>::State at{};
    std::copy_n(y.begin(), 6, at.begin());
    return m.energy(at);
  };
  std::size_t k = 0;
  for (const double t : {0.5, 4.1, 8.2, 10.0}) {
    ++k;
    // Ten times the coarser steps' tolerance: ten seconds' growth.
    for (std::size_t i = 0; i < 5; ++i) CHECK(std::abs(fine[k][i] - coarse[k][i]) < 1e-10L);
    CHECK(std::abs(energy(fine[k]) - energy(fine[0]) - fine[k][6]) < 1e-10L * energy(fine[0]));    // likewise
    CHECK(std::abs(fine[k][1] - published("flyball-governor", "figure", "slider.z", t)) < 0.002);  // three pixels
  }
}

namespace {

using LubricatedCrank = LubricatedSpatialSliderCrank<PinkusSternlicht, Real>;

SpatialSliderCrank<Real> shipped_mechanism() {
  SpatialSliderCrank<Real> m;
  m.crank_centre = 0;
  m.slider_inertia = 1e-4L;
  return m;
}

LubricatedCrank lubricated(Real clearance, Real viscosity) {
  return {shipped_mechanism(), Bearing<Real>(0.04L, 0.01L - clearance, clearance), Lubricant<Real>(viscosity)};
}

/// The same with the film's work as a seventh state.
struct WithWork {
  const LubricatedCrank& m;
  std::size_t states() const { return 7; }
  static LubricatedCrank::State of(const ShortState<Real, 7>& y) {
    LubricatedCrank::State at{};
    std::copy_n(y.begin(), 6, at.begin());
    return at;
  }
  void rate(const Real& t, const ShortState<Real, 7>& y, ShortState<Real, 7>& dydt) const {
    LubricatedCrank::State slope{};
    m.rate(t, of(y), slope);
    std::copy_n(slope.begin(), 6, dydt.begin());
    dydt[6] = m.film_power(of(y));
  }
  void weights(const ShortState<Real, 7>& y, ShortState<Real, 7>& w) const {
    LubricatedCrank::State six{};
    m.weights(of(y), six);
    std::copy_n(six.begin(), 6, w.begin());
    w[6] = 1e-3L;
  }
  void increments(const ShortState<Real, 7>& y, ShortState<Real, 7>& d) const {
    weights(y, d);
    for (Real& x : d) x *= 1e-10L;
  }
};

}  // namespace

TEST_CASE("lubricated spatial slider-crank: what the film takes is what the mechanism loses") {
  const LubricatedCrank m = lubricated(2e-4L, 0.4L);
  ShortState<Real, 7> y{};
  const auto start = m.start(0.3L, 6);
  std::copy_n(start.begin(), 6, y.begin());
  y[4] += 0.5L;  // the rod off its course: the film works from the start
  Lobatto<Real, 7> steps(1e-11L);
  steps.reach(WithWork{m}, Real(0), y, Real(0.7L));
  const Real lost = m.energy(WithWork::of(y)) - m.energy([&] {
    auto at = start;
    at[4] += 0.5L;
    return at;
  }());
  CHECK(lost < -1e-4L);                   // so that there is something to compare
  CHECK(std::abs(lost - y[6]) < 1e-12L);  // the tolerance, of some joules
}

TEST_CASE("lubricated spatial slider-crank: a stiff film leaves the ideal motion of the energy's quadrature") {
  const SpatialSliderCrank<Real> ideal = shipped_mechanism();
  const SpatialSliderCrankMotion<Real> motion(ideal, 0, 6);
  const Real end = 0.5L;
  const Real angle = motion.angle(end);
  std::vector<Real> off;
  for (const Real viscosity : {0.4L, 4.0L}) {
    const LubricatedCrank m = lubricated(2e-5L, viscosity);
    auto y = m.start(0, 6);
    Lobatto<Real, 6> steps(1e-8L);
    steps.reach(m, Real(0), y, end);
    off.push_back(std::abs(y[0] - angle));
  }
  CHECK(off[0] < 8e-6L);  // a part of the clearance over the crank's arm
  // The film's compliance: in inverse proportion to the viscosity, to first order in it.
  CHECK(std::abs(off[1] / off[0] - 0.1L) < 1e-3L);
}

}  // namespace spatial_oracles_test
