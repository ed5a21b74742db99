// Laws that are chosen when the program runs: films of joints, scenes and batches.
#include "lubjoint/joint/chosen_film.hpp"

#include <catch2/catch.hpp>

#include "lubjoint/film/batch.hpp"
#include "lubjoint/film/losses.hpp"
#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/journal_losses.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scene_text.hpp"

namespace chosen_film_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Vec = Vector2<double>;

namespace {

const Bearing<double> squat(0.02, 0.02, 1e-4);  // L/D = 1/2: every law is made for it
const Lubricant<double> oil(0.25);

/// States of a film: all directions, both signs of a and b.
std::vector<FilmState<double>> some_states() {
  std::vector<FilmState<double>> states;
  for (int i = 0; i < 60; ++i) {
    const double epsilon = 0.95 * std::sqrt((i + 0.5) / 60);
    states.emplace_back(epsilon * Vec(std::cos(2.4 * i), std::sin(2.4 * i)),
                        Vec(7 * std::cos(0.7 * i), 7 * std::sin(0.7 * i)));
  }
  return states;
}

std::string scene_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = read_text(journal_scene_file);
  for (const auto& [path, value] : changes) text = SceneText(text).with(path, value);
  return text;
}

/// example 1's bearing, shortened to L/D = 1/2, with a law.
Scene squat_scene(const std::string& law) {
  return parse_scene(scene_with({{"joints[0].film", "\"" + law + "\""}, {"joints[0].length", "0.0098"}}), "squat.toml");
}

}  // namespace

TEST_CASE("chosen film: every law's force is the law's own to the bit, and its derivatives are exact") {
  for_each_film_law<EveryFilmLaw>([]<class Law>() {
    INFO(Law::name);
    if constexpr (HalfFilmLaw<Law>) {
      CHECK_THROWS_WITH(ChosenFilm<double>(Law::name, squat, oil), Contains(std::string(Law::name)));
    } else {
      const ChosenFilm<double> film(Law::name, squat, oil);
      for (const FilmState<double>& state : some_states()) {
        CHECK(film.force(state) == film_force<Law>(squat, oil, state));
        using D = Dual<double, 6>;
        // ê and u as functions of six variables.
        Vector2<D> e(D::variable(state.eccentricity.x(), 0), D::variable(state.eccentricity.y(), 3));
        Vector2<D> u(D::variable(state.velocity.x(), 1) + 0.5 * e.y() - 0.5 * state.eccentricity.y(),
                     D::variable(state.velocity.y(), 5));
        const FilmState<D> seeded(e, u);
        const Vector2<D> chosen = film.force(seeded);
        const Vector2<D> own = film_force<Law>(squat, oil, seeded);
        for (int i = 0; i < 2; ++i) {
          CHECK(chosen(i).value() == Approx(own(i).value()).epsilon(1e-14).margin(1e-300));  // rounding of q
          // Rounding, times the slope's terms: at most 1/q of each other.
          CHECK((chosen(i).derivatives() - own(i).derivatives()).norm() <=
                1e-12 * std::hypot(own(0).derivatives().norm(), own(1).derivatives().norm()));
        }
      }
    }
  });
}

TEST_CASE("chosen film: a law that there is not, and a bearing a law is not made for, are refused by name") {
  CHECK_THROWS_WITH(ChosenFilm<double>("squeeze", squat, oil), Contains("squeeze_long_full"));
  CHECK_THROWS_WITH(ChosenFilm<double>("butenschoen", Bearing<double>(0.04, 0.0098, 2e-4), oil),
                    Contains("butenschoen") && Contains("at most 1"));
}

TEST_CASE("scenes: laws of the squeeze alone and of finite length run, by both engines alike") {
  for (const std::string law :
       {"squeeze_long_full", "squeeze_short_full", "squeeze_long", "squeeze_short", "moes_impedance", "butenschoen"}) {
    INFO(law);
    Scene scene = squat_scene(law);
    scene.run.duration = 0.02;
    scene.run.output_interval = 0.002;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
    scene.bodies[0].position = {5e-5, 2e-5};
    REQUIRE(is_free_journal(scene));
    const JournalTrajectory alone = simulate_journal(scene);
    REQUIRE(alone.outcome.status == RunStatus::finished);
    scene.energy_ledger = true;  // the engine of mechanisms
    const MultibodyTrajectory general = simulate_multibody(scene);
    REQUIRE(general.outcome.status == RunStatus::finished);
    REQUIRE(alone.samples.size() == general.samples.size());
    double apart = 0;
    double travelled = 0;
    for (std::size_t i = 0; i < alone.samples.size(); ++i) {
      const Vec here(alone.samples[i].state[0], alone.samples[i].state[1]);
      apart = std::max(apart, (here - general.samples[i].joints[0].eccentricity / scene.joints[0].clearance).norm());
      travelled = std::max(travelled, (here - Vec(0.25, 0.1)).norm());
    }
    CHECK(travelled > 0.05);
    CHECK(apart < 1e-8);  // both keep 1e-10 of a clearance a step, over some hundred steps
    // What the film takes is what the bodies lose: the ledger's residual, over what has been turned over.
    REQUIRE(general.energy_residual);
    CHECK(*general.energy_residual < 1e-7 * general.energy_scale);  // the tolerance times steps
  }
}

