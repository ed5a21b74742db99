/// The largest values of several quantities along a run that are evaluated together.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lubjoint/run/largest_value.hpp"

namespace lubjoint {

/// Looks at a step in a few places; where these leave room for a value larger than all before it, in all of them.
/// @tparam R  of time
template <class R>
class StepLooks {
 public:
  /// @param pieces  into so many a step is divided
  StepLooks(std::size_t quantities, std::size_t pieces)
      : pieces_(pieces), largest_(quantities), looks_(quantities, std::vector<double>(pieces + 1)) {}

  /// The largest value of a quantity, and when.
  const LargestValue<R>& largest(std::size_t quantity) const { return largest_[quantity]; }

  /// A step.
  /// @param anew  may it begin with other values than the one before it has ended with, if at the same time?
  /// @param see  see(t, put) evaluates the step at t, and hands quantity k to put(k, value); its end comes before what
  ///             lies between its ends
  /// @param f  f(k, t) is quantity k at any time of the step;  @param confirm  as LargestValue::look
  template <class See, class Function, class Confirm>
  void step(const R& t_old, const R& t_new, bool anew, const See& see, const Function& f, const Confirm& confirm) {
    const auto time_of = [&](std::size_t i) {
      const double share = static_cast<double>(i) / static_cast<double>(pieces_);
      return i == pieces_ ? t_new : R(t_old + (t_new - t_old) * share);
    };
    const auto look_at = [&](std::size_t i) {
      see(time_of(i), [&](std::size_t k, double value) { looks_[k][i] = value; });
    };
    for (std::vector<double>& looks : looks_) looks.front() = looks.back();
    if (anew || t_old != seen_to_) look_at(0);
    seen_to_ = t_new;
    look_at(pieces_);
    const std::size_t stride = pieces_ > few && pieces_ % few == 0 ? pieces_ / few : 1;
    for (std::size_t i = stride; i < pieces_; i += stride) look_at(i);
    if (stride > 1) {
      bool any = false;
      for (std::size_t k = 0; k < largest_.size() && !any; ++k) any = largest_[k].may_be_exceeded(looks_[k], stride, 1);
      if (!any) return;
      for (std::size_t i = 1; i < pieces_; ++i) {
        if (i % stride != 0) look_at(i);
      }
    }
    for (std::size_t k = 0; k < largest_.size(); ++k) {
      largest_[k].look(
          looks_[k], time_of, [&](const R& t) { return f(k, t); }, [&](const R& t) { return confirm(k, t); });
    }
  }

 private:
  static constexpr std::size_t few = 4;  ///< pieces at first

  std::size_t pieces_;
  R seen_to_{-1};  ///< end of the last step
  std::vector<LargestValue<R>> largest_;
  std::vector<std::vector<double>> looks_;  ///< of each quantity
};

}  // namespace lubjoint
