// Friction torque in the joint: on the bodies, in the ledger, in scenes and in what they leave behind.
#include <catch2/catch.hpp>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

#include "lubjoint/film/losses.hpp"
#include "lubjoint/scene/journal_losses.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/trajectory_csv.hpp"
#include "support/csv.hpp"
#include "support/scene_text.hpp"

namespace shear_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

/// journal.toml with pieces of its text replaced.
Scene journal_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  static const TemporaryFolder folder;
  std::string text = read_text(journal_scene_file);
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  }
  return load_scene(folder.write("journal.toml", text));
}

const std::pair<std::string, std::string> with_shear{"[[joints]]", "[[joints]]\nshear = \"film\""};
const std::pair<std::string, std::string> with_ledger{"interval = 1e-3", "energy_ledger = true\ninterval = 1e-3"};
const std::pair<std::string, std::string> held{"spin = 52.35987755982989", "spin = {held = 52.35987755982989}"};
std::pair<std::string, std::string> law(const std::string& name) {
  return {"film = \"pinkus_sternlicht\"", "film = \"" + name + "\""};
}
std::pair<std::string, std::string> duration(const std::string& seconds) {
  return {"duration = 1.0", "duration = " + seconds};
}

/// Two bodies, each with its centre off its mass centre, joined by a film and nothing else.
Scene two_bodies(const std::string& film, std::optional<ShearExtent> shear) {
  Scene scene;
  scene.run.duration = 1;
  SceneBody body;
  body.name = "a";
  body.mass = 2;
  body.inertia = 0.5;
  scene.bodies.push_back(body);
  body.name = "b";
  body.mass = 0.25;
  body.inertia = 0.125;
  scene.bodies.push_back(body);
  SceneJoint joint;
  joint.name = "film";
  joint.film = film;
  joint.viscosity = 0.4;
  joint.length = 0.04;
  joint.journal_radius = 0.0098;
  joint.clearance = 2e-4;
  joint.bearing = {0, {0.125, -0.25}};
  joint.journal = {1, {-0.0625, 0.5}};
  joint.shear = shear;
  scene.joints.push_back(joint);
  return scene;
}

/// A random state with the journal inside of its bearing.
std::vector<double> random_state(std::mt19937_64& draw) {
  std::uniform_real_distribution<double> part(-1, 1);
  std::vector<double> y(12);
  for (double& value : y) value = part(draw);
  y[8] *= 100;
  y[11] *= 100;
  const auto point = [&](std::size_t body, double sx, double sy) {
    const double c = std::cos(y[3 * body + 2]);
    const double s = std::sin(y[3 * body + 2]);
    return Vector2<double>(c * sx - s * sy, s * sx + c * sy);
  };
  const Vector2<double> bearing = Vector2<double>(y[0], y[1]) + point(0, 0.125, -0.25);
  const Vector2<double> journal = bearing + 1.2e-4 * Vector2<double>(part(draw), part(draw));
  const Vector2<double> centre = journal - point(1, -0.0625, 0.5);
  y[3] = centre.x();
  y[4] = centre.y();
  return y;
}

}  // namespace

TEST_CASE("shear: the bodies get T_J and T_B about their centres, and the pair has no resultant and no moment") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const Scene scene = two_bodies(std::string(Law::name), ShearExtent::film);
    const auto smooth = planar_system<double>(two_bodies(std::string(Law::name), std::nullopt));
    const auto sheared = planar_system<double>(scene);
    auto without = smooth.workspace<double>();
    auto with = sheared.workspace<double>();
    std::mt19937_64 draw(7);
    for (int n = 0; n < 20; ++n) {
      const std::vector<double> y = random_state(draw);
      smooth.evaluate(0.0, y.data(), {}, without);
      sheared.evaluate(0.0, y.data(), {}, with);
      const JournalMotion<double>& motion = with.joints[0].kinematics.motion;
      const Bearing<double> bearing(0.04, 0.0098, 2e-4);
      const FilmLosses<double> losses =
          film_losses<Law>(bearing, Lubricant<double>(0.4), film_state(motion, bearing.clearance()),
                           motion.journal_spin - motion.bearing_spin);
      const double on_journal = with.forces[5] - without.forces[5];
      const double on_bearing = with.forces[2] - without.forces[2];
      // Moments of forces on arms of up to 0.8 m are what the torques are subtracted from.
      const double rounding = 1e-14 * losses.force.norm();
      const double moment = cross(motion.eccentricity, losses.force);
      CHECK(std::abs(on_journal - losses.torque_journal) <= rounding);
      CHECK(std::abs(on_bearing + losses.torque_journal) <= rounding);
      CHECK(std::abs(losses.torque_bearing + moment + losses.torque_journal) <= rounding);
      // Forces are what they were; the moment about the origin of the whole pair is nothing.
      double total = with.forces[2] + with.forces[5];
      for (const std::size_t b : {0u, 3u}) total += y[b] * with.forces[b + 1] - y[b + 1] * with.forces[b];
      CHECK(with.forces[0] == without.forces[0]);
      CHECK(with.forces[4] == without.forces[4]);
      CHECK(std::abs(total) <= 4 * rounding);
    }
  });
}

