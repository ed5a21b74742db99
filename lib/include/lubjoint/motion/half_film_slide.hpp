/// A half film between moving bodies whose journal slides on a = 0.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"

namespace lubjoint::detail {

/// Does this joint's force jump where a changes sign?
template <class R>
bool has_half_film(const JointElement<R>& joint) {
  const auto is_polar = []<class Law>(const LubricatedJoint<Law, R>&) { return PolarLaw<Law>; };
  return joint.film && std::visit(is_polar, *joint.film);
}

/// Slip velocity of a journal across its line of centres, u_t = (e × v)/|e| − ω̄|e| [m/s]; a = −2u_t/c. e ≠ 0.
template <class R>
R slip_velocity(const JournalMotion<R>& motion) {
  const R distance = norm(motion.eccentricity);
  return cross(motion.eccentricity, motion.velocity) / distance -
         (motion.bearing_spin + motion.journal_spin) / 2 * distance;
}

/// Is the journal on a = 0 to rounding?
template <class R>
bool is_on_jump(const JournalMotion<R>& motion) {
  using std::abs;
  const R speed = norm(motion.velocity) + abs(motion.bearing_spin + motion.journal_spin) * norm(motion.eccentricity);
  return abs(slip_velocity(motion)) <= 1e4 * std::numeric_limits<R>::epsilon() * speed;  // places 1e3 clearances long
}

/// States just beyond either side of the jump, and the share of the first.
template <class R>
struct HalfFilmSlide {
  std::vector<R> up;    ///< u_t > 0
  std::vector<R> down;  ///< u_t < 0
  R share;              ///< λ, of the forces at `up`
};

/// Where the forces on both sides drive u_t back to 0 the journal stays there (Filippov), under
///   F = λF₊ + (1 − λ)F₋,   λ = r₋/(r₋ − r₊),   r± = u̇_t just beyond either side,   r₊ < 0 < r₋.
/// A method that steps across the jump back and forth has that force in the mean, and at any instant one side's.
/// r± is a central difference over so short a time that the journal moves by 1e-5 of its eccentricity: its own error is
/// the square of that.
/// @param step_length  of the steps at the jump [s]: the journal slides if its side takes it back to u_t = 0 within
///   three of these
/// @return none if it does not slide
template <class R>
std::optional<HalfFilmSlide<R>> half_film_slide(MultibodyOde<R>& ode, const R& t, const std::vector<R>& y,
                                                const std::vector<JointMemory<R>>& memory, std::size_t j,
                                                const R& step_length) {
  using std::abs;
  const PlanarSystem<R>& system = ode.system();
  const JointElement<R>& joint = system.joints()[j];
  if (!has_half_film(joint) || !(step_length > 0)) return std::nullopt;
  if (!memory.empty() && memory[j].phase == ContactPhase::dry) return std::nullopt;
  const auto motion_at = [&](const R& time, const std::vector<R>& state) {
    system.evaluate_kinematics(time, state.data(), ode.workspace());
    return system.journal_motion(j, ode.workspace());
  };
  const JournalMotion<R> motion = motion_at(t, y);
  const R distance = norm(motion.eccentricity);
  if (!(distance > 0)) return std::nullopt;
  const R slip = slip_velocity(motion);
  const R speed = norm(motion.velocity) + abs(motion.bearing_spin + motion.journal_spin) * distance;
  if (!(speed > 0)) return std::nullopt;
  constexpr double beyond = 1e-8;  // of the speed: so small a change of the forces, and far above rounding
  // The velocity across moves one body: the constraints' forces change by as little.
  const bool moves_journal = joint.journal_at.body != ground_body;
  const std::size_t first = system.coordinates() + 3 * (moves_journal ? joint.journal_at.body : joint.bearing_at.body);
  const R lead = R(1e-5) * distance / speed;
  const auto state_with = [&](const R& wanted) {
    const R by = (moves_journal ? wanted - slip : slip - wanted) / distance;
    std::vector<R> state = y;
    state[first] -= by * motion.eccentricity.y();
    state[first + 1] += by * motion.eccentricity.x();
    return state;
  };
  const auto slip_rate = [&](const std::vector<R>& state) {
    const std::vector<R> accelerations = ode.at(t, state, memory).accelerations;
    const std::size_t n = system.coordinates();
    std::vector<R> ahead = state;
    std::vector<R> behind = state;
    for (std::size_t i = 0; i < n; ++i) {
      ahead[i] += lead * state[n + i];
      ahead[n + i] += lead * accelerations[i];
      behind[i] -= lead * state[n + i];
      behind[n + i] -= lead * accelerations[i];
    }
    return R((slip_velocity(motion_at(t + lead, ahead)) - slip_velocity(motion_at(t - lead, behind))) / (2 * lead));
  };
  HalfFilmSlide<R> slide{state_with(R(beyond * speed)), state_with(R(-beyond * speed)), R(0)};
  const R up = slip_rate(slide.up);
  const R down = slip_rate(slide.down);
  if (!(up < 0 && down > 0)) return std::nullopt;
  const R back = slip > 0 ? R(-up) : down;
  if (!(abs(slip) <= 3 * step_length * back)) return std::nullopt;
  slide.share = down / (down - up);
  return slide;
}

}  // namespace lubjoint::detail
