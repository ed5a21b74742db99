/// A slider-crank with a clearance joint in Simbody, a multibody engine that nobody here wrote. In plain numbers, and
/// C++17: Simbody's headers are no C++20. Optional when the program is built.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "oracle/mechanisms/simbody_run.hpp"

namespace lubjoint::mechanisms {

/// Where the journal is in its bearing, in the inertial frame.
struct SimbodyPin {
  std::array<double, 2> eccentricity;  ///< [m]
  std::array<double, 2> velocity;      ///< its rate [m/s]
  double bearing_spin;                 ///< [rad/s]
  double journal_spin;                 ///< [rad/s]
};

/// A crank on the ground at the origin, driven at constant speed, a rod, a slider on the x axis; mass centres at
/// mid-length, no gravity. Starts extended, the crank along x. SI units.
struct SimbodyProblem {
  double crank_length;
  double crank_mass;
  double crank_inertia;  ///< of each body about its mass centre
  double rod_length;
  double rod_mass;
  double rod_inertia;
  double slider_mass;
  double crank_speed;     ///< [rad/s]
  double start_rod_spin;  ///< absolute [rad/s]
  double start_slider;    ///< distance from the origin [m]
  bool bearing_on_rod;    ///< the journal on the slider, or the other way round
  /// Force on the journal [N]. It may throw where it has none: the step is then tried again, shorter.
  std::function<std::array<double, 2>(const SimbodyPin&)> force;
};

/// Crank (Pin on the ground), rod (Pin on the crank) and slider (Slider on the ground), the joint between the last two
/// a custom force: three coordinates, the first of them prescribed.
class SimbodyEngine {
 public:
  explicit SimbodyEngine(const SimbodyProblem& problem);
  ~SimbodyEngine();
  SimbodyEngine(const SimbodyEngine&) = delete;
  SimbodyEngine& operator=(const SimbodyEngine&) = delete;

  /// By CPodes' BDF with Newton's iteration, Simbody's method for stiff systems. Its explicit ones and CPodes' Adams
  /// take ten times as long on these films.
  /// @param accuracy  Simbody's only tolerance, the same for all states
  /// @param duration  [s]
  /// @param times     to be looked at, ascending; none: only the end is reached, for its run time
  /// @param seconds   of processor time after which the run is given up
  SimbodyRun<SimbodyPin> run(double accuracy, double duration, const std::vector<double>& times, double seconds);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace lubjoint::mechanisms
