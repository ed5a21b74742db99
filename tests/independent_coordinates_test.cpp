// Independent coordinates: the same motion as absolute ones, on the constraints to rounding, in fewer states.
#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "lubjoint/motion/in_plane.hpp"
#include "lubjoint/motion/independent_integrator.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_coordinates.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "support/scenes.hpp"

namespace independent_coordinates_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

Scene shipped(const std::string& name) { return load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/" + name + ".toml"); }

/// Mechanisms of one, two and three freedoms.
Scene slider_crank() { return shipped("slider-crank"); }
Scene one_freedom() {
  Scene scene = shipped("slider-crank-torque");
  scene.stabilisation = {};
  return scene;
}
Scene three_freedoms() {  // the crank turns freely
  Scene scene = shipped("slider-crank");
  std::erase_if(scene.constraints, [](const SceneConstraint& each) { return each.is_driver(); });
  return scene;
}

struct Prepared {
  explicit Prepared(const Scene& scene, bool ledger = false)
      : system(planar_system<double>(scene)), ode(system, ledger), start(scene_start<double>(scene)) {
    assemble_start(system, 0.0, scene_units(scene).mechanism, start);
    start.resize(ode.dimension(), 0.0);
    const double length = scene_units(scene).length;
    for (std::size_t i = 0; i < system.coordinates(); ++i)
      units.push_back(i % 3 == 2 ? length / scene_units(scene).mechanism : length);
  }
  PlanarSystem<double> system;
  MultibodyOde<double> ode;
  std::vector<double> start, units;
};

using SmallOde = IndependentOde<InPlane<double>, run_time_size>;

/// (z, ż) of a start, moved: a film's eccentricities and velocities, or coordinates.
std::vector<double> moved(SmallOde& small, const Prepared& prepared, const Scene& scene, double by) {
  std::vector<double> x;
  small.take(prepared.start, x);
  const std::size_t f = small.freedoms();
  for (std::size_t k = 0; k < f; ++k) {
    const double size = small.chart().is_of_joint(k) ? scene.joints[small.chart().joint_of(k)].clearance : 0.1;
    x[k] += by * size * (k % 2 ? -0.3 : 0.4);
    x[f + k] += by * size * 100 * (k % 2 ? 0.7 : 0.2);
  }
  return x;
}

double largest_constraint(const PlanarSystem<double>& system, double t, const std::vector<double>& y) {
  SystemWorkspace<double> w = system.workspace<double>();
  system.evaluate_kinematics(t, y.data(), w);
  double largest = 0;
  for (const auto& row : w.rows) largest = std::max(largest, std::abs(row.value));
  return largest;
}

}  // namespace

TEST_CASE("listed LU: solutions are those of a dense solver, both ways, in the order found at another matrix") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const std::size_t n : {1, 2, 5, 9, 20}) {
    CAPTURE(n);
    std::vector<std::uint32_t> places(n * n, ListedLu<double>::none);
    std::vector<double> first(n * n, 0.0);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (j != (i * 7 + 3) % n && number(random) > -0.4) continue;
        places[i * n + j] = count++;
        first[i * n + j] = number(random) + (j == (i * 7 + 3) % n ? 3 : 0);
      }
    }
    ListedLu<double> lu;
    REQUIRE(lu.find_order(n, first, places, count));
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    std::vector<double> values(lu.storage());
    for (std::size_t i = 0; i < n * n; ++i) {
      if (places[i] == ListedLu<double>::none) continue;
      const double value = first[i] * (1 + 0.1 * number(random));
      values[places[i]] = value;
      a(static_cast<Eigen::Index>(i / n), static_cast<Eigen::Index>(i % n)) = value;
    }
    lu.factorise(values.data());
    Eigen::VectorXd b(static_cast<Eigen::Index>(n)), x = b, work = b;
    for (Eigen::Index i = 0; i < b.size(); ++i) b(i) = number(random);
    lu.solve(values.data(), b.data(), x.data(), work.data());
    CHECK((a * x - b).norm() < 1e-12 * b.norm());  // pivots of a fifth: rounding grows by less than 5^k of few k
    lu.solve_transposed(values.data(), b.data(), x.data(), work.data());
    CHECK((a.transpose() * x - b).norm() < 1e-12 * b.norm());  // likewise
  }
  ListedLu<double> lu;
  CHECK_FALSE(lu.find_order(2, {1, 2, 2, 4}, {0, 1, 2, 3}, 4));
}