TEST_CASE("shear: power on both bodies is the loss, negative for every law; without torque it may be positive") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const auto system = planar_system<double>(two_bodies(std::string(Law::name), ShearExtent::film));
    auto w = system.workspace<double>();
    std::mt19937_64 draw(11);
    for (int n = 0; n < 50; ++n) {
      const std::vector<double> y = random_state(draw);
      system.evaluate(0.0, y.data(), {}, w);
      double power = 0;
      for (std::size_t i = 0; i < 6; ++i) power += w.forces[i] * y[6 + i];
      const auto losses = system.joints()[0].losses(w.joints[0], JointMemory<double>{});
      REQUIRE(losses.has_value());
      CHECK(losses->power > 0);
      CHECK(power == Approx(-losses->power).epsilon(1e-9));  // forces on velocities of the bodies, which cancel
    }
    // A journal that whirls slower than half its spin is driven by the forces; the torque takes more than they give.
    const JointElement<double>& element = system.joints()[0];
    const PlanarMotion<double> journal{Vector2<double>(0.125 + 0.0625 + 1e-4, -0.25 - 0.5), 0,
                                       Vector2<double>(0.5 * 50, 1e-3 + 0.0625 * 50), 50};
    const auto force = element.force(PlanarFrame<double>(ground_motion<double>()), PlanarFrame<double>(journal), {});
    CHECK(std::abs(force.kinematics.motion.velocity.x()) < 1e-12);
    CHECK(force.film_power() > 0);
    CHECK(element.losses(force, {})->power > 0);
  });
}

