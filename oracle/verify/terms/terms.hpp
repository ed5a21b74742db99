/// Which term of a force is wrong, and how: radial and tangential component, each in one kind of motion.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/states/judgement.hpp"

namespace lubjoint::verify {

enum class Component { radial, tangential };
/// wedge: steady rotation, v = 0, the bearing at rest; closing, opening: pure squeeze, a = 0; mixed: neither a nor b is
/// zero.
enum class MotionKind { wedge, closing, opening, mixed };
enum class TermVerdict { right, absent, factor, function, wrong, undecided };

inline constexpr std::array<std::string_view, 2> component_names = {"radial", "tangential"};
inline constexpr std::array<std::string_view, 4> motion_kind_names = {"wedge", "closing", "opening", "mixed"};
inline constexpr std::array<std::string_view, 6> term_verdict_names = {"right",    "absent", "factor",
                                                                       "function", "wrong",  "undecided"};

/// One component in one kind of motion.
struct Term {
  Component component = Component::radial;
  MotionKind states = MotionKind::wedge;
  TermVerdict verdict = TermVerdict::undecided;  ///< undecided: too few states, or on the jump of a half film
  bool vanishes = false;                         ///< is zero, and right: says nothing about the law
  double precision = 0;                          ///< error over |F| at which this holds; 0: rounding
  double digits = 0;                             ///< that nineteen states in twenty agree to, over |F|
  std::optional<double> factor = {};             ///< of what it should be, where that is a number
  /// In mixed motion: "wedge" or "squeeze" if that part alone is wrong, the other being as it should be.
  std::string part = {};
  std::string factor_text = {};                  ///< the number or ratio of inputs in words; may be empty
  std::map<std::string, double> exponents = {};  ///< powers of ε, q, … by which the ratio is off; "function" only

  bool is_right() const { return verdict == TermVerdict::right; }
  std::string words() const;  ///< "is 1/pi times what it should be"
};

/// One state's component as given and as it should be.
struct TermNumber {
  double given, expected, tolerance, force;
  const State* state;
  double ratio, gap, rate;  ///< ε, 1 − ε, |a| + |b|
  double wedge, squeeze;    ///< the parts of what is expected, in laws that have such parts; else both are zero

  double error() const { return given > expected ? given - expected : expected - given; }
};
/// By component and kind of motion.
using TermNumbers = std::array<std::array<std::vector<TermNumber>, 4>, 2>;

/// All terms of answers that have these numbers, in the order of the enumerations.
/// @param powers  are powers of ε and of the inputs looked for? Below three digits too many of them fit.
std::vector<Term> terms_of(const TermNumbers& numbers, bool powers);

/// All terms, in the order of the enumerations; none for quantities without a force of the film alone.
/// A term is right within each state's own tolerance or, in a numerical program, to at least two digits (`digits`).
std::vector<Term> terms_of(const Judgement& judgement, const std::vector<State>& states, const Answers& answers);

}  // namespace lubjoint::verify
