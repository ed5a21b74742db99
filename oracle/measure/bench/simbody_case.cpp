#include "oracle/measure/bench/simbody_case.hpp"

#include "oracle/mechanisms/simbody_slider_crank.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

mechanisms::SimbodyProblem problem_of(const Scene& scene) {
  const SceneJoint& joint = scene.joints.at(0);
  const bool on_rod = !joint.bearing.on_ground() && scene.bodies[joint.bearing.body].name == "rod";
  return mechanisms::simbody_slider_crank(mechanism_of<double>(scene), crank_speed_of(scene),
                                          Bearing<double>(joint.length, joint.journal_radius, joint.clearance),
                                          Lubricant<double>(joint.viscosity),
                                          on_rod ? mechanisms::BearingOn::rod : mechanisms::BearingOn::slider);
}

class SimbodyCase final : public BenchCase {
 public:
  SimbodyCase(const Scene& scene, std::vector<double> times, Reference reference)
      : engine_(problem_of(scene)),
        clearance_(scene.joints.at(0).clearance),
        duration_(scene.run.duration),
        times_(std::move(times)),
        reference_(std::move(reference)) {}

  std::string formulation() const override { return "joint"; }
  std::vector<std::string> methods() const override { return {"simbody_cpodes"}; }

  MethodRun run(const std::string&, double tolerance, const BenchLimits& limits) override {
    return measured_run(limits, reference_, [&](Reference* seen) {
      const auto run = engine_.run(tolerance, duration_, seen ? times_ : std::vector<double>(), limits.seconds);
      if (seen) {
        for (const mechanisms::SimbodyPin& pin : run.pins) {
          seen->emplace_back(pin.eccentricity[0] / clearance_, pin.eccentricity[1] / clearance_);
        }
      }
      return method_run(run);
    });
  }

 private:
  mechanisms::SimbodyEngine engine_;
  double clearance_;
  double duration_;
  std::vector<double> times_;
  Reference reference_;
};

}  // namespace

MethodRun method_run(const mechanisms::SimbodyOutcome& run) {
  MethodRun result;
  result.finished = run.finished;
  result.message = run.out_of_time ? std::string(out_of_time) : run.message;
  result.seconds = run.seconds;
  result.steps = run.steps;
  result.rejected = run.rejected;
  result.rhs_evaluations = run.evaluations;
  return result;
}

std::vector<std::string_view> simbody_methods() { return {"simbody_cpodes"}; }
std::string simbody_version() { return mechanisms::simbody_version(); }

std::unique_ptr<BenchCase> simbody_case(const Scene& scene, const std::vector<double>& times,
                                        const Reference& reference) {
  return std::make_unique<SimbodyCase>(scene, times, reference);
}

}  // namespace lubjoint::reports
