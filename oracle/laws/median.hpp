/// The middle one of some numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace lubjoint::reports {

/// @param values  one or more
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace lubjoint::reports