TEST_CASE("independent coordinates: accelerations and reactions are those of the multipliers' equations") {
  for (const Scene& scene : {slider_crank(), one_freedom(), three_freedoms()}) {
    CAPTURE(scene.name);
    Prepared prepared(scene, true);
    SmallOde small(prepared.ode, prepared.units);
    small.choose(0, prepared.start);
    REQUIRE(small.freedoms() == prepared.system.coordinates() - prepared.system.constraint_rows());
    const std::size_t n = prepared.system.coordinates();
    const std::size_t f = small.freedoms();
    for (const double t : {0.0, 1e-4}) {
      const std::vector<double> x = moved(small, prepared, scene, 1);
      std::vector<double> rate(x.size()), y, y_rate(prepared.ode.dimension()), expected(prepared.ode.dimension());
      small.rate(x, rate, t);
      small.expand(t, x, y);
      CHECK(largest_constraint(prepared.system, t, y) < 2e-16);  // of mechanisms of 0.17 m
      small.expand_rate(rate, y_rate);
      prepared.ode.rate(y, expected, t);
      double scale = 0;
      for (std::size_t i = n; i < 2 * n; ++i) scale = std::max(scale, std::abs(expected[i]));
      for (std::size_t i = n; i < 2 * n; ++i)
        CHECK(std::abs(y_rate[i] - expected[i]) < 1e-11 * scale);  // condition 1e4
      for (std::size_t i = 2 * n; i < y.size(); ++i) {  // powers, with the driver's moment from its multiplier
        const double size = std::max(1.0, std::abs(expected[i]));
        CHECK(std::abs(rate[2 * f + i - 2 * n] - expected[i]) < 1e-10 * size);  // likewise, times speeds
      }
    }
  }
}

TEST_CASE("independent coordinates: the exact Jacobian and slope in time are those of differences") {
  for (const Scene& scene : {slider_crank(), one_freedom(), three_freedoms()}) {
    CAPTURE(scene.name);
    Prepared prepared(scene, true);
    SmallOde small(prepared.ode, prepared.units);
    small.choose(0, prepared.start);
    const std::vector<double> x = moved(small, prepared, scene, 1);
    const double t = 1e-4;
    SmallOde::Jacobian exact;
    small.jacobian(x, exact, t);
    const auto size = static_cast<Eigen::Index>(x.size());
    const std::size_t f = small.freedoms();
    const auto difference = [&](auto&& at) {  // of order 4
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(size);
      std::vector<double> rate(x.size());
      for (const auto& [shift, weight] : {std::pair(1.0, 8.0), {-1.0, -8.0}, {2.0, -1.0}, {-2.0, 1.0}}) {
        at(shift, rate);
        sum += weight / 12 * Eigen::Map<Eigen::VectorXd>(rate.data(), size);
      }
      return sum;
    };
    for (std::size_t j = 0; j < 2 * f; ++j) {
      const bool of_joint = small.chart().is_of_joint(j % f);
      const double h = (of_joint ? scene.joints.front().clearance : 0.1) * 1e-3 * (j < f ? 1 : 100);
      const Eigen::VectorXd column = difference([&](double shift, std::vector<double>& rate) {
                                       std::vector<double> near = x;
                                       near[j] += shift * h;
                                       small.rate(near, rate, t);
                                     }) /
                                     h;
      CAPTURE(j);
      const Eigen::VectorXd given = exact.col(static_cast<Eigen::Index>(j));
      CHECK((given - column).norm() < 1e-7 * column.norm());  // differences in steps of a thousandth lose so much
    }
    std::vector<double> slope(x.size());
    small.time_slope(x, slope, t);
    const double h = 1e-6;
    const Eigen::VectorXd by_difference =
        difference([&](double shift, std::vector<double>& rate) { small.rate(x, rate, t + shift * h); }) / h;
    const Eigen::Map<Eigen::VectorXd> given(slope.data(), size);
    std::vector<double> rate(x.size());
    small.rate(x, rate, t);
    const double noise = 3e-13 * Eigen::Map<Eigen::VectorXd>(rate.data(), size).norm() / h;
    CHECK((given - by_difference).norm() < 1e-6 * by_difference.norm() + noise);  // 0.17 m by clearances, times 2^-53
  }
}

