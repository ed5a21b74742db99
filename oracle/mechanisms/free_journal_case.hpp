/// What a free journal is given, and what its run leaves.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "oracle/mechanisms/journal_films.hpp"

namespace lubjoint::mechanisms {

/// The wall of the bearing: what happens beyond |e| = c.
template <class R>
struct BearingWall {
  R stiffness;            ///< K [N/m^{3/2}]
  R restitution;          ///< c_r
  R min_impact_speed;     ///< least δ̇₀ [m/s]
  R blend;                ///< e₀ [m]
  R widening;             ///< e₁: the film's clearance is c + e₁ [m]
  R friction = R(0);      ///< Coulomb's coefficient
  R slow_sliding = R(1);  ///< s₀, sliding speed below which friction fades [m/s]
};

/// Young's modulus [Pa] and Poisson's ratio of a surface.
template <class R>
struct WallElasticity {
  R modulus;
  R poisson;
};

/// Hertz's stiffness of a sphere of radius R_J in a spherical seat of R_J + c: K = (4/3) E* √R*, with
/// 1/R* = 1/R_J − 1/(R_J + c) and 1/E* the sum of (1 − ν²)/E [N/m^{3/2}].
template <class R>
R seat_stiffness(const R& journal_radius, const R& clearance, const WallElasticity<R>& bearing,
                 const WallElasticity<R>& journal) {
  using std::sqrt;
  const R curvature = 1 / journal_radius - 1 / (journal_radius + clearance);
  const R compliance = (1 - bearing.poisson * bearing.poisson) / bearing.modulus +
                       (1 - journal.poisson * journal.poisson) / journal.modulus;
  return 4 / (3 * compliance * sqrt(curvature));
}

/// Everything about a journal but its film's law.
template <class R>
struct FreeJournalCase {
  R length;                                      ///< L [m]
  R journal_radius;                              ///< [m]
  R clearance;                                   ///< c [m]
  R viscosity;                                   ///< [Pa s]
  R mass;                                        ///< [kg]
  std::array<R, 2> load = {R(0), R(0)};          ///< all constant forces, the weight among them [N]
  std::array<R, 2> eccentricity = {R(0), R(0)};  ///< e/c at the start
  std::array<R, 2> velocity = {R(0), R(0)};      ///< of e at the start, over c, inertial [1/s]
  R spin = R(0);                                 ///< of the journal at the start [rad/s]
  R spin_acceleration = R(0);                    ///< prescribed [rad/s²]
  std::optional<BearingWall<R>> wall = {};       ///< none: the film alone, ε < 1
  /// About the mass centre [kg m²]. Above 0 the spin is not prescribed: friction at the wall changes it.
  R inertia = R(0);
};

/// One smooth piece of the motion.
struct JournalPiece {
  enum class Where { film, blend, dry };
  Where where = Where::film;
  FilmBranch film;
  bool slides = false;  ///< a half film on a = 0
  bool touches = true;  ///< beyond the film: the contact pushes; false where it would have to pull

  bool operator==(const JournalPiece& o) const {
    return where == o.where && film.side == o.film.side && film.squeeze == o.film.squeeze && slides == o.slides &&
           touches == o.touches;
  }
};

/// The journal at one time, inertial.
template <class R>
struct FreeJournalSample {
  R t;
  std::array<R, 2> eccentricity;  ///< e/c
  std::array<R, 2> velocity;      ///< ė/c [1/s]
  std::array<R, 2> force;         ///< of film and contact on the journal [N]
  R spin;                         ///< ω_J [rad/s]
  JournalPiece piece;             ///< in which it is
};

/// The begin of a piece.
template <class R>
struct JournalChange {
  R t;
  JournalPiece piece;
};

template <class R>
struct FreeJournalRun {
  std::vector<FreeJournalSample<R>> samples;  ///< at the times asked for, or fewer if it stopped
  std::vector<JournalChange<R>> changes;      ///< of piece, the first at the start
  R sliding_time = R(0);                      ///< spent on a = 0 [s]
  std::size_t steps = 0;
  std::string stopped;  ///< why it did not reach the last time; empty if it did
};

}  // namespace lubjoint::mechanisms
