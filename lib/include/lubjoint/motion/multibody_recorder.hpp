/// What a run of a multibody system leaves behind: samples, extremes, drift, energy.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "lubjoint/motion/half_film_slide.hpp"
#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/motion/multibody_step.hpp"
#include "lubjoint/motion/outcome.hpp"

namespace lubjoint {

namespace detail {

template <class R>
JointSample joint_sample(const JointElement<R>& joint, const JointForce<R>& force, const JointMemory<R>& memory) {
  using std::sqrt;
  const Vector2<R>& e = force.kinematics.motion.eccentricity;
  const R distance = sqrt(R(e.x() * e.x() + e.y() * e.y()));
  JointSample sample{e.template cast<double>(), force.total().template cast<double>(),
                     static_cast<double>(distance / joint.bearing.clearance()),
                     static_cast<double>(joint.bearing.clearance() - distance)};
  if (const auto losses = joint.losses(force, memory)) {
    sample.losses = {static_cast<double>(losses->torque_journal), static_cast<double>(losses->torque_bearing),
                     static_cast<double>(losses->power), std::nullopt};
    if (losses->side_flow) sample.losses.side_flow = static_cast<double>(*losses->side_flow);
  }
  return sample;
}

/// Keeps the largest value of one quantity, and the steps on both sides of it; the peak itself is searched at the end.
template <class R>
class PeakTracker {
 public:
  /// @param confirm  the value by the method itself: in a thin film an interpolant can show a peak that is none
  template <class Confirm>
  void consider(double value, const R& t, const std::shared_ptr<const MultibodyStep<R>>& step, const Confirm& confirm) {
    if (at_step_end_ && step != step_) {
      next_ = step;
      at_step_end_ = false;
    }
    if (known_ && value <= value_) return;
    if (t != step->t_new) {
      value = confirm();
      if (known_ && value <= value_) return;
    }
    known_ = true;
    value_ = value;
    t_ = t;
    before_ = t == step->t_old && step_ && step_ != step && step_->t_new == step->t_old ? step_ : nullptr;
    step_ = step;
    next_ = nullptr;
    at_step_end_ = t == step->t_new;
  }

