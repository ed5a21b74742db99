/// How far each law is off, to be looked up by L/D and eccentricity ratio.
#pragma once

#include <string>

namespace lubjoint::reports {

/// |F_law − F|/|F|, F the finite-length film of Swift and Stieber with a free onset, as CSV
///   length_over_diameter,eccentricity_ratio,law,median,closing,sliding,opening
/// for L/D ⅛, ¼, ½, 1, the paper's 2.0408… and 4, ε 0.1, 0.3, 0.5, 0.7 and 0.9, and every law that is a formula, fits
/// among them (a fit is left out where it is not made for the L/D). Over the directions of model_error_map's grid: the
/// median of all, and the largest where u is within 60° of e, across it, and within 60° against it. Two digits, and
/// none beyond 1e-3, which is the solver's bound.
std::string model_error_lookup();

}  // namespace lubjoint::reports
