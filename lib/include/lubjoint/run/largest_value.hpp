/// The largest value of a quantity along a run, found inside the steps.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace lubjoint {

/// The largest value of one quantity, and when. Each step is looked at in pieces; where it may hold a larger value
/// than all steps before it, be it between two looks, the peak is searched by Brent's method, to half the digits of
/// double precision in its time and all of them in its value.
/// @tparam R  of time
template <class R>
class LargestValue {
 public:
  double value() const { return value_; }      ///< 0 before the first
  const R& t() const { return t_; }            ///< when
  bool is_known() const { return is_known_; }  ///< has anything been looked at?

  /// The value at one moment.
  void consider(double value, const R& t) {
    if (is_known_ && !(value > value_)) return;
    is_known_ = true;
    value_ = value;
    t_ = t;
  }

  /// May a step hold a larger value than all before it? Between its looks a quantity may exceed them by as much as it
  /// bends there: a parabola does by at most an eighth of its second difference.
  /// @param values  as in look;  @param stride  every stride-th of them, both ends included, is known
  /// @param share  of the second differences that is allowed for
  bool may_be_exceeded(const std::vector<double>& values, std::size_t stride, double share) const {
    if (!is_known_) return true;
    bool changes = false;
    bool exceeds = false;
    for (std::size_t i = 0; i < values.size(); i += stride) {
      changes = changes || values[i] != value_;
      exceeds = exceeds || !(values[i] + share * bend(values, i, stride) < value_);
    }
    return changes && exceeds;
  }

  /// A step.
  /// @param values  the quantity at time_of(0) … time_of(pieces), at both ends without an interpolant's error
  /// @param f  f(t), the quantity at any time of the step; where it throws std::domain_error, as an interpolant that
  ///           passes a bearing's wall may, no peak is searched
  /// @param confirm  confirm(t), the same by the method itself: in a thin film an interpolant can show a peak that is
  ///                 not there
  template <class TimeOf, class Function, class Confirm>
  void look(const std::vector<double>& values, const TimeOf& time_of, const Function& f, const Confirm& confirm) {
    const std::size_t last = values.size() - 1;
    if (!may_be_exceeded(values, 1, 0.25)) return;
    for (std::size_t i = 0; i <= last; ++i) {
      if (is_known_ && values[i] + 0.25 * bend(values, i, 1) < value_) continue;
      if (i > 0 && i < last) {
        if (values[i] >= values[i - 1] && values[i] >= values[i + 1])
          search(time_of(i - 1), time_of(i + 1), time_of(i), values[i], f, confirm);
        continue;
      }
      consider(values[i], time_of(i));
      // No look beyond a step's end: the value a little inside tells on which side of the end the peak lies.
      const std::size_t inside = i == 0 ? 1 : last - 1;
      if (values[inside] > values[i]) continue;  // the peak is further on
      try {
        const R beside = time_of(i) + (time_of(inside) - time_of(i)) * 1e-3;
        if (!(f(beside) > values[i])) continue;
      } catch (const std::domain_error&) {
        continue;
      }
      search(std::min<R>(time_of(i), time_of(inside)), std::max<R>(time_of(i), time_of(inside)), time_of(i), values[i],
             f, confirm);
    }
  }

 private:
  /// Second difference of the looks about one of them, or next to an end.
  static double bend(const std::vector<double>& values, std::size_t i, std::size_t stride) {
    const std::size_t last = values.size() - 1;
    if (last < 2 * stride) return 0;
    const std::size_t middle = std::clamp(i, stride, last - stride);
    return std::abs(values[middle - stride] - 2 * values[middle] + values[middle + stride]);
  }

  /// Of double precision's digits: a maximum is flat, so that no more are to be had.
  static constexpr int bits = 26;

  /// @param looked_at  between the two, with its value: it stands where the search fails
  template <class Function, class Confirm>
  void search(const R& lower, const R& upper, const R& looked_at, double value, const Function& f,
              const Confirm& confirm) {
    R at = looked_at;
    try {
      // From the lower end: a time of many digits would lose them in double precision.
      const auto found = boost::math::tools::brent_find_minima([&](double s) { return -f(R(lower + R(s))); }, 0.0,
                                                               static_cast<double>(R(upper - lower)), bits);
      if (-found.second >= value) at = lower + R(found.first);
    } catch (const std::domain_error&) {
    }
    consider(confirm(at), at);
  }

  bool is_known_ = false;
  double value_ = 0;
  R t_{};
};

}  // namespace lubjoint
