#include "oracle/measure/bench/simbody_case.hpp"
#include "oracle/measure/bench/simbody_space.hpp"

namespace lubjoint::reports {

std::vector<std::string_view> simbody_methods() { return {}; }
std::string simbody_version() { return {}; }

std::unique_ptr<BenchCase> simbody_case(const Scene&, const std::vector<double>&, const Reference&) { return nullptr; }
std::unique_ptr<BenchCase> simbody_spatial_case(const SpatialScene&, const std::vector<double>&, const Reference&,
                                                const FilmChange&) {
  return nullptr;
}

}  // namespace lubjoint::reports
