/// Reference trajectories of multibody scenes, in extended precision (64-bit significands), each by two methods.
#pragma once

#include <string>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::reports {

/// A reference trajectory as its file has it, and how well its methods agree.
struct ReferenceCsv {
  std::string csv;
  double agreed_digits;  ///< −log10 of the largest disagreement
};

/// At a hundredth of the duration and its multiples: t [s]; for each joint NAME.ex_over_c, NAME.ey_over_c [-] and
/// NAME.fx, NAME.fy on the journal [N]; without joints for each body NAME.x, NAME.y [m] and NAME.phi [rad]; for each
/// driver NAME.moment [N m]; and `disagreement`, the largest distance of the methods' vectors over the vector's largest
/// size.
///
/// | scene | printed | compared with |
/// |---|---|---|
/// | slider-crank with one film | minimal coordinates, Fehlberg 7(8) | absolute coordinates, Radau IIA(5) |
/// | slider-crank, ideal and driven | closed form | absolute coordinates, both integrators |
/// | any other | absolute coordinates, Radau IIA(5) | absolute coordinates, Fehlberg 7(8) |
///
/// Numbers are printed to 1e-15 or better of the vector's largest size along the trajectory.
/// @throws std::runtime_error if a run stops
ReferenceCsv multibody_reference(const Scene& scene);

}  // namespace lubjoint::reports