TEST_CASE("shear: exact derivatives of the equations of motion contain the torque") {
  const Scene scene = two_bodies("short_dynamic", ShearExtent::film);
  const auto system = planar_system<double>(scene);
  MultibodyOde<double> ode(system, true);
  std::mt19937_64 draw(3);
  std::vector<double> y = random_state(draw);
  y.resize(12 + ledger_terms, 0.0);
  JacobianOf<double, run_time_size> exact;
  ode.jacobian(y, exact, 0.0);
  for (const std::size_t j : {8u, 11u, 9u}) {
    const double step = j == 9 ? 1e-6 : 1e-4;
    std::vector<double> more(y.size()), less(y.size());
    auto moved = y;
    moved[j] += step;
    ode.rate(moved, more, 0.0);
    moved[j] -= 2 * step;
    ode.rate(moved, less, 0.0);
    for (std::size_t i = 6; i < y.size(); ++i) {
      const double slope = (more[i] - less[i]) / (2 * step);
      const double entry = exact(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      // Central differences: rounding of accelerations over the step, and its square.
      CHECK(entry == Approx(slope).epsilon(1e-5).margin(1e-6 * std::abs(more[i])));
    }
  }
}

TEST_CASE("shear with the spin held: example 1's motion is the same to the bit, on the short path, with its losses") {
  for (const char* name : {"pinkus_sternlicht", "short_half", "long_dynamic"}) {
    INFO(name);
    const Scene plain = journal_with({law(name), duration("0.05")});
    const Scene scene = journal_with({law(name), duration("0.05"), with_shear, held});
    REQUIRE(is_free_journal(scene));
    const JournalTrajectory expected = simulate_journal(plain);
    const JournalTrajectory run = simulate_journal(scene);
    REQUIRE(run.samples.size() == expected.samples.size());
    for (std::size_t i = 0; i < run.samples.size(); ++i) CHECK(run.samples[i].state == expected.samples[i].state);
    CHECK(run.outcome.rhs_evaluations == expected.outcome.rhs_evaluations);
    const auto rows = parse_csv(reports::trajectory_csv(scene, run));
    CHECK(parse_csv(reports::trajectory_csv(plain, expected))[0].count("bearing.power") == 0);
    const CsvRow& last = rows.back();
    const auto number_of = [&](const char* column) { return std::stod(last.at(column)); };
    const double moment =
        number_of("bearing.ex") * number_of("bearing.fy") - number_of("bearing.ey") * number_of("bearing.fx");
    CHECK(number_of("bearing.torque_journal") + number_of("bearing.torque_bearing") ==
          Approx(-moment).margin(1e-15 * std::abs(number_of("bearing.torque_journal"))).epsilon(1e-12));
    // What the bearing's frame does not move takes nothing: P = −(F·v + T_J ω_J).
    const double on_journal = number_of("bearing.fx") * number_of("journal.vx") +
                              number_of("bearing.fy") * number_of("journal.vy") +
                              number_of("bearing.torque_journal") * number_of("journal.omega");
    CHECK(number_of("bearing.power") == Approx(-on_journal).epsilon(1e-11));
    CHECK(last.at("bearing.side_flow").empty() == (std::string(name) != "short_half"));
  }
}

TEST_CASE(
    "shear with the spin free: the journal slows down by its torque, and the ledger closes on a loss that only grows") {
  const Scene scene = journal_with({law("short_dynamic"), duration("0.2"), with_shear, with_ledger});
  CHECK_FALSE(is_free_journal(scene));
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const auto film = 2 + static_cast<std::size_t>(LedgerTerm::film);
  double work = 0;
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    const MultibodySample& now = run.samples[i];
    const MultibodySample& before = run.samples[i - 1];
    CHECK(now.state[5] < before.state[5]);
    CHECK(now.ledger[film] < before.ledger[film]);
    // I dω = T_J dt and dW = −P dt by the trapezoid; the film settles within milliseconds at first.
    work += (now.t - before.t) * (*now.joints[0].losses.power + *before.joints[0].losses.power) / 2;
    if (i < 20) continue;
    const double torque = (*now.joints[0].losses.torque_journal + *before.joints[0].losses.torque_journal) / 2;
    CHECK(2.5e-4 * (now.state[5] - before.state[5]) == Approx(torque * (now.t - before.t)).epsilon(1e-4));
  }
  CHECK(work == Approx(-run.samples.back().ledger[film]).epsilon(1e-2));  // the trapezoid of the first milliseconds
  REQUIRE(run.energy_residual.has_value());
  CHECK(*run.energy_residual < 1e-7 * run.energy_scale);  // the integrator's tolerance is 1e-8
}

TEST_CASE("shear with the spin free: example 1's journal is down to half its spin as soon as the README says") {
  const Scene scene = journal_with({law("short_dynamic"), duration("0.8"), with_shear});
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  double half_life = 0;
  for (const MultibodySample& sample : run.samples) {
    if (sample.state[5] > scene.bodies[0].spin / 2) half_life = sample.t;
  }
  // A concentric half film alone would take ln 2 · cI/(πμR³L): eccentricity and the force's own moment are on top.
  const double concentric = std::log(2) * 2e-4 * 2.5e-4 / (std::acos(-1) * 0.4 * std::pow(0.0098, 3) * 0.04);
  CHECK(half_life < concentric);
  CHECK(half_life > 0.9 * concentric);
  std::ostringstream sentence;
  sentence << std::fixed << std::setprecision(2) << "half of its spin after " << half_life << " s";
  CHECK_THAT(read_text(LUBJOINT_SOURCE_DIR "/README.md"), Contains(sentence.str()));
}

TEST_CASE("shear with the spin held in any scene: a driver holds it, with the moment that the film asks for") {
  const Scene scene = journal_with({law("long_dynamic"), duration("0.02"), with_shear, held, with_ledger});
  CHECK_FALSE(is_free_journal(scene));
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  REQUIRE(run.driver_names == std::vector<std::string>{"journal.spin"});
  const MultibodySample& last = run.samples.back();
  CHECK(last.driving_moments[0] == Approx(-*last.joints[0].losses.torque_journal).epsilon(1e-9));  // Baumgarte's rest
  CHECK(last.state[5] == Approx(52.35987755982989).epsilon(1e-9));
  CHECK_THAT(reports::trajectory_csv(scene, run), Contains("journal.spin.moment") && Contains(",bearing.side_flow"));
  CHECK(*run.energy_residual < 1e-7 * run.energy_scale);
}

