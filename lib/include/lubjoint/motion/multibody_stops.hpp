/// Why a multibody run could not go on, and what to change.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/stop_words.hpp"
#include "lubjoint/run/outcome.hpp"

namespace lubjoint::detail {

/// A tolerance wider than the blend of film and contact says nothing of the share that the contact has, and so of how a
/// journal within a tolerance of its wall comes back; empty if it is not, or the journal is further off.
template <class R>
std::string unresolved_contact_reason(MultibodyOde<R>& ode, const R& t, const std::vector<R>& y, double tolerance) {
  const std::vector<JointElement<R>>& joints = ode.system().joints();
  const auto unresolved = [&](const JointElement<R>& joint) {
    return joint.contact && joint.contact->transition &&
           R(tolerance) * joint.bearing.clearance() > joint.contact->transition->e0;
  };
  if (std::none_of(joints.begin(), joints.end(), unresolved)) return {};
  ode.system().evaluate_kinematics(t, y.data(), ode.workspace());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const R& c = joints[j].bearing.clearance();
    const R distance = norm(ode.system().journal_motion(j, ode.workspace()).eccentricity);
    if (!unresolved(joints[j]) || distance < (1 - R(tolerance)) * c) continue;
    return "joint \"" + joints[j].name + "\" meets its wall, and the absolute_tolerance of " + number(tolerance) +
           " clearances is wider than the blend of film and contact, e0/c = " +
           number(static_cast<double>(joints[j].contact->transition->e0 / c)) +
           ": the contact would be chance; use a tolerance of at most a tenth of e0/c";
  }
  return {};
}

/// The joint nearest to its wall.
struct NearestJoint {
  bool found = false;
  double gap = 1;     ///< 1 − |ê|
  std::string words;  ///< which, and how near
};

template <class R>
NearestJoint nearest_joint(MultibodyOde<R>& ode, const R& t, const std::vector<R>& y) {
  const std::vector<JointElement<R>>& joints = ode.system().joints();
  ode.system().evaluate_kinematics(t, y.data(), ode.workspace());
  NearestJoint nearest;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Vector2<R> e = ode.system().journal_motion(j, ode.workspace()).eccentricity;
    const R& c = joints[j].bearing.clearance();
    const Vector2<double> ratio(static_cast<double>(e.x() / c), static_cast<double>(e.y() / c));
    const double gap = film_gap(ratio);
    if (nearest.found && !(gap < nearest.gap)) continue;
    nearest = {true, gap,
               "joint \"" + joints[j].name + "\" is at eccentricity ratio " + eccentricity_words(ratio) + "; "};
  }
  return nearest;
}

/// @param implicit  was it an implicit integrator?
template <class R>
std::string step_limit_reason(MultibodyOde<R>& ode, const R& t, const std::vector<R>& y, std::size_t limit,
                              bool implicit) {
  const NearestJoint nearest = nearest_joint(ode, t, y);
  return nearest.words + step_limit_words(limit, implicit, nearest.gap);
}

/// @param implicit  was it an implicit integrator?
template <class R>
std::string stall_reason(MultibodyOde<R>& ode, const R& t, const std::vector<R>& y, bool implicit) {
  const NearestJoint nearest = nearest_joint(ode, t, y);
  return nearest.words + stall_words() + remedy_words(implicit, nearest.gap);
}

template <class R>
std::string no_step_reason(MultibodyOde<R>& ode, const R& t, const std::vector<R>& y) {
  const NearestJoint nearest = nearest_joint(ode, t, y);
  const std::string reason = nearest.words + "no step, however short, gives a finite state; ";
  if (!nearest.found) return reason + "use a looser relative_tolerance, or lower the loads and speeds";
  return reason + "raise the viscosity, lower the load or the clearance, or give the joint a transition to contact";
}

}  // namespace lubjoint::detail
