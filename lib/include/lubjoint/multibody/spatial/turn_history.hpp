/// What a run remembers of angles, so that they are counted through revolutions: a state says them up to whole turns.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "lubjoint/multibody/spatial/turn.hpp"

namespace lubjoint {

/// A trial step turns a body by so much that nobody can say which revolution it is in: it is too long.
class AngleNotCounted : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// Counted angles and their rates at times along a run. Between two times an angle lies near the cubic through both;
/// after the last one, near where the mean of its rates then and now leads. A step that turns it by more than three
/// quarters of half a turn is too long: stages of high order would lead astray in it.
template <class R>
class TurnHistory {
 public:
  /// @param angles  number of counted angles; with none there is nothing to remember
  explicit TurnHistory(std::size_t angles = 0) : angles_(angles) {}

  bool empty() const { return angles_ == 0; }         ///< is there no angle?
  bool has_begun() const { return !times_.empty(); }  ///< is anything known yet?

  /// Forgets all.
  void clear() {
    times_.clear();
    ends_.clear();
  }

  /// Angles at a time after the last one: motion(k, near) is that of angle k by a place near it, which is where the
  /// mean of both rates leads from the last time; at the first time, the angle's zero.
  /// @param zero  zero(k) [rad]
  template <class Motion, class Zero>
  void add(const R& t, const Motion& motion, const Zero& zero) {
    const bool first = times_.empty();
    const R h = first ? R(0) : R(t - times_.back());
    for (std::size_t k = 0; k < angles_; ++k) {
      if (first) {
        const AngleMotion<R> at = motion(k, zero(k));
        ends_.push_back({at.angle, at.rate});
        continue;
      }
      const End& before = ends_[ends_.size() - angles_];
      const AngleMotion<R> at = motion(k, before.angle);
      const R place = before.angle + h * (before.rate + at.rate) / 2;
      ends_.push_back({nearest_turn(at.angle, place), at.rate});
    }
    times_.push_back(t);
    if (times_.size() < 2 * remembered) return;
    times_.erase(times_.begin(), times_.begin() + remembered);
    ends_.erase(ends_.begin(), ends_.begin() + static_cast<std::ptrdiff_t>(remembered * angles_));
  }

  /// The motion of an angle at t. @param motion  motion(near), as above; its rate does not depend on near
  /// @throws AngleNotCounted
  template <class Motion>
  auto counted(std::size_t k, const R& t, const Motion& motion) const {
    using std::abs;
    if (t < times_.back()) return motion(between(k, t));
    const End& last = ends_[ends_.size() - angles_ + k];
    const R h = t - times_.back();
    const auto here = motion(last.angle);
    const R turned = abs(h) * (abs(last.rate) + abs(R(value_of(here.rate)))) / 2;
    if (!(turned < most_turned())) refuse();
    const R place = last.angle + h * (last.rate + value_of(here.rate)) / 2;
    return near_enough(motion(place), place);
  }

 private:
  struct End {
    R angle;
    R rate;
  };
  static constexpr std::ptrdiff_t remembered = 1024;  ///< last times at least: looks back are into the last step

  static R most_turned() { return R(0.75) * pi<R>(); }
  [[noreturn]] static void refuse() {
    throw AngleNotCounted("a body turns by too much in a step for its revolutions to be counted");
  }
  /// A motion whose angle is not more than three quarters of half a turn from where it should be.
  template <class Motion>
  static Motion near_enough(const Motion& motion, const R& place) {
    using std::abs;
    if (!(abs(R(value_of(motion.angle) - place)) < most_turned())) refuse();
    return motion;
  }
  /// A place near angle k at a time before the last one.
  R between(std::size_t k, const R& t) const {
    const auto above = std::upper_bound(times_.begin(), times_.end(), t);
    const auto i = std::max<std::size_t>(1, static_cast<std::size_t>(above - times_.begin()));
    const End& a = ends_[(i - 1) * angles_ + k];
    const End& z = ends_[i * angles_ + k];
    const R h = times_[i] - times_[i - 1];
    const R s = (t - times_[i - 1]) / h;
    const R over = (z.angle - a.angle) - h * a.rate;
    const R dv = h * (z.rate - a.rate);
    return a.angle + s * (h * a.rate + s * ((3 * over - dv) + s * (dv - 2 * over)));
  }

  std::size_t angles_;
  std::vector<R> times_;
  std::vector<End> ends_;  // of each time, all angles
};

}  // namespace lubjoint
