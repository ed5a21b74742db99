/// What a run of a multibody system leaves behind: samples, extremes, drift, energy.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/motion/multibody_step.hpp"
#include "lubjoint/motion/sensor_values.hpp"
#include "lubjoint/run/outcome.hpp"
#include "lubjoint/run/output_times.hpp"
#include "lubjoint/run/step_looks.hpp"

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

}  // namespace detail

/// Samples at regular times, peaks inside the steps, drift and energy of a multibody run.
template <class R>
class MultibodyRecorder {
 public:
  /// @param pieces  into so many a step is divided in the search for its extremes
  /// @param sensors  what is measured beside bodies, joints and constraints; kept by reference
  MultibodyRecorder(MultibodyOde<R>& ode, const RunSettings& settings, std::size_t pieces,
                    const std::vector<Sensor>& sensors)
      : ode_(ode), outputs_(settings), sensors_(sensors) {
    for (std::size_t c = 0; c < ode.system().constraints().size(); ++c) {
      const NamedConstraint<R>& constraint = ode.system().constraints()[c];
      if (constraint.is_driver()) {
        drivers_.push_back(c);
      } else {
        // A pin can't hold a moment.
        const bool pin = std::holds_alternative<Revolute<R>>(constraint.constraint);
        reactions_.push_back({c, false});
        if (!pin) reactions_.push_back({c, true});
      }
    }
    first_reaction_ = 2 * ode.system().joints().size() + 2 * drivers_.size();
    first_sensor_ = first_reaction_ + reactions_.size();
    for (const Sensor& sensor : sensors_) sensor_values_ += sensor_quantities(sensor).size();
    quantities_ = first_sensor_ + 2 * sensor_values_;
    looks_ = StepLooks<R>(quantities_, pieces);
  }

  /// The first sample.
  void start(const R& t, const std::vector<R>& y) {
    add_sample(t, y, ode_.memory());
    balance_.start(ode_.energy(y));
  }

  /// An accepted step: the samples in it, and its extremes.
  /// @param by_method  by_method(step, t, y) puts the state inside a step into y by the integrator itself
  template <class ByMethod>
  void step(const std::shared_ptr<const MultibodyStep<R>>& step, const ByMethod& by_method) {
    const std::size_t n = ode_.system().coordinates();
    outputs_.up_to(static_cast<double>(step->t_new), [&](double t) {
      step->sample_at(
          R(t), by_method, [n](const MultibodyStep<R>& in, const R& at, std::vector<R>& y) { in.state_at(at, n, y); },
          state_);
      add_sample(R(t), state_, step->memory);
    });
    looks_.step(
        step->t_old, step->t_new, step->begins_anew(),
        [&](const R& t, const auto& put) {
          if (t == step->t_new) {
            state_ = step->y_new;
          } else {
            step->state_at(t, n, state_);
          }
          const SystemWorkspace<R>& w = ode_.at(t, state_, step->memory);
          if (!sensors_.empty()) read_sensors(sensors_, ode_.system(), w, measured_);
          for (std::size_t k = 0; k < quantities_; ++k) put(k, quantity(k, w, measured_));
          if (t == step->t_new) note_drift(w, step->y_new);
        },
        [&](std::size_t k, const R& t) {
          step->state_at(t, n, state_);
          return exactly(k, ode_.at(t, state_, step->memory));
        },
        [&](std::size_t k, const R& t) { return by(by_method, *step, t, k); });
  }

