#include "oracle/files/program_identity.hpp"

#include <stdexcept>

#include "lubjoint/version.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"

namespace lubjoint::reports {

std::string program_identity() {
  std::string text = LUBJOINT_VERSION;
  try {
    text += " " + sha256(read_input("/proc/self/exe"));
  } catch (const std::invalid_argument&) {  // no such file on this system: the version has to do
  }
  return text;
}

}  // namespace lubjoint::reports
