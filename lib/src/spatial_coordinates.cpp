#include "lubjoint/scene/spatial_coordinates.hpp"

#include <array>

#include "lubjoint/motion/in_space.hpp"
#include "lubjoint/motion/independent_integrator.hpp"
#include "lubjoint/ode/integrators.hpp"

namespace lubjoint {

namespace {

template <std::size_t N>
std::unique_ptr<Integrator<double, run_time_size>> method_of_size(const std::string& name, SpatialOde<double>& ode,
                                                                  const StepTolerance<double, run_time_size>& tolerance,
                                                                  std::vector<std::array<double, 2>> of_joints) {
  return std::make_unique<IndependentIntegrator<InSpace<double>, N>>(
      ode, tolerance, std::move(of_joints),
      [name](const StepTolerance<double, N>& of_chart) { return make_integrator<N>(name, of_chart); });
}

}  // namespace

CoordinatesChoice choose_coordinates(const SpatialScene& scene, const SpatialSystem<double>& system) {
  return choose_coordinates(
      {scene.coordinates, scene.stabilisation, scene.file, system.velocities(), system.kept().size()});
}

std::unique_ptr<Integrator<double, run_time_size>> independent_method(const std::string& name,
                                                                      const SpatialScene& scene,
                                                                      SpatialOde<double>& ode, const RunSettings& run,
                                                                      const std::vector<double>& tolerances) {
  const double share = tolerance_of_independent(run.absolute_tolerance) / run.absolute_tolerance;
  const double rate = scene_units(scene).rate;
  std::vector<std::array<double, 2>> of_joints;
  for (const SpatialSceneJoint& joint : scene.joints) {
    const double place = share * run.absolute_tolerance * joint.plane.clearance;
    of_joints.push_back({place, place * rate});
  }
  StepTolerance<double, run_time_size> tolerance{0, tolerances, tolerance_of_independent(run.relative_tolerance),
                                                 ode.dimension() - ode.mechanical_states()};
  for (double& each : tolerance.absolute) each *= share;
  const std::size_t freedoms = ode.system().velocities() - ode.system().kept().size();
  if (freedoms == 2 && !ode.with_ledger()) return method_of_size<4>(name, ode, tolerance, std::move(of_joints));
  return method_of_size<run_time_size>(name, ode, tolerance, std::move(of_joints));
}

}  // namespace lubjoint
