/// What is said of an error of a law, in tables and in warnings.
#pragma once

#include <string>

namespace lubjoint::reports {

/// An error as it is read: a share in per cent, from ten on as a multiple.
std::string error_words(double error);

/// The law that has the film of the bearing's real length, if it can be compiled; with a blank behind it.
/// @param shape  L/D
std::string remedy(double shape);

}  // namespace lubjoint::reports