TEST_CASE(
    "independent coordinates: the forces' part of the Jacobian is what a film of ten times the viscosity changes") {
  for (Scene scene : {slider_crank(), three_freedoms()}) {
    CAPTURE(scene.name);
    const auto matrices = [&](double viscosity) {
      scene.joints.front().viscosity = viscosity;
      Prepared prepared(scene);
      SmallOde small(prepared.ode, prepared.units);
      small.choose(0, prepared.start);
      REQUIRE(small.has_force_part());
      const std::vector<double> x = moved(small, prepared, scene, 1);
      SmallOde::Jacobian whole, part;
      small.jacobian(x, whole, 1e-4);
      part.setConstant(whole.rows(), whole.cols(), 7);
      small.force_part(x, part, 1e-4);
      const Eigen::Index f = whole.rows() / 2;
      return std::pair<Eigen::MatrixXd, Eigen::MatrixXd>(whole.bottomRows(f), part.bottomRows(f));
    };
    const auto [thin, thin_part] = matrices(0.4);
    const auto [thick, thick_part] = matrices(4);
    const Eigen::Index f = thin.rows();
    for (const Eigen::Index of : {Eigen::Index(0), f}) {  // by z and by ż, which have other units
      const Eigen::MatrixXd by_film = (thick - thin).middleCols(of, f);
      const Eigen::MatrixXd by_part = (thick_part - thin_part).middleCols(of, f);
      // Left out are the moment of the film's force on the bearing's body, e in its arm, and what places have to do with
      // it: a clearance in the length of the rod.
      CHECK((by_film - by_part).norm() < 0.02 * by_film.norm());
    }
    CHECK((thick_part - 10 * thin_part).norm() < 1e-12 * thick_part.norm());  // F is linear in the viscosity
  }
  const Scene ideal = one_freedom();
  Prepared prepared(ideal);
  SmallOde small(prepared.ode, prepared.units);
  small.choose(0, prepared.start);
  CHECK_FALSE(small.has_force_part());
}

TEST_CASE("independent coordinates: what the time alone prescribes is found apart") {
  const auto prescribed = [](const Scene& scene) {
    Prepared prepared(scene);
    SmallOde small(prepared.ode, prepared.units);
    small.choose(0, prepared.start);
    const auto& parts = small.chart().parts();
    CHECK(parts.prescribed().size() + parts.free().size() == prepared.system.coordinates());
    return parts.prescribed().columns;
  };
  const Scene scene = slider_crank();
  REQUIRE(scene.bodies[0].name == "crank");
  REQUIRE(scene.bodies[2].name == "slider");
  const std::vector<std::size_t> of_slider{7, 8};  // across its guide, and its angle
  CHECK(prescribed(scene) == std::vector<std::size_t>{0, 1, 2, 7, 8});
  CHECK(prescribed(three_freedoms()) == of_slider);
  CHECK(prescribed(one_freedom()) == of_slider);
}

TEST_CASE("independent coordinates: of a known size, without a ledger and from places near by they are the same") {
  const Scene scene = slider_crank();
  Prepared with(scene, true), without(scene);
  SmallOde general(with.ode, with.units);
  IndependentOde<InPlane<double>, 4> small(without.ode, without.units);
  small.choose(0, without.start);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1, 1);
  std::array<double, 4> at{}, rate{};
  small.take(without.start, at);
  const std::array<double, 4> start = at;
  Eigen::Matrix4d j;
  SmallOde::Jacobian whole;
  double t = 0;
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    // Three times in turn, near by, as of the stages of a step, and every so often a step to new ones.
    if (trial % 12 == 0) t += 2e-4;
    const double now = t + 5e-5 * (trial % 3);
    for (std::size_t k = 0; k < 2; ++k) {
      at[k] = start[k] + 1e-4 * part(random) * std::pow(10.0, -(trial % 12) / 3);
      at[2 + k] = 0.02 * part(random);
    }
    small.rate(at, rate, now);
    general.choose(0, with.start);  // forgets all places
    std::vector<double> x(general.dimension()), x_rate(x.size());
    general.take(with.start, x);
    std::copy(at.begin(), at.end(), x.begin());
    general.rate(x, x_rate, now);
    double scale = 0;
    for (std::size_t i = 2; i < 4; ++i) scale = std::max(scale, std::abs(x_rate[i]));
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(rate[i] - x_rate[i]) < 1e-12 * scale);  // condition 1e3
    std::vector<double> y, other;
    small.expand(now, at, y);
    general.expand(now, x, other);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double size = i < 9 ? 1 : 1e3;              // rad and m; 1/s
      CHECK(std::abs(y[i] - other[i]) < 2e-15 * size);  // a few units of rounding
    }
    CHECK(largest_constraint(without.system, now, y) < 2e-16);  // of a mechanism of 0.17 m
    if (trial % 5 != 0) continue;
    small.jacobian(at, j, now);
    general.jacobian(x, whole, now);
    const double largest = j.cwiseAbs().maxCoeff();
    CHECK((j - whole.topLeftCorner(4, 4)).cwiseAbs().maxCoeff() < 1e-12 * largest);  // condition 1e3
  }
}

