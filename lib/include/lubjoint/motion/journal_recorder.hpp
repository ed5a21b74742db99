/// What a run of a journal leaves behind: samples at regular times, and its extremes.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "lubjoint/multibody/free_journal.hpp"
#include "lubjoint/run/largest_value.hpp"
#include "lubjoint/run/outcome.hpp"
#include "lubjoint/run/output_times.hpp"

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
  explicit JournalRecorder(const RunSettings& settings) : outputs_(settings) {}

  /// The first sample.
  template <class Mode, class State>
  void start(const Mode& mode, double t, const State& y) {
    add(mode, t, y);
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
    outputs_.up_to(t_new, [&](double t) { add(mode, t, sample_at(t)); });
    const std::size_t pieces = std::min(looks, max_pieces);
    const auto time_of = [&](std::size_t i) {
      return i == pieces ? t_new : t_old + (t_new - t_old) * static_cast<double>(i) / static_cast<double>(pieces);
    };
    ratios_.resize(pieces + 1);
    forces_.resize(pieces + 1);
    for (std::size_t i = 0; i <= pieces; ++i) {
      const auto y = state_at(time_of(i));
      ratios_[i] = squared_ratio(mode, time_of(i), y);
      forces_[i] = mode.force(time_of(i), y).norm();
    }
    const auto ratio_at = [&](double t) { return squared_ratio(mode, t, state_at(t)); };
    const auto force_at = [&](double t) { return mode.force(t, state_at(t)).norm(); };
    squared_ratio_.look(ratios_, time_of, ratio_at, ratio_at);
    force_.look(forces_, time_of, force_at, force_at);
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

  OutputTimes outputs_;
  std::vector<JournalSample> samples_;
  std::vector<SlidingInterval> sliding_;
  LargestValue<double> squared_ratio_;
  LargestValue<double> force_;
  std::vector<double> ratios_, forces_;  ///< at the places of a step that are looked at
};

}  // namespace lubjoint
