/// Stiffness, damping and threshold of stability of a journal at rest on its film, as tables.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/results/film_in_bearing.hpp"

namespace lubjoint::reports {

/// A steady state, in the frame of its load: x along the load on the journal, y 90° counter-clockwise of it.
struct CoefficientRow {
  double eccentricity_ratio;          ///< ε
  double omega;                       ///< [rad/s]
  double load;                        ///< [N]
  double attitude;                    ///< from the load to e, positive in the sense of the spin [rad]
  Eigen::Matrix2d stiffness;          ///< [N/m]
  Eigen::Matrix2d damping;            ///< [N s/m]
  double critical_mass;               ///< per bearing [kg]; infinite: every mass is stable
  std::optional<double> whirl_ratio;  ///< whirl over spin at that mass; none where it is infinite
  double difference;                  ///< of closed forms and exact derivatives, over the largest entry
};

/// At an eccentricity ratio. @throws FilmDomainError unless 0 < ε < 1 and ω is finite and not 0
CoefficientRow coefficients_at(const FilmInBearing& film, double eccentricity_ratio, double omega);

/// Under a load. @returns nothing if no ε from 1e-300 to 1 − 1e-15 carries it
std::optional<CoefficientRow> coefficients_under(const FilmInBearing& film, double load, double omega);

/// CSV of rows. @param dimensionless  cK/W, cωC/W and mcω²/W with the spin's magnitude, in place of SI units
/// @throws std::range_error if a number leaves the range of double
std::string coefficients_csv(const FilmInBearing& film, const std::vector<CoefficientRow>& rows, bool dimensionless);

/// Whirl over spin at the threshold as ε → 0; ½ of every film that is isotropic at the centre.
/// @param table  of a law that is compiled
double whirl_ratio_at_the_centre(std::string_view law, const CompiledFilm* table = nullptr);

/// What a user should know who asks for the stability of a rotor with this law; empty if nothing. A law is warned of
/// whose whirl at the centre is not half of the spin: its answer there depends on a direction that no film has.
/// @param table  of a law that is compiled
std::string stability_warning(std::string_view law, const CompiledFilm* table = nullptr);

/// Says how far a row is beyond the places at which a compiled law's stated error was measured; empty if it is not.
std::string beyond_table_note(const FilmInBearing& film, double eccentricity_ratio);

}  // namespace lubjoint::reports
