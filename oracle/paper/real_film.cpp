#include "oracle/paper/real_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/paper/slider_crank_checks.hpp"
#include "oracle/results/angles.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::size_t looks = 12;  ///< at a run's forces

/// A state of a film with the force that a run had there [N].
struct SeenForce {
  FilmState<double> film;
  Vector2<double> force;
};

template <class Slides>
void add_if_moving(std::vector<SeenForce>& seen, const Slides& slides, double t, const SeenForce& each) {
  const bool slides_then =
      std::ranges::any_of(slides, [t](const auto& slide) { return slide.start <= t && t <= slide.end; });
  if (!slides_then && !is_zero(each.film.velocity) && !is_zero(each.film.eccentricity)) seen.push_back(each);
}

double ratio_of(const SeenForce& each) { return each.film.eccentricity.norm(); }

/// How a force compares with the solver's.
struct Off {
  double difference;  ///< |F − F_solved|/|F_solved|
  double bound;       ///< of the solver's error, over the same
};

Off off_the_solver(const SceneJoint& joint, const SeenForce& seen) {
  const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
  const double scale = force_scale(BearingLimit::long_bearing, bearing, Lubricant<double>(joint.viscosity));
  const oracle::FiniteFilm film = oracle::finite_film_of(joint.film);
  const double asked = film == oracle::FiniteFilm::finite_reynolds ? 2e-4 : 1e-8;
  const oracle::FiniteForce solved = finite_force(film, length_to_diameter(bearing), seen.film, {asked});
  return {(seen.force / scale - solved.ratio).norm() / solved.ratio.norm(), solved.relative_error()};
}

Check compared(const SceneJoint& joint, const std::vector<SeenForce>& seen) {
  const char* what = "forces of the run";
  const char* against = "Reynolds’ equation, solved at their states";
  if (seen.empty()) return Check::not_checked(what, "no state is within the table");
  double worst = 0;
  double bound = 0;
  for (const SeenForce& each : seen) {
    const Off off = off_the_solver(joint, each);
    if (!(off.difference <= worst)) worst = off.difference;  // also of what is not a number
    bound = std::max(bound, off.bound);
  }
  return Check::at_most(what, against, worst, joint.table->error + bound, "of |F|",
                        "the table’s stated error and the solver’s");
}

/// Those of a run's samples at which its film moves; not where a half film slides on its jump.
std::vector<SeenForce> forces_of(const Scene& scene, const JournalTrajectory& run) {
  const double spin = journal_scene(scene).drive.mean_spin();
  std::vector<SeenForce> seen;
  for (const JournalSample& sample : run.samples) {
    const auto& y = sample.state;
    add_if_moving(
        seen, run.sliding, sample.t,
        {FilmState<double>(Vector2<double>(y[0], y[1]), Vector2<double>(y[2] + spin * y[1], y[3] - spin * y[0])),
         sample.force});
  }
  return seen;
}

std::vector<SeenForce> forces_of(const Scene& scene, const MultibodyTrajectory& run) {
  const SceneJoint& joint = scene.joints.front();
  std::vector<SeenForce> seen;
  for (const MultibodySample& sample : run.samples) {
    const JournalMotion<double> motion =
        joint_kinematics(motion_in(sample.state, joint.bearing.body), joint.bearing.point,
                         motion_in(sample.state, joint.journal.body), joint.journal.point)
            .motion;
    add_if_moving(seen, run.slides, sample.t, {film_state(motion, joint.clearance), sample.joints.front().force});
  }
  return seen;
}

/// A few of them, evenly among those within the table.
std::vector<SeenForce> some_within_table(const SceneJoint& joint, std::vector<SeenForce> seen) {
  std::erase_if(seen, [&](const SeenForce& each) { return ratio_of(each) > joint.table->ratio_limit; });
  if (seen.size() <= looks) return seen;
  std::vector<SeenForce> some;
  for (std::size_t i = 1; i <= looks; ++i) some.push_back(seen[i * (seen.size() - 1) / looks]);
  return some;
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
  item.verdict.checks.push_back(energy_check(item.run, run_tolerance));
  item.verdict.checks.push_back(solved_force_check(item.scene, item.run));
  item.beyond = beyond_table(item.scene, item.run);
  return item;
}

