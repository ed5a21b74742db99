/// What in a scene, or in the run of one, its author has probably not meant.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// The least thickness of film that surfaces of usual roughness bear, 1.5e-4 of the bearing's diameter [m]: 3 µm for 20
/// mm. Source: Flores et al. (2009), section 8; Hamrock has 2.5 µm there.
double safe_film_thickness(const SceneJoint& joint);

/// Sizes and speeds that can hardly be meant, a sentence each: c/R_B outside 1e-4…0.05, a journal that is larger than
/// the distances between the points of its mechanism, and spins that are a driver's speed in rpm or degrees.
std::vector<std::string> unit_warnings(const Scene& scene);

/// The same of joints in any mechanism.
/// @param mechanism  its size [m];  @param is_mechanism  has it more than one body?
std::vector<std::string> joint_unit_warnings(const std::vector<SceneJoint>& joints, double mechanism,
                                             bool is_mechanism);
/// The same of a driver, a sentence or none.
/// @param body  that it turns;  @param spin  of the body;  @param given  of it against the driver's other body; all
///   about the driver's axis at the start [rad/s]
std::vector<std::string> driver_unit_warnings(const std::string& driver, const std::string& body, double speed,
                                              double spin, double given);

/// Which unit a number may have been given in, if it is that much larger than what was needed; else empty.
std::string unit_guess(double given, double needed);

/// Where a law is a poor one for the shape of its bearing, a sentence each.
std::vector<std::string> law_warnings(const Scene& scene);

/// What bringing the start onto the constraints has moved by more than 1 % (of the mechanism's size, of a radian, of
/// the speed itself), by body, with what was given and what is needed.
std::vector<std::string> correction_warnings(const Scene& scene, const MultibodyTrajectory& run);

/// Says that a film was thinner than is safe; empty if it never was. One that gave way to contact is not a thin film.
/// @param thickness  least c − |e| of the run [m];  @param t  when [s]
std::string thin_film_warning(const SceneJoint& joint, double thickness, double t);

}  // namespace lubjoint::reports
