/// A joint with clearance as a force element: film, dry contact, or one blended into the other.
#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>

#include "lubjoint/film/losses.hpp"
#include "lubjoint/joint/chosen_film.hpp"
#include "lubjoint/joint/dry_contact.hpp"
#include "lubjoint/joint/transition.hpp"
#include "lubjoint/multibody/planar_body.hpp"

namespace lubjoint {

namespace detail {
template <class R, class Laws>
struct FilmVariant;
template <class R, class... Law>
struct FilmVariant<R, std::tuple<Law...>> {
  using Type = std::variant<LubricatedJoint<Law, R>..., LubricatedJoint<FiniteHalf, R>, ChosenFilm<R>>;
};
}  // namespace detail

/// Any law's film: the law is chosen when the scene is made, and costs one jump a force; laws that are not of
/// law_list.hpp and do not jump share the last of the films.
template <class R>
using AnyFilm = typename detail::FilmVariant<R, FilmLaws>::Type;

/// The film of the law of that name.
/// @param table  of a law that is compiled; no other law asks
/// @throws std::invalid_argument that lists the laws there are, or as ChosenFilm
template <class R>
AnyFilm<R> make_film(std::string_view law, const Bearing<R>& bearing, const Lubricant<R>& oil,
                     const CompiledFilm* table = nullptr) {
  return with_film_law<NamedFilmLaws>(
      law, [&]<class Law>() { return AnyFilm<R>(film_of<RunLaw<Law>, R>(law, bearing, oil, table)); });
}

/// Dry contact of a joint.
template <class R>
struct JointContact {
  ContactSurface<R> surface;                          ///< stiffness and restitution
  std::optional<TransitionTolerances<R>> transition;  ///< none: a dry joint
  R min_impact_speed;                                 ///< least δ̇₀ [m/s]
};

/// Which side of its jump at a = 0 a half film is on.
enum class FilmSide {
  of_slip,     ///< whatever the sign of a says: a state by itself, and a law without a jump
  converging,  ///< a > 0, continued smoothly beyond a = 0
  mirrored,    ///< a < 0, likewise
  sliding      ///< a = 0, by a tangential force inside the jump (Filippov)
};

/// The memory of a joint: which piece of its force holds, and what that piece needs to know.
template <class R>
struct JointMemory {
  ContactPhase phase = ContactPhase::film;  ///< of film and contact
  R impact_speed = R(1);                    ///< δ̇₀, at which e = c was last crossed outwards [m/s]
  FilmSide side = FilmSide::of_slip;        ///< of a half film
  Vector2<R> line{R(1), R(0)};              ///< n of a journal that slides, where ½(φ_i + φ_j) = line_angle
  R line_angle{0};                          ///< [rad]
};

/// A journal on the line along which it slides. a = 0 is e × u = 0 with u = ė − ω̄ e⊥: in the frame that turns with the
/// mean spin ω̄ = ½(ω_i + ω_j) the journal moves along its line of centres, which so is fixed in that frame. As ω̄ is the
/// rate of ½(φ_i + φ_j), the line's direction n is a function of the coordinates, and a = 0 a constraint on places:
///   n⊥·e = 0,   n = A(½(φ_i + φ_j) − line_angle) line;
/// no division by |e|, so that a slide may begin at the centre.
template <class T>
struct SlidePlace {
  Vector2<T> line;  ///< n
  T along;          ///< n·e [m]
  T across;         ///< n⊥·e, 0 but for drift [m]
  T rate;           ///< n·(ė − ω̄ e⊥) [m/s]
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
  bool squeeze_only;   ///< does the law leave the wedge out?
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
  return with_film_law<NamedFilmLaws>(law, [&]<class Law>() {
    return JointShear<R>{sheared_gap<Law>(shear), Law::limit, Law::extent,
                         SqueezeOnlyLaw<Law>,     bearing,    couette_scale(bearing, oil)};
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

  bool has_contact() const { return contact.has_value(); }  ///< may it touch?

  /// Does its force jump where a changes sign?
  bool has_half_film() const {
    const auto jumps = []<class Film>(const Film&) { return Film::jumps; };
    return film && std::visit(jumps, *film);
  }

  /// Is its force at most once differentiable where ε̇ changes sign?
  bool kinks() const {
    return film && std::visit([](const auto& of_law) { return of_law.kinks(); }, *film);
  }

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
    return force_at(kinematics(bearing_body, journal_body), bearing_body, journal_body, memory);
  }

  /// The same where the journal's motion is known better than the difference of the bodies' positions says.
  /// @param known  the force there, its kinematics apart, of whoever has it already; or nullptr
  template <class T>
  JointForce<T> force_at(const JointKinematics<T>& at, const PlanarFrame<T>& bearing_body,
                         const PlanarFrame<T>& journal_body, const JointMemory<R>& memory,
                         const JointForce<T>* known = nullptr) const {
    if (known != nullptr) return {at, known->film, known->contact};
    JointForce<T> result{at, Vector2<T>(T(0), T(0)), {Vector2<T>(T(0), T(0)), T(0)}};
    const JournalMotion<T>& motion = result.kinematics.motion;
    add_forces(motion, memory, result, [&] {
      if (memory.side != FilmSide::sliding) return film_force(motion, memory.side);
      const SlidePlace<T> place = slide_place(bearing_body, journal_body, motion, memory);
      const T along = jump_force(place).along;
      return Vector2<T>(T(along * place.line.x()), T(along * place.line.y()));
    });
    return result;
  }

  /// Force on the journal, which does not slide on its film's jump, from its motion alone.
  template <class T>
  JointForce<T> force_in_motion(const JournalMotion<T>& motion, const JointMemory<R>& memory) const {
    const Vector2<T> none(T(0), T(0));
    JointForce<T> result{{none, none, motion}, none, {none, T(0)}};
    add_forces(motion, memory, result, [&] { return film_force(motion, memory.side); });
    return result;
  }

  /// The journal seen along the line that its memory names.
  template <class T>
  SlidePlace<T> slide_place(const PlanarFrame<T>& bearing_body, const PlanarFrame<T>& journal_body,
                            const JournalMotion<T>& motion, const JointMemory<R>& memory) const {
    using std::cos;
    using std::sin;
    const T turned = (bearing_body.angle + journal_body.angle) / 2 - memory.line_angle;
    const T c = cos(turned);
    const T s = sin(turned);
    const Vector2<T> n(T(c * memory.line.x() - s * memory.line.y()), T(s * memory.line.x() + c * memory.line.y()));
    const T across = cross(n, motion.eccentricity);
    const T mean_spin = (motion.bearing_spin + motion.journal_spin) / 2;
    return {n, dot(n, motion.eccentricity), across, T(dot(n, motion.velocity) + mean_spin * across)};
  }

  /// What the half film of a journal that slides does, film alone. Needs a half film.
  /// @throws FilmDomainError where there is no film
  template <class T>
  JumpForce<T> jump_force(const SlidePlace<T>& place) const {
    return std::visit(
        [&]<class Film>(const Film& law) -> JumpForce<T> {
          if constexpr (Film::jumps) {
            const R& clearance = law.bearing().clearance();
            return law.on_jump(T(place.along / clearance), T(place.rate / clearance));
          } else {
            throw std::logic_error("a law without a jump has no journal that slides on it");
          }
        },
        *film);
  }

  /// The film's share in the force of a phase in which it has one: 1, or less in the blend of eq. 20.
  template <class T>
  T film_share(const JournalMotion<T>& motion, const JointMemory<R>& memory) const {
    return contact && memory.phase == ContactPhase::blend ? shares_at(motion).film : T(1);
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
    if (contact && memory.phase == ContactPhase::blend) couette = couette * shares_at(motion).film;
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
  /// The two parts of a joint's force, the film's by of_film().
  template <class T, class OfFilm>
  void add_forces(const JournalMotion<T>& motion, const JointMemory<R>& memory, JointForce<T>& result,
                  const OfFilm& of_film) const {
    if (!contact) {
      result.film = of_film();
      return;
    }
    if (memory.phase == ContactPhase::film) {
      if (film) result.film = of_film();
      return;
    }
    const ContactForce<T> dry = dry_contact_force(motion, bearing, contact->surface, memory.impact_speed);
    if (memory.phase == ContactPhase::dry || !film) {
      result.contact = dry;
      return;
    }
    // The two parts of eq. 20, kept apart: the ledger books them apart.
    const TransitionShares<T> share = shares_at(motion);
    const Vector2<T> oil = of_film();
    result.film = Vector2<T>(T(share.film * oil.x()), T(share.film * oil.y()));
    result.contact.force = Vector2<T>(T(share.contact * dry.force.x()), T(share.contact * dry.force.y()));
    result.contact.couple = share.contact * dry.couple;
  }

  /// Of a motion whose film has just been asked for its force, and looked at there.
  template <class T>
  FilmState<T> sheared_film(const JournalMotion<T>& motion) const {
    const R& clearance = shear->bearing.clearance();
    const Vector2<T> e_hat = eccentricity_in_clearances(motion, clearance);
    const FilmState<T> state(e_hat, pure_squeeze_velocity(motion, clearance, e_hat),
                             one_minus_squared_norm<T>(e_hat.x(), e_hat.y()), Unchecked());
    return shear->squeeze_only ? without_wedge(state) : state;
  }

  template <class T>
  TransitionShares<T> shares_at(const JournalMotion<T>& motion) const {
    return transition_shares<T>(norm(motion.eccentricity), bearing.clearance(), *contact->transition);
  }

  /// @param side  of_slip, converging or mirrored
  template <class T>
  Vector2<T> film_force(const JournalMotion<T>& motion, FilmSide side) const {
    return std::visit(
        [&]<class Film>(const Film& law) {
          const FilmState<T> state = film_state(motion, law.bearing().clearance());
          if constexpr (Film::jumps) {
            if (side != FilmSide::of_slip) {
              return law.force(state, side == FilmSide::converging ? HalfFilmSide::converging : HalfFilmSide::mirrored);
            }
          }
          return law.force(state);
        },
        *film);
  }
};

}  // namespace lubjoint
