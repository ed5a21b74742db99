// Loads and drivers from tables: what files may say, what lies between their rows, and motions that are known exactly.
#include <math.h>  // isnan without std::, which Boost's interpolators ask for

#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lubjoint/number/dual.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/trajectory_table.hpp"
#include "support/temporary_folder.hpp"

namespace table_load_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// A body that flies freely, another on a pin, and a third on a guide.
const std::string head = R"(name = "s"
duration = 2.0
[[bodies]]
name = "free"
mass = 2.0
inertia = 0.5
[[bodies]]
name = "rotor"
mass = 1.0
inertia = 0.25
position = [1.0, 0.0]
spin = 3.0
[[bodies]]
name = "slider"
mass = 4.0
inertia = 1.0
position = [0.0, 2.0]
[[constraints]]
name = "pin"
type = "revolute"
first = {body = "ground", point = [1.0, 0.0]}
second = {body = "rotor"}
[[constraints]]
name = "guide"
type = "translational"
first = {body = "ground", point = [-1.0, 2.0]}
axis = [1.0, 0.0]
second = {body = "slider"}
[integrator]
relative_tolerance = 1e-11
[output]
interval = 0.01
energy_ledger = true
)";

struct Files {
  TemporaryFolder folder;
  std::string scene(const std::string& tail) const { return folder.write("s.toml", head + tail); }
};

/// The message of a scene's refusal; "accepted" if there is none.
std::string refusal(const Files& files, const std::string& tail) {
  try {
    load_scene(files.scene(tail));
    return "accepted";
  } catch (const SceneError& error) {
    return error.what();
  }
}

MultibodyTrajectory finished(const Scene& scene) {
  MultibodyTrajectory run = simulate_multibody(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(*run.energy_residual < 1e-9 * run.energy_scale);  // 100 times the tolerance, over some hundred steps
  return run;
}

/// A column of a run's table.
std::vector<double> column(const Scene& scene, const MultibodyTrajectory& run, const std::string& name) {
  const TrajectoryTable table = trajectory_table(scene, run);
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  REQUIRE(found != table.columns.end());
  std::vector<double> values;
  for (const auto& row : table.rows) values.push_back(*row[static_cast<std::size_t>(found - table.columns.begin())]);
  return values;
}

const std::string on_free = "[[loads]]\nbody = \"free\"\ntable = \"f.csv\"\n";

}  // namespace

