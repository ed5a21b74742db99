/// The slider-crank scenes' answers by other means: closed form and minimal coordinates.
#pragma once

#include <complex>
#include <vector>

#include "lubjoint/scene/simulate.hpp"
#include "oracle/mechanisms/slider_crank.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

/// Journal in its bearing, and the driving moment, at an instant.
struct ReferenceSample {
  Vector2<double> eccentricity_ratio;  ///< ê
  Vector2<double> force;               ///< on the journal [N]
  double driving_moment;               ///< [N m]
};

/// The largest values along a run in minimal coordinates, found without the recorder of the library's runs.
struct ReferencePeaks {
  Peak eccentricity_ratio;  ///< |ê|
  Peak force;               ///< |F| on the journal [N]
  Peak max_moment;          ///< of the driver [N m]
  Peak min_moment;          ///< least, of either sign [N m]
};

struct ReferenceRun {
  std::vector<ReferenceSample> samples;
  ReferencePeaks peaks;
};

/// The motion that repeats itself, and what becomes of a small deviation from it in one revolution.
struct PeriodicOrbit {
  double residual = 0;                            ///< |P(y) − y| of the revolution map, in clearances
  double distance = 0;                            ///< of the run's last state from it, |Δê|
  std::vector<std::complex<double>> multipliers;  ///< of the revolution map, largest first
};

/// Masses and lengths of a slider-crank scene with bodies crank, rod and slider.
/// @throws std::invalid_argument  a scene of another kind
mechanisms::SliderCrank<double> slider_crank_of(const Scene& scene);

bool has_contact(const Scene& scene);

/// A slider-crank that starts extended, driven, with one Pinkus–Sternlicht film and no contact.
bool has_minimal_coordinates(const Scene& scene);

/// The scene in minimal coordinates, in 64-bit significands by Fehlberg's 7(8).
/// @param times  ascending, the first 0
/// @param start  (q, q̇) of all bodies, the crank at 0; empty: e = 0 and the ideal velocities
std::vector<ReferenceSample> minimal_coordinates_run(const Scene& scene, const std::vector<double>& times,
                                                     double tolerance, const std::vector<long double>& start = {});

/// The same with its peaks: every local maximum of the samples that comes near the largest is searched between its
/// neighbours by Brent's method, each trial integrated anew from the sample before.
/// @param times  close enough that no peak lies hidden between two
ReferenceRun minimal_coordinates_run_with_peaks(const Scene& scene, const std::vector<double>& times, double tolerance);

/// The periodic orbit by Newton's method on the revolution map in minimal coordinates.
/// @param last  ê at the end of a run of whole revolutions
PeriodicOrbit periodic_orbit(const Scene& scene, const Vector2<double>& last);

}  // namespace lubjoint::reports
