/// Equations of motion of a journal that floats on its film in a fixed bearing: no constraint, so no multipliers and no
/// linear solve.
#pragma once

#include <array>

#include "lubjoint/joint/chosen_film.hpp"

namespace lubjoint {

/// Everything about the journal but its film.
template <class R>
struct JournalDrive {
  R mass;           ///< m [kg]
  Vector2<R> load;  ///< W, all constant forces on the journal, its weight included [N]
  R bearing_spin;   ///< ω_B [rad/s]
  R journal_spin;   ///< ω_J [rad/s]: constant, since the film's force acts at the journal's centre

  /// ½(ω_J + ω_B) [rad/s].
  R mean_spin() const { return (bearing_spin + journal_spin) / 2; }
};

/// State of the free journal: ê = e/c and w = ė/c, so that a tolerance is a fraction of a clearance.
template <class T>
using JournalState = std::array<T, 4>;

/// ê̇ = w,  ẇ = (F(ê, u) + W)/(m c),  u = w − ½(ω_J + ω_B) ê⊥. Law: a FilmLaw, a CompiledLaw or ChosenLaw.
/// Source: Newton's law; Flores et al. (2009), section 7.
template <class Law, class R = double>
class FreeJournal {
 public:
  using FilmLawType = Law;  ///< the law of its film

  /// @throws std::invalid_argument if the mass is not positive and finite
  FreeJournal(const FilmOf<Law, R>& joint, const JournalDrive<R>& drive)
      : joint_(joint), drive_(drive), inertia_(drive.mass * joint.bearing().clearance()) {
    detail::require_positive("mass", drive.mass, "kg");
  }

  const FilmOf<Law, R>& joint() const { return joint_; }   ///< bearing, oil, law
  const JournalDrive<R>& drive() const { return drive_; }  ///< mass, load, spins
  const R& inertia() const { return inertia_; }            ///< m c [kg m]

  /// Film state (ê, u) of a state.
  template <class T>
  FilmState<T> film(const JournalState<T>& y) const {
    const R spin = drive_.mean_spin();
    return FilmState<T>(Vector2<T>(y[0], y[1]), Vector2<T>(T(y[2] + spin * y[1]), T(y[3] - spin * y[0])));
  }

  /// Force of the film on the journal [N].
  template <class T>
  Vector2<T> force(const JournalState<T>& y) const {
    return joint_.force(film(y));
  }

  /// Right-hand side of the equations above.
  /// @throws FilmDomainError where ε ≥ 1
  template <class T>
  void rate(const JournalState<T>& y, JournalState<T>& dydt) const {
    fill(y, joint_.force(film(y)), dydt);
  }

  /// The rate with a half film of the given side.
  template <class T>
  requires JumpingLaw<Law>
  void rate(const JournalState<T>& y, JournalState<T>& dydt, HalfFilmSide side) const {
    fill(y, joint_.force(film(y), side), dydt);
  }

 private:
  template <class T>
  void fill(const JournalState<T>& y, const Vector2<T>& force, JournalState<T>& dydt) const {
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (force.x() + drive_.load.x()) / inertia_;
    dydt[3] = (force.y() + drive_.load.y()) / inertia_;
  }

  FilmOf<Law, R> joint_;
  JournalDrive<R> drive_;
  R inertia_;
};

}  // namespace lubjoint