  /// @param quantity  quantity(interpolant, t);  @param confirm  the same by the method itself
  template <class Quantity, class Confirm>
  Peak peak(std::size_t pieces, const Quantity& quantity, const Confirm& confirm) const {
    if (!known_) return {0, 0};
    Peak best{value_, static_cast<double>(t_)};
    const auto search = [&](const MultibodyStep<R>& step) {
      const R piece = (step.t_new - step.t_old) / static_cast<double>(pieces);
      const double low = static_cast<double>(std::max<R>(step.t_old, t_ - piece) - step.t_old);
      const double high = static_cast<double>(std::min<R>(step.t_new, t_ + piece) - step.t_old);
      if (!(high > low)) return;
      const auto found = boost::math::tools::brent_find_minima(
          [&](double s) { return -quantity(step, R(step.t_old + R(s))); }, low, high, 30);
      if (!(-found.second > best.value)) return;
      const R at = step.t_old + R(found.first);
      const double value = confirm(step, at);
      if (value > best.value) best = {value, static_cast<double>(at)};
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

/// Samples at regular times, peaks inside the steps, drift and energy of a multibody run.
template <class R>
class MultibodyRecorder {
 public:
  /// @param pieces  into so many a step is divided in the search for its extremes
  MultibodyRecorder(MultibodyOde<R>& ode, const RunSettings& settings, std::size_t pieces)
      : ode_(ode),
        settings_(settings),
        pieces_(pieces),
        trackers_(2 * ode.system().joints().size()),
        jumps_(ode.system().joints().size()) {
    for (std::size_t c = 0; c < ode.system().constraints().size(); ++c) {
      if (ode.system().constraints()[c].is_driver()) drivers_.push_back(c);
    }
    trackers_.resize(trackers_.size() + 2 * drivers_.size());
    values_.resize(trackers_.size());
  }

  /// The first sample.
  void start(const R& t, const std::vector<R>& y) {
    for (std::size_t j = 0; j < jumps_.size(); ++j) jumps_[j].slip = slip_at(t, y, j);
    add_sample(t, y, ode_.memory(), R(0));
    next_ = 1;
    const MechanicalEnergy<R> energy = ode_.energy(y);
    start_energy_ = energy.kinetic + energy.potential;
  }

  /// An accepted step: the samples in it, and its extremes.
  /// @param by_method  by_method(step, t, y) puts the state inside a step into y by the integrator itself
  template <class ByMethod>
  void step(const std::shared_ptr<const MultibodyStep<R>>& step, const ByMethod& by_method) {
    const std::size_t n = ode_.system().coordinates();
    for (double t = output_time(next_); t <= static_cast<double>(step->t_new) && t < settings_.duration;
         t = output_time(++next_)) {
      // The quintic's error in an explicit step of higher order may be a thousand tolerances.
      if (R(t) == step->t_new) {
        state_ = step->y_new;
      } else if (step->is_explicit) {
        by_method(*step, R(t), state_);
      } else {
        step->state_at(R(t), n, state_);
      }
      add_sample(R(t), state_, step->memory, R(step->t_new - step->t_old));
    }
    note_jumps(*step);
    last_length_ = step->t_new - step->t_old;
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
      for (std::size_t k = 0; k < trackers_.size(); ++k) values_[k] = quantity(k, w);
      if (i == pieces_) note_drift(w, step->y_new);
      for (std::size_t k = 0; k < trackers_.size(); ++k) {
        trackers_[k].consider(values_[k], t, step, [&] { return by(by_method, *step, t, k); });
      }
    }
  }

  /// The last sample, and the peaks refined.
  template <class ByMethod>
  void finish(const R& t, const std::vector<R>& y, const ByMethod& by_method) {
    if (samples_.empty() || samples_.back().t < static_cast<double>(t)) add_sample(t, y, ode_.memory(), last_length_);
    std::size_t k = 0;
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      const Peak eccentricity = peak(k++, by_method);
      const Peak force = peak(k++, by_method);
      joint_extremes_.push_back({eccentricity, force, jumps_[j].crossings});
    }
    for (std::size_t d = 0; d < drivers_.size(); ++d) {
      const Peak high = peak(k++, by_method);
      Peak low = peak(k++, by_method);
      low.value = -low.value;
      driver_extremes_.push_back({high, low});
    }
  }

  const std::vector<MultibodySample>& samples() const { return samples_; }  ///< in order
  const ConstraintDrift& drift() const { return drift_; }                   ///< largest so far
  double energy_residual() const { return energy_residual_; }               ///< largest |E − E₀ − work| [J]
  double energy_scale() const { return energy_scale_; }                     ///< largest kinetic energy or work [J]

  /// Of the joints, in order; after finish.
  const std::vector<JointExtremes>& joint_extremes() const { return joint_extremes_; }
  /// Of the drivers, in order; after finish.
  const std::vector<DriverExtremes>& driver_extremes() const { return driver_extremes_; }

 private:
  /// i intervals; within rounding of the end it is the end.
  double output_time(std::size_t i) const {
    const double t = static_cast<double>(i) * settings_.output_interval;
    return t >= settings_.duration * (1 - 4 * std::numeric_limits<double>::epsilon()) ? settings_.duration : t;
  }

  double moment(const SystemWorkspace<R>& w, std::size_t driver) const {
    return static_cast<double>(ode_.system().reaction_on_second(driver, w)[2]);
  }

  /// What tracker k follows: |e| and |F| of each joint, then the moment of each driver and its opposite.
  double quantity(std::size_t k, const SystemWorkspace<R>& w) const {
    const std::size_t joint = k / 2;
    if (joint < w.joints.size()) {
      const JointForce<R>& force = w.joints[joint];
      return static_cast<double>(k % 2 == 0 ? force.kinematics.motion.eccentricity.norm() : force.total().norm());
    }
    const double value = moment(w, drivers_[joint - w.joints.size()]);
    return k % 2 == 0 ? value : -value;
  }

  template <class ByMethod>
  double by(const ByMethod& by_method, const MultibodyStep<R>& step, const R& t, std::size_t k) {
    by_method(step, t, exact_);
    return quantity(k, ode_.at(t, exact_, step.memory));
  }

  template <class ByMethod>
  Peak peak(std::size_t k, const ByMethod& by_method) {
    return trackers_[k].peak(
        pieces_,
        [&](const MultibodyStep<R>& step, const R& t) {
          step.state_at(t, ode_.system().coordinates(), state_);
          return quantity(k, ode_.at(t, state_, step.memory));
        },
        [&](const MultibodyStep<R>& step, const R& t) { return by(by_method, step, t, k); });
  }

  /// Where a half film slides on its jump: with the force that keeps it there.
  /// @param step_length  of the step that the state lies in; 0: none
  void add_sample(const R& t, const std::vector<R>& y, const std::vector<JointMemory<R>>& memory,
                  const R& step_length) {
    const SystemWorkspace<R>& w = ode_.at(t, y, memory);
    const auto narrow = [](const R& value) { return static_cast<double>(value); };
    MultibodySample sample;
    sample.t = narrow(t);
    for (std::size_t i = 0; i < ode_.mechanical_states(); ++i) sample.state.push_back(narrow(y[i]));
    for (std::size_t j = 0; j < w.joints.size(); ++j) {
      const JointMemory<R> at_j = memory.empty() ? JointMemory<R>() : memory[j];
      sample.joints.push_back(detail::joint_sample(ode_.system().joints()[j], w.joints[j], at_j));
    }
    for (const std::size_t c : drivers_) sample.driving_moments.push_back(moment(w, c));
    add_slides(t, y, memory, step_length, sample);
    if (ode_.with_ledger()) {
      const MechanicalEnergy<R> energy = ode_.energy(y);
      sample.ledger = {narrow(energy.kinetic), narrow(energy.potential)};
      for (std::size_t i = ode_.mechanical_states(); i < y.size(); ++i) sample.ledger.push_back(narrow(y[i]));
    }
    samples_.push_back(std::move(sample));
  }

  /// What is known of a half film's jump.
  struct Jump {
    R slip{};                     ///< u_t at the end of the last step
    std::size_t crossings = 0;    ///< steps in which it changed sign, or that ended within one more of that
    std::size_t steps_since = 0;  ///< the last of these
    R step_length{};              ///< of the last of these [s]
  };
  /// So many steps after a crossing a method that starts anew there has grown to where it meets the jump again.
  static constexpr std::size_t soon = 30;

  R slip_at(const R& t, const std::vector<R>& y, std::size_t j) {
    if (!detail::has_half_film(ode_.system().joints()[j])) return R(0);
    ode_.system().evaluate_kinematics(t, y.data(), ode_.workspace());
    const JournalMotion<R> motion = ode_.system().journal_motion(j, ode_.workspace());
    if (!(norm(motion.eccentricity) > 0) || detail::is_on_jump(motion)) return R(0);
    return detail::slip_velocity(motion);
  }

  void note_jumps(const MultibodyStep<R>& step) {
    for (std::size_t j = 0; j < jumps_.size(); ++j) {
      if (!detail::has_half_film(ode_.system().joints()[j])) continue;
      Jump& jump = jumps_[j];
      const R before = jump.slip;
      jump.slip = slip_at(step.t_new, step.y_new, j);
      ++jump.steps_since;
      const bool dry = !step.memory.empty() && step.memory[j].phase == ContactPhase::dry;
      // Crossed, or as near to it as would cross in one more step: an error estimate that sees the jump rejects steps
      // that do, and the method comes up to it from one side again and again.
      const R next = jump.slip + (jump.slip - before);
      if (dry || (jump.slip != 0 && before * jump.slip > 0 && next * jump.slip > 0) || before == jump.slip) continue;
      ++jump.crossings;
      jump.steps_since = 0;
      jump.step_length = step.t_new - step.t_old;
    }
  }

  /// Puts the sliding forces in; the drivers' moments follow the joints' forces linearly.
  void add_slides(const R& t, const std::vector<R>& y, const std::vector<JointMemory<R>>& memory, const R& step_length,
                  MultibodySample& sample) {
    const std::vector<double> plain = sample.driving_moments;
    for (std::size_t j = 0; j < sample.joints.size(); ++j) {
      if (jumps_[j].crossings == 0 || jumps_[j].steps_since > soon) continue;
      const auto slide =
          detail::half_film_slide(ode_, t, y, memory, j, std::max<R>(step_length, jumps_[j].step_length));
      if (!slide) continue;
      Vector2<double> force(0, 0);
      for (const bool up : {true, false}) {
        const double share = static_cast<double>(up ? slide->share : R(1 - slide->share));
        const SystemWorkspace<R>& w = ode_.at(t, up ? slide->up : slide->down, memory);
        force += share * w.joints[j].total().template cast<double>();
        for (std::size_t d = 0; d < drivers_.size(); ++d) {
          sample.driving_moments[d] += share * (moment(w, drivers_[d]) - plain[d]);
        }
      }
      sample.joints[j].force = force;
    }
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
  R last_length_{};
  std::vector<Jump> jumps_;
  std::vector<MultibodySample> samples_;
  std::vector<R> state_, exact_;
  std::vector<double> values_;
  std::vector<JointExtremes> joint_extremes_;
  std::vector<DriverExtremes> driver_extremes_;
  ConstraintDrift drift_;
  R start_energy_{};
  double energy_residual_ = 0;
  double energy_scale_ = 0;
};

}  // namespace lubjoint
