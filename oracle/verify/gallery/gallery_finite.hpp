/// Mistakes that people make when they solve Reynolds' equation for a bearing's real length.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/reynolds/finite_force.hpp"
#include "oracle/verify/states/quantity.hpp"

namespace lubjoint::verify {

/// What a program claims to compute.
struct FiniteClaim {
  oracle::FiniteFilm film;
  oracle::FilmOnset onset = oracle::FilmOnset::free;  ///< of finite_reynolds
  std::string words() const;                          ///< "finite_reynolds, free onset"
};

/// A program at work on one state. It reads its inputs, makes rates of them, and solves an equation.
struct FiniteWork {
  FiniteClaim claim;
  Quantities quantities;
  double viscosity, length, radius, clearance;
  double omega_bearing, omega_journal;  ///< of Cartesian states
  Vector2<double> e, v;                 ///< likewise
  double epsilon;                       ///< ε, of polar states read and of others made
  double wedge;                         ///< the spins' part of a
  double whirl;                         ///< that of the line of centres
  double squeeze;                       ///< b
  Vector2<double> radial{1, 0};         ///< in the answer's axes
  double shape = 0;                     ///< L/D in the equation
  double factor = 1;                    ///< of the force
  bool clipped = false;                 ///< the full film without its negative pressure, in place of the film
  bool mirrored = true;                 ///< the half film, for a < 0
  bool clockwise = false;               ///< the tangential direction
};

/// One mistake: what it does after each step of the work; null: nothing.
struct FiniteMistake {
  std::string_view name;
  std::string_view description;  ///< what was done
  std::string_view symptom;      ///< how it shows
  bool (*applies)(const FiniteClaim&, Quantities);
  void (*to_inputs)(FiniteWork&);
  void (*to_rates)(FiniteWork&);
  void (*to_equation)(FiniteWork&);
};

/// All of them, in the order in which they are looked for.
const std::vector<FiniteMistake>& finite_gallery();

/// A force in the answer's components, and a bound of its error over its size.
struct FiniteAnswer {
  Vector2<double> force;  ///< [N]
  double bound = 0;
};

/// The answer of a program that makes these mistakes, by the solver; with none, the right one.
/// @param tolerance  asked of the solver
/// @returns nothing where the program finds the journal outside of its bearing
std::optional<FiniteAnswer> finite_answer(const FiniteClaim& claim, Quantities quantities, const State& state,
                                          const std::vector<const FiniteMistake*>& mistakes,
                                          const oracle::FiniteLengthOptions& options);

/// A state's motion in the journal's own frame, as a right program finds it.
struct PolarMotion {
  double ratio;            ///< ε
  double slip;             ///< a [1/s]
  double squeeze;          ///< b [1/s]
  double whirl;            ///< the part of a that comes from the line of centres [1/s]
  bool turns;              ///< is there a wedge, and the bearing at rest?
  Vector2<double> radial;  ///< in the answer's axes
};
PolarMotion polar_motion(Quantities quantities, const State& state);

/// Is a state of a half film on its jump, at a = 0, so that rounding decides which side is meant?
bool is_on_finite_jump(const FiniteClaim& claim, Quantities quantities, const State& state);

/// The gallery for people: a list, or a table in Markdown.
std::string described_finite_gallery();
std::string finite_gallery_markdown();

}  // namespace lubjoint::verify
