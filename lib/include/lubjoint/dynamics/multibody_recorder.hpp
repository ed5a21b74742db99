/// What a run of a multibody system leaves behind: samples, extremes, drift, energy.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "lubjoint/dynamics/multibody_ode.hpp"
#include "lubjoint/dynamics/multibody_results.hpp"
#include "lubjoint/dynamics/outcome.hpp"
#include "lubjoint/dynamics/multibody_step.hpp"

namespace lubjoint {

namespace detail {

template <class R>
JointSample joint_sample(const JointElement<R>& joint, const JointForce<R>& force) {
  using std::sqrt;
  const Vector2<R>& e = force.kinematics.motion.eccentricity;
  const R distance = sqrt(R(e.x() * e.x() + e.y() * e.y()));
  return {e.template cast<double>(), force.total().template cast<double>(),
          static_cast<double>(distance / joint.bearing.clearance()),
          static_cast<double>(joint.bearing.clearance() - distance)};
}

/// Keeps the largest value of one quantity, and the steps on both sides of it; the peak itself is searched at the end.
template <class R>
class PeakTracker {
 public:
  void consider(double value, const R& t, const std::shared_ptr<const MultibodyStep<R>>& step) {
    if (at_step_end_ && step != step_) {
      next_ = step;
      at_step_end_ = false;
    }
    if (known_ && value <= value_) return;
    known_ = true;
    value_ = value;
    t_ = t;
    before_ = t == step->t_old && step_ && step_ != step && step_->t_new == step->t_old ? step_ : nullptr;
    step_ = step;
    next_ = nullptr;
    at_step_end_ = t == step->t_new;
  }

  /// @param quantity  quantity(interpolant, t)
  template <class Quantity>
  Peak peak(std::size_t pieces, const Quantity& quantity) const {
    if (!known_) return {0, 0};
    Peak best{value_, static_cast<double>(t_)};
    const auto search = [&](const MultibodyStep<R>& step) {
      const R piece = (step.t_new - step.t_old) / static_cast<double>(pieces);
      const double low = static_cast<double>(std::max<R>(step.t_old, t_ - piece) - step.t_old);
      const double high = static_cast<double>(std::min<R>(step.t_new, t_ + piece) - step.t_old);
      if (!(high > low)) return;
      const auto found = boost::math::tools::brent_find_minima(
          [&](double s) { return -quantity(step, R(step.t_old + R(s))); }, low, high, 30);
      if (-found.second > best.value) best = {-found.second, static_cast<double>(step.t_old) + found.first};
    };
    if (before_) search(*before_);
    search(*step_);
    if (next_) search(*next_);
    return best;
  }

 private:
  bool known_ = false;
  double value_ = 0;
  R t_{};
  std::shared_ptr<const MultibodyStep<R>> before_, step_, next_;
  bool at_step_end_ = false;
};

}  // namespace detail

template <class R>
class MultibodyRecorder {
 public:
  MultibodyRecorder(MultibodyOde<R>& ode, const RunSettings& settings, std::size_t pieces)
      : ode_(ode), settings_(settings), pieces_(pieces), trackers_(2 * ode.system().joints().size()) {
    for (std::size_t c = 0; c < ode.system().constraints().size(); ++c) {
      if (ode.system().constraints()[c].is_driver()) drivers_.push_back(c);
    }
    trackers_.resize(trackers_.size() + 2 * drivers_.size());
  }

  void start(const R& t, const std::vector<R>& y) {
    add_sample(t, y, ode_.memory());
    next_ = 1;
    const MechanicalEnergy<R> energy = ode_.energy(y);
    start_energy_ = energy.kinetic + energy.potential;
  }

  void step(const std::shared_ptr<const MultibodyStep<R>>& step) {
    const std::size_t n = ode_.system().coordinates();
    for (double t = output_time(next_); t <= static_cast<double>(step->t_new) && t < settings_.duration;
         t = output_time(++next_)) {
      step->state_at(R(t), n, state_);
      add_sample(R(t), state_, step->memory);
    }
    for (std::size_t i = 0; i <= pieces_; ++i) {
      const R t =
          i == pieces_
              ? step->t_new
              : R(step->t_old + (step->t_new - step->t_old) * static_cast<double>(i) / static_cast<double>(pieces_));
      if (i == pieces_) {
        state_ = step->y_new;
      } else {
        step->state_at(t, n, state_);
      }
      const SystemWorkspace<R>& w = ode_.at(t, state_, step->memory);
      std::size_t k = 0;
      for (std::size_t j = 0; j < w.joints.size(); ++j) {
        trackers_[k++].consider(distance(w, j), t, step);
        trackers_[k++].consider(force(w, j), t, step);
      }
      for (const std::size_t c : drivers_) {
        trackers_[k++].consider(moment(w, c), t, step);
        trackers_[k++].consider(-moment(w, c), t, step);
      }
      if (i == pieces_) note_drift(w, step->y_new);
    }
  }

