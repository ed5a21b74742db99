/// Stability of a rigid rotor in a bearing: its threshold, and maps of it over load or speed and mass.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "oracle/results/coefficient_table.hpp"

namespace lubjoint::reports {

/// A rotor's bearing, and what it carries. The load is held whatever the mass: a part of it that is weight does not
/// grow with the masses of a map.
struct RotorQuestion {
  FilmInBearing film;
  double load;                 ///< [N]
  double omega;                ///< spin of the journal, not 0 [rad/s]
  std::optional<double> mass;  ///< per bearing [kg]
};

/// A speed at which a rotor gains or loses its stability.
struct CriticalSpeed {
  double omega;       ///< magnitude [rad/s]
  bool stable_below;  ///< else: stable above
};

/// Two verdicts on a rotor of a certain mass, and what both say together.
enum class RotorStability { stable, unstable, undecided };

/// "yes", "no" or "undecided".
const char* rotor_stability_word(RotorStability stability);

struct RotorAnswer {
  CoefficientRow rest;         ///< with the critical mass by Routh's condition
  double mass_by_eigenvalues;  ///< the critical mass once more; infinite: every mass is stable
  std::optional<double> whirl_by_eigenvalues;
  std::optional<RotorStability> stability;     ///< of the mass, if there is one
  std::vector<CriticalSpeed> critical_speeds;  ///< of the mass under the load, ascending
};

/// @throws std::invalid_argument if the film does not carry the load
RotorAnswer rotor_answer(const RotorQuestion& question);

/// Is a mass below its threshold by Routh's condition, and do the eigenvalues say the same? Where they do not (on the
/// threshold itself, to rounding) it is undecided.
RotorStability rotor_stability(const CoefficientRow& rest, double mass);

std::string rotor_text(const RotorQuestion& question, const RotorAnswer& answer);
nlohmann::ordered_json rotor_json(const RotorQuestion& question, const RotorAnswer& answer);

/// What a map varies beside the mass.
enum class MapAxis { speed, load };

struct StabilityMap {
  MapAxis axis;
  std::vector<double> values;  ///< speeds [rad/s] or loads [N]
  std::vector<double> masses;  ///< [kg]
};

/// One row a point: load, omega, mass, eccentricity_ratio, critical_mass, whirl_ratio, growth_rate (the largest real
/// part of the eigenvalues [1/s]) and stable. Where the film does not carry the load, what follows the mass is empty.
std::string map_csv(const RotorQuestion& question, const StabilityMap& map);

/// Draws the map as NAME.svg and NAME.png. @throws OutputError
void draw_map(const RotorQuestion& question, const StabilityMap& map, const std::filesystem::path& folder,
              const std::string& name);

}  // namespace lubjoint::reports
