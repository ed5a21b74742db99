/// Journals in space that slide on the jump of their half film.
#pragma once

#include <vector>

#include "lubjoint/multibody/spatial/chart_functions.hpp"
#include "lubjoint/multibody/spatial/system_workspace.hpp"
#include "lubjoint/multibody/spatial/turn.hpp"

namespace lubjoint {

namespace detail {

/// Rows n⊥·e = 0 of the journals that slide, from the frames, and what their forces act on. n turns in the bearing's
/// frame by half of θ, the turn of journal against bearing about the bearing's axis. With e = (e₁, e₂) by t₁ and t₂:
///   Φ̇ = n⊥·ė − ½θ̇ n·e,   Φ̈ = n⊥·ë − ½θ̈ n·e − θ̇ n·ė − ¼θ̇² n⊥·e.
/// a = 0 asks for half of ω = n_B·(ω_J − ω_B) in place of half of θ̇: they are one where the axes are parallel, and a
/// tilt ψ puts ψ² of the turn between them, which no function of places could do without.
/// @param turn_of_joint  turn_of_joint(j) is θ and θ̇ of joint j, counted through revolutions
template <class System, class T, class TurnOf>
void evaluate_slides(const System& system, const std::vector<JointMemory<RealOf<T>>>& memory,
                     const TurnOf& turn_of_joint, SpatialWorkspace<T>& w) {
  for (auto& slide : w.slides) {
    const auto& joint = system.joints()[slide.joint];
    const SpatialFrame<T>& body_i = system.frame(joint.bearing_at.body, w);
    const SpatialFrame<T>& body_j = system.frame(joint.journal_at.body, w);
    const SpatialJointKinematics<T> k = joint.kinematics(body_i, body_j);
    const AngleMotion<T> turn = turn_of_joint(slide.joint);
    slide.place = joint.plane.slide_place(PlanarFrame<T>(ground_motion<T>()), turned_journal(k.motion, turn.angle),
                                          k.motion, memory[slide.joint]);
    const SlidePlace<T>& at = slide.place;
    const Vector2<T> across = perpendicular(at.line);
    std::array<SpatialRow<T>, 2> of_e{};
    SpatialRow<T> of_turn{};
    fill_eccentricity(body_i, body_j, k, of_e);
    fill_turn_between(joint.bearing_at, joint.journal_at, body_i, body_j, of_turn);
    const T half = at.along / 2;
    slide.row.value = at.across;
    slide.row.time_rate = T(0);
    slide.row.gamma = across.x() * of_e[0].gamma + across.y() * of_e[1].gamma - half * of_turn.gamma +
                      turn.rate * dot(at.line, k.motion.velocity) + turn.rate * turn.rate / 4 * at.across;
    for (std::size_t c = 0; c < 6; ++c) {
      slide.row.first[c] = across.x() * of_e[0].first[c] + across.y() * of_e[1].first[c] - half * of_turn.first[c];
      slide.row.second[c] = across.x() * of_e[0].second[c] + across.y() * of_e[1].second[c] - half * of_turn.second[c];
    }
    SpatialJointForce<T> unit{k, {}, joint.plane.shear ? T(-half) : T(0)};
    unit.plane.film = across;
    unit.plane.contact = {Vector2<T>(T(0), T(0)), T(0)};
    const auto put = [](const SpatialFrame<T>& body, const SpatialWrench<T>& wrench) {
      return columns(wrench.force, in_body(body, wrench.moment));
    };
    slide.on_bearing = put(body_i, unit.on_bearing());
    slide.on_journal = put(body_j, unit.on_journal());
  }
}

}  // namespace detail

}  // namespace lubjoint
