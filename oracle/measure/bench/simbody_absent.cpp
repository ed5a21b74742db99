#include "oracle/measure/bench/simbody_case.hpp"

namespace lubjoint::reports {

std::vector<std::string_view> simbody_methods() { return {}; }
std::string simbody_version() { return {}; }

std::unique_ptr<BenchCase> simbody_case(const Scene&, const std::vector<double>&, const Reference&) { return nullptr; }

}  // namespace lubjoint::reports
