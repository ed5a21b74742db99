/// Force and pressure of a lubricant film of finite length, by solving Reynolds' equation around and along it.
#pragma once

#include <string_view>
#include <vector>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint::oracle {

/// Where the finite-length film carries pressure. P = 0 at |z| = L/2 in all of them, and
///   finite_full      periodic around the bearing, negative pressure kept;
///   finite_half      p = 0 at θ = 0 and π for a ≥ 0, at π and 2π for a < 0; nothing elsewhere;
///   finite_dynamic   p = 0 at θs = atan2(2b, a) and θs + π; nothing elsewhere;
///   finite_reynolds  p ≥ 0, and p = ∂p/∂n = 0 where it ruptures and reforms (Swift–Stieber), a complementarity
///   problem.
enum class FiniteFilm { finite_full, finite_half, finite_dynamic, finite_reynolds };

std::string_view name_of(FiniteFilm film);
/// @throws std::invalid_argument that lists the films there are
FiniteFilm finite_film_of(std::string_view name);

/// Where the film of finite_reynolds reforms: wherever the complementarity problem says, or, in a steady wedge (b = 0),
/// at the maximum film, as Raimondi and Boyd (1958) and Butenschön (1976) have it. In squeeze (b ≠ 0) nothing is
/// pinned: the pressure may lie across the maximum film. The other films do not ask.
enum class FilmOnset { free, maximum_film };

/// How full, half and dynamic films are solved: two solvers that share the equation and no step.
///   axial_series           harmonics along the axis, spectral elements around it (smooth_film.hpp);
///   circumferential_modes  eigenfunctions around the film, the axis in closed form (circumferential_modes.hpp): a
///                          millisecond, but an estimate that grows for ε > 0.999.
/// The grids of finite_reynolds do not ask.
enum class SmoothFilmMethod { axial_series, circumferential_modes };

struct FiniteLengthOptions {
  double relative_tolerance = 1e-3;  ///< of the error estimate in |F|, 1e-12 to 0.1
  FilmOnset onset = FilmOnset::free;
  SmoothFilmMethod method = SmoothFilmMethod::axial_series;
};

/// A force on the journal with the estimated bounds of its error.
struct FiniteLengthResult {
  double radial = 0;            ///< along the eccentricity [N]
  double tangential = 0;        ///< 90° counter-clockwise of it [N]
  double radial_error = 0;      ///< [N]
  double tangential_error = 0;  ///< [N]
  /// Order of convergence seen in the last refinements: in the step for finite_reynolds (2 expected), in the degree of
  /// the elements for the others, whose convergence is exponential. Not a number where nothing was refined (u = 0) or
  /// where the last change was lost in rounding.
  double observed_order = 0;
  int unknowns = 0;            ///< of the largest system of equations
  bool tolerance_met = false;  ///< the error estimate is within the tolerance asked for
};

/// Force of a finite-length film on the journal:
///   (1/R²) ∂θ(H³ ∂θp) + H³ ∂zz p = −(6μ/c²)(a sinθ − 2b cosθ),   F = R ∬ p (cosθ, sinθ) dθ dz
/// Source: Reynolds (1886); the films as in FiniteFilm. Without dimensions: p = 6μ(R/c)² P, ζ = z/R, so that
/// F = 6μ(R²/c)² f(L/D, ε, a, b).
/// @param state  0 ≤ ε < 1, a and b [1/s]
/// Validity: any L/D and ε for full, half and dynamic. finite_reynolds is meant for L/D 0.05…10 and ε ≤ 0.99; beyond,
/// its grids resolve less, and the error estimate grows.
/// Accuracy: full, half and dynamic reach 1e-10 of |F|. finite_reynolds reaches 1e-3 in a few milliseconds and about
/// 1e-5 in a tenth of a second, or two seconds where it has to take its finest grids; a force that nearly vanishes, as
/// that of a separating film (b < 0) at ε > 0.9, less.
/// @throws std::invalid_argument if the tolerance is outside of its range
FiniteLengthResult finite_length_force(FiniteFilm film, const Bearing<double>& bearing, const Lubricant<double>& oil,
                                       const PolarFilmState<double>& state, const FiniteLengthOptions& options = {});

/// What leaves a film by both sides, net, with the estimated bound of its error.
struct FiniteLengthFlow {
  double side_flow = 0;        ///< [m³/s]
  double error = 0;            ///< [m³/s]
  double observed_order = 0;   ///< as of the force
  int unknowns = 0;            ///< of the largest system of equations
  bool tolerance_met = false;  ///< the error estimate is within the tolerance asked for
};