  void finish(const R& t, const std::vector<R>& y) {
    if (samples_.empty() || samples_.back().t < static_cast<double>(t)) add_sample(t, y, ode_.memory());
  }

  const std::vector<MultibodySample>& samples() const { return samples_; }
  const ConstraintDrift& drift() const { return drift_; }
  double energy_residual() const { return energy_residual_; }
  double energy_scale() const { return energy_scale_; }

  std::vector<JointExtremes> joint_extremes() const {
    std::vector<JointExtremes> result;
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      result.push_back({peak(2 * j, [&](const auto& w) { return distance(w, j); }),
                        peak(2 * j + 1, [&](const auto& w) { return force(w, j); })});
    }
    return result;
  }

  std::vector<DriverExtremes> driver_extremes() const {
    std::vector<DriverExtremes> result;
    std::size_t k = 2 * ode_.system().joints().size();
    for (const std::size_t c : drivers_) {
      const Peak high = peak(k++, [&](const auto& w) { return moment(w, c); });
      Peak low = peak(k++, [&](const auto& w) { return -moment(w, c); });
      low.value = -low.value;
      result.push_back({high, low});
    }
    return result;
  }

 private:
  double output_time(std::size_t i) const { return static_cast<double>(i) * settings_.output_interval; }

  static double distance(const SystemWorkspace<R>& w, std::size_t joint) {
    return static_cast<double>(w.joints[joint].kinematics.motion.eccentricity.norm());
  }
  static double force(const SystemWorkspace<R>& w, std::size_t joint) {
    return static_cast<double>(w.joints[joint].total().norm());
  }
  double moment(const SystemWorkspace<R>& w, std::size_t driver) const {
    return static_cast<double>(ode_.system().reaction_on_second(driver, w)[2]);
  }

  template <class Quantity>
  Peak peak(std::size_t tracker, const Quantity& quantity) const {
    std::vector<R> y;
    return trackers_[tracker].peak(pieces_, [&](const MultibodyStep<R>& step, const R& t) {
      step.state_at(t, ode_.system().coordinates(), y);
      return quantity(ode_.at(t, y, step.memory));
    });
  }

  void add_sample(const R& t, const std::vector<R>& y, const std::vector<JointMemory<R>>& memory) {
    const SystemWorkspace<R>& w = ode_.at(t, y, memory);
    const auto narrow = [](const R& value) { return static_cast<double>(value); };
    MultibodySample sample;
    sample.t = narrow(t);
    for (std::size_t i = 0; i < ode_.mechanical_states(); ++i) sample.state.push_back(narrow(y[i]));
    for (std::size_t j = 0; j < w.joints.size(); ++j) {
      sample.joints.push_back(detail::joint_sample(ode_.system().joints()[j], w.joints[j]));
    }
    for (const std::size_t c : drivers_) sample.driving_moments.push_back(moment(w, c));
    if (ode_.with_ledger()) {
      const MechanicalEnergy<R> energy = ode_.energy(y);
      sample.ledger = {narrow(energy.kinetic), narrow(energy.potential)};
      for (std::size_t i = ode_.mechanical_states(); i < y.size(); ++i) sample.ledger.push_back(narrow(y[i]));
    }
    samples_.push_back(std::move(sample));
  }

  void note_drift(const SystemWorkspace<R>& w, const std::vector<R>& y) {
    for (std::size_t row = 0; row < w.rows.size(); ++row) {
      drift_.position = std::max(drift_.position, std::abs(static_cast<double>(w.rows[row].value)));
      const R rate = ode_.system().constraint_rate(row, w);
      drift_.velocity = std::max(drift_.velocity, std::abs(static_cast<double>(rate)));
    }
    if (!ode_.with_ledger()) return;
    const MechanicalEnergy<R> energy = ode_.energy(y);
    R residual = energy.kinetic + energy.potential - start_energy_;
    energy_scale_ = std::max(energy_scale_, static_cast<double>(energy.kinetic));
    for (std::size_t i = ode_.mechanical_states(); i < y.size(); ++i) {
      residual -= y[i];
      energy_scale_ = std::max(energy_scale_, std::abs(static_cast<double>(y[i])));
    }
    energy_residual_ = std::max(energy_residual_, std::abs(static_cast<double>(residual)));
  }

  MultibodyOde<R>& ode_;
  RunSettings settings_;
  std::size_t pieces_;
  std::vector<detail::PeakTracker<R>> trackers_;
  std::vector<std::size_t> drivers_;
  std::size_t next_ = 0;
  std::vector<MultibodySample> samples_;
  std::vector<R> state_;
  ConstraintDrift drift_;
  R start_energy_{};
  double energy_residual_ = 0;
  double energy_scale_ = 0;
};

}  // namespace lubjoint
