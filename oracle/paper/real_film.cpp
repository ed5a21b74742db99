#include "oracle/paper/real_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/paper/slider_crank_checks.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::reports {

namespace {

constexpr double tolerance = 1e-10;
constexpr std::size_t looks = 12;  ///< at a run's forces

/// A state of a film with the force that a run had there [N].
struct SeenForce {
  FilmState<double> film;
  Vector2<double> force;
};

Check compared(const SceneJoint& joint, const std::vector<SeenForce>& seen) {
  const char* what = "forces of the run";
  const char* against = "Reynolds’ equation, solved at their states";
  if (seen.empty()) return Check::not_checked(what, "no state is within the table");
  const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
  const double scale = force_scale(BearingLimit::long_bearing, bearing, Lubricant<double>(joint.viscosity));
  const oracle::FiniteFilm film = oracle::finite_film_of(joint.film);
  const double asked = film == oracle::FiniteFilm::finite_reynolds ? 2e-4 : 1e-8;
  double worst = 0;
  double bound = 0;
  for (const SeenForce& each : seen) {
    const oracle::FiniteForce solved = finite_force(film, length_to_diameter(bearing), each.film, {asked});
    const double difference = (each.force / scale - solved.ratio).norm() / solved.ratio.norm();
    if (!(difference <= worst)) worst = difference;  // also of what is not a number
    bound = std::max(bound, solved.relative_error());
  }
  return Check::at_most(what, against, worst, joint.table->error + bound, "of |F|",
                        "the table’s stated error and the solver’s");
}

bool is_within_table(const SceneJoint& joint, const FilmState<double>& film) {
  return !is_zero(film.velocity) && !is_zero(film.eccentricity) && film.eccentricity.norm() <= joint.table->ratio_limit;
}

RealFilmJournal run_journal(Scene scene) {
  RealFilmJournal item;
  item.scene = std::move(scene);
  item.run = simulate_journal(item.scene);
  item.rest = journal_equilibrium(item.scene);
  const JournalScene parts = journal_scene(item.scene);
  const LoadedState solved =
      finite_equilibrium(oracle::finite_film_of(parts.law), oracle::FilmOnset::free, parts.bearing, parts.oil,
                         parts.drive.load.norm(), std::abs(2 * parts.drive.mean_spin()));
  // |F| grows with ε at least as fast as ε does.
  item.verdict.checks.push_back(Check::at_most("place of rest", "the root of the solver’s force",
                                               std::abs(item.rest.eccentricity_ratio / solved.eccentricity_ratio - 1),
                                               parts.table->error + 2e-4, "of ε",
                                               "the table’s stated error, and the solver’s and the root’s, 1e-4 each"));
  item.verdict.checks.push_back(solved_force_check(item.scene, item.run));
  return item;
}

RealFilmCrank run_crank(Scene scene) {
  RealFilmCrank item;
  item.scene = std::move(scene);
  item.run = simulate_multibody(item.scene);
  item.verdict.checks.push_back(energy_check(item.run, tolerance));
  item.verdict.checks.push_back(solved_force_check(item.scene, item.run));
  return item;
}

/// A scene with a law and fine tolerances.
Scene prepared(Scene scene, std::string_view law, SceneFilms& films) {
  scene.joints.front().film = law;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
  films.provide(scene);
  return scene;
}

template <class Item>
std::vector<const Verdict*> verdicts_of(const std::vector<Item>& items) {
  std::vector<const Verdict*> list;
  for (const Item& item : items) list.push_back(&item.verdict);
  return list;
}

}  // namespace

Check solved_force_check(const Scene& scene, const JournalTrajectory& run) {
  const SceneJoint& joint = scene.joints.front();
  const double spin = journal_scene(scene).drive.mean_spin();
  const auto slides = [&](double t) {
    return std::ranges::any_of(run.sliding, [t](const auto& each) { return each.start <= t && t <= each.end; });
  };
  std::vector<SeenForce> seen;
  for (std::size_t i = 1; i <= looks && run.samples.size() > 1; ++i) {
    const JournalSample& sample = run.samples[i * (run.samples.size() - 1) / looks];
    const auto& y = sample.state;
    const FilmState<double> film(Vector2<double>(y[0], y[1]), Vector2<double>(y[2] + spin * y[1], y[3] - spin * y[0]));
    if (is_within_table(joint, film) && !slides(sample.t)) seen.push_back({film, sample.force});
  }
  return compared(joint, seen);
}

