/// The finite-length film as a law of the film's state, to hold laws and programs against.
#pragma once

#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::oracle {

/// A force over the force scale S = μLR³/c², with a bound of its error.
struct FiniteForce {
  Vector2<double> ratio;      ///< F/S on the journal, in the frame of the state [1/s]
  double error = 0;           ///< bound of |F − F_exact|/S [1/s]
  bool tolerance_met = true;  ///< the bound is within the tolerance asked for

  /// The bound over |F|; infinite where there is no force.
  double relative_error() const;
};

/// Force of a finite-length film of one L/D at a state of the film: finite_length_force (which has the equation, the
/// solvers and what they reach) in the frame of the state, without the bearing's other dimensions. At ê = 0 the radial
/// direction is that of u; at u = 0 the force is zero.
/// @param length_to_diameter  L/(2R)
/// @throws std::invalid_argument if L/D is not a finite number above 0, or the tolerance is outside of its range
FiniteForce finite_force(FiniteFilm film, double length_to_diameter, const FilmState<double>& state,
                         const FiniteLengthOptions& options = {});

/// A side flow over cRL, with a bound of its error.
struct FiniteFlow {
  double ratio = 0;           ///< Q/(cRL) [1/s]
  double error = 0;           ///< [1/s]
  bool tolerance_met = true;  ///< the bound is within the tolerance asked for
};

/// What leaves a finite-length film by both sides, net, at a state of the film: finite_length_flow without the
/// bearing's other dimensions. At u = 0 it is zero.
/// @param options  the tolerance is a share of 2|u|
/// @throws std::invalid_argument as finite_force
FiniteFlow finite_side_flow(FiniteFilm film, double length_to_diameter, const FilmState<double>& state,
                            const FiniteLengthOptions& options = {});

/// I₁ of what is sheared, with a bound of its error.
struct FiniteCouette {
  double integral = 0;        ///< [-]
  double error = 0;           ///< [-]
  bool tolerance_met = true;  ///< the bound is within the tolerance asked for
};

/// I₁ = (1/L) ∬_{p>0} dθ dz/H of finite_reynolds with a free onset, at a state of the film: finite_reynolds_couette
/// without the bearing's other dimensions.
/// @param relative_tolerance  of I₁
/// @throws std::invalid_argument as finite_force
FiniteCouette finite_couette_integral(double length_to_diameter, const FilmState<double>& state,
                                      double relative_tolerance = 1e-3);

/// A pressure over μ(R/c)², the film's largest, and a bound of the error.
struct FinitePressure {
  double ratio = 0;    ///< p/(μ(R/c)²) [1/s]
  double largest = 0;  ///< [1/s]
  double error = 0;    ///< [1/s]
};

/// Pressure of a finite-length film of one L/D at a place: finite_length_pressure_at without the bearing's other
/// dimensions. At u = 0 it is zero.
/// @param theta  from the maximum film [rad];  @param zeta  z/R
/// @throws std::invalid_argument as finite_force
FinitePressure finite_pressure(FiniteFilm film, double length_to_diameter, const PolarFilmState<double>& state,
                               double theta, double zeta, FilmOnset onset = FilmOnset::free);

}  // namespace lubjoint::oracle
