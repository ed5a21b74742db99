/// Medians of run times.
#pragma once

#include <functional>
#include <vector>

namespace lubjoint::reports {

/// The middle value; of an even number of them, the upper of the two.
double median_of(std::vector<double> values);

/// Median time of each piece of work [ns]. A repeat runs all of them once, one after the other, so that what slows the
/// machine down for a while slows all of them, and ratios stay.
std::vector<double> interleaved_medians(int repeats, const std::vector<std::function<void()>>& work);

}  // namespace lubjoint::reports