TEST_CASE("tables: what a file may not say is refused with its line, and so is what the scene may not say of it") {
  const Files files;
  const auto with = [&](const std::string& csv, const std::string& tail = on_free) {
    files.folder.write("f.csv", csv);
    return refusal(files, tail);
  };
  CHECK(with("# N\nt,fx,fy\n0,1,2\n\n2, 3,4\n") == "accepted");
  CHECK_THAT(with("time,fx\n0,1\n2,3\n"),
             Contains("f.csv:1: the first column is \"time\"; allowed is one of t, angle"));
  CHECK_THAT(with("t,fz\n0,1\n2,3\n"), Contains("f.csv:1: a column is \"fz\"; allowed is one of fx, fy, moment"));
  CHECK_THAT(with("t,fx,fx\n0,1,1\n2,3,3\n"), Contains("f.csv:1: column \"fx\" is there twice"));
  CHECK_THAT(with("t\n0\n2\n"), Contains("f.csv:1: one column alone"));
  CHECK_THAT(with("t,fx\n0,1\n2\n"), Contains("f.csv:3: 1 fields; allowed is 2"));
  CHECK_THAT(with("t,fx\n0,1\n2,x\n"), Contains("f.csv:3: column fx is \"x\"; allowed is a finite number"));
  CHECK_THAT(with("t,fx\n0,1\n2,inf\n"), Contains("f.csv:3: column fx is \"inf\""));
  CHECK_THAT(with("t,fx\n0,1\n0,2\n"), Contains("f.csv:3: t is 0 after 0; allowed is a number above"));
  CHECK_THAT(with("t,fx\n0,1\n"), Contains("the table has 1 rows; allowed is two or more"));
  CHECK_THAT(with(""), Contains("f.csv:1: no header"));
  CHECK_THAT(with("t,fx\n0,1\n1,3\n"),
             Contains("loads[0].table is a table from 0 s to 1 s; allowed is one that covers the run, 0 s to 2 s"));
  CHECK(with("t,fx\n0,1\n1,1\n", on_free + "periodic = true\n") == "accepted");
  CHECK_THAT(with("t,fx\n0,1\n1,3\n", on_free + "periodic = true\n"),
             Contains("a periodic table whose fx is 1 in its first row and 3 in its last"));
  CHECK_THAT(with("t,fx\n0,1\n1e-9,1\n", on_free + "periodic = true\n"),
             Contains("a table whose rows the run passes 2e+09 times; allowed is at most 1000000 rows in a run"));
  {  // or by the duration that a run is given
    CHECK(with("t,fx\n0,1\n1e-3,1\n", on_free + "periodic = true\n") == "accepted");
    Scene longer = load_scene(files.folder / "s.toml");
    CHECK(scene_knots(longer).size() == 1999);  // within 2 s
    longer.run.duration = 1e9;
    CHECK_THROWS_WITH(
        simulate_multibody(longer),
        Contains("loads[0] has a table whose rows the run passes 1e+12 times; allowed are at most 1000000"));
  }
  CHECK_THAT(with("t,fx\n0,1\n2,3\n", on_free + "interpolation = \"cubic\"\n"),
             Contains("interpolation is \"cubic\"; allowed is one of linear, pchip, makima"));
  CHECK_THAT(with("t,fx\n0,1\n2,3\n", on_free + "interpolation = \"pchip\"\n"), Contains("four rows or more"));
  CHECK_THAT(with("t,fx\n0,1\n2,3\n", on_free + "against = \"rotor\"\n"),
             Contains("against is given for a table over t"));
  CHECK_THAT(with("t,moment\n0,1\n2,3\n", on_free + "point = [0.1, 0.0]\n"),
             Contains("point is given for a moment alone"));
  CHECK_THAT(with("t,fx\n0,1\n2,3\n", on_free + "force = [1.0, 0.0]\n"), Contains("unknown key loads[0].force"));
  CHECK_THAT(with("t,fx\n0,1\n2,3\n", "[[loads]]\nbody = \"free\"\ntable = \"g.csv\"\n"),
             Contains("loads[0].table is \"g.csv\", and there is no file") && Contains("relative to the scene"));
  const std::string turn = "angle,moment\n0,1\n3,-1\n6.283185307179586,1\n";
  const std::string on_rotor = "[[loads]]\nbody = \"rotor\"\ntable = \"f.csv\"\n";
  CHECK(with(turn, on_rotor + "against = \"rotor\"\n") == "accepted");
  CHECK_THAT(with(turn, on_rotor), Contains("loads[0].against is missing"));
  CHECK_THAT(with(turn, on_rotor + "against = \"rotor\"\nperiodic = true\n"),
             Contains("such a table always is periodic"));
  CHECK_THAT(with("angle,moment\n0,1\n360,1\n", on_rotor + "against = \"rotor\"\n"),
             Contains("a table over 360 rad of angle") && Contains("angles are in rad"));
  // An end that is put at its whole revolutions stays above the row before it.
  CHECK_THAT(
      with("# rad\nangle,moment\n0,1\n6.2831855,2\n6.283186,1\n", on_rotor + "against = \"rotor\"\n"),
      Contains("f.csv:4: angle is 6.2831855 rad in the last row but one; allowed is an angle below the end of the "
               "table's whole revolutions, 6.28318530718 rad"));
  // Columns of a force are a force, whatever stands in them.
  CHECK(with("t,fx,fy,moment\n0,0,0,1\n2,0,0,3\n", on_free + "point = [0.1, 0.0]\n") == "accepted");
  // A body that a motor turns passes the rows of a table as often as its speed says: refused by the run's own duration.
  const std::string spun = on_rotor + "against = \"rotor\"\n[[constraints]]\nname = \"motor\"\ntype = \"driver\"\n" +
                           "body = \"rotor\"\nspeed = 3.0\n";
  CHECK(with(turn, spun) == "accepted");
  Scene fast = load_scene(files.folder / "s.toml");
  CHECK(scene_knots(fast).size() == 1);  // 3 rad alone: the run ends at 6 rad
  fast.run.duration = 1e9;
  CHECK_THROWS_WITH(simulate_multibody(fast),
                    Contains("loads[0] has a table whose rows the run passes 9.5493e+08 times"));
  // The command line may ask for more than the file covers.
  files.folder.write("f.csv", "t,fx\n0,1\n2,3\n");
  Scene scene = load_scene(files.scene(on_free));
  scene.run.duration = 3;
  CHECK_THROWS_WITH(simulate_multibody(scene), Contains("loads[0] has a table from 0 s to 2 s, and the run needs it"));
}

