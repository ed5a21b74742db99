/// Turns and degrees.
#pragma once

#include <numbers>

namespace lubjoint::reports {

inline constexpr double two_pi = 2 * std::numbers::pi;     ///< a turn [rad]
inline constexpr double degrees = 180 / std::numbers::pi;  ///< in a radian

}  // namespace lubjoint::reports
