#include "lubjoint/scene/spatial_coordinates.hpp"

#include <algorithm>
#include <array>
#include <variant>

#include "lubjoint/motion/in_space.hpp"
#include "lubjoint/motion/independent_integrator.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"

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
  const auto& elements = system.elements();
  const bool counts = std::any_of(elements.springs.begin(), elements.springs.end(),
                                  [](const auto& each) {
                                    return std::holds_alternative<SpatialRotationalSpring<double>>(each.spring);
                                  }) ||
                      std::any_of(elements.loads.begin(), elements.loads.end(), [](const auto& each) {
                        const auto* table = std::get_if<SpatialTableLoad<double>>(&each);
                        return table != nullptr && table->of_angle;
                      });
  if (counts && scene.coordinates == SceneCoordinates::independent) {
    throw SceneError(scene.file +
                     ": coordinates is \"independent\" beside a spring about a pin or a table over an angle, whose "
                     "revolutions are counted in absolute ones; allowed is \"absolute\", or \"auto\"");
  }
  if (counts) return {false, "forces that depend on angles counted through revolutions"};
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
