/// How far each force law is from the film of the bearing's real length.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/scene/simulate.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::reports {

/// The finite-length films that laws are compared with: those that let the film rupture.
inline constexpr std::array<oracle::FiniteFilm, 3> compared_films = {
    oracle::FiniteFilm::finite_half, oracle::FiniteFilm::finite_dynamic, oracle::FiniteFilm::finite_reynolds};

/// States of a map: every ε with directions of u. Mirror symmetry leaves half of the directions: those with a ≥ 0, from
/// pure opening (−180°… of u from e) over pure wedge (−90°) to pure closing (0).
struct ModelErrorGrid {
  std::vector<double> eccentricity_ratios;
  std::size_t directions = 13;       ///< at least 2, from −180° to 0, both included
  double relative_tolerance = 1e-3;  ///< of the finite-length force

  static ModelErrorGrid standard();
};

/// |F_law − F|/|F| at one state, F the finite-length film's force.
struct ModelErrorEntry {
  std::string_view law;
  oracle::FiniteFilm film;
  double eccentricity_ratio;
  double direction;    ///< of u from the eccentricity [rad]
  double error;        ///< [-]
  double uncertainty;  ///< of F, over |F| [-]
};

/// The map for a bearing: it depends on L/D alone.
std::vector<ModelErrorEntry> model_error_map(const Bearing<double>& bearing, const ModelErrorGrid& grid);

/// One law against one film.
struct ModelErrorSummary {
  std::string_view law;
  oracle::FiniteFilm film;
  double median;
  double largest;
  std::array<double, 3> share_within;  ///< of the states within 5, 10 and 25 %
  /// The same by direction of motion: u within 60° of e (closing), across it (sliding), within 60° against it
  /// (opening).
  std::array<std::array<double, 3>, 3> by_direction;
  /// Largest ε up to which all closing or sliding states (b ≥ 0) are within 25 %; none if not even the smallest.
  std::optional<double> safe_ratio;
};

std::vector<ModelErrorSummary> summaries_of(const std::vector<ModelErrorEntry>& map);

/// Steady state under a constant load.
struct LoadedState {
  std::string name;  ///< of the law or the film
  double eccentricity_ratio;
  double attitude;  ///< from the load to e, positive with the spin [rad]

  /// The name as it is shown: the Swift–Stieber film is told by its onset, on which its answer depends.
  std::string label() const { return name == "finite_reynolds" ? name + ", free onset" : name; }
};

/// Equilibrium of a finite-length film: ε with |F| = W at b = 0, a = ε Σω, by bracketed root finding.
/// @throws std::invalid_argument if load or spin is not positive; std::domain_error if no ε up to 0.99 carries the load
LoadedState finite_equilibrium(oracle::FiniteFilm film, oracle::FilmOnset onset, const Bearing<double>& bearing,
                               const Lubricant<double>& oil, double load, double spin_sum);

/// The same for every law and every compared film (and finite_reynolds with pinned onset).
std::vector<LoadedState> loaded_states(const Bearing<double>& bearing, const Lubricant<double>& oil, double load,
                                       double spin_sum);

/// Error of the law that a run used, at states that the run visited, against finite_reynolds.
struct VisitedModelError {
  double median = 0;
  double largest = 0;
  std::size_t states = 0;
  double eccentricity_ratio_of_largest = 0;
};

/// @param states  how many samples of the run to look at, evenly spaced
VisitedModelError visited_model_error(const Scene& scene, const JournalTrajectory& run, std::size_t states = 7);
/// The same of one joint of a multibody run; a dry one has no states.
VisitedModelError visited_model_error(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run,
                                      std::size_t states = 7);
/// The same of a joint's journal, seen in its bearing at the samples of a run, in order.
VisitedModelError visited_model_error(const SceneJoint& joint, const std::vector<JournalMotion<double>>& motions,
                                      std::size_t states = 7);

/// One sentence if the law is more than 25 % off at half of the visited states or more; else empty.
std::string model_warning(const SceneJoint& joint, const VisitedModelError& error);
/// One sentence for several laws in the same bearing, which names the worst; empty if none is to be warned of.
/// @param errors  in the order of the joints
std::string model_warning(const std::vector<SceneJoint>& joints, const std::vector<VisitedModelError>& errors);

std::string model_error_table(const Bearing<double>& bearing, const std::vector<ModelErrorSummary>& summaries,
                              const std::vector<LoadedState>& loaded);
std::string model_error_csv(const std::vector<ModelErrorEntry>& map);
/// Map as a picture: a panel a law, ε against direction, the error in colour. @returns the files' names
std::vector<std::string> draw_model_error(const std::vector<ModelErrorEntry>& map, const std::filesystem::path& folder);

}  // namespace lubjoint::reports