TEST_CASE("independent coordinates: after a search that finds no places the next one starts from the last good ones") {
  const Scene scene = slider_crank();
  Prepared prepared(scene);
  SmallOde small(prepared.ode, prepared.units);
  small.choose(0, prepared.start);
  const std::vector<double> good = moved(small, prepared, scene, 1);
  std::vector<double> far = good, nan = good, expected(good.size()), rate(good.size());
  far[1] += 1;  // a metre off the slider's guide: no rod is so long
  nan[1] = std::nan("");
  small.rate(good, expected, 1e-4);
  const auto same = [&] {
    small.rate(good, rate, 1e-4);
    double scale = 0;
    for (const double each : expected) scale = std::max(scale, std::abs(each));
    for (std::size_t i = 0; i < rate.size(); ++i) CHECK(std::abs(rate[i] - expected[i]) < 1e-12 * scale);  // rounding
  };
  for (const std::vector<double>* bad : {&far, &nan}) {
    for (const double t : {1e-4, 2e-4}) {  // where places are known, and at a new time
      CHECK_THROWS_AS(small.rate(*bad, rate, t), SingularConstraints);
      same();
    }
    std::vector<double> x;
    small.take(prepared.start, x);  // nothing is known then
    CHECK_THROWS_AS(small.rate(*bad, rate, 1e-4), SingularConstraints);
    same();
  }
  // Places far off that are found, and have no film: what is found from there may be another assembly, or nothing.
  for (int i = 0; i < 60; ++i) {
    std::vector<double> off = good;
    off[0] += 0.15 * std::sin(1.7 * i);
    off[1] += 0.15 * std::cos(2.3 * i);
    CHECK_THROWS_AS(small.rate(off, rate, i % 2 ? 1e-4 : 2e-4), std::domain_error);
    same();
  }
}

TEST_CASE("independent coordinates: the golden trajectories are followed about as closely as in absolute ones") {
  for (const char* name : {"slider-crank", "slider-crank-c0.1-mu0.4", "slider-crank-c0.5-mu0.4",
                           "slider-crank-c0.2-mu0.04", "slider-crank-c0.5-mu0.04"}) {
    CAPTURE(name);
    Scene scene = shipped(name);
    const std::string file = LUBJOINT_SOURCE_DIR "/data/golden/trajectories/" + std::string(name) + ".csv";
    const reports::CsvTable golden(reports::read_input(file), name);
    set_tolerance(scene, 1e-14);
    scene.run.stop_at_outputs = true;
    scene.run.output_interval = golden.number(0, golden.column("t"));
    std::array<double, 2> error{};
    for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
      scene.coordinates = coordinates;
      const MultibodyTrajectory run = simulate_multibody(scene);
      REQUIRE(run.outcome.status == RunStatus::finished);
      REQUIRE(run.samples.size() == golden.rows() + 1);
      double& worst = error[coordinates == SceneCoordinates::independent];
      for (std::size_t row = 0; row < golden.rows(); ++row) {
        const Vector2<double> e = run.samples[row + 1].joints[0].eccentricity / scene.joints[0].clearance;
        const Vector2<double> expected(golden.number(row, golden.column("gudgeon-pin.ex_over_c")),
                                       golden.number(row, golden.column("gudgeon-pin.ey_over_c")));
        worst = std::max(worst, (e - expected).norm());
      }
    }
    CHECK(error[1] < 1e-10);         // some thousand steps of 1e-14
    CHECK(error[1] < 4 * error[0]);  // 0.1 to 2.2 of it were measured, in a quarter to 1.1 of the steps
  }
}

