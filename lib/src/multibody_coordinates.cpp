#include <algorithm>
#include <array>

#include "lubjoint/motion/in_plane.hpp"
#include "lubjoint/motion/independent_integrator.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_coordinates.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

namespace {

// A right-hand side in independent coordinates works on a matrix of all coordinates by all freedoms, and an implicit
// step on full ones of the freedoms. Measured on chains of pendulums: at 15 freedoms a step takes 0.6 of the time of
// one in absolute coordinates with sparse matrices, at 20 0.84. The choice of a chart takes 1.6 ms at 60 coordinates
// and grows as their cube.
constexpr std::size_t most_freedoms = 15;
constexpr std::size_t most_coordinates = 60;

template <std::size_t N>
std::unique_ptr<Integrator<double, run_time_size>> method_of_size(const std::string& name, MultibodyOde<double>& ode,
                                                                  const StepTolerance<double, run_time_size>& tolerance,
                                                                  std::vector<std::array<double, 2>> of_joints) {
  return std::make_unique<IndependentIntegrator<InPlane<double>, N>>(
      ode, tolerance, std::move(of_joints),
      [name](const StepTolerance<double, N>& of_chart) { return make_integrator<N>(name, of_chart); });
}

/// Does a scene's stabilisation say more than that there is none in its file?
bool asks_for_stabilisation(const SceneStabilisation& given) {
  const SceneStabilisation otherwise;
  return given.asked || given.projection || given.passes_singular || given.alpha != otherwise.alpha ||
         given.beta != otherwise.beta;
}

std::string counted(std::size_t count, const std::string& what, const std::string& plural) {
  return std::to_string(count) + " " + (count == 1 ? what : plural);
}

}  // namespace

CoordinatesChoice choose_coordinates(const CoordinatesCase& given) {
  const std::size_t freedoms = given.coordinates - given.constraints;
  if (given.asked == SceneCoordinates::absolute) return {false, ""};
  if (given.asked == SceneCoordinates::independent) {
    if (freedoms == 0) {
      throw SceneError(given.file +
                       ": coordinates = \"independent\", but the constraints prescribe all motion and leave none; "
                       "allowed are \"auto\" and \"absolute\"");
    }
    return {true, ""};
  }
  const std::string count = counted(freedoms, "degree of freedom", "degrees of freedom");
  if (given.constraints == 0) return {false, "there are no constraints"};
  if (asks_for_stabilisation(given.stabilisation))
    return {false, "the scene asks for a stabilisation of its constraints"};
  if (freedoms == 0) return {false, "the constraints prescribe all motion"};
  if (freedoms > most_freedoms) return {false, count + " are more than " + std::to_string(most_freedoms)};
  if (given.coordinates > most_coordinates) {
    return {false,
            std::to_string(given.coordinates) + " coordinates are more than " + std::to_string(most_coordinates)};
  }
  return {true, count + " in " + std::to_string(given.coordinates) + " coordinates"};
}

CoordinatesChoice choose_coordinates(const Scene& scene, const PlanarSystem<double>& system) {
  return choose_coordinates(
      {scene.coordinates, scene.stabilisation, scene.file, system.coordinates(), system.constraint_rows()});
}

// Steps in independent coordinates are as long as their tolerance lets them be, those in absolute ones are kept short
// by places a thousand times larger: with a tenth, a scene's tolerance means errors of the same size in both. Below
// 1e-14 rounding would be all that is left of an error estimate.
double tolerance_of_independent(double given) { return std::max(given / 10, std::min(given, 1e-14)); }

std::unique_ptr<Integrator<double, run_time_size>> independent_method(const std::string& name, const Scene& scene,
                                                                      MultibodyOde<double>& ode, const RunSettings& run,
                                                                      const std::vector<double>& tolerances) {
  const double share = tolerance_of_independent(run.absolute_tolerance) / run.absolute_tolerance;
  const double rate = scene_units(scene).rate;
  std::vector<std::array<double, 2>> of_joints;
  for (const SceneJoint& joint : scene.joints) {
    const double place = share * run.absolute_tolerance * joint.clearance;
    of_joints.push_back({place, place * rate});
  }
  StepTolerance<double, run_time_size> tolerance{0, tolerances, tolerance_of_independent(run.relative_tolerance),
                                                 ode.dimension() - ode.mechanical_states()};
  for (double& each : tolerance.absolute) each *= share;
  const std::size_t freedoms = ode.system().coordinates() - ode.system().constraint_rows();
  if (freedoms == 2 && !ode.with_ledger()) return method_of_size<4>(name, ode, tolerance, std::move(of_joints));
  return method_of_size<run_time_size>(name, ode, tolerance, std::move(of_joints));
}

}  // namespace lubjoint
