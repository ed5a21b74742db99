#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/mechanisms/slider_crank.hpp"
#include "oracle/trajectories/extended_run.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace golden_trajectory_test {

using namespace lubjoint;

namespace {

const std::filesystem::path data = std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data";
const std::filesystem::path trajectories = data / "golden" / "trajectories";

reports::CsvTable table(const std::string& name) {
  const auto file = trajectories / (name + ".csv");
  return {reports::read_input(file.string()), file.filename().string()};
}

/// The scenes that ship, other than those of a free journal.
std::vector<std::filesystem::path> multibody_scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data / "scenes")) {
    if (!entry.is_regular_file()) continue;  // the published problems have a folder, and numbers of their own
    if (!is_free_journal(load_scene(entry.path()))) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("golden trajectories: the files have their manifest's checksums") {
  for (const auto& difference : reports::manifest_differences(trajectories)) FAIL_CHECK(difference.text());
}

TEST_CASE("golden trajectories: the simulator follows the reference of every law to its end") {
  for (const std::string_view law : film_law_names) {
    CAPTURE(law);
    const reports::CsvTable golden = table("journal-" + std::string(law));
    Scene scene = load_scene(data / "scenes" / "journal.toml");
    scene.joints.front().film = law;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-12;
    for (const std::size_t back : {std::size_t{1}, golden.rows() / 2, golden.rows() - 4}) {
      const std::size_t row = golden.rows() - back;
      // The end of a run is the end of a step: no interpolant is compared.
      scene.run.duration = golden.number(row, golden.column("t"));
      scene.run.output_interval = scene.run.duration;
      const JournalTrajectory run = simulate_journal(scene);
      REQUIRE(run.outcome.status == RunStatus::finished);
      const JournalSample& last = run.samples.back();
      const double ex = golden.number(row, golden.column("ex_over_c"));
      const double ey = golden.number(row, golden.column("ey_over_c"));
      const double apart = std::hypot(last.state[0] - ex, last.state[1] - ey);
      CHECK(apart < 2e-9);  // tolerance 1e-12 a step, thousands of steps, and events of the half films
      const double fx = golden.number(row, golden.column("fx"));
      const double fy = golden.number(row, golden.column("fy"));
      const double force_error = std::hypot(last.force.x() - fx, last.force.y() - fy);
      CHECK(force_error < 1e-4);  // the film's damping, 1e5 N s/m, amplifies the velocity's error
    }
  }
}

TEST_CASE("golden trajectories: every scene that ships has one, and every law of the free journal") {
  std::set<std::string> expected;
  for (const auto& file : multibody_scenes()) expected.insert(file.stem().string() + ".csv");
  CHECK(expected.size() == 9);
  for (const std::string_view law : film_law_names) expected.insert("journal-" + std::string(law) + ".csv");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(trajectories)) {
    if (entry.path().extension() == ".csv") found.insert(entry.path().filename().string());
  }
  CHECK(found == expected);
}

TEST_CASE("golden trajectories: the simulator in double follows every multibody scene's reference") {
  // Double precision leaves 1e-13 of a clearance in coordinates of a thousand clearances, and a step's tolerance 1e-12;
  // the film's damping makes force of velocity, and of each of its errors.
  for (const auto& file : multibody_scenes()) {
    CAPTURE(file.stem().string());
    const reports::CsvTable golden = table(file.stem().string());
    Scene scene = load_scene(file);
    scene.energy_ledger = false;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-12;
    scene.run.output_interval = scene.run.duration / static_cast<double>(golden.rows());
    scene.run.stop_at_outputs = true;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    REQUIRE(run.samples.size() == golden.rows() + 1);
    // Distance of the vectors of some columns, and their largest size.
    double position = 0, force = 0, force_size = 0, moment = 0, moment_size = 0;
    for (std::size_t row = 0; row < golden.rows(); ++row) {
      const MultibodySample& sample = run.samples[row + 1];
      const auto is = [&](const std::string& column) { return golden.number(row, golden.column(column)); };
      CHECK(sample.t == is("t"));
      for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const std::string& name = scene.joints[j].name;
        const Vector2<double> ratio = sample.joints[j].eccentricity / scene.joints[j].clearance;
        position =
            std::max(position, std::hypot(ratio.x() - is(name + ".ex_over_c"), ratio.y() - is(name + ".ey_over_c")));
        const Vector2<double> should(is(name + ".fx"), is(name + ".fy"));
        force = std::max(force, (sample.joints[j].force - should).norm());
        force_size = std::max(force_size, should.norm());
      }
      for (std::size_t b = 0; scene.joints.empty() && b < scene.bodies.size(); ++b) {
        const std::string& name = scene.bodies[b].name;
        const double* q = sample.state.data() + 3 * b;
        const double metre = 1 / 0.17;  // the mechanism's length
        position = std::max({position, metre * std::hypot(q[0] - is(name + ".x"), q[1] - is(name + ".y")),
                             std::abs(q[2] - is(name + ".phi"))});
      }
      if (!sample.driving_moments.empty()) {
        moment = std::max(moment, std::abs(sample.driving_moments[0] - is("motor.moment")));
        moment_size = std::max(moment_size, std::abs(is("motor.moment")));
      }
    }
    CHECK(position < 1e-9);               // a few thousand steps of 1e-12; impact's bounce multiplies them
    CHECK(force <= 5e-9 * force_size);    // the film of 4e-4 clearances: force changes faster than place
    CHECK(moment <= 5e-9 * moment_size);  // follows the force
  }
}