/// Side flow of a finite-length film out of both sides, net:
///   Q = cR² ∫ −H³ ∂ζP dθ,   ζ = z/R = Λ,   p = 6μ(R/c)² P; the viscosity cancels.
/// Source: the mean velocity −(h²/12μ) ∂p/∂z of Poiseuille's flow at z = ±L/2. As L/D → 0 it is the short bearing's,
/// cRL ∫ u·m dθ. Of a full film it is zero, as everything that the motion displaces on one half of the circle is drawn
/// in on the other. A half or dynamic film also has flow through its cut ends, which leaves the film, not the bearing,
/// and is not in it.
/// @param options  the tolerance is a share of 2cRL|u|, which is all that the motion displaces: the net flow may vanish
/// Accuracy: half and dynamic films reach 1e-9 of 2cRL|u|, finite_reynolds about 1e-4.
/// @throws std::invalid_argument if the tolerance is outside of its range
FiniteLengthFlow finite_length_flow(FiniteFilm film, const Bearing<double>& bearing,
                                    const PolarFilmState<double>& state, const FiniteLengthOptions& options = {});

/// ∬ dθ dz/(LH) over the part of a gap that carries pressure, with the estimated bound of its error.
struct FiniteLengthCouette {
  double integral = 0;         ///< I₁ [-]
  double error = 0;            ///< [-]
  double observed_order = 0;   ///< as of the force
  int unknowns = 0;            ///< of the largest system of equations
  bool tolerance_met = false;  ///< the error estimate is within the tolerance asked for
};

/// What finite_reynolds with a free onset shears: I₁ = (1/L) ∬_{p>0} dθ dz/H, of which a journal with the relative spin
/// ω has the torque (μωR³L/c) I₁. As L/D → 0 it is the short dynamic film's, (2/√q) atan2(√q, −ê·u/|u|). At u = 0,
/// where it depends on how the motion dies away, it is half of the whole gap's, π/√q, as of the dynamic film. The other
/// films' bounds are known, and their integrals closed forms.
/// Accuracy: about 1e-4; a millisecond or some to 1e-3.
/// @param relative_tolerance  of the error estimate in I₁, 1e-12 to 0.1
/// @throws std::invalid_argument if the tolerance is outside of its range
FiniteLengthCouette finite_reynolds_couette(const Bearing<double>& bearing, const PolarFilmState<double>& state,
                                            double relative_tolerance = 1e-3);

/// A pressure at a place, the film's largest, and a bound of the error.
struct FiniteLengthPressure {
  double pressure = 0;  ///< [Pa]
  double largest = 0;   ///< of its magnitudes in the whole film, to a percent or so [Pa]
  double error = 0;     ///< [Pa]
};

/// Pressure of a finite-length film at one place; zero outside of the film and of the bearing.
/// @param theta  from the maximum film, counter-clockwise [rad]
/// @param zeta  z/R, from the middle
/// Accuracy, of the largest pressure: 1e-6; finite_reynolds 6e-4 for L/D ¼ to 2, ε ≤ 0.9, in a seventh of a second.
FiniteLengthPressure finite_length_pressure_at(FiniteFilm film, const Bearing<double>& bearing,
                                               const Lubricant<double>& oil, const PolarFilmState<double>& state,
                                               double theta, double zeta, FilmOnset onset = FilmOnset::free);

/// A pressure field on a grid over the whole bearing.
struct PressureField {
  std::vector<double> theta;     ///< from the maximum film, counter-clockwise, 0…2π, both ends included [rad]
  std::vector<double> z;         ///< −L/2…L/2, both ends included [m]
  std::vector<double> pressure;  ///< [Pa]; pressure[i * z.size() + j] belongs to theta[i], z[j]
};

/// Pressure of a finite-length film at evenly spaced angles and stations.
/// Accuracy: about 1e-6 of the largest pressure; finite_reynolds about 1e-3, as it is solved on one grid, at least as
/// fine as the one asked for, and interpolated linearly.
/// @param angles  3 to 10000;  @param stations  3 to 1000
/// @throws std::invalid_argument if a count is outside of its range
PressureField finite_length_pressure(FiniteFilm film, const Bearing<double>& bearing, const Lubricant<double>& oil,
                                     const PolarFilmState<double>& state, int angles, int stations,
                                     FilmOnset onset = FilmOnset::free);

}  // namespace lubjoint::oracle
