/// Reference motions of the extreme cases: made by methods of other families than those that are judged, stored with
/// how far two of them agree, and read again.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "oracle/measure/stress/stress_cases.hpp"

namespace lubjoint::reports {

/// A journal in its bearing at an output time, and how much a motion's disturbances have grown by then.
struct ReferencePlace {
  double t = 0;           ///< [s]
  Vector2<double> place;  ///< ê = e/c
  Vector2<double> rate;   ///< its inertial rate [1/s]
  Vector2<double> force;  ///< on the journal [N]
  double growth = 1;  ///< largest factor by which a disturbance of ê or ê̇/V at an earlier output reaches this one
  double force_gain = 0;  ///< |∂F/∂ê| + V |∂F/∂ê̇|, over the unit of force: what a disturbance does to the force
};

/// The motion of one case with one law.
struct StressReference {
  std::string scenario;  ///< the first case that has it
  std::string law;
  std::string key;        ///< of the motion: what the scene says of it and nothing else (motion_key)
  std::string methods;    ///< how it was made, and with what it was compared
  double rate_unit = 1;   ///< V: what rates are measured by [1/s]
  double force_unit = 1;  ///< what forces are measured by [N]
  /// Largest distances of the two methods: places [clearances], rates over V, forces over their unit.
  std::array<double, 3> apart{};
  std::vector<ReferencePlace> rows;  ///< at the output times, the start left out; fewer if none could be had beyond
  std::string why_none;              ///< why there are none, or none beyond the last; else empty

  /// Does it reach the end of the motion?
  bool whole() const { return !rows.empty() && why_none.empty(); }
};

/// All numbers of a scene that a motion depends on, and no tolerance or integrator, as a checksum (SHA-256, 16 digits).
std::string motion_key(const Scene& scene);

/// References by motion.
class StressReferences {
 public:
  StressReferences() = default;

  /// Both files of a folder, `stress-references.csv` and `stress-reference-motions.csv`.
  /// @throws std::invalid_argument if one is missing, or a motion's rows do not have the checksum in its line;
  ///   CsvError
  static StressReferences read(const std::filesystem::path& folder);

  /// Writes both. @throws OutputError
  void write(const std::filesystem::path& folder) const;

  void add(StressReference reference);
  const StressReference* find(const std::string& key) const;
  const std::map<std::string, StressReference>& all() const { return by_key_; }

  /// That of a scene; one without rows, and with why, if the scene is another than any reference was made for.
  StressReference of(const Scene& scene) const;

 private:
  std::map<std::string, StressReference> by_key_;
};

inline constexpr const char* reference_table_name = "stress-references.csv";
inline constexpr const char* reference_motions_name = "stress-reference-motions.csv";

/// Two methods further apart than this, in places, are no reference [clearances].
inline constexpr double poor_agreement = 1e-6;

/// Makes the reference of a scene: none where two methods do not agree, with why.
StressReference make_stress_reference(const Scene& scene);

/// Makes those of all cases and laws that the folder's files do not have to their end, and writes the files after each:
/// an interrupted run goes on where it was.
/// @throws OutputError
void make_stress_references(const std::vector<StressCase>& cases, const std::vector<std::string>& laws,
                            const std::filesystem::path& folder, unsigned threads);

}  // namespace lubjoint::reports
