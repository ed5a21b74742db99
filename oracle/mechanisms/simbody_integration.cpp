#include "oracle/mechanisms/simbody_integration.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace lubjoint::mechanisms {

Silence::Silence() : before_(::dup(STDERR_FILENO)) {
  const int nowhere = ::open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  std::fflush(stderr);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

Silence::~Silence() {
  if (before_ < 0) return;
  std::fflush(stderr);
  ::dup2(before_, STDERR_FILENO);
  ::close(before_);
}

std::string simbody_version() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace lubjoint::mechanisms
