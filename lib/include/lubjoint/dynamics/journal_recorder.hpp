/// What a run of a journal leaves behind: samples at regular times, and its extremes.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <vector>

#include "lubjoint/dynamics/outcome.hpp"
#include "lubjoint/multibody/free_journal.hpp"

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

  /// An accepted step: the samples in it, and its extremes.
  /// @param looks  into so many pieces the step is divided in the search for its extremes
  template <class Mode, class StateAt>
  void step(const Mode& mode, double t_old, double t_new, const StateAt& state_at, std::size_t looks) {
    for (double t = output_time(next_); t <= t_new && t < settings_.duration; t = output_time(++next_)) {
      add(mode, t, state_at(t));
    }
    const int pieces = static_cast<int>(std::min<std::size_t>(looks, max_pieces));
    std::array<double, max_pieces + 1> ratio{};
    std::array<double, max_pieces + 1> force{};
    for (int i = 0; i <= pieces; ++i) {
      const double t = i == pieces ? t_new : t_old + (t_new - t_old) * i / pieces;
      const auto y = state_at(t);
      const auto k = static_cast<std::size_t>(i);
      ratio[k] = squared_ratio(mode, t, y);
      force[k] = mode.force(t, y).norm();
    }
    for (int i = 0; i <= pieces; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double lower = t_old + (t_new - t_old) * std::max(i - 1, 0) / pieces;
      const double upper = t_old + (t_new - t_old) * std::min(i + 1, pieces) / pieces;
      // A peak inside the step, not the way up to its end.
      const auto is_peak = [&](const auto& values) {
        return i > 0 && i < pieces && values[k] >= values[k - 1] && values[k] >= values[k + 1];
      };
      if (ratio[k] > max_squared_ratio_) {
        max_squared_ratio_ = ratio[k];
        if (is_peak(ratio)) {
          refine(max_squared_ratio_, lower, upper, [&](double t) { return squared_ratio(mode, t, state_at(t)); });
        }
      }
      if (force[k] > max_force_) {
        max_force_ = force[k];
        if (is_peak(force))
          refine(max_force_, lower, upper, [&](double t) { return mode.force(t, state_at(t)).norm(); });
      }
    }
  }

  /// The last sample.
  template <class Mode, class State>
  void finish(const Mode& mode, double t, const State& y) {
    if (samples_.empty() || samples_.back().t < t) add(mode, t, y);
  }

  /// An interval of sliding.
  void slid(double start, double end) { sliding_.push_back({start, end}); }

  const std::vector<JournalSample>& samples() const { return samples_; }           ///< in order
  const std::vector<SlidingInterval>& sliding() const { return sliding_; }         ///< in order
  double max_eccentricity_ratio() const { return std::sqrt(max_squared_ratio_); }  ///< largest ε
  double max_force() const { return max_force_; }                                  ///< largest |F| [N]

 private:
  static constexpr std::size_t max_pieces = 4;

  double output_time(std::size_t i) const { return static_cast<double>(i) * settings_.output_interval; }

  template <class Mode, class State>
  void add(const Mode& mode, double t, const State& y) {
    samples_.push_back({t, mode.journal(t, y), mode.force(t, y)});
  }

  template <class Mode, class State>
  void consider(const Mode& mode, double t, const State& y) {
    max_squared_ratio_ = std::max(max_squared_ratio_, squared_ratio(mode, t, y));
    max_force_ = std::max(max_force_, mode.force(t, y).norm());
  }

  template <class Mode, class State>
  static double squared_ratio(const Mode& mode, double t, const State& y) {
    const JournalState<double> journal = mode.journal(t, y);
    return journal[0] * journal[0] + journal[1] * journal[1];
  }

  template <class Function>
  static void refine(double& best, double lower, double upper, const Function& f) {
    const auto minimum = boost::math::tools::brent_find_minima([&](double t) { return -f(t); }, lower, upper, 26);
    best = std::max(best, -minimum.second);
  }

  RunSettings settings_;
  std::size_t next_ = 0;
  std::vector<JournalSample> samples_;
  std::vector<SlidingInterval> sliding_;
  double max_squared_ratio_ = 0;
  double max_force_ = 0;
};

}  // namespace lubjoint
