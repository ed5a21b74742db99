/// Which program it is: results of another one are not taken up.
#pragma once

#include <string>

namespace lubjoint::reports {

/// Version and checksum (SHA-256) of this very program, one line: other code may give other bits.
std::string program_identity();

}  // namespace lubjoint::reports