TEST_CASE("golden trajectories: rounding in double is where the error stops falling, and nothing before it") {
  // The same method at the same tolerance in extended precision has the method's error without the rounding.
  const reports::CsvTable golden = table("slider-crank");
  Scene scene = load_scene(data / "scenes" / "slider-crank.toml");
  scene.coordinates = SceneCoordinates::absolute;  // those of the extended run
  scene.energy_ledger = false;
  scene.run.output_interval = scene.run.duration / static_cast<double>(golden.rows());
  scene.run.stop_at_outputs = true;
  reports::Reference exact;
  for (std::size_t row = 0; row < golden.rows(); ++row) {
    exact.emplace_back(golden.number(row, golden.column("gudgeon-pin.ex_over_c")),
                       golden.number(row, golden.column("gudgeon-pin.ey_over_c")));
  }
  const auto apart = [](const reports::Reference& one, const reports::Reference& other) {
    REQUIRE(one.size() == other.size());
    double worst = 0;
    for (std::size_t i = 0; i < one.size(); ++i) worst = std::max(worst, (one[i] - other[i]).norm());
    return worst;
  };
  struct Errors {
    double in_double;
    double extended;
    double rounding;
  };
  const auto errors_at = [&](double tolerance) {
    scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
    const auto in_double = reports::looked_at(scene, simulate_multibody(scene).samples);
    const auto extended = reports::looked_at(
        scene,
        reports::extended_multibody_run(scene, scene.run.output_interval, reports::ExtendedMethod::radau, tolerance)
            .samples);
    return Errors{apart(in_double, exact), apart(extended, exact), apart(in_double, extended)};
  };
  const Errors loose = errors_at(1e-10);
  CHECK(loose.in_double > 1e-10);
  CHECK(loose.rounding < 0.02 * loose.in_double);  // measured: 9e-13 of 4.8e-10
  // Coordinates of a thousand clearances have 2^-53 of themselves, 1e-13 clearances, and are rounded at every step.
  const Errors tight = errors_at(1e-14);
  CHECK(tight.extended < 0.5 * tight.in_double);  // goes on falling: measured 1.9e-13 against 1.1e-12
  CHECK(tight.in_double > 1e-13);                 // does not
  CHECK(tight.in_double < 1e-11);
  CHECK(tight.rounding > 0.5 * tight.in_double);  // and that is why
}

TEST_CASE("golden trajectories: two methods agree on as many digits as was measured") {
  for (const auto& entry : std::filesystem::directory_iterator(trajectories)) {
    if (entry.path().extension() != ".csv") continue;
    const std::string name = entry.path().stem().string();
    const reports::CsvTable golden = table(name);
    double worst = 0;
    for (std::size_t row = 0; row < golden.rows(); ++row) {
      worst = std::max(worst, golden.number(row, golden.column("disagreement")));
    }
    CAPTURE(name);
    // As many as data/README.md says, in halves of a decade: what its methods leave of the precision they calculate in.
    CHECK(worst < (name.starts_with("journal-")       ? 3e-15
                   : name == "slider-crank-ideal"     ? 3e-15
                   : name.starts_with("slider-crank") ? 1e-11
                                                      : 1e-10));
  }
}

TEST_CASE("golden trajectories: the crank under a constant moment is where energy and quadrature say") {
  const Scene scene = load_scene(data / "scenes" / "slider-crank-torque.toml");
  const auto m = reports::mechanism_of<long double>(scene);
  const auto moment = static_cast<long double>(scene.loads.front().moment);
  const reports::CsvTable golden = table("slider-crank-torque");
  const auto integrate = [](const auto& f, long double a, long double b) {
    return boost::math::quadrature::gauss_kronrod<long double, 61>::integrate(f, a, b, 12, 1e-17L);
  };
  double worst = 0;
  for (std::size_t row = 4; row < golden.rows(); row += 19) {
    const long double angle = golden.number(row, golden.column("crank.phi"));
    const long double t = mechanisms::torque_driven_time(m, moment, angle, integrate);
    worst = std::max(worst, std::abs(static_cast<double>(t / static_cast<long double>(golden.number(row, 0)) - 1)));
  }
  CHECK(worst < 1e-14);  // the file's 64-bit significands, and the doubles it is read into
}

}  // namespace golden_trajectory_test
