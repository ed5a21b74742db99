/// What a run in space leaves behind: samples, extremes, drift, energy.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "lubjoint/motion/multibody_recorder.hpp"
#include "lubjoint/motion/spatial_interpolant.hpp"
#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/motion/spatial_sensor_values.hpp"
#include "lubjoint/run/output_times.hpp"
#include "lubjoint/run/step_looks.hpp"

namespace lubjoint {

/// Samples at regular times, peaks inside the steps, drift and energy of a run in space.
template <class R>
class SpatialRecorder {
 public:
  /// @param pieces  into so many a step is divided in the search for its extremes
  /// @param resolution  below which a quantity is the run's own error: its peaks are not searched, and count as 0
  /// @param sensors  what is measured beside bodies, joints and constraints; kept by reference
  SpatialRecorder(SpatialOde<R>& ode, const RunSettings& settings, std::size_t pieces,
                  const SpatialResolution& resolution, const std::vector<SpatialSensor>& sensors)
      : ode_(ode), outputs_(settings), resolution_(resolution), sensors_(sensors) {
    const auto& constraints = ode.system().constraints();
    for (std::size_t c = 0; c < constraints.size(); ++c) {
      if (constraints[c].is_driver()) {
        drivers_.push_back(c);
      } else {
        reactions_.push_back({c, false});
        if (constraints[c].holds_moment()) reactions_.push_back({c, true});
      }
    }
    first_driver_ = of_joint * ode.system().joints().size();
    first_reaction_ = first_driver_ + 2 * drivers_.size();
    first_sensor_ = first_reaction_ + reactions_.size();
    for (const SpatialSensor& sensor : sensors_) sensor_values_ += sensor_quantities(sensor).size();
    looks_ = StepLooks<R>(first_sensor_ + 2 * sensor_values_, pieces);
  }

  /// The first sample.
  void start(const R& t, const std::vector<R>& y) {
    add_sample(t, y, ode_.memory());
    balance_.start(ode_.energy(t, y));
    note_drift(t, ode_.last(), y);
  }

  /// An accepted step: the samples in it, and its extremes.
  /// @param by_method  by_method(step, t, y) puts the state inside a step into y by the integrator itself
  template <class ByMethod>
  void step(const std::shared_ptr<const MultibodyStep<R>>& step, const ByMethod& by_method) {
    outputs_.up_to(static_cast<double>(step->t_new), [&](double t) {
      step->sample_at(
          R(t), by_method, [this](const MultibodyStep<R>& in, const R& at, std::vector<R>& y) { inside(in, at, y); },
          state_);
      add_sample(R(t), state_, step->memory);
    });
    looks_.step(
        step->t_old, step->t_new, step->begins_anew(),
        [&](const R& t, const auto& put) {
          if (t == step->t_new) {
            state_ = step->y_new;
          } else {
            inside(*step, t, state_);
          }
          const SpatialWorkspace<R>& w = ode_.at(t, state_, step->memory);
          if (!sensors_.empty()) read_sensors(sensors_, ode_.system(), t, w, measured_);
          for (std::size_t k = 0; k < first_sensor_ + 2 * sensor_values_; ++k) put(k, quantity(k, w, measured_));
          if (t == step->t_new) note_drift(t, w, step->y_new);
        },
        [&](std::size_t k, const R& t) {
          inside(*step, t, state_);
          return exactly(k, t, ode_.at(t, state_, step->memory));
        },
        [&](std::size_t k, const R& t) { return by(by_method, *step, t, k); });
  }

  /// The last sample, and what the peaks are of.
  void finish(const R& t, const std::vector<R>& y) {
    if (samples_.empty() || samples_.back().t < static_cast<double>(t)) add_sample(t, y, ode_.memory());
    std::size_t k = 0;
    const auto next = [&] {
      const LargestValue<R>& largest = looks_.largest(k++);
      return Peak{largest.value(), static_cast<double>(largest.t())};
    };
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      SpatialJointExtremes extremes;
      for (Peak* each :
           {&extremes.eccentricity, &extremes.force, &extremes.tilt, &extremes.sliding, &extremes.edge_share}) {
        *each = next();
      }
      joint_extremes_.push_back(extremes);
    }
    for (std::size_t d = 0; d < drivers_.size(); ++d) {
      const Peak high = next();
      Peak low = next();
      low.value = -low.value;
      driver_extremes_.push_back({high, low});
    }
    for (const Reaction& reaction : reactions_) {
      const Peak largest = next();
      if (reaction.of_moment) {
        reaction_extremes_.back().moment = largest;
      } else {
        reaction_extremes_.push_back({reaction.constraint, largest, std::nullopt});
      }
    }
    for (std::size_t s = 0; s < sensor_values_; ++s) {
      const Peak high = next();
      Peak low = next();
      low.value = -low.value;
      sensor_extremes_.push_back({high, low});
    }
  }

