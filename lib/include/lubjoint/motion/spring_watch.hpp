/// Springs whose length passes 0, where they have no direction. A step may land beyond that without noticing.
#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/motion/multibody_step.hpp"
#include "lubjoint/motion/stop_words.hpp"

namespace lubjoint {

/// A spring without a direction.
struct SpringAtZero {
  double t;            ///< [s]
  std::size_t spring;  ///< its number
};

/// Watches the lengths of springs: wherever the straight line between two looks at d passes near 0, the place at which
/// d is across it is found by the method itself. A length there of less than a share of the longest that the spring has
/// had is none: the run does not know the difference.
/// @tparam Springs  PlanarSprings or SpatialSprings
template <class R, class Springs>
class SpringWatch {
 public:
  using State = std::vector<R>;                          ///< places, velocities, work
  using Step = std::shared_ptr<const MultibodyStep<R>>;  ///< an accepted one

  /// @param tolerance  relative, of the run
  /// @param pieces  into so many a step is divided
  SpringWatch(Springs springs, double tolerance, std::size_t pieces)
      : springs_(std::move(springs)), share_(std::clamp(10 * tolerance, 1e-9, 1e-3)), pieces_(pieces) {
    for (std::size_t k = 0; k < springs_.size(); ++k) {
      if (springs_.has_direction(k)) watched_.push_back({k, Span::Zero(), 0});
    }
  }

  /// The start of the run.
  void start(const State& y) {
    for (Watched& each : watched_) {
      each.at = springs_.span(y, each.spring);
      each.longest = each.at.norm();
    }
  }

  /// The next accepted step.
  /// @param inside  inside(step, t, y) is the state inside it, as accurate as the run
  /// @returns the first spring found that passes length 0 in it
  template <class Inside>
  std::optional<SpringAtZero> step(const Step& step, const Inside& inside) {
    if (watched_.empty()) return std::nullopt;
    R before = step->t_old;
    for (std::size_t i = 1; i <= pieces_; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(pieces_);
      const R t = i == pieces_ ? step->t_new : R(step->t_old + (step->t_new - step->t_old) * share);
      if (i < pieces_) springs_.state_at(*step, t, state_);
      for (Watched& each : watched_) {
        const Span now = springs_.span(i < pieces_ ? state_ : step->y_new, each.spring);
        const Span was = each.at;
        each.at = now;
        each.longest = std::max(each.longest, now.norm());
        // Places between the looks that are behind and ahead of 0; the way between bends by less than it is long.
        const Span way = now - was;
        if (!(was.dot(way) <= 0 && now.dot(way) >= 0 && nearest(was, now) <= way.norm())) continue;
        if (const auto found = passing(each, was, way, before, t, *step, inside)) return found;
      }
      before = t;
    }
    return std::nullopt;
  }

  /// A spring without direction at a state, if there is one.
  std::optional<SpringAtZero> at(const R& t, const State& y) const {
    for (const Watched& each : watched_) {
      if (springs_.span(y, each.spring).norm() <= share_ * each.longest)
        return SpringAtZero{static_cast<double>(t), each.spring};
    }
    return std::nullopt;
  }

  /// "spring "s" …", with what to do.
  std::string words(const SpringAtZero& place) const {
    return "spring \"" + springs_.name(place.spring) + "\" has length 0 at " + detail::number(place.t) +
           " s, where it has no direction; let the run end before it, or move an end of the spring";
  }

 private:
  using Span = typename Springs::Span;
  struct Watched {
    std::size_t spring;
    Span at;  ///< d at the last look
    double longest;
  };

  /// Least |d| on the straight line between two looks.
  static double nearest(const Span& from, const Span& to) {
    const Span way = to - from;
    const double squared = way.squaredNorm();
    const double share = squared > 0 ? std::clamp(-from.dot(way) / squared, 0.0, 1.0) : 0.0;
    return (from + share * way).norm();
  }

  /// Where d is across the way between two looks, is it 0?
  template <class Inside>
  std::optional<SpringAtZero> passing(const Watched& each, const Span& was, const Span& way, const R& from, const R& to,
                                      const MultibodyStep<R>& step, const Inside& inside) {
    const auto along = [&](double s) {
      inside(step, R(from + R(s)), state_);
      return springs_.span(state_, each.spring).dot(way);
    };
    const double all = static_cast<double>(to - from);
    const double first = was.dot(way);
    const double last = along(all);  // by the method's own steps, which end a little beside the step
    double s = first < 0 ? all : 0;
    if (first < 0 && last > 0) {
      std::uintmax_t looks = 60;
      const boost::math::tools::eps_tolerance<double> tolerance(std::numeric_limits<double>::digits - 3);
      s = boost::math::tools::toms748_solve(along, 0.0, all, first, last, tolerance, looks).first;
    }
    along(s);
    if (!(springs_.span(state_, each.spring).norm() <= share_ * each.longest)) return std::nullopt;
    return SpringAtZero{static_cast<double>(from) + s, each.spring};
  }

  Springs springs_;
  double share_;
  std::size_t pieces_;
  std::vector<Watched> watched_;
  State state_;
};

}  // namespace lubjoint
