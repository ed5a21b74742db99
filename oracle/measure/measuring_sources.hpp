/// Which sources a measured table was made by.
#pragma once

#include <string>

namespace lubjoint::reports {

/// Version, and a checksum (SHA-256, 12 digits) of the sources that runs of scenes and their judgement come from: all
/// of lib, and oracle/measure/stress. What is measured stays true of them whatever else in the project changes; a
/// change of any of them changes this.
std::string measuring_sources();

}  // namespace lubjoint::reports