TEST_CASE("tables: between rows lies what Boost's interpolators have there, and derivatives are exact") {
  const Files files;
  const std::vector<double> t{0, 0.3, 0.7, 1.2, 1.5, 2};
  const std::vector<double> f{1, 4, 2, -3, -3.5, 6};
  std::string csv = "t,fy\n";
  for (std::size_t i = 0; i < t.size(); ++i) csv += std::to_string(t[i]) + "," + std::to_string(f[i]) + "\n";
  files.folder.write("f.csv", csv);
  const auto curves = [&](const std::string& interpolation) {
    return *load_scene(files.scene(on_free + "interpolation = \"" + interpolation + "\"\n")).loads[0].table->curves;
  };
  using Points = std::vector<double>;
  const boost::math::interpolators::pchip<Points> pchip{Points(t), Points(f)};
  const boost::math::interpolators::makima<Points> makima{Points(t), Points(f)};
  const TableCurves<3> by_pchip = curves("pchip");
  const TableCurves<3> by_makima = curves("makima");
  const TableCurves<3> by_line = curves("linear");
  for (double x = 0.01; x < 2; x += 0.037) {
    CHECK(by_pchip.at(x)[1] == Approx(pchip(x)).epsilon(1e-13));  // rounding
    CHECK(by_makima.at(x)[1] == Approx(makima(x)).epsilon(1e-13));
    CHECK(by_makima.at(x)[0] == 0);
    for (const TableCurves<3>* table : {&by_pchip, &by_makima, &by_line}) {
      const auto exact = table->with_derivatives(x);
      const auto dual = table->with_derivatives(Dual<double, 1>::variable(x, 0));
      CHECK(dual.value[1].derivatives()(0) == Approx(exact.slope[1]).margin(1e-13));  // rounding
      CHECK(dual.slope[1].derivatives()(0) == Approx(exact.curvature[1]).margin(1e-12));
      CHECK(table->scaled(-2).at(x)[1] == Approx(-2 * exact.value[1]).margin(1e-15));
    }
  }
  CHECK(by_line.at(0.5)[1] == Approx(3).epsilon(1e-15));
  // A periodic table goes on as smoothly at its ends as at any other row.
  files.folder.write("f.csv", "t,fy\n0,1\n0.3,4\n0.7,2\n1.2,-3\n1.5,1\n");
  for (const std::string interpolation : {"pchip", "makima"}) {
    const auto table =
        *load_scene(files.scene(on_free + "periodic = true\ninterpolation = \"" + interpolation + "\"\n"))
             .loads[0]
             .table->curves;
    CHECK(table.at(0.4 + 3 * 1.5)[1] == Approx(table.at(0.4)[1]).epsilon(1e-13));
    CHECK(table.at(0.4 - 2 * 1.5)[1] == Approx(table.at(0.4)[1]).epsilon(1e-13));
    const double before = table.with_derivatives(1.5 - 1e-9).slope[1];
    CHECK(before == Approx(table.with_derivatives(0.0).slope[1]).epsilon(1e-6));  // 1e-9 s of a curvature of some 100
  }
}

TEST_CASE("tables: a force over time moves a body as its integrals say, and a later start goes on with the table") {
  const Files files;
  files.folder.write("f.csv", "t,fx,moment\n0,0,1\n0.5,4,1\n1,-2,0\n2.5,1,3\n");
  const Scene scene = load_scene(files.scene(on_free));
  const MultibodyTrajectory run = finished(scene);
  // Velocity and place of a force that is a straight line between rows.
  const auto exact = [](double t) {
    const std::vector<double> knots{0, 0.5, 1, 2.5};
    const std::vector<double> values{0, 4, -2, 1};
    double x = 0;
    double v = 0;
    for (std::size_t k = 0; k < 3 && knots[k] < t; ++k) {
      const double h = std::min(t, knots[k + 1]) - knots[k];
      const double slope = (values[k + 1] - values[k]) / (knots[k + 1] - knots[k]);
      x += v * h + (values[k] * h * h / 2 + slope * h * h * h / 6) / 2;  // mass 2 kg
      v += (values[k] * h + slope * h * h / 2) / 2;
    }
    return std::pair(x, v);
  };
  const std::vector<double> x = column(scene, run, "free.x");
  const std::vector<double> v = column(scene, run, "free.vx");
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(x[i] == Approx(exact(run.samples[i].t).first).margin(1e-11));  // the run's tolerance
    CHECK(v[i] == Approx(exact(run.samples[i].t).second).margin(1e-11));
  }
}

