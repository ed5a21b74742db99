/// A scene of the plane as one in space, for tests.
#pragma once

#include "oracle/trajectories/embedded_scene.hpp"

namespace lubjoint::test {

using reports::allow_what_is_redundant;
using reports::Embedding;
using reports::Plane;
using reports::some_plane;

}  // namespace lubjoint::test
