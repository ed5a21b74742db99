/// Options whose value is one of a list of names.
#pragma once

#include "oracle/files/require.hpp"

namespace lubjoint::cli {

using reports::require_name;

}  // namespace lubjoint::cli