TEST_CASE("tables: a moment over a body's angle gives it the energy under the curve, through every revolution") {
  const Files files;
  // A pulse and a brake, over one revolution; the knots are places, not times.
  files.folder.write("f.csv", "angle,moment\n0,0\n1,6\n1.5,0\n4,-1\n6.283185307179586,0\n");
  for (const double spin : {3.0, -3.0}) {
    Scene scene = load_scene(files.scene("[[loads]]\nbody = \"rotor\"\ntable = \"f.csv\"\nagainst = \"rotor\"\n"));
    scene.bodies[1].spin = spin;
    const MultibodyTrajectory run = finished(scene);
    const auto work = [](double angle) {
      const std::vector<double> knots{0, 1, 1.5, 4, 2 * std::numbers::pi};
      const std::vector<double> values{0, 6, 0, -1, 0};
      const double turns = std::floor(angle / (2 * std::numbers::pi));
      const auto up_to = [&](double rest) {
        double sum = 0;
        for (std::size_t k = 0; k < 4 && knots[k] < rest; ++k) {
          const double h = std::min(rest, knots[k + 1]) - knots[k];
          sum += values[k] * h + (values[k + 1] - values[k]) / (knots[k + 1] - knots[k]) * h * h / 2;
        }
        return sum;
      };
      return turns * up_to(2 * std::numbers::pi) + up_to(angle - turns * 2 * std::numbers::pi);
    };
    const std::vector<double> angle = column(scene, run, "rotor.phi");
    const std::vector<double> omega = column(scene, run, "rotor.omega");
    CHECK(std::abs(angle.back()) > 4);  // past several knots
    for (std::size_t i = 0; i < angle.size(); ++i)
      // 100 tolerances of the start's 9 rad²/s²: one of the rotors comes to rest and turns back.
      CHECK(omega[i] * omega[i] == Approx(spin * spin + 2 * work(angle[i]) / 0.25).margin(9e-9));
  }
}

TEST_CASE("drivers: a swing, a table and a way along a guide are followed, by the effort that they take") {
  const Files files;
  const std::string spin_free =
      head.substr(0, head.find("spin = 3.0\n")) + head.substr(head.find("[[bodies]]\nname = \"slider\""));
  const auto scene_of = [&](const std::string& tail) {
    return load_scene(files.folder.write("d.toml", spin_free + tail));
  };
  {
    const Scene scene = scene_of(
        "[[constraints]]\nname = \"motor\"\ntype = \"driver\"\nbody = \"rotor\"\nspeed = 2.0\n"
        "harmonic = {amplitude = 0.3, speed = 7.0, phase = 0.4}\n");
    const MultibodyTrajectory run = finished(scene);
    const std::vector<double> phi = column(scene, run, "rotor.phi");
    const std::vector<double> moment = column(scene, run, "motor.moment");
    for (std::size_t i = 0; i < phi.size(); ++i) {
      const double t = run.samples[i].t;
      const double swing = 0.3 * std::cos(7 * t + 0.4);
      CHECK(phi[i] == Approx(2 * t + swing - 0.3 * std::cos(0.4)).margin(1e-9));  // a rotor that starts at angle 0
      CHECK(moment[i] == Approx(-0.25 * 49 * swing).margin(1e-7));                // with Baumgarte's share of the drift
    }
  }
  {
    // A cubic through its rows is the spline itself.
    const auto way = [](double t) { return 1 + 0.5 * t - 0.7 * t * t + 0.2 * t * t * t; };
    std::string csv = "t,position\n";
    for (const double t : {0.0, 0.4, 0.9, 1.3, 2.0}) csv += std::to_string(t) + "," + std::to_string(way(t)) + "\n";
    files.folder.write("way.csv", csv);
    const Scene scene =
        scene_of("[[constraints]]\nname = \"ram\"\ntype = \"driver\"\nalong = \"guide\"\ntable = \"way.csv\"\n");
    const MultibodyTrajectory run = finished(scene);
    const std::vector<double> x = column(scene, run, "slider.x");
    const std::vector<double> force = column(scene, run, "ram.force");
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double t = run.samples[i].t;
      CHECK(x[i] == Approx(way(t) - 1).margin(1e-6));  // rows of six digits
      CHECK(force[i] == Approx(4 * (-1.4 + 1.2 * t)).margin(1e-4));
    }
  }
  const auto refused = [&](const std::string& keys, const std::string& words) {
    const std::string tail = "[[constraints]]\nname = \"motor\"\ntype = \"driver\"\n" + keys;
    CHECK_THROWS_WITH(scene_of(tail), Contains(words) && (Contains("allowed") || Contains("required")));
  };
  refused("along = \"pin\"\nspeed = 1.0\n", "along is \"pin\"");
  refused("along = \"guide\"\nbody = \"slider\"\nspeed = 1.0\n", "unknown key constraints[2].body");
  refused("body = \"rotor\"\n", "speed is missing");
  refused("body = \"rotor\"\nharmonic = {amplitude = 0.0, speed = 1.0}\n", "amplitude is 0");
  refused("body = \"rotor\"\nharmonic = {amplitude = 1.0}\n", "speed is missing, and so is frequency");
  refused("body = \"rotor\"\ntable = \"way.csv\"\n", "a column is \"position\"; allowed is one of angle");
  refused("along = \"guide\"\ntable = \"way.csv\"\nspeed = 1.0\n", "unknown key constraints[2].speed");
  files.folder.write("short.csv", "t,angle\n0,0\n1,1\n2,1\n");
  refused("body = \"rotor\"\ntable = \"short.csv\"\n", "a table of 3 rows; allowed is four rows or more");
}

}  // namespace table_load_test
