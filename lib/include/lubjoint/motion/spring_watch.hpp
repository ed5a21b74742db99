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
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
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
template <class R>
class SpringWatch {
 public:
  using State = std::vector<R>;                          ///< (q, q̇, work)
  using Step = std::shared_ptr<const MultibodyStep<R>>;  ///< an accepted one

  /// @param tolerance  relative, of the run
  /// @param pieces  into so many a step is divided
  SpringWatch(MultibodyOde<R>& ode, double tolerance, std::size_t pieces)
      : ode_(ode), share_(std::clamp(10 * tolerance, 1e-9, 1e-3)), pieces_(pieces) {
    const auto& springs = ode.system().elements().springs;
    for (std::size_t k = 0; k < springs.size(); ++k) {
      if (std::holds_alternative<TranslationalSpring<R>>(springs[k].spring)) watched_.push_back({k, {0, 0}, 0});
    }
  }

  /// The start of the run.
  void start(const State& y) {
    for (Watched& each : watched_) {
      each.at = span(y, each.spring);
      each.longest = length(each.at);
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
      if (i < pieces_) step->state_at(t, ode_.system().coordinates(), state_);
      for (Watched& each : watched_) {
        const Vector2<double> now = span(i < pieces_ ? state_ : step->y_new, each.spring);
        const Vector2<double> was = each.at;
        each.at = now;
        each.longest = std::max(each.longest, length(now));
        // Places between the looks that are behind and ahead of 0; the way between bends by less than it is long.
        const Vector2<double> way = now - was;
        if (!(was.dot(way) <= 0 && now.dot(way) >= 0 && nearest(was, now) <= length(way))) continue;
        if (const auto found = passing(each, was, way, before, t, *step, inside)) return found;
      }
      before = t;
    }
    return std::nullopt;
  }

  /// A spring without direction at a state, if there is one.
  std::optional<SpringAtZero> at(const R& t, const State& y) const {
    for (const Watched& each : watched_) {
      if (length(span(y, each.spring)) <= share_ * each.longest)
        return SpringAtZero{static_cast<double>(t), each.spring};
    }
    return std::nullopt;
  }

  /// "spring "s" …", with what to do.
  std::string words(const SpringAtZero& place) const {
    return "spring \"" + ode_.system().elements().springs[place.spring].name + "\" has length 0 at " +
           detail::number(place.t) +
           " s, where it has no direction; let the run end before it, or move an end of the spring";
  }

 private:
  struct Watched {
    std::size_t spring;
    Vector2<double> at{0, 0};  ///< d at the last look
    double longest;
  };

  static double length(const Vector2<double>& d) { return std::hypot(d.x(), d.y()); }

  /// d = P_j − P_i.
  Vector2<double> span(const State& y, std::size_t k) const {
    const auto& spring = std::get<TranslationalSpring<R>>(ode_.system().elements().springs[k].spring);
    const std::size_t n = ode_.system().coordinates();
    const auto place = [&](const BodyPoint<R>& point) {
      if (point.on_ground()) return point.point;
      const R* q = y.data() + planar_coordinates * point.body;
      const Vector2<R> s = inertial_vector(
          PlanarMotion<R>{Vector2<R>(q[0], q[1]), q[2], Vector2<R>(q[n], q[n + 1]), q[n + 2]}, point.point);
      return Vector2<R>(q[0] + s.x(), q[1] + s.y());
    };
    const Vector2<R> i = place(spring.first);
    const Vector2<R> j = place(spring.second);
    return {static_cast<double>(j.x() - i.x()), static_cast<double>(j.y() - i.y())};
  }

  /// Least |d| on the straight line between two looks.
  static double nearest(const Vector2<double>& from, const Vector2<double>& to) {
    const Vector2<double> way = to - from;
    const double squared = way.squaredNorm();
    const double share = squared > 0 ? std::clamp(-from.dot(way) / squared, 0.0, 1.0) : 0.0;
    return length(from + share * way);
  }

  /// Where d is across the way between two looks, is it 0?
  template <class Inside>
  std::optional<SpringAtZero> passing(const Watched& each, const Vector2<double>& was, const Vector2<double>& way,
                                      const R& from, const R& to, const MultibodyStep<R>& step, const Inside& inside) {
    const auto along = [&](double s) {
      inside(step, R(from + R(s)), state_);
      return span(state_, each.spring).dot(way);
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
    if (!(length(span(state_, each.spring)) <= share_ * each.longest)) return std::nullopt;
    return SpringAtZero{static_cast<double>(from) + s, each.spring};
  }

  MultibodyOde<R>& ode_;
  double share_;
  std::size_t pieces_;
  std::vector<Watched> watched_;
  State state_;
};

}  // namespace lubjoint
