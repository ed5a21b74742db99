/// Judging programs for the film of the bearing's real length: against the solver, to the error that it states.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/gallery/gallery_finite.hpp"
#include "oracle/verify/states/answers.hpp"
#include "oracle/verify/states/quantity.hpp"
#include "oracle/verify/verification.hpp"

namespace lubjoint::verify {

/// An error over |F| that is right unless another one is asked for: programs of this kind are numerical.
inline constexpr double finite_tolerance = 1e-3;

/// L/D of the states' bearings.
inline constexpr std::array finite_shapes = {0.25, 0.5, 1.0, 2.0};

/// ε of the states of a motion, so many of each shape; the innermost of motions changes fastest, then these, then
/// shapes.
inline constexpr std::array finite_ratios = {0.1, 0.3, 0.5, 0.7, 0.9};

/// The states that a program of finite length is asked about: bearings of L/D ¼, ½, 1 and 2, ε from 0.1 to 0.9 in all
/// directions, each with steady rotation of either sign, closing and opening squeeze alone, and both with rotation.
/// @param quantities  cartesian or polar
/// @param domain  conditions that all of them fulfil
/// @throws std::invalid_argument for other quantities, or if no state is left
std::vector<State> finite_states(Quantities quantities, const Conjunction& domain = {});

/// How one answer came out.
struct FiniteComparison {
  Vector2<double> expected;  ///< in the answer's components [N]
  double bound = 0;          ///< of the error of `expected`, over its size
  double error = 0;          ///< of the answer over |F|; infinite where it is not a number
  Outcome outcome = Outcome::undecided;

  /// Is it said whether it is right?
  bool is_decided() const { return outcome != Outcome::left_out && outcome != Outcome::undecided; }
};

using FiniteMistakes = std::vector<const FiniteMistake*>;

/// A mistake, or two, that a program may have made.
struct FiniteSuspicion {
  FiniteMistakes mistakes;
  double share = 0;         ///< of the failing states, reproduced
  double contradicted = 0;  ///< right states at which it would have shown, over the failing ones
};

struct FiniteVerification {
  FiniteClaim claim;
  Quantities quantities = Quantities::cartesian;
  double tolerance = finite_tolerance;  ///< over |F|, to which the solver's bound is added
  std::vector<State> states;
  Answers answers;
  std::vector<FiniteComparison> comparisons;
  std::string domain = {};  ///< the declared domain in words, for the report
  Verdict verdict = Verdict::undecided;
  std::optional<double> factor;             ///< all answers are so many times the right ones
  std::vector<FiniteSuspicion> suspicions;  ///< the likeliest first; what predicts the same answers stands beside it
  std::vector<FiniteClaim> others;          ///< other films for which all answers are right
  std::vector<std::string> laws;            ///< laws for which they are
  std::vector<Term> terms;                  ///< where the answers are not simply right
  Domain right_where, wrong_where, not_a_number_where;

  std::size_t count(Outcome outcome) const;
  double worst_error() const;  ///< of the numbers that are decided
  bool accepted() const { return verdict == Verdict::agrees; }
};

/// Judges answers. A state is undecided where the solver's own bound is above the tolerance, and left out where it lies
/// on the jump of finite_half, at a = 0. Answers agree if none is wrong and more are right than are undecided. If
/// answers are wrong, mistakes of the gallery are tried, alone and in pairs, whether one factor makes all answers
/// right, whether other films do, and whether laws do.
/// @param tolerance  error over |F| that is right; 0: finite_tolerance
/// @param threads  no result depends on them
/// @param domain  the declared domain in words, for the report
FiniteVerification verify_finite_film(const FiniteClaim& claim, Quantities quantities, std::vector<State> states,
                                      Answers answers, double tolerance, unsigned threads, std::string domain = {});

std::string text_report(const FiniteVerification& verification);
nlohmann::ordered_json json_report(const FiniteVerification& verification);

}  // namespace lubjoint::verify
