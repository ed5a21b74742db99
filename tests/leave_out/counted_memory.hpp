/// Counts every allocation of this program: malloc and its relatives are replaced when it is linked (--wrap), and
/// operator new is made of malloc.
#pragma once

#include <cstddef>

namespace lubjoint::test {

/// Allocations since the program began, of all threads.
std::size_t allocations();

}  // namespace lubjoint::test
