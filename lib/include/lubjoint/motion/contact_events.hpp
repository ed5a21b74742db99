/// Where joints with contact change from one piece of their force to the next.
#pragma once

#include <algorithm>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/multibody_results.hpp"

namespace lubjoint {

namespace detail {

/// Distance from the near and the far seam of a joint's phase, in clearances; positive inside. Without a transition
/// there is one seam, |e| = c.
template <class R>
struct SeamMargins {
  R inner;  ///< falls below 0 when the journal goes inwards
  R outer;  ///< falls below 0 when it goes outwards
};

template <class R>
SeamMargins<R> seam_margins(const JointElement<R>& joint, ContactPhase phase, const Vector2<R>& eccentricity) {
  using std::sqrt;
  const R far(1);  // no seam on that side
  const R c = joint.bearing.clearance();
  const R over = (sqrt(R(eccentricity.x() * eccentricity.x() + eccentricity.y() * eccentricity.y())) - c) / c;
  if (phase == ContactPhase::film) return {far, R(-over)};
  if (!joint.contact->transition) return {over, far};
  const R width = joint.contact->transition->e0 / c;
  if (phase == ContactPhase::dry) return {R(over - width), far};
  return {over, R(width - over)};
}

/// The phase on the other side of a seam.
template <class R>
ContactPhase next_phase(const JointElement<R>& joint, ContactPhase phase, bool outwards) {
  const bool blends = joint.contact->transition.has_value();
  switch (phase) {
    case ContactPhase::film:
      return blends ? ContactPhase::blend : ContactPhase::dry;
    case ContactPhase::blend:
      return outwards ? ContactPhase::dry : ContactPhase::film;
    case ContactPhase::dry:
      break;
  }
  return blends ? ContactPhase::blend : ContactPhase::film;
}

/// Memory of a joint at the start of a run.
template <class R>
JointMemory<R> starting_memory(const JointElement<R>& joint, const JournalMotion<R>& motion) {
  if (!joint.contact) return {};
  const R distance = motion.eccentricity.norm();
  const R c = joint.bearing.clearance();
  ContactPhase phase = ContactPhase::film;
  if (joint.contact->transition) {
    phase = contact_phase(distance, c, *joint.contact->transition);
  } else if (distance > c) {
    phase = ContactPhase::dry;
  }
  JointMemory<R> memory;
  memory.phase = phase;
  memory.impact_speed = joint.contact->min_impact_speed;
  return memory;
}

/// The joint's memory once it has crossed into another phase. A journal that leaves the film hits the wall: its speed
/// there is the impact's until it is back in the film.
/// @param normal_speed  v·r at the crossing [m/s]
template <class R>
void enter_phase(const JointElement<R>& joint, JointMemory<R>& memory, ContactPhase to, const R& normal_speed) {
  if (memory.phase == ContactPhase::film) {
    memory.impact_speed = std::max<R>(normal_speed, joint.contact->min_impact_speed);
  }
  memory.phase = to;
}

/// v·r [m/s].
template <class R>
R normal_speed(const JournalMotion<R>& motion) {
  return dot(motion.velocity, direction(motion.eccentricity));
}

}  // namespace detail

}  // namespace lubjoint