TEST_CASE("independent coordinates: constraints hold to rounding over 1000 revolutions, and the ledger closes") {
  Scene scene = slider_crank();
  scene.coordinates = SceneCoordinates::independent;
  scene.energy_ledger = true;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-6;
  const double turn = scene.run.duration / 2;
  std::vector<double> residual;
  for (const int turns : {100, 1000}) {
    scene.run.duration = turns * turn;
    scene.run.output_interval = scene.run.duration / 10;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    // Angles of 6283 rad have steps of 9e-13, which Φ of the driver shows; lengths of 0.17 m those of 3e-17.
    CHECK(run.drift.position < 2e-12);
    residual.push_back(*run.energy_residual / run.energy_scale);
  }
  CHECK(residual[1] < 10 * residual[0] * 1.5);  // at most as the time
}

TEST_CASE("independent coordinates: a chart that wears out is replaced between two steps, unseen") {
  // A crank-rocker: its rocker's angle is no coordinate where the coupler and the crank are in line.
  Scene scene;
  scene.file = scene.name = "crank-rocker";
  const double crank = 0.1, coupler = 0.25, rocker = 0.2, base = 0.25;
  const double diagonal = std::hypot(base, crank);  // the crank upright
  const double at_base =
      std::acos((rocker * rocker + diagonal * diagonal - coupler * coupler) / (2 * rocker * diagonal));
  const double angle = std::numbers::pi - std::atan2(crank, base) - at_base;
  const Vector2<double> end(base + rocker * std::cos(angle), rocker * std::sin(angle));
  const Vector2<double> pin(0, crank);
  scene.bodies = {body("rocker", 0.2, 1e-3, 0.5 * (Vector2<double>(base, 0) + end)),
                  body("coupler", 0.2, 1e-3, 0.5 * (pin + end)), body("crank", 1, 1e-2, 0.5 * pin)};
  scene.bodies[0].angle = angle;
  scene.bodies[1].angle = std::atan2(end.y() - pin.y(), end.x() - pin.x());
  scene.bodies[2].angle = std::numbers::pi / 2;
  scene.bodies[2].spin = 20;
  scene.gravity = {0, -9.81};
  const auto joint = [](const char* name, BodyPoint<double> first, BodyPoint<double> second) {
    return SceneConstraint{name, Revolute<double>{first, second}};
  };
  scene.constraints = {joint("a", {ground_body, {0, 0}}, {2, {-crank / 2, 0}}),
                       joint("b", {2, {crank / 2, 0}}, {1, {-coupler / 2, 0}}),
                       joint("c", {1, {coupler / 2, 0}}, {0, {rocker / 2, 0}}),
                       joint("d", {ground_body, {base, 0}}, {0, {-rocker / 2, 0}})};
  scene.run.duration = 2;
  scene.run.output_interval = 0.01;
  set_tolerance(scene, 1e-13);
  Prepared prepared(scene);
  std::vector<double> tolerances = scene_tolerances<double>(scene);
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    if (i % 9 >= 3) tolerances[i] *= 1e3;  // so that the rocker is chosen, as the body that is known best
  }
  IndependentIntegrator<InPlane<double>, run_time_size> method(
      prepared.ode, {0, tolerances, 1e-13, 0}, {},
      [](const auto& tolerance) { return make_integrator<run_time_size>("radau_iia5", tolerance); });
  std::vector<double> y = prepared.start;
  double t = 0, dt = 1e-5, worst = 0;
  while (t < scene.run.duration) {
    dt = std::min(dt, scene.run.duration - t);
    if (method.try_step(prepared.ode, y, t, dt)) worst = std::max(worst, largest_constraint(prepared.system, t, y));
  }
  CHECK(method.charts() > 1);
  CHECK(worst < 3e-16);  // lengths of 0.25 m
  set_tolerance(scene, 1e-11);
  scene.coordinates = SceneCoordinates::absolute;
  scene.stabilisation.projection = true;
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  for (std::size_t i = 0; i < y.size(); ++i) {
    CHECK(y[i] == Approx(run.samples.back().state[i]).margin(1e-7));  // two methods at 1e-11 over a dozen turns
  }
  scene.coordinates = SceneCoordinates::independent;
  scene.stabilisation = {};
  const MultibodyTrajectory other = simulate_multibody(scene);
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      CHECK(other.samples[i].state[k] == Approx(run.samples[i].state[k]).margin(1e-8));  // within steps, too
    }
  }
}