  const std::vector<SpatialSample>& samples() const { return samples_; }  ///< in order
  const SpatialDrift& drift() const { return drift_; }                    ///< largest so far, but for |p|'s
  /// Are the rows that were left out still implied by the others? They are then off by as much as those, added up along
  /// the loop, which is given a factor of 100; rows of rad and of m are compared by the size of the mechanism.
  bool is_redundant_still() const { return left_out_ <= redundant_limit(); }
  /// How far a row that was left out may be off [m or rad].
  double largest_left_out(std::size_t row) const { return redundant_limit() * unit_of_row(row); }
  double energy_residual() const { return balance_.residual(); }  ///< largest |E − E₀ − work| [J]
  double energy_scale() const { return balance_.scale(); }        ///< largest kinetic energy or work [J]

  /// Of the joints, in order; after finish.
  const std::vector<SpatialJointExtremes>& joint_extremes() const { return joint_extremes_; }
  /// Of the drivers, in order; after finish.
  const std::vector<DriverExtremes>& driver_extremes() const { return driver_extremes_; }
  /// Of the constraints that are no drivers, in order; after finish.
  const std::vector<ReactionExtremes>& reaction_extremes() const { return reaction_extremes_; }
  /// Of the sensors' values, in order; after finish.
  const std::vector<SensorExtremes>& sensor_extremes() const { return sensor_extremes_; }

 private:
  static constexpr std::size_t of_joint = 5;  ///< quantities of a joint

  /// A constraint whose force, or whose moment, is followed.
  struct Reaction {
    std::size_t constraint;
    bool of_moment;
  };

  void inside(const MultibodyStep<R>& step, const R& t, std::vector<R>& y) const {
    spatial_state_at<R>(step, ode_.system().bodies().size(), t, y);
  }

  double redundant_limit() const { return std::max(1e-6, 100 * kept_); }
  double unit_of_row(std::size_t row) const { return ode_.system().row_is_length(row) ? resolution_.mechanism : 1; }

  /// A quantity, or 0 where the run can't tell it from its own errors. The peaks of these, which an interpolant shows
  /// and the method does not confirm, would be searched in every step.
  static double above(double least, double value) { return value > least ? value : 0; }

  double tilt(const SpatialJointForce<R>& force) const {
    return above(resolution_.angle, static_cast<double>(force.kinematics.tilt()));
  }
  /// Share of the film that a tilt takes at the bearing's edge. Where a film gives way to contact, the transition's
  /// width stands for a thinner film: what it does not feel is no share of it. 0 of a joint without a film.
  static double edge_share(const SpatialJointElement<R>& joint, double tilt, double eccentricity) {
    if (!joint.plane.film) return 0;
    const double gap = static_cast<double>(joint.plane.bearing.clearance()) - eccentricity;
    const auto& contact = joint.plane.contact;
    const double floor = contact && contact->transition ? static_cast<double>(contact->transition->e0) : 0;
    const double film = std::max(gap, floor);
    return film > 0 ? static_cast<double>(joint.edge_shift(R(tilt))) / film : 0;
  }

  static double length(const Vector2<R>& v) { return static_cast<double>(v.norm()); }

  /// What number k of the peaks is of: of each joint |e|, |F|, ψ, |σ| and the edge's share; then the effort of each
  /// driver and its opposite, then the reactions, then each value of the sensors and its opposite.
  double quantity(std::size_t k, const SpatialWorkspace<R>& w, const std::vector<double>& measured) const {
    using std::abs;
    if (k >= first_sensor_) {
      const double value = measured[(k - first_sensor_) / 2];
      return (k - first_sensor_) % 2 == 0 ? value : -value;
    }
    if (k >= first_reaction_) {
      const Reaction& reaction = reactions_[k - first_reaction_];
      const SpatialReaction<R> at = ode_.system().reaction_at_joint(reaction.constraint, w);
      const double force = static_cast<double>(at.force.norm());
      // Of an arm that is known to the tolerance.
      return reaction.of_moment ? above(force * resolution_.length, static_cast<double>(at.moment.norm())) : force;
    }
    if (k >= first_driver_) {
      const double value = static_cast<double>(ode_.system().driving_effort(drivers_[(k - first_driver_) / 2], w));
      return (k - first_driver_) % 2 == 0 ? value : -value;
    }
    const SpatialJointElement<R>& joint = ode_.system().joints()[k / of_joint];
    const SpatialJointForce<R>& force = w.joints[k / of_joint];
    const double eccentricity = length(force.kinematics.motion.eccentricity);
    switch (k % of_joint) {
      case 0:
        return eccentricity;
      case 1:
        return length(force.plane.total());
      case 2:
        return tilt(force);
      case 3:
        return above(resolution_.length, std::abs(static_cast<double>(force.kinematics.sliding)));
      default:
        return edge_share(joint, tilt(force), eccentricity);
    }
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
    return exactly(k, t, ode_.at(t, exact_, step.memory));
  }

