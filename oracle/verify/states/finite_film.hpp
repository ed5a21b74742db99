/// Judging programs for the film of the bearing's real length: against the solver, to the error that it states.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oracle/reynolds/finite_force.hpp"
#include "oracle/verify/states/answers.hpp"
#include "oracle/verify/states/quantity.hpp"
#include "oracle/verify/verification.hpp"

namespace lubjoint::verify {

/// What a program claims to compute.
struct FiniteClaim {
  oracle::FiniteFilm film;
  oracle::FilmOnset onset = oracle::FilmOnset::free;  ///< of finite_reynolds
  std::string words() const;                          ///< "finite_reynolds, free onset"
};

/// An error over |F| that is right unless another one is asked for: programs of this kind are numerical.
inline constexpr double finite_tolerance = 1e-3;

/// The states that a program of finite length is asked about: bearings of L/D ¼, ½, 1 and 2, ε from 0.1 to 0.9 in all
/// directions, each with steady rotation of either sign, closing and opening squeeze alone, and both with rotation.
/// @param quantities  cartesian or polar
/// @throws std::invalid_argument for other quantities
std::vector<State> finite_states(Quantities quantities);

/// How one answer came out.
struct FiniteComparison {
  Vector2<double> expected;  ///< in the answer's components [N]
  double bound = 0;          ///< of the error of `expected`, over its size
  double error = 0;          ///< of the answer over |F|; infinite where it is not a number
  Outcome outcome = Outcome::undecided;
};

struct FiniteVerification {
  FiniteClaim claim;
  Quantities quantities = Quantities::cartesian;
  double tolerance = finite_tolerance;  ///< over |F|, to which the solver's bound is added
  std::vector<State> states;
  Answers answers;
  std::vector<FiniteComparison> comparisons;
  Verdict verdict = Verdict::undecided;
  std::optional<double> factor;      ///< all answers are so many times the right ones
  std::optional<FiniteClaim> other;  ///< all answers are right for another film

  std::size_t count(Outcome outcome) const;
  double worst_error() const;  ///< of the numbers that are decided
  bool accepted() const { return verdict == Verdict::agrees; }
};

/// Judges answers. A state is undecided where the solver's own bound is above the tolerance, and left out where it lies
/// on the jump of finite_half, at a = 0. If answers are wrong, it is tried whether one factor makes all of them right,
/// and whether another film does.
/// @param tolerance  error over |F| that is right; 0: finite_tolerance
/// @param threads  no result depends on them
FiniteVerification verify_finite_film(const FiniteClaim& claim, Quantities quantities, std::vector<State> states,
                                      Answers answers, double tolerance, unsigned threads);

std::string text_report(const FiniteVerification& verification);
nlohmann::ordered_json json_report(const FiniteVerification& verification);

}  // namespace lubjoint::verify
