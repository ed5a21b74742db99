/// What measuring a scene's cost needs in the plane and in space.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "lubjoint/scene/spatial_scene.hpp"
#include "oracle/measure/scene_cost.hpp"
#include "oracle/measure/timing.hpp"

namespace lubjoint::reports {

/// Everything that is timed, and what to do with each time when it is there.
class Measurement {
 public:
  template <class Use>
  void add(TimedPiece piece, Use use) {
    pieces_.push_back(std::move(piece));
    uses_.push_back(std::move(use));
  }
  /// Equations that pieces refer to.
  template <class Equations, class... Given>
  Equations& keep(const Given&... given) {
    const auto made = std::make_shared<Equations>(given...);
    kept_.push_back(made);
    return *made;
  }

  /// The first piece is the whole right-hand side.
  void run(std::size_t rounds) {
    constexpr double batch_seconds = 2e-4;
    const std::vector<Timing> timings = time_in_turn(pieces_, rounds, batch_seconds);
    for (std::size_t i = 0; i < timings.size(); ++i) {
      uses_[i](timings[i].nanoseconds(), timings[i].ratio_to(timings.front()));
    }
  }

 private:
  std::vector<TimedPiece> pieces_;
  std::vector<std::function<void(double, double)>> uses_;
  std::vector<std::shared_ptr<void>> kept_;
};

/// What the parts leave of the right-hand side, as the last of them.
inline void add_rest(const std::string& name, SceneCost& cost) {
  CostPart rest{name, cost.nanoseconds, 1};
  for (const CostPart& part : cost.parts) {
    rest.nanoseconds -= part.nanoseconds;
    rest.share -= part.share;
  }
  cost.parts.push_back(rest);
}

inline SceneJoint& in_plane(SceneJoint& joint) { return joint; }
inline SceneJoint& in_plane(SpatialSceneJoint& joint) { return joint.plane; }
inline const SceneJoint& in_plane(const SceneJoint& joint) { return joint; }
inline const SceneJoint& in_plane(const SpatialSceneJoint& joint) { return joint.plane; }

inline bool has_film(const SceneJoint& joint) { return joint.film != no_film; }

/// Steel, with a transition, in every joint.
template <class AnyScene>
AnyScene with_contact(AnyScene scene) {
  for (auto& each : scene.joints) {
    SceneJoint& joint = in_plane(each);
    joint.transition = SceneTransition{joint.clearance / 40, joint.clearance / 20};
    joint.contact = SceneContact{207e9, 0.3, 207e9, 0.3, 0.9, 1e-3, 0.0, 1e-3};
  }
  return scene;
}

/// Films alone; joints without one are left out.
template <class AnyScene>
AnyScene without_contact(AnyScene scene) {
  std::erase_if(scene.joints, [](const auto& joint) { return !has_film(in_plane(joint)); });
  for (auto& each : scene.joints) {
    in_plane(each).transition.reset();
    in_plane(each).contact.reset();
  }
  return scene;
}

template <class AnyScene>
bool has_shear(const AnyScene& scene) {
  return std::ranges::any_of(scene.joints, [](const auto& joint) { return in_plane(joint).shear.has_value(); });
}

/// Every film's friction torque, or, where the scene has one, none.
template <class AnyScene>
AnyScene with_shear_changed(AnyScene scene) {
  const bool in_scene = has_shear(scene);
  for (auto& each : scene.joints) {
    SceneJoint& joint = in_plane(each);
    joint.shear.reset();
    if (!in_scene && has_film(joint)) joint.shear = ShearExtent::film;
  }
  return scene;
}

template <class AnyScene>
bool has_baumgarte(const AnyScene& scene) {
  return scene.stabilisation.alpha != 0 || scene.stabilisation.beta != 0;
}

template <class AnyScene>
AnyScene with_upkeep_changed(AnyScene scene) {
  scene.stabilisation = has_baumgarte(scene) ? SceneStabilisation{true, 0, 0} : SceneStabilisation{false, 5, 5};
  return scene;
}

/// Numbers of bodies, constraints, force terms and events.
template <class AnyScene>
void count_scene(const AnyScene& scene, SceneCost& cost) {
  cost.scene = scene.name;
  cost.bodies = scene.bodies.size();
  cost.constraints = scene.constraints.size();
  cost.loads = scene.loads.size();
  cost.weights = scene.gravity.norm() > 0 ? scene.bodies.size() : 0;
  cost.ledger_terms = scene.energy_ledger ? ledger_works(scene) : 0;
  cost.springs = scene.springs.size();
  cost.moving_loads = static_cast<std::size_t>(
      std::ranges::count_if(scene.loads, [](const auto& load) { return !load.is_constant(); }));
  for (const auto& each : scene.joints) {
    const SceneJoint& joint = in_plane(each);
    if (joint.contact) {
      ++cost.contacts;
      cost.contact_seams += joint.transition ? 2 : 1;
    }
    if (!has_film(joint)) continue;
    const auto known = std::ranges::find_if(cost.films, [&](const auto& film) { return film.first == joint.film; });
    if (known == cost.films.end()) {
      cost.films.emplace_back(joint.film, 1);
    } else {
      ++known->second;
    }
  }
}

inline std::size_t nonzeros(const Eigen::MatrixXd& matrix) {
  return static_cast<std::size_t>((matrix.array() != 0).count());
}

/// Adds the right-hand side of a planar scene whose plane is turned in space, unless it has what there is only in the
/// plane.
/// @param y  (q, q̇) of the plane
void add_space(const Scene& scene, const std::vector<double>& y, SceneCost& cost, Measurement& measurement);

/// What a right-hand side and its Jacobian cost in independent coordinates: between two states that are a step apart in
/// the first coordinate, such as a millionth of a clearance, as a late Newton iteration asks for it.
template <class Small>
void add_independent_pieces(const std::shared_ptr<Small>& small, const std::vector<double>& state, double step,
                            SceneCost& cost, Measurement& measurement) {
  const auto states = std::make_shared<std::array<std::vector<double>, 2>>();
  (*states)[0] = (*states)[1] = state;
  (*states)[1][0] += step;
  const auto rate = std::make_shared<std::vector<double>>(state.size());
  const auto add = [&](const std::string& what, TimedPiece piece) {
    measurement.add(std::move(piece), [&cost, what](double time, double ratio) {
      cost.independent.push_back({what, time, ratio});
    });
  };
  add("right-hand side in independent coordinates", repeated([small, states, rate, turn = std::size_t(0)]() mutable {
        small->rate((*states)[turn = 1 - turn], *rate, 0.0);
      }));
  const auto jacobian = std::make_shared<Eigen::MatrixXd>();
  add("its exact Jacobian in them", repeated([small, states, jacobian, turn = std::size_t(0)]() mutable {
        small->jacobian((*states)[turn = 1 - turn], *jacobian, 0.0);
      }));
}

}  // namespace lubjoint::reports