Check solved_force_check(const Scene& scene, const MultibodyTrajectory& run) {
  const SceneJoint& joint = scene.joints.front();
  const auto slides = [&](double t) {
    return std::ranges::any_of(run.slides, [t](const auto& each) { return each.start <= t && t <= each.end; });
  };
  std::vector<SeenForce> seen;
  for (std::size_t i = 1; i <= looks && run.samples.size() > 1; ++i) {
    const MultibodySample& sample = run.samples[i * (run.samples.size() - 1) / looks];
    const JournalMotion<double> motion =
        joint_kinematics(motion_in(sample.state, joint.bearing.body), joint.bearing.point,
                         motion_in(sample.state, joint.journal.body), joint.journal.point)
            .motion;
    const FilmState<double> film = film_state(motion, joint.clearance);
    if (is_within_table(joint, film) && !slides(sample.t)) seen.push_back({film, sample.joints.front().force});
  }
  return compared(joint, seen);
}

std::vector<const Verdict*> RealFilms::journal_verdicts() const { return verdicts_of(journal); }
std::vector<const Verdict*> RealFilms::crank_verdicts() const { return verdicts_of(crank); }

bool RealFilms::passed() const {
  const auto good = [](const auto& item) { return item.verdict.agrees(); };
  return std::ranges::all_of(journal, good) && std::ranges::all_of(crank, good);
}

RealFilms run_real_films(const std::filesystem::path& scenes, SceneFilms& films) {
  const Scene journal = load_scene(scenes / "journal.toml");
  std::vector<Scene> cranks;
  for (const char* file : slider_crank_pairs) {
    cranks.push_back(load_scene(scenes / file));
    cranks.back().energy_ledger = true;
  }
  constexpr auto& laws = names_of_laws<CompiledLaws>;
  RealFilms result;
  result.journal.resize(laws.size());
  result.crank.resize(laws.size() * cranks.size());
  run_parallel(laws.size() * (1 + cranks.size()), available_cores(), [&](std::size_t i) {
    const std::string_view law = laws[i % laws.size()];
    if (i < laws.size()) {
      result.journal[i] = run_journal(prepared(journal, law, films));
    } else {
      const std::size_t at = i - laws.size();
      result.crank[at] = run_crank(prepared(cranks[at / laws.size()], law, films));
    }
  });
  return result;
}

std::string pair_of(const SceneJoint& joint) {
  return fmt::format("{:g} mm, {:g} Pa s", 1e3 * joint.clearance, joint.viscosity);
}

std::string real_films_table(const RealFilms& films) {
  constexpr double degrees = 180 / std::numbers::pi;
  std::string text =
      "The film of the bearing's real length\n"
      "example 1        rest e/c  attitude [deg]  largest e/c  largest force [N]  verdict\n";
  for (const RealFilmJournal& item : films.journal) {
    text += fmt::format("{:<16}{:9.4f}{:16.2f}{:13.4f}{:19.3f}  {}\n", item.scene.joints[0].film,
                        item.rest.eccentricity_ratio, degrees * item.rest.attitude, item.run.max_eccentricity_ratio,
                        item.run.max_force, item.verdict.in_letters());
  }
  text += check_legend(films.journal_verdicts());
  text +=
      "\nexample 2                          largest e/c  least film [um]  largest force [N]  moment [N m]         "
      "verdict\n";
  for (const RealFilmCrank& item : films.crank) {
    const double clearance = item.scene.joints[0].clearance;
    const double farthest = item.run.joints[0].eccentricity.value;
    const DriverExtremes& moment = item.run.drivers[0];
    text += fmt::format("{:<16}  {:<16}{:12.4f}{:17.3f}{:19.2f}{:9.3f} to {:<8.3f}  {}\n", item.scene.joints[0].film,
                        pair_of(item.scene.joints[0]), farthest / clearance, 1e6 * (clearance - farthest),
                        item.run.joints[0].force.value, moment.min_moment.value, moment.max_moment.value,
                        item.verdict.in_letters());
  }
  return text + check_legend(films.crank_verdicts());
}

}  // namespace lubjoint::reports