  /// The last sample, and what the peaks are of.
  void finish(const R& t, const std::vector<R>& y) {
    if (samples_.empty() || samples_.back().t < static_cast<double>(t)) add_sample(t, y, ode_.memory());
    std::size_t k = 0;
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      const Peak eccentricity = peak(k++);
      const Peak force = peak(k++);
      joint_extremes_.push_back({eccentricity, force});
    }
    for (std::size_t d = 0; d < drivers_.size(); ++d) {
      const Peak high = peak(k++);
      Peak low = peak(k++);
      low.value = -low.value;
      driver_extremes_.push_back({high, low});
    }
    for (const Reaction& reaction : reactions_) {
      const Peak largest = peak(k++);
      if (reaction.of_moment) {
        reaction_extremes_.back().moment = largest;
      } else {
        reaction_extremes_.push_back({reaction.constraint, largest, std::nullopt});
      }
    }
    for (std::size_t s = 0; s < sensor_values_; ++s) {
      const Peak high = peak(k++);
      Peak low = peak(k++);
      low.value = -low.value;
      sensor_extremes_.push_back({high, low});
    }
  }

  const std::vector<MultibodySample>& samples() const { return samples_; }  ///< in order
  const ConstraintDrift& drift() const { return drift_; }                   ///< largest so far
  double energy_residual() const { return balance_.residual(); }            ///< largest |E − E₀ − work| [J]
  double energy_scale() const { return balance_.scale(); }                  ///< largest kinetic energy or work [J]

  /// Of the joints, in order; after finish.
  const std::vector<JointExtremes>& joint_extremes() const { return joint_extremes_; }
  /// Of the drivers, in order; after finish.
  const std::vector<DriverExtremes>& driver_extremes() const { return driver_extremes_; }
  /// Of the constraints that are no drivers, in order; after finish.
  const std::vector<ReactionExtremes>& reaction_extremes() const { return reaction_extremes_; }
  /// Of the sensors' values, in order; after finish.
  const std::vector<SensorExtremes>& sensor_extremes() const { return sensor_extremes_; }

 private:
  /// A constraint whose force, or whose moment, is followed.
  struct Reaction {
    std::size_t constraint;
    bool of_moment;
  };

  /// −λ: the moment of a driver that turns, the force of one that moves along an axis.
  double moment(const SystemWorkspace<R>& w, std::size_t driver) const {
    return static_cast<double>(0 - w.multipliers[ode_.system().first_row(driver)]);
  }

  /// What number k of the peaks is of: |e| and |F| of each joint, then the moment of each driver and its opposite, then
  /// the reactions, then each value of the sensors and its opposite.
  double quantity(std::size_t k, const SystemWorkspace<R>& w, const std::vector<double>& measured) const {
    if (k >= first_sensor_) {
      const double value = measured[(k - first_sensor_) / 2];
      return (k - first_sensor_) % 2 == 0 ? value : -value;
    }
    if (k >= first_reaction_) return size_of(reactions_[k - first_reaction_], w);
    const std::size_t joint = k / 2;
    if (joint < w.joints.size()) {
      const JointForce<R>& force = w.joints[joint];
      return static_cast<double>(k % 2 == 0 ? force.kinematics.motion.eccentricity.norm() : force.total().norm());
    }
    const double value = moment(w, drivers_[joint - w.joints.size()]);
    return k % 2 == 0 ? value : -value;
  }

  /// |F| or |M| of a constraint.
  double size_of(const Reaction& reaction, const SystemWorkspace<R>& w) const {
    const JointReaction<R> at_joint = ode_.system().reaction_at_joint(reaction.constraint, w);
    return reaction.of_moment ? std::abs(static_cast<double>(at_joint.moment))
                              : static_cast<double>(at_joint.force.norm());
  }

  /// By the method's own steps, which are none of the run's cost. Quantities often peak together.
  template <class ByMethod>
  double by(const ByMethod& by_method, const MultibodyStep<R>& step, const R& t, std::size_t k) {
    if (t != exact_t_ || step.t_old != exact_from_) {
      const std::size_t counted = ode_.evaluations();
      by_method(step, t, exact_);
      ode_.count_from(counted);
      exact_t_ = t;
      exact_from_ = step.t_old;
    }
    return exactly(k, ode_.at(t, exact_, step.memory));
  }

  /// The same, of a state that is not one of a step's pieces.
  double exactly(std::size_t k, const SystemWorkspace<R>& w) {
    if (k >= first_sensor_) read_sensors(sensors_, ode_.system(), w, exactly_measured_);
    return quantity(k, w, exactly_measured_);
  }

  Peak peak(std::size_t k) const {
    const LargestValue<R>& largest = looks_.largest(k);
    return {largest.value(), static_cast<double>(largest.t())};
  }

  void add_sample(const R& t, const std::vector<R>& y, const std::vector<JointMemory<R>>& memory) {
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
    if (!sensors_.empty()) read_sensors(sensors_, ode_.system(), w, sample.sensors);
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
    if (ode_.with_ledger()) balance_.note(ode_.energy(y), y, ode_.mechanical_states());
  }

  MultibodyOde<R>& ode_;
  OutputTimes outputs_;
  StepLooks<R> looks_{0, 1};
  std::vector<std::size_t> drivers_;
  std::vector<Reaction> reactions_;
  const std::vector<Sensor>& sensors_;
  std::size_t first_reaction_ = 0;  ///< its number among the peaks
  std::size_t first_sensor_ = 0;    ///< likewise
  std::size_t sensor_values_ = 0;   ///< of all sensors together
  std::size_t quantities_ = 0;      ///< that are looked at
  std::vector<MultibodySample> samples_;
  std::vector<R> state_, exact_;
  R exact_t_{-1}, exact_from_{-1};  ///< of exact_: its time, and where its step begins
  std::vector<double> measured_, exactly_measured_;
  std::vector<JointExtremes> joint_extremes_;
  std::vector<DriverExtremes> driver_extremes_;
  std::vector<ReactionExtremes> reaction_extremes_;
  std::vector<SensorExtremes> sensor_extremes_;
  ConstraintDrift drift_;
  EnergyBalance<R> balance_;
};

}  // namespace lubjoint
