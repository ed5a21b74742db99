/// What runs are held against.
#pragma once

#include <vector>

#include "lubjoint/number/vector.hpp"

namespace lubjoint::reports {

/// What errors are measured in, at one time after the other. With joints e/c of each; without, each body's mass centre
/// over the mechanism's size, and its angle [rad].
using Reference = std::vector<Vector2<double>>;

}  // namespace lubjoint::reports
