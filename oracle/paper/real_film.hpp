/// The paper's examples with the film of the bearing's real length, as the compiled laws have it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/laws/scene_films.hpp"
#include "oracle/paper/example_2.hpp"
#include "oracle/results/check.hpp"

namespace lubjoint::reports {

/// Example 1 with one film.
struct RealFilmJournal {
  Scene scene;
  JournalTrajectory run;
  JournalEquilibrium rest;
  Verdict verdict;
};

/// Where a run leaves the places at which its table's error was measured.
struct BeyondTable {
  double share;               ///< of the output times
  double eccentricity_ratio;  ///< at the one of them where the force is largest
  double difference;          ///< |F − F_solved|/|F_solved| there, F the table's continuation
  double bound;               ///< of the solver's own error there, likewise
};

/// "12 %, to 3 %": share, and how far the continuation is off, the solver's bound included; "<" where that bound is the
/// larger part, or all of it is less than a thousandth of a per cent; "no" where the run stays within the table.
std::string words_of(const std::optional<BeyondTable>& beyond);

/// Example 2, one of its five pairs of clearance and viscosity, with one film.
struct RealFilmCrank {
  Scene scene;
  MultibodyTrajectory run;
  Verdict verdict;
  std::optional<BeyondTable> beyond;  ///< of its joint; not judged
};

/// The scenes of example 2: 0.2 mm and 0.4 Pa s; then 0.1 and 0.5 mm; then 0.04 Pa s with 0.2 and 0.5 mm.
inline constexpr std::array<const char*, 5> slider_crank_pairs = {
    "slider-crank.toml", "slider-crank-c0.1-mu0.4.toml", "slider-crank-c0.5-mu0.4.toml",
    "slider-crank-c0.2-mu0.04.toml", "slider-crank-c0.5-mu0.04.toml"};

/// Clearance and viscosity of a joint in words.
std::string pair_of(const SceneJoint& joint);

/// Both examples with finite_full, finite_half, finite_dynamic and finite_reynolds, in this order; of example 2 all
/// four for each of its pairs, as slider_crank_pairs has them.
struct RealFilms {
  std::vector<RealFilmJournal> journal;
  std::vector<RealFilmCrank> crank;

  std::vector<const Verdict*> journal_verdicts() const;
  std::vector<const Verdict*> crank_verdicts() const;
  bool passed() const;
};

/// Runs them. Each place of rest is held against the one that the solver of Reynolds' equation finds, and forces along
/// each run against the solver's; of example 2 the energy ledger has to close.
/// @param scenes  folder with journal.toml and the scenes of slider_crank_pairs
RealFilms run_real_films(const std::filesystem::path& scenes, SceneFilms& films);

/// Forces at some states of a run against the solver, over |F|: the largest difference and the largest that the table's
/// stated error and the solver's bounds allow. States beyond the table, at rest and on the jump of a half film are left
/// out.
Check solved_force_check(const Scene& scene, const JournalTrajectory& run);
Check solved_force_check(const Scene& scene, const MultibodyTrajectory& run);

/// What a run's joint is off beyond its table, at the output times; nothing where it stays within.
std::optional<BeyondTable> beyond_table(const Scene& scene, const MultibodyTrajectory& run);

/// The film that both examples are drawn with beside the paper's: Reynolds' equation with its free boundary.
inline constexpr std::string_view drawn_film = "finite_reynolds";

/// The runs of example 2's cases with that film, in their order; none where one of them was not made.
std::vector<const MultibodyTrajectory*> drawn_runs(const RealFilms& films, const Example2& example);

/// The tables that people read.
std::string real_films_table(const RealFilms& films);

}  // namespace lubjoint::reports