/// A scene with a law and fine tolerances.
Scene prepared(Scene scene, std::string_view law, SceneFilms& films) {
  scene.joints.front().film = law;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = run_tolerance;
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
  return compared(scene.joints.front(), some_within_table(scene.joints.front(), forces_of(scene, run)));
}

Check solved_force_check(const Scene& scene, const MultibodyTrajectory& run) {
  return compared(scene.joints.front(), some_within_table(scene.joints.front(), forces_of(scene, run)));
}

std::optional<BeyondTable> beyond_table(const Scene& scene, const MultibodyTrajectory& run) {
  const SceneJoint& joint = scene.joints.front();
  std::vector<SeenForce> beyond = forces_of(scene, run);
  const auto all = static_cast<double>(beyond.size());
  std::erase_if(beyond, [&](const SeenForce& each) { return !(ratio_of(each) > joint.table->ratio_limit); });
  if (beyond.empty()) return std::nullopt;
  const SeenForce& strongest =
      *std::ranges::max_element(beyond, {}, [](const SeenForce& each) { return each.force.norm(); });
  const auto [difference, bound] = off_the_solver(joint, strongest);
  return BeyondTable{static_cast<double>(beyond.size()) / all, ratio_of(strongest), difference, bound};
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

std::vector<const MultibodyTrajectory*> drawn_runs(const RealFilms& films, const Example2& example) {
  std::vector<const MultibodyTrajectory*> runs;
  for (const Example2Case& wanted : example.cases) {
    const SceneJoint& joint = wanted.scene.joints.front();
    const auto found = std::ranges::find_if(films.crank, [&](const RealFilmCrank& each) {
      const SceneJoint& other = each.scene.joints.front();
      return other.film == drawn_film && other.clearance == joint.clearance && other.viscosity == joint.viscosity;
    });
    if (found == films.crank.end()) return {};
    runs.push_back(&found->run);
  }
  return runs;
}

std::string pair_of(const SceneJoint& joint) {
  return fmt::format("{:g} mm, {:g} Pa s", 1e3 * joint.clearance, joint.viscosity);
}

std::string words_of(const std::optional<BeyondTable>& beyond) {
  if (!beyond) return "no";
  const double off = beyond->difference + beyond->bound;
  if (off < 1e-5) return fmt::format("{:.2g} %, < 0.001 %", 100 * beyond->share);
  return fmt::format("{:.2g} %, {} {:.2g} %", 100 * beyond->share, beyond->bound > beyond->difference ? "<" : "to",
                     100 * off);
}

std::string real_films_table(const RealFilms& films) {
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
      "beyond the table      verdict\n";
  for (const RealFilmCrank& item : films.crank) {
    const double clearance = item.scene.joints[0].clearance;
    const double farthest = item.run.joints[0].eccentricity.value;
    const DriverExtremes& moment = item.run.drivers[0];
    text += fmt::format("{:<16}  {:<16}{:12.4f}{:17.3f}{:19.2f}{:9.3f} to {:<9.3f} {:<20}  {}\n",
                        item.scene.joints[0].film, pair_of(item.scene.joints[0]), farthest / clearance,
                        1e6 * (clearance - farthest), item.run.joints[0].force.value, moment.min_moment.value,
                        moment.max_moment.value, words_of(item.beyond), item.verdict.in_letters());
  }
  return text +
         "Beyond the table: at this share of the output times e/c is larger than any at which the table's error was\n"
         "measured; and how far its continuation is off the solver's force, where it is largest there (not judged).\n" +
         check_legend(films.crank_verdicts());
}

}  // namespace lubjoint::reports
