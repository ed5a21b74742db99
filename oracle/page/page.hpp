/// report.html: everything that `reproduce` found, as one file that needs no network and no server.
///
/// The plots are gnuplot's SVG inside of the page. A plotting library of the npm registry would bring the toggles and
/// hovering with it, but Node, npm and some five hundred packages to a bare Debian, a second package index to trust,
/// and a bundle larger than all the data. gnuplot is needed anyway, is in Debian, draws without a script running (on
/// paper, too), and its lines take the page's colours. The one plot that people want to question, error against run
/// time, is drawn by run_time.js from the CSV that the page carries.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "oracle/laws/law_check.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/page/proof_ledger.hpp"
#include "oracle/page/provenance.hpp"
#include "oracle/page/run_data.hpp"
#include "oracle/page/space_example.hpp"
#include "oracle/paper/example_1.hpp"
#include "oracle/paper/example_2.hpp"
#include "oracle/paper/real_film.hpp"

namespace lubjoint::reports::page {

/// How far the laws are from the film of the bearing's real length.
struct BearingModelError {
  double length_to_diameter = 0;
  std::vector<ModelErrorEntry> map;
  std::vector<LoadedState> loaded;         ///< under the load of example 1
  std::vector<VisitedModelError> visited;  ///< by the orbits of example 1, in the order of the laws
};

/// What the page tells of.
struct Content {
  Example1 journal;
  Example2 slider_crank;
  SpaceExample space;
  LawChecks laws;
  BearingModelError model_error;
  std::optional<RealFilms> real_films;  ///< both examples with films of finite length, where they were run
  std::optional<ProofLedger> proofs;    ///< the stored ledger, where it is there
  std::optional<RunTimes> run_times;    ///< error against run time, where it was measured
  std::optional<Stability> stability;   ///< extreme cases, where they were run
  Provenance provenance;

  /// Did everything that this run checked agree? What it did not check does not count, nor do stored runs.
  bool passed() const;
  /// Is none of the stored extreme cases wrong?
  bool stored_runs_are_right() const;
};

/// The model error of example 1's bearing. @param example  with at least one law
BearingModelError bearing_model_error(const Example1& example);

/// What the film of a law costs at its equilibrium, and the rotor that it keeps stable there.
struct RestLosses {
  double torque_journal = 0;            ///< on the journal about its centre [N m]
  double torque_bearing = 0;            ///< on the bearing about its centre [N m]
  double power = 0;                     ///< lost in the film [W]
  std::optional<double> side_flow;      ///< [m³/s]; none of a long bearing
  std::optional<double> critical_mass;  ///< [kg], infinite: every mass is stable; none without load or spin
  std::optional<double> whirl_ratio;    ///< whirl over spin at that mass; none where it is infinite or there is none
};

/// At the equilibrium of a law of example 1, with the scene's shear, else that of the film. @throws SceneError
RestLosses losses_at_rest(const Example1Law& item);

/// One row a law; what is not defined is empty.
std::string losses_at_rest_csv(const Example1& example);

/// The page. The same content gives the same bytes.
/// @throws OutputError if gnuplot is missing or fails
std::string report_page(const Content& content);

/// Writes the page into a folder. @returns the file's name
std::string write_page(const Content& content, const std::filesystem::path& folder);

}  // namespace lubjoint::reports::page
