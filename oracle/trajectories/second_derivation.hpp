/// What each golden trajectory is held against besides the methods that made it: a derivation of its own, from
/// oracle/mechanisms alone, integrated by a method of its own.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/scene.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/trajectories/disagreement.hpp"
#include "oracle/trajectories/trajectory_columns.hpp"

namespace lubjoint::reports {

/// A trajectory of a scene.
struct SecondDerivation {
  std::string how;                ///< in a few words
  TrajectoryColumns columns;      ///< those of the scene's file
  TrajectoryValues<double> rows;  ///< at each of the times
  /// Of each row: what ten times the tolerance changes, in the measure of `disagreement`; 0 of a closed form.
  std::vector<double> own_error;
};

/// | scene | derivation | method |
/// |---|---|---|
/// | free journal, any law; journal with contact | turning frame, own contact and sliding | Lobatto IIIC, own events |
/// | slider-crank with one film, driven | rod angle and slider position | Lobatto IIIC |
/// | slider-crank, ideal and driven | loop of the mechanism; moment from the energy | closed form |
/// | slider-crank, ideal, constant moment | energy integral ½Iθ˙² = Mθ, and its quadrature | quadrature and Newton |
///
/// In 64-bit significands.
/// @param law  of the film, in place of the scene's own; empty: the scene's own
/// @throws std::invalid_argument if there is none of this scene; std::runtime_error if an integration stops
SecondDerivation second_derivation(const Scene& scene, const std::string& law, const std::vector<double>& times);

/// How far a stored trajectory is from its second derivation.
struct SecondAgreement {
  std::string how;
  std::vector<double> apart;    ///< of each row: as `disagreement`
  std::vector<double> allowed;  ///< of each row
  double digits = 0;            ///< −log10 of the largest

  bool agrees(std::size_t row) const { return apart[row] <= allowed[row]; }
  /// The first row that does not agree; the number of rows if all do.
  std::size_t first_wrong() const;
};

/// Compares every row and every column. Allowed is what the file states (the largest `disagreement` up to the row: a
/// trajectory does not forget its errors), the second derivation's own error, and half a unit of the last printed digit
/// of each component.
/// @throws CsvError if the file has other columns or rows than the derivation
SecondAgreement second_agreement(const SecondDerivation& second, const CsvTable& file);

/// The same, with the derivation made at the file's times.
SecondAgreement second_agreement(const Scene& scene, const std::string& law, const CsvTable& file);

}  // namespace lubjoint::reports
