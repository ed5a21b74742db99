#include <stdexcept>

#include "oracle/measure/stress/stress_references.hpp"

namespace lubjoint::reports {

StressReference make_stress_reference(const Scene&) {
  throw std::invalid_argument(
      "this program was built without quadruple precision, which reference motions need; build it with "
      "-DLUBJOINT_CERTIFIED=ON");
}

void make_stress_references(const std::vector<StressCase>& cases, const std::vector<std::string>& laws,
                            const std::filesystem::path&, unsigned) {
  if (!cases.empty() && !laws.empty()) make_stress_reference(cases.front().scene);
}

}  // namespace lubjoint::reports
