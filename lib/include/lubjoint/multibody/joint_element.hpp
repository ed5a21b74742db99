/// A joint with clearance as a force element: film, dry contact, or one blended into the other.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/losses.hpp"
#include "lubjoint/joint/dry_contact.hpp"
#include "lubjoint/joint/lubricated_joint.hpp"
#include "lubjoint/joint/transition.hpp"
#include "lubjoint/multibody/planar_body.hpp"

namespace lubjoint {

namespace detail {
template <class R, class Laws>
struct FilmVariant;
template <class R, class... Law>
struct FilmVariant<R, std::tuple<Law...>> {
  using Type = std::variant<LubricatedJoint<Law, R>...>;
};
}  // namespace detail

/// Any law's film: the law is chosen when the scene is made, and costs one jump a force.
template <class R>
using AnyFilm = typename detail::FilmVariant<R, FilmLaws>::Type;

/// The film of the law of that name.
/// @throws std::invalid_argument that lists the laws there are
template <class R>
AnyFilm<R> make_film(std::string_view law, const Bearing<R>& bearing, const Lubricant<R>& oil) {
  return with_film_law(law, [&]<class Law>() { return AnyFilm<R>(LubricatedJoint<Law, R>(bearing, oil)); });
}

/// Dry contact of a joint.
template <class R>
struct JointContact {
  ContactSurface<R> surface;                          ///< stiffness and restitution
  std::optional<TransitionTolerances<R>> transition;  ///< none: a dry joint
  R min_impact_speed;                                 ///< least δ̇₀ [m/s]
};

/// The memory of a joint with contact: which piece of its force holds, and δ̇₀.
template <class R>
struct JointMemory {
  ContactPhase phase = ContactPhase::film;  ///< the piece
  R impact_speed = R(1);                    ///< δ̇₀, at which e = c was last crossed outwards [m/s]
};

/// What a joint does to its journal, film and contact apart.
template <class T>
struct JointForce {
  JointKinematics<T> kinematics;  ///< where the journal is
  Vector2<T> film;                ///< the film's share, on the journal [N]
  ContactForce<T> contact;        ///< the contact's share, on the journal

  /// Both shares together [N].
  Vector2<T> total() const { return Vector2<T>(T(film.x() + contact.force.x()), T(film.y() + contact.force.y())); }

  /// Power of a force F on the journal and −F at the same point of the bearing's body: F·v − ω_B (e × F) [W].
  T power(const Vector2<T>& force) const {
    const JournalMotion<T>& m = kinematics.motion;
    return T(dot(force, m.velocity) - m.bearing_spin * cross(m.eccentricity, force));
  }
  T film_power() const { return power(film); }  ///< of the film on both bodies [W]
  /// Of the contact on both bodies, its couple included [W].
  T contact_power() const {
    const JournalMotion<T>& m = kinematics.motion;
    return T(power(contact.force) + contact.couple * (m.journal_spin - m.bearing_spin));
  }
};

/// Shear of a joint's oil: what the film's law does not say.
template <class R>
struct JointShear {
  ShearedGap gap;      ///< that is sheared
  BearingLimit limit;  ///< of the law: has it a side flow?
  FilmExtent extent;   ///< of the law's film
  Bearing<R> bearing;  ///< of the film: with a transition, of clearance c + e₁
  R torque_scale;      ///< μR³L/c of that bearing [N m s]
};

/// What the oil of a joint with shear costs; what is undefined is not there.
template <class T>
struct JointLosses {
  T torque_journal;            ///< on the journal about its centre [N m]
  T torque_bearing;            ///< on the bearing about its centre [N m]
  T power;                     ///< lost in the film [W]
  std::optional<T> side_flow;  ///< out of both sides [m³/s]
};

/// The shear of a law in a bearing. @throws std::invalid_argument if the law has not this shear
template <class R>
JointShear<R> make_shear(std::string_view law, const Bearing<R>& bearing, const Lubricant<R>& oil, ShearExtent shear) {
  return with_film_law(law, [&]<class Law>() {
    return JointShear<R>{sheared_gap<Law>(shear), Law::limit, Law::extent, bearing, couette_scale(bearing, oil)};
  });
}

/// A joint with clearance between two bodies: a film, dry contact, or both with a transition.
template <class R>
struct JointElement {
  std::string name;                ///< in messages and results
  BodyPoint<R> bearing_at;         ///< the bearing's centre
  BodyPoint<R> journal_at;         ///< the journal's centre
  Bearing<R> bearing;              ///< its clearance is the one that is reported
  std::optional<AnyFilm<R>> film;  ///< with a transition, of clearance c + e₁
  /// None: the film alone.
  std::optional<JointContact<R>> contact;
  /// None: no friction torque. A joint with shear has a film.
  std::optional<JointShear<R>> shear = std::nullopt;

