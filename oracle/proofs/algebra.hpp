/// Exact zero test in a field of rational functions with square roots and angles.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lubjoint::proofs {

/// Rational functions of symbols, π and unknown transcendental quantities, extended by generators of degree two.
///
/// Every generator g carries one relation g² = w, w a polynomial in the symbols and in the generators before it. The
/// relations are a triangular set: dividing by them from the last to the first leaves a polynomial of degree below two
/// in every generator, and that remainder is unique. It is zero exactly if the expression vanishes for all values
/// of the symbols and generators that obey the relations (as long as no w is the square of something in the field
/// before it; for a sign, w = 1, a remainder other than zero still means that one of its two values fails).
class Algebra {
 public:
  Algebra() = default;

  /// Adds a generator with its square.
  Algebra& root(const GiNaC::symbol& generator, const GiNaC::ex& square);
  /// Adds the sine and cosine of an angle; the angle itself stays an independent symbol.
  Algebra& angle(const GiNaC::symbol& theta);

  /// Numerator of the expression, reduced by every relation and expanded.
  /// @throws std::domain_error if the denominator vanishes identically
  GiNaC::ex normal_form(const GiNaC::ex& expression) const;

  bool vanishes(const GiNaC::ex& expression) const { return normal_form(expression).is_zero(); }

 private:
  GiNaC::ex reduced(const GiNaC::ex& polynomial) const;

  std::vector<std::pair<GiNaC::symbol, GiNaC::ex>> relations_;
  GiNaC::exmap functions_;
};

/// True if the expanded polynomial in the given symbols has only positive coefficients (and at least one): it is then
/// positive where the symbols are positive. With allow_constant_only = false nothing else is asked.
bool has_only_positive_coefficients(const GiNaC::ex& polynomial, const std::vector<GiNaC::symbol>& symbols);

/// Collects the identities of one statement.
class Proof {
 public:
  /// The two sides are equal in the algebra.
  void equal(const Algebra& algebra, const GiNaC::ex& left, const GiNaC::ex& right);
  void zero(const Algebra& algebra, const GiNaC::ex& expression) { equal(algebra, expression, GiNaC::ex(0)); }
  /// The polynomial is positive where all the symbols are: every coefficient is positive.
  void positive(const GiNaC::ex& polynomial, const std::vector<GiNaC::symbol>& symbols);
  void remark(const std::string& text);

  int identities() const { return identities_; }
  bool holds() const { return failures_ == 0 && identities_ > 0; }
  bool examined() const { return identities_ > 0; }
  const std::string& note() const { return note_; }

 private:
  void fail(const std::string& what, const GiNaC::ex& remainder);

  int identities_ = 0;
  int failures_ = 0;
  std::string note_;
};

}  // namespace lubjoint::proofs