TEST_CASE("independent coordinates: auto picks them where they are few, and says why") {
  const auto chosen = [](const Scene& scene) { return choose_coordinates(scene, planar_system<double>(scene)); };
  CHECK(chosen(slider_crank()).independent);
  CHECK(chosen(slider_crank()).reason == "2 degrees of freedom in 9 coordinates");
  Scene scene = slider_crank();
  scene.stabilisation.asked = true;
  CHECK_FALSE(chosen(scene).independent);
  CHECK_THAT(chosen(scene).reason, Contains("stabilisation"));
  CHECK_FALSE(chosen(shipped("slider-crank-ideal")).independent);
  CHECK(chosen(shipped("slider-crank-ideal")).reason.size() > 0);
  scene = shipped("slider-crank-ideal");
  scene.stabilisation = {};
  CHECK(chosen(scene).reason == "the constraints prescribe all motion");
  scene.coordinates = SceneCoordinates::independent;
  CHECK_THROWS_WITH(chosen(scene), Contains("prescribe all motion") && Contains("\"absolute\""));
  scene = slider_crank();
  scene.coordinates = SceneCoordinates::absolute;
  CHECK_FALSE(chosen(scene).independent);
  CHECK(chosen(scene).reason.empty());
}

TEST_CASE("independent coordinates: what a scene may ask for is refused by name where it makes no sense") {
  const std::string text = reports::read_input(LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml");
  const auto with = [&](const std::string& value, const std::string& more = "") {
    std::string changed = text;
    const std::string line = "coordinates = \"auto\"";
    changed.replace(changed.find(line), line.size(), "coordinates = " + value);
    return changed + more;
  };
  CHECK(parse_scene(with("\"absolute\""), "s.toml").coordinates == SceneCoordinates::absolute);
  CHECK(parse_scene(with("\"independent\""), "s.toml").coordinates == SceneCoordinates::independent);
  CHECK_THROWS_WITH(parse_scene(with("\"minimal\""), "s.toml"),
                    Contains("coordinates is \"minimal\"") && Contains("\"auto\", \"independent\" or \"absolute\""));
  CHECK_THROWS_WITH(parse_scene(with("2"), "s.toml"), Contains("coordinates"));
  CHECK_THROWS_WITH(parse_scene(with("\"independent\"", "[stabilisation]\nmethod = \"projection\"\n"), "s.toml"),
                    Contains("beside a stabilisation table"));
  const std::string journal = reports::read_input(LUBJOINT_SOURCE_DIR "/data/scenes/journal.toml");
  for (const char* value : {"\"absolute\"", "\"independent\""}) {
    CHECK_THROWS_WITH(parse_scene("coordinates = " + std::string(value) + "\n" + journal, "s.toml"),
                      Contains("without constraints"));
  }
  CHECK_NOTHROW(parse_scene("coordinates = \"auto\"\n" + journal, "s.toml"));
}

TEST_CASE("independent coordinates: a way that a motor makes pass 0 is followed at any tolerance, by every method") {
  Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/examples/shaker.toml");
  scene.run.duration = scene.run.output_interval = 1;
  const auto run_with = [&](const std::string& integrator, double tolerance, SceneCoordinates coordinates) {
    scene.integrator = integrator;
    scene.coordinates = coordinates;
    scene.stabilisation = {};
    scene.stabilisation.projection = coordinates == SceneCoordinates::absolute;
    set_tolerance(scene, tolerance);
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(integrator << " at " << tolerance << ": " << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    return run.samples.back().state;
  };
  const std::vector<double> wanted = run_with("radau_iia5", 1e-11, SceneCoordinates::absolute);
  const auto distance = [&](const std::vector<double>& state) {
    double largest = 0;  // of places in m and rad
    for (std::size_t i = 0; i < 9; ++i) largest = std::max(largest, std::abs(state[i] - wanted[i]));
    return largest;
  };
  for (const std::string integrator : {"radau_iia5", "radau_iia9", "rosenbrock4", "dopri5", "fehlberg78",
                                       "bulirsch_stoer", "adams_bashforth_moulton"}) {
    for (const double tolerance : {1e-6, 1e-9, 1e-11}) {
      const std::vector<double> state = run_with(integrator, tolerance, SceneCoordinates::independent);
      CHECK(distance(state) < 1e3 * tolerance);  // some hundred steps, each off by a tolerance of some 0.1 m at most
    }
  }
}

}  // namespace independent_coordinates_test
