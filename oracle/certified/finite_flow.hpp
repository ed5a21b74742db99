/// Golden side flows of films of finite length, by two solvers that share no step.
#pragma once

#include <string>
#include <vector>

#include "oracle/certified/finite_force.hpp"
#include "oracle/certified/golden.hpp"

namespace lubjoint::certified {

/// A side flow over cRL [1/s], out of both sides, net, and a bound of its error.
struct FiniteGoldenFlow {
  double flow;
  double uncertainty;
};

/// The states of the golden forces, but those of full films: these lose nothing.
std::vector<FiniteGoldenState> finite_flow_states();

/// Half and dynamic films by the axial series and by the circumferential modes, finite_reynolds by finite volumes and
/// by finite elements; the flow is the first one's. The uncertainty is what they differ by, and their own bounds; of
/// finite_reynolds that of the finite volumes.
FiniteGoldenFlow finite_golden_flow(const FiniteGoldenState& state);

inline constexpr const char* finite_flow_file = "finite_film_side_flow.csv";

/// The file's text.
std::string finite_flow_csv(const GoldenRun& run);

/// What of the file's text is not as it is made again, one row in run.every: beyond both uncertainties together.
std::vector<reports::GoldenDifference> check_finite_flow(const std::string& text, const GoldenRun& run);

}  // namespace lubjoint::certified
