// Contact as users meet it: its two forms, what it gives back of an impact, indentations that are no films.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/joint/dry_contact.hpp"
#include "lubjoint/joint/rebound.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scenes.hpp"
#include "support/temporary_folder.hpp"

namespace contact_form_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string impact = LUBJOINT_SOURCE_DIR "/data/scenes/impact.toml";
const Elasticity<double> steel{207e9, 0.3};
constexpr double length = 0.04;
constexpr double clearance = 2e-4;

/// Force of a resting journal at an indentation.
double pressed(double depth, const ContactSurface<double>& surface) {
  const JournalMotion<double> motion{{clearance + depth, 0}, {0, 0}, 0, 0};
  return -dry_contact_force(motion, Bearing<double>(length, 0.0098, clearance), surface, 0.1).force.x();
}

/// impact.toml as a dry joint in which the journal flies straight at the wall, once.
std::string dry_impact(const std::string& form, const std::string& bearing_length) {
  return R"(name = "dry-impact"
duration = 5e-4
[[bodies]]
name = "journal"
mass = 0.13
inertia = 2.5e-4
velocity = [0.7, 0.0]
[[joints]]
name = "bearing"
film = "none"
)" + bearing_length +
         R"(
journal_radius = 0.0098
clearance = 0.0002
bearing = {body = "ground"}
journal = {body = "journal"}
[joints.contact]
)" + form +
         R"(
bearing_modulus = 207e9
bearing_poisson = 0.3
journal_modulus = 207e9
journal_poisson = 0.3
restitution = 0.5
min_impact_speed = 1e-3
[integrator]
relative_tolerance = 1e-10
)";
}

}  // namespace

TEST_CASE("rebound: the certified exit speeds, and 0.7252 for a restitution of 0.5") {
  CHECK(rebound_ratio(0.5) == Approx(0.7252411).epsilon(1e-7));  // the digits given
  CHECK(rebound_ratio(1) == 1);
  std::size_t compared = 0;
  for (const CsvRow& row : read_csv(LUBJOINT_SOURCE_DIR "/data/golden/contact_exit_speed.csv")) {
    const double exact = std::stod(row.at("exit_speed")) / std::stod(row.at("impact_speed"));
    // Rounding of k, which the ratio's two sides share, near c_r = 1.
    CHECK(std::abs(rebound_ratio(std::stod(row.at("restitution"))) / exact - 1) < 1e-11);
    ++compared;
  }
  CHECK(compared > 10);
  CHECK_THROWS_WITH(rebound_ratio(1.5), Contains("restitution is 1.5"));
}

TEST_CASE("contact of a cylinder: Liu, Zhang and Yang's force at any depth, in proportion to the length") {
  const double modulus = 1 / (2 * (1 - 0.3 * 0.3) / 207e9);
  const ContactSurface<double> surface{cylinder_contact_stiffness(length, clearance, steel, steel), 0.5, 0, 1e-3,
                                       ContactForm::cylinder};
  for (const double depth : {1e-9, 1e-6, 1e-4, 5e-4}) {
    const double printed =
        0.5 * std::numbers::pi * length * modulus * depth * std::sqrt(depth / (2 * (clearance + depth)));
    // Rounding of the depth as a difference of lengths, times 3/2.
    CHECK(pressed(depth, surface) == Approx(printed).epsilon(1e-15 + 1e-19 / depth));
  }
  CHECK(cylinder_contact_stiffness(2 * length, clearance, steel, steel) == 2 * surface.stiffness);
  // The point form does not know of a length; it has 8√2/(3π) √(R_B R_J)/L of the cylinder's, here 0.297.
  const ContactSurface<double> point{contact_stiffness(0.0098, clearance, steel, steel), 0.5};
  CHECK(point.stiffness / surface.stiffness ==
        Approx(8 * std::sqrt(2.0) * std::sqrt(0.01 * 0.0098) / (3 * std::numbers::pi * length)).epsilon(1e-14));
}

TEST_CASE("contact forms in scenes: another force, the same rebound; what is not known is refused") {
  const TemporaryFolder folder;
  const auto run_of = [&](const std::string& form, const std::string& given_length) {
    return simulate_multibody(load_scene(folder.write("scene.toml", dry_impact(form, given_length))));
  };
  const MultibodyTrajectory point = run_of("", "");
  const MultibodyTrajectory cylinder = run_of("form = \"cylinder\"", "length = 0.04");
  for (const MultibodyTrajectory* run : {&point, &cylinder}) {
    REQUIRE(run->events.size() >= 2);
    // Of a free impact, whatever the force: tolerance × stiffness.
    CHECK(std::abs(-run->events[1].normal_speed / (0.7 * rebound_ratio(0.5)) - 1) < 1e-7);
  }
  // The largest force goes with K^{2/5}, as below: 0.297^{-2/5} = 1.62, less what the enclosing bush takes.
  CHECK(cylinder.joints[0].force.value > 1.5 * point.joints[0].force.value);
  const MultibodyTrajectory longer = run_of("form = \"cylinder\"", "length = 0.08");
  // K δ^{5/2} ~ energy: the largest force goes with K^{2/5}, but for the enclosing bush.
  CHECK(longer.joints[0].force.value / cylinder.joints[0].force.value == Approx(std::pow(2, 0.4)).epsilon(0.02));
  CHECK_THROWS_WITH(run_of("form = \"line\"", ""), Contains("form") && Contains("\"point\" or \"cylinder\""));
  CHECK_THROWS_WITH(run_of("form = \"cylinder\"", ""), Contains("without a length"));
}

TEST_CASE("summary of a run with contact: an indentation is no film, and the rebound is said") {
  const TemporaryFolder folder;
  const ProgramResult text = lubjoint_program({"simulate", impact, "--out", folder / "out"});
  CHECK_THAT(text.out, Contains("(indentation ") && !Contains("film -"));
  CHECK_THAT(text.out, Contains("restitution 0.9: a free impact gives back 0.9132 of its speed"));
  double largest = 0;
  for (const CsvRow& row : read_csv(folder / "out/impact.csv")) {
    const double film = std::stod(row.at("bearing.film_thickness"));
    const double depth = clearance * (std::stod(row.at("bearing.eccentricity_ratio")) - 1);
    largest = std::max(largest, depth);
    CHECK(film >= 0);
    CHECK((film == 0 || std::abs(film + depth) < 1e-18));  // rounding of c
  }
  CHECK(largest > 0);
  const auto joint = nlohmann::json::parse(lubjoint_program({"simulate", impact, "--json"}).out)["joints"][0];
  CHECK(joint["min_film_thickness"] == 0);
  CHECK(joint["max_indentation"].get<double>() ==
        Approx(clearance * (joint["max_eccentricity_ratio"].get<double>() - 1)).epsilon(1e-12));
  CHECK(joint["rebound_ratio"].get<double>() == rebound_ratio(0.9));
}

}  // namespace contact_form_test
