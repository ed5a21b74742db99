/// Reference trajectories of a free journal, in extended precision.
///
/// Written anew from the published polar forms: it shares no force law and no event logic with lib. Two integrators of
/// different families, an implicit collocation method and an explicit Runge–Kutta pair, are made to agree; the digits
/// on which they do are what is printed.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// A free journal that starts at rest at the centre of a fixed bearing. SI units; all inputs are exact doubles.
struct JournalCase {
  double length;
  double journal_radius;
  double clearance;
  double viscosity;
  double mass;
  std::array<double, 2> load;     ///< applied force [N]
  std::array<double, 2> gravity;  ///< [m/s²]; the weight is mass · gravity, formed without rounding
  double spin;                    ///< of the journal [rad/s]
  std::vector<double> times;      ///< increasing, above 0 [s]
};

/// State at one time, by two integrators: e/c, ė/c [1/s], force on the journal [N]. Decimal digits.
struct TrajectoryRow {
  double t;
  std::array<std::string, 6> value;
  /// Largest distance of the two, of ê, ė/c and the force, over the largest size of that vector along the trajectory.
  double disagreement;
};

/// A time at which a half film changed its mode.
struct ModeChange {
  std::string t;
  std::string mode;  ///< the one that begins: converging, mirrored or sliding
};

struct ReferenceTrajectory {
  std::vector<TrajectoryRow> rows;
  std::vector<ModeChange> modes;
  double agreed_digits = 0;  ///< −log10 of the largest disagreement
};

/// @param tolerance  relative, of a step; 1e-20 gives about 17 digits
/// @throws std::runtime_error if an integrator can't go on
ReferenceTrajectory reference_trajectory(const std::string& law, const JournalCase& journal, double tolerance);

/// CSV of a trajectory: t [s], e/c [-], ė/c [1/s], force on the journal [N], and the disagreement.
std::string trajectory_reference_csv(const ReferenceTrajectory& trajectory);

/// Times of the reference trajectories [s]: the first milliseconds closely, then every 20 ms to the end.
std::vector<double> reference_times(double duration);

}  // namespace lubjoint::reports
