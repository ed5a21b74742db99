/// A scene's golden trajectory as the race's reference.
#pragma once

#include <optional>
#include <vector>

#include "oracle/measure/bench/bench_case.hpp"

namespace lubjoint::reports {

struct GoldenReference {
  std::vector<double> times;  ///< [s]
  Reference seen;             ///< at each time as Reference says, in the order of the scene's joints or bodies
  double disagreement;        ///< of the two methods behind it: of the vectors' largest size along the trajectory
};

/// The golden trajectory of a scene that ships; nothing for any other.
/// @param scene  as its file says
/// @throws CsvError if the trajectory can't be read
std::optional<GoldenReference> golden_reference(const Scene& scene);

}  // namespace lubjoint::reports
