/// What a run of a journal leaves behind: samples at regular times, and its extremes.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "lubjoint/multibody/free_journal.hpp"
#include "lubjoint/run/outcome.hpp"

namespace lubjoint {

/// A journal at an instant.
struct JournalSample {
  double t;                    ///< [s]
  JournalState<double> state;  ///< ê, w
  Vector2<double> force;       ///< on the journal [N]

  double eccentricity_ratio() const { return std::hypot(state[0], state[1]); }  ///< ε
};

/// An interval that was spent sliding on a = 0.
struct SlidingInterval {
  double start;  ///< [s]
  double end;    ///< [s]
};

/// Samples every output interval, and the largest ε and |F|, refined inside the step that has them.
class JournalRecorder {
 public:
  /// Nothing is recorded yet.
  explicit JournalRecorder(const RunSettings& settings) : settings_(settings) {}

  /// The first sample.
  template <class Mode, class State>
  void start(const Mode& mode, double t, const State& y) {
    add(mode, t, y);
    next_ = 1;
    consider(mode, t, y);
  }

  /// An accepted step whose inside is as good as its end.
  template <class Mode, class StateAt>
  void step(const Mode& mode, double t_old, double t_new, const StateAt& state_at, std::size_t looks) {
    step(mode, t_old, t_new, state_at, state_at, looks);
  }

  /// An accepted step: the samples in it, and its extremes.
  /// @param state_at   the state inside the step, to look for extremes by
  /// @param sample_at  the same, as good as the step's end
  /// @param looks  number of pieces that the step is divided into in the search for its extremes
  template <class Mode, class StateAt, class SampleAt>
  void step(const Mode& mode, double t_old, double t_new, const StateAt& state_at, const SampleAt& sample_at,
            std::size_t looks) {
    for (double t = output_time(next_); t <= t_new && t < settings_.duration; t = output_time(++next_)) {
      add(mode, t, sample_at(t));
    }
    const int pieces = static_cast<int>(std::min<std::size_t>(looks, max_pieces));
    std::array<double, max_pieces + 1> ratio{};
    std::array<double, max_pieces + 1> force{};
    const auto time_of = [&](int i) { return i == pieces ? t_new : t_old + (t_new - t_old) * i / pieces; };
    for (int i = 0; i <= pieces; ++i) {
      const auto y = state_at(time_of(i));
      const auto k = static_cast<std::size_t>(i);
      ratio[k] = squared_ratio(mode, time_of(i), y);
      force[k] = mode.force(time_of(i), y).norm();
    }
    squared_ratio_.look(ratio, pieces, time_of, [&](double t) { return squared_ratio(mode, t, state_at(t)); });
    force_.look(force, pieces, time_of, [&](double t) { return mode.force(t, state_at(t)).norm(); });
  }

  /// The last sample.
  template <class Mode, class State>
  void finish(const Mode& mode, double t, const State& y) {
    if (samples_.empty() || samples_.back().t < t) add(mode, t, y);
  }

  /// An interval of sliding.
  void slid(double start, double end) { sliding_.push_back({start, end}); }

  const std::vector<JournalSample>& samples() const { return samples_; }               ///< in order
  const std::vector<SlidingInterval>& sliding() const { return sliding_; }             ///< in order
  double max_eccentricity_ratio() const { return std::sqrt(squared_ratio_.value()); }  ///< largest ε
  double max_force() const { return force_.value(); }                                  ///< largest |F| [N]
  double t_max_eccentricity_ratio() const { return squared_ratio_.t(); }               ///< when ε was largest [s]
  double t_max_force() const { return force_.t(); }                                    ///< when |F| was [s]

 private:
  static constexpr std::size_t max_pieces = 4;
  using Looks = std::array<double, max_pieces + 1>;

  /// The largest value of one quantity, and when.
  class Largest {
   public:
    double value() const { return value_; }
    double t() const { return t_; }

    void consider(double value, double t) {
      if (!(value > value_)) return;
      value_ = value;
      t_ = t;
    }

    /// @param values  at time_of(0) … time_of(pieces) of a step;  @param f  the quantity at any time of the step
    template <class TimeOf, class Function>
    void look(const Looks& values, int pieces, const TimeOf& time_of, const Function& f) {
      for (int i = 0; i <= pieces; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (values[k] < value_) continue;
        consider(values[k], time_of(i));
        if (i > 0 && i < pieces) {
          if (values[k] >= values[k - 1] && values[k] >= values[k + 1]) refine(time_of(i - 1), time_of(i + 1), f);
        } else {
          // No look beyond a step's end: the value a little inside tells on which side of the end the peak lies.
          const int inside = i == 0 ? 1 : pieces - 1;
          if (values[static_cast<std::size_t>(inside)] > values[k]) continue;  // the peak is further on
          const double beside = time_of(i) + 1e-3 * (time_of(inside) - time_of(i));
          if (f(beside) > values[k])
            refine(std::min(time_of(i), time_of(inside)), std::max(time_of(i), time_of(inside)), f);
        }
      }
    }

   private:
    template <class Function>
    void refine(double lower, double upper, const Function& f) {
      const auto minimum = boost::math::tools::brent_find_minima([&](double t) { return -f(t); }, lower, upper, 26);
      consider(-minimum.second, minimum.first);
    }

    double value_ = 0;
    double t_ = 0;
  };

  /// i intervals; within rounding of the end it is the end.
  double output_time(std::size_t i) const {
    const double t = static_cast<double>(i) * settings_.output_interval;
    return t >= settings_.duration * (1 - 4 * std::numeric_limits<double>::epsilon()) ? settings_.duration : t;
  }

  template <class Mode, class State>
  void add(const Mode& mode, double t, const State& y) {
    samples_.push_back({t, mode.journal(t, y), mode.force(t, y)});
  }

  template <class Mode, class State>
  void consider(const Mode& mode, double t, const State& y) {
    squared_ratio_.consider(squared_ratio(mode, t, y), t);
    force_.consider(mode.force(t, y).norm(), t);
  }

  template <class Mode, class State>
  static double squared_ratio(const Mode& mode, double t, const State& y) {
    const JournalState<double> journal = mode.journal(t, y);
    return journal[0] * journal[0] + journal[1] * journal[1];
  }

  RunSettings settings_;
  std::size_t next_ = 0;
  std::vector<JournalSample> samples_;
  std::vector<SlidingInterval> sliding_;
  Largest squared_ratio_;
  Largest force_;
};

}  // namespace lubjoint