TEST_CASE("shear in the transition: the torque is continuous at both seams and nothing in dry contact") {
  Scene scene = two_bodies("long_dynamic", ShearExtent::film);
  SceneJoint& joint = scene.joints[0];
  joint.transition = SceneTransition{1e-5, 3e-5};
  joint.contact = SceneContact{2e11, 0.3, 2e11, 0.3, 0.9, 0.01, 0, 1e-3};
  const auto system = planar_system<double>(scene);
  const JointElement<double>& element = system.joints()[0];
  const auto torque = [&](double distance, ContactPhase phase) {
    PlanarMotion<double> still = ground_motion<double>();
    PlanarMotion<double> journal{Vector2<double>(0.125 + 0.0625 + distance, -0.25 - 0.5), 0,
                                 Vector2<double>(-0.01, 0.02), 40};
    const JointMemory<double> memory{phase, 0.1};
    const auto force = element.force(PlanarFrame<double>(still), PlanarFrame<double>(journal), memory);
    return element.shear_torque(force, memory);
  };
  const double c = 2e-4;
  const double at_wall = torque(c, ContactPhase::film);
  CHECK(at_wall != 0);
  CHECK(torque(c, ContactPhase::blend) == Approx(at_wall).epsilon(1e-9));  // |e| is right to 1e-12 of c
  CHECK(std::abs(torque(c + 1e-5, ContactPhase::blend)) < 1e-9 * std::abs(at_wall));
  CHECK(torque(c + 1e-5, ContactPhase::dry) == 0);
}

TEST_CASE("shear: scenes name line, key, what was given and what is allowed") {
  const auto refused = [](const std::vector<std::pair<std::string, std::string>>& changes, const auto& matcher) {
    CHECK_THROWS_WITH(journal_with(changes), matcher);
  };
  refused({{"[[joints]]", "[[joints]]\nshear = \"wet\""}},
          Contains("joints[0].shear is \"wet\"; allowed is one of film, flooded, striated"));
  refused({law("long_dynamic"), {"[[joints]]", "[[joints]]\nshear = \"striated\""}},
          Contains("joints[0].shear is \"striated\" with long_dynamic; allowed is film or flooded"));
  refused({{"[[joints]]", "[[joints]]\nshear = 3"}}, Contains("joints[0].shear"));
  refused({held, {"spin = {held = 52.35987755982989}", "spin = {hold = 5}"}}, Contains("bodies[0].spin"));
  refused({{"spin = 52.35987755982989", "spin = {held = \"fast\"}"}}, Contains("bodies[0].spin.held"));
  CHECK(journal_with({law("long_half"), {"[[joints]]", "[[joints]]\nshear = \"striated\""}}).joints[0].shear ==
        ShearExtent::striated);
  // A law that is not the file's has to have the shear, too.
  Scene striated = journal_with({law("long_half"), held, {"[[joints]]", "[[joints]]\nshear = \"striated\""}});
  striated.joints[0].film = "long_dynamic";
  CHECK_THROWS_WITH(simulate_journal(striated), Contains("striated") && Contains("long_dynamic"));
  striated.bodies[0].spin_is_held = false;
  CHECK_THROWS_WITH(simulate_multibody(striated), Contains("striated") && Contains("long_dynamic"));
  // Without a film there is no oil.
  SceneFile impact(LUBJOINT_SOURCE_DIR "/data/scenes/impact.toml");
  CHECK_THROWS_WITH(impact.scene({{"joints[0].film", std::string("none")}, {"joints[0].shear", std::string("film")}}),
                    Contains("shear") || Contains("transition"));
  // A free journal that slows down has no steady state.
  CHECK_THROWS_WITH(journal_losses(journal_with({with_shear}), JournalSample{0, {0, 0, 0, 0}, {0, 0}}),
                    Contains("slows the journal down") && Contains("held"));
}

}  // namespace shear_test