  /// The same, of a state that is not one of a step's pieces.
  double exactly(std::size_t k, const R& t, const SpatialWorkspace<R>& w) {
    if (k >= first_sensor_) read_sensors(sensors_, ode_.system(), t, w, exactly_measured_);
    return quantity(k, w, exactly_measured_);
  }

  /// @param at  whose Euler parameters may be off by a share of the tolerance: a sample's are not
  void add_sample(const R& t, const std::vector<R>& at, const std::vector<JointMemory<R>>& memory) {
    std::vector<R> y = at;
    for (std::size_t b = 0; b < ode_.system().bodies().size(); ++b) {
      R* p = &y[spatial_coordinates * b + 3];
      const EulerParameters<R> unit = normalised(EulerParameters<R>(p[0], p[1], p[2], p[3]));
      std::copy(unit.data(), unit.data() + 4, p);
    }
    const SpatialWorkspace<R>& w = ode_.at(t, y, memory);
    const auto narrow = [](const R& value) { return static_cast<double>(value); };
    SpatialSample sample;
    sample.t = narrow(t);
    for (std::size_t i = 0; i < ode_.mechanical_states(); ++i) sample.state.push_back(narrow(y[i]));
    for (std::size_t j = 0; j < w.joints.size(); ++j) {
      const JointMemory<R> at_j = memory.empty() ? JointMemory<R>() : memory[j];
      const SpatialJointForce<R>& force = w.joints[j];
      // Losses and gaps are the plane's.
      const JointSample in_plane = detail::joint_sample(ode_.system().joints()[j].plane, force.plane, at_j);
      sample.joints.push_back({force.kinematics.in_space(force.kinematics.motion.eccentricity).template cast<double>(),
                               force.force().template cast<double>(), in_plane.eccentricity_ratio,
                               in_plane.film_thickness, narrow(force.kinematics.tilt()),
                               narrow(force.kinematics.sliding), in_plane.losses});
    }
    for (const std::size_t c : drivers_) sample.driving_efforts.push_back(narrow(ode_.system().driving_effort(c, w)));
    if (!sensors_.empty()) read_sensors(sensors_, ode_.system(), t, w, sample.sensors);
    if (ode_.with_ledger()) {
      const MechanicalEnergy<R> energy = ode_.energy(t, y);
      sample.ledger = {narrow(energy.kinetic), narrow(energy.potential)};
      for (std::size_t i = ode_.mechanical_states(); i < y.size(); ++i) sample.ledger.push_back(narrow(y[i]));
    }
    samples_.push_back(std::move(sample));
  }

  void note_drift(const R& t, const SpatialWorkspace<R>& w, const std::vector<R>& y) {
    const std::vector<std::size_t>& without = ode_.system().left_out();
    for (std::size_t row = 0; row < w.rows.size(); ++row) {
      const double off = std::abs(static_cast<double>(w.rows[row].value));
      drift_.position = std::max(drift_.position, off);
      drift_.velocity = std::max(drift_.velocity, std::abs(static_cast<double>(ode_.system().constraint_rate(row, w))));
      const bool is_left_out = std::binary_search(without.begin(), without.end(), row);
      if (is_left_out) drift_.left_out_position = std::max(drift_.left_out_position, off);
      double& share = is_left_out ? left_out_ : kept_;
      share = std::max(share, off / unit_of_row(row));
    }
    if (ode_.with_ledger()) balance_.note(ode_.energy(t, y), y, ode_.mechanical_states());
  }

  SpatialOde<R>& ode_;
  OutputTimes outputs_;
  SpatialResolution resolution_;
  double kept_ = 0, left_out_ = 0;  ///< drift of the rows in rad, or in mechanisms
  StepLooks<R> looks_{0, 1};
  std::vector<std::size_t> drivers_;
  std::vector<Reaction> reactions_;
  const std::vector<SpatialSensor>& sensors_;
  std::size_t first_driver_ = 0, first_reaction_ = 0, first_sensor_ = 0;  ///< their numbers among the peaks
  std::size_t sensor_values_ = 0;                                         ///< of all sensors together
  std::vector<SpatialSample> samples_;
  std::vector<SpatialJointExtremes> joint_extremes_;
  std::vector<DriverExtremes> driver_extremes_;
  std::vector<ReactionExtremes> reaction_extremes_;
  std::vector<SensorExtremes> sensor_extremes_;
  std::vector<double> measured_, exactly_measured_;
  SpatialDrift drift_;
  EnergyBalance<R> balance_;
  std::vector<R> state_, exact_;
  R exact_t_{-1}, exact_from_{-1};
};

}  // namespace lubjoint
