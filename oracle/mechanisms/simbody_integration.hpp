/// Runs of Simbody's integrator, for the sources of mechanisms that are built on it.
#pragma once

#include <Simbody.h>

#include <stdexcept>
#include <vector>

#include "oracle/mechanisms/processor_time.hpp"
#include "oracle/mechanisms/simbody_run.hpp"

namespace lubjoint::mechanisms {

/// A run's share of processor time. What is called at every evaluation of the forces looks at it now and then.
class SimbodyClock {
 public:
  void start(double seconds) {
    out_of_time_ = false;
    deadline_ = processor_seconds() + seconds;
  }
  /// @throws std::runtime_error where the share is used up
  void look() {
    if (++calls_ % 256 == 0 && processor_seconds() > deadline_) out_of_time_ = true;
    if (out_of_time_) throw std::runtime_error("out of time");
  }
  bool is_out_of_time() const { return out_of_time_; }

 private:
  double deadline_ = 0;  ///< in processor_seconds()
  std::size_t calls_ = 0;
  bool out_of_time_ = false;
};

/// A force element of these mechanisms: it looks at the clock, and says where the journal is.
template <class Pin>
class SimbodyPinForce : public SimTK::Force::Custom::Implementation {
 public:
  virtual Pin pin(const SimTK::State& state) const = 0;
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
  SimbodyClock& clock() const { return clock_; }

 private:
  mutable SimbodyClock clock_;  ///< Simbody's forces are constant
};

/// How Simbody is to integrate.
struct SimbodySettings {
  double accuracy;            ///< its only tolerance, the same for all states
  double duration;            ///< [s]
  double seconds;             ///< of processor time after which a run is given up
  std::vector<double> times;  ///< to be looked at, ascending; none: only the end is reached, for its run time
  /// Bring every step's end onto the constraints, or only those that are off by more than their tolerance?
  bool project_every_step = false;
};

/// Standard error is nowhere as long as this is there: CPodes reports what it then mends, and can't be asked not to.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int before_;
};

/// By CPodes' BDF with Newton's iteration, Simbody's method for stiff systems.
template <class Pin>
SimbodyRun<Pin> integrate(const SimTK::MultibodySystem& system, const SimTK::State& start,
                          const SimbodyPinForce<Pin>& force, const SimbodySettings& settings) {
  SimbodyRun<Pin> result;
  SimTK::CPodesIntegrator stepper(system, SimTK::CPodes::BDF);
  stepper.setAccuracy(settings.accuracy);
  stepper.setFinalTime(settings.duration);
  stepper.setProjectEveryStep(settings.project_every_step);
  std::vector<double> goals = settings.times;
  if (goals.empty()) goals = {settings.duration};
  force.clock().start(settings.seconds);
  const int before = system.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration);
  const Silence silence;
  const double begin = processor_seconds();
  try {
    stepper.initialize(start);
    for (const double goal : goals) {
      while (stepper.getTime() < goal) stepper.stepTo(goal);
      if (settings.times.empty()) continue;
      system.realize(stepper.getState(), SimTK::Stage::Velocity);
      result.pins.push_back(force.pin(stepper.getState()));
    }
    result.finished = true;
  } catch (const std::exception&) {  // of Simbody: where in its sources, over several lines
    result.out_of_time = force.clock().is_out_of_time();
    result.message = "Simbody stopped at " + std::to_string(stepper.getTime()) + " s";
  }
  result.seconds = processor_seconds() - begin;
  result.steps = static_cast<std::size_t>(stepper.getNumStepsTaken());
  result.rejected = static_cast<std::size_t>(stepper.getNumErrorTestFailures());
  result.evaluations =
      static_cast<std::size_t>(system.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration) - before);
  return result;
}

}  // namespace lubjoint::mechanisms