TEST_CASE("scenes: friction of a squeeze film is that of the film of the squeeze, in both engines") {
  for (const std::string law : {"squeeze_short", "squeeze_long_full", "moes_impedance", "butenschoen"}) {
    INFO(law);
    Scene scene = squat_scene(law);
    scene.run.duration = 0.01;
    scene.run.output_interval = 0.002;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
    scene.bodies[0].position = {5e-5, 2e-5};
    scene.bodies[0].velocity = {-1e-4, 0.02};  // mostly along the wall: what a squeeze film leaves out
    scene.bodies[0].spin_is_held = true;
    scene.joints[0].shear = ShearExtent::film;
    const SceneJoint& joint = scene.joints[0];
    const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
    const Lubricant<double> lubricant(joint.viscosity);
    const JournalTrajectory alone = simulate_journal(scene);
    scene.energy_ledger = true;  // the engine of mechanisms
    const MultibodyTrajectory general = simulate_multibody(scene);
    REQUIRE(alone.outcome.status == RunStatus::finished);
    REQUIRE(general.outcome.status == RunStatus::finished);
    REQUIRE(alone.samples.size() == general.samples.size());
    for (std::size_t i = 0; i < alone.samples.size(); ++i) {
      const auto& y = alone.samples[i].state;
      const double half_sum = scene.bodies[0].spin / 2;
      const FilmState<double> film(Vec(y[0], y[1]), Vec(y[2] + half_sum * y[1], y[3] - half_sum * y[0]));
      const FilmLosses<double> own = with_film_law<EveryFilmLaw>(
          law, [&]<class Law>() { return film_losses<Law>(bearing, lubricant, film, scene.bodies[0].spin); });
      // The two runs keep 1e-10 a step, and a torque follows a thin film's rates.
      CHECK(*general.samples[i].joints[0].losses.torque_journal == Approx(own.torque_journal).epsilon(1e-6));
      CHECK(*journal_losses(scene, alone.samples[i]).torque_journal == Approx(own.torque_journal).epsilon(1e-12));
    }
  }
  CHECK_THROWS_WITH(make_shear<double>("squeeze_short", squat, oil, ShearExtent::striated), Contains("squeeze_short"));
}

TEST_CASE("shaped laws: polar forces have the caller's radial direction, at the centre as beside it") {
  const PolarFilmState<double> centre(0.0, 1.0, 0.5);
  const PolarFilmState<double> beside(1e-12, 1.0, 0.5);
  const PolarForce<double> at = film_force<Butenschoen>(squat, oil, centre);
  const PolarForce<double> near = film_force<Butenschoen>(squat, oil, beside);
  CHECK(at.radial == Approx(near.radial).epsilon(1e-10));  // a hundred times the distance
  CHECK(at.tangential == Approx(near.tangential).epsilon(1e-10));
}

TEST_CASE("scenes: what a law can't do is said by name: equilibrium, and shapes it is not made for") {
  for (const std::string law : {"squeeze_long_full", "squeeze_short_full", "squeeze_long", "squeeze_short"}) {
    CHECK_THROWS_WITH(journal_equilibrium(squat_scene(law)),
                      Contains(law) && Contains("leaves the wedge out") && Contains("short_dynamic"));
  }
  for (const std::string law : {"moes_impedance", "butenschoen"}) {
    CHECK_THROWS_WITH(journal_equilibrium(squat_scene(law)), Contains(law) && Contains("is a fit"));
  }
  CHECK_THROWS_WITH(parse_scene(scene_with({{"joints[0].film", "\"butenschoen\""}}), "long.toml"),
                    Contains("joints[0].film") && Contains("L/D = 2.04") && Contains("at most 1"));
  CHECK_THROWS_WITH(parse_scene(scene_with({{"joints[0].film", "\"squeeze_lng\""}}), "typo.toml"),
                    Contains("did you mean squeeze_long?"));
}

TEST_CASE("batches: laws of the squeeze alone and of finite length give the bits of one state at a time") {
  const std::vector<FilmState<double>> states = some_states();
  std::vector<double> ex, ey, ux, uy, fx(states.size()), fy(states.size());
  for (const FilmState<double>& s : states) {
    ex.push_back(s.eccentricity.x());
    ey.push_back(s.eccentricity.y());
    ux.push_back(s.velocity.x());
    uy.push_back(s.velocity.y());
  }
  const FilmStateArrays arrays{ex, ey, ux, uy};
  for_each_film_law<EveryFilmLaw>([&]<class Law>() {
    INFO(Law::name);
    film_forces(Law::name, squat, oil, arrays, {fx, fy});
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Vec one = film_force<Law>(squat, oil, states[i]);
      CHECK(fx[i] == one.x());
      CHECK(fy[i] == one.y());
    }
    if constexpr (ShapedFilmLaw<Law>) {
      CHECK_THROWS_WITH(film_force_ratios(Law::name, arrays, {fx, fy}), Contains("depends on the bearing"));
    } else {
      film_force_ratios(Law::name, arrays, {fx, fy});
      CHECK(fx[7] == force_ratio<Law>(states[7]).x());
    }
  });
  CHECK_THROWS_WITH(film_forces("butenschoen", Bearing<double>(1, 0.4, 0.1), oil, arrays, {fx, fy}),
                    Contains("butenschoen") && Contains("at most 1"));
}

}  // namespace chosen_film_test