  bool has_contact() const { return contact.has_value(); }  ///< does it need events?

  /// Where the journal is, seen from the bearing.
  template <class T>
  JointKinematics<T> kinematics(const PlanarFrame<T>& bearing_body, const PlanarFrame<T>& journal_body) const {
    return joint_kinematics(bearing_body, bearing_at.point, journal_body, journal_at.point);
  }

  /// Force on the journal, of the piece that the memory names.
  /// @throws FilmDomainError where there is no film, and the phase asks for one
  template <class T>
  JointForce<T> force(const PlanarFrame<T>& bearing_body, const PlanarFrame<T>& journal_body,
                      const JointMemory<R>& memory) const {
    JointForce<T> result{
        kinematics(bearing_body, journal_body), Vector2<T>(T(0), T(0)), {Vector2<T>(T(0), T(0)), T(0)}};
    const JournalMotion<T>& motion = result.kinematics.motion;
    if (!contact) {
      result.film = film_force(motion);
      return result;
    }
    if (memory.phase == ContactPhase::film) {
      if (film) result.film = film_force(motion);
      return result;
    }
    const ContactForce<T> dry = dry_contact_force(motion, bearing, contact->surface, memory.impact_speed);
    if (memory.phase == ContactPhase::dry || !film) {
      result.contact = dry;
      return result;
    }
    // The two shares of eq. 20, kept apart: the ledger books them apart.
    const Vector2<T> zero(T(0), T(0));
    const T distance = norm(motion.eccentricity);
    const auto share = [&](const Vector2<T>& a, const Vector2<T>& b) {
      return transition_force(distance, bearing.clearance(), *contact->transition, a, b);
    };
    result.film = share(film_force(motion), zero);
    result.contact.force = share(zero, dry.force);
    result.contact.couple = (distance - bearing.clearance()) / contact->transition->e0 * dry.couple;
    return result;
  }

  /// T_J = −T_C − ½ e×F on the journal about its centre [N m], T_C and the film's force F times the film's share in
  /// the blend of eq. 20; 0 in dry contact. The bearing gets −T_J beside −F at the journal's centre, which together are
  /// T_B = T_C − ½ e×F about its own. Needs shear.
  /// @param force  of this joint, with the same memory
  template <class T>
  T shear_torque(const JointForce<T>& force, const JointMemory<R>& memory) const {
    if (contact && memory.phase == ContactPhase::dry) return T(0);
    const JournalMotion<T>& motion = force.kinematics.motion;
    const T rate = shear->torque_scale * couette_integral(sheared_film(motion), shear->gap);
    T couette = rate * (motion.journal_spin - motion.bearing_spin);
    if (contact && memory.phase == ContactPhase::blend) {
      couette = couette * (1 - (norm(motion.eccentricity) - bearing.clearance()) / contact->transition->e0);
    }
    return T(-couette - cross(motion.eccentricity, force.film) / 2);
  }

  /// Torques, power and side flow of a joint with shear; nothing in dry contact, and no side flow in the blend.
  template <class T>
  std::optional<JointLosses<T>> losses(const JointForce<T>& force, const JointMemory<R>& memory) const {
    if (!shear || (contact && memory.phase == ContactPhase::dry)) return std::nullopt;
    const JournalMotion<T>& motion = force.kinematics.motion;
    const T on_journal = shear_torque(force, memory);
    JointLosses<T> result{on_journal, T(-on_journal - cross(motion.eccentricity, force.film)),
                          T(-force.film_power() - on_journal * (motion.journal_spin - motion.bearing_spin)),
                          std::nullopt};
    if (contact && memory.phase == ContactPhase::blend) return result;
    result.side_flow = side_flow(shear->bearing, sheared_film(motion), shear->limit, shear->extent);
    return result;
  }

 private:
  /// Of a motion whose film has just been asked for its force, and looked at there.
  template <class T>
  FilmState<T> sheared_film(const JournalMotion<T>& motion) const {
    const R& clearance = shear->bearing.clearance();
    const Vector2<T> e_hat = eccentricity_in_clearances(motion, clearance);
    return FilmState<T>(e_hat, pure_squeeze_velocity(motion, clearance, e_hat),
                        one_minus_squared_norm<T>(e_hat.x(), e_hat.y()), Unchecked());
  }

  template <class T>
  Vector2<T> film_force(const JournalMotion<T>& motion) const {
    return std::visit([&](const auto& law) { return law.force(film_state(motion, law.bearing().clearance())); }, *film);
  }
};

}  // namespace lubjoint
