#include "oracle/proofs/algebra.hpp"

#include <sstream>
#include <stdexcept>

namespace lubjoint::proofs {

using GiNaC::ex;
using GiNaC::symbol;

Algebra& Algebra::root(const symbol& generator, const ex& square) {
  relations_.emplace_back(generator, square.expand());
  return *this;
}

Algebra& Algebra::angle(const symbol& theta) {
  const symbol sine("sin_" + theta.get_name());
  const symbol cosine("cos_" + theta.get_name());
  functions_[GiNaC::sin(theta)] = sine;
  functions_[GiNaC::cos(theta)] = cosine;
  return root(sine, 1 - GiNaC::pow(cosine, 2));
}

ex Algebra::reduced(const ex& polynomial) const {
  ex rest = polynomial.expand();
  for (auto relation = relations_.rbegin(); relation != relations_.rend(); ++relation) {
    const auto& [generator, square] = *relation;
    const int degree = rest.degree(generator);
    if (degree < 2) continue;
    ex even = 0;
    ex odd = 0;
    ex power = 1;
    for (int k = 0; k <= degree; ++k) {
      (k % 2 == 0 ? even : odd) += rest.coeff(generator, k) * power;
      if (k % 2 == 1) power = (power * square).expand();
    }
    rest = (even + odd * generator).expand();
  }
  return rest;
}

ex Algebra::normal_form(const ex& expression) const {
  const ex fraction = expression.subs(functions_, GiNaC::subs_options::no_pattern).numer_denom();
  if (reduced(fraction.op(1)).is_zero()) throw std::domain_error("a denominator vanishes identically");
  return reduced(fraction.op(0));
}

bool has_only_positive_coefficients(const ex& polynomial, const std::vector<symbol>& symbols) {
  GiNaC::lst variables;
  for (const symbol& variable : symbols) variables.append(variable);
  const ex expanded = polynomial.expand();
  if (expanded.is_zero()) return false;
  const auto positive_term = [&](const ex& term) {
    ex coefficient = term;
    for (const symbol& variable : symbols) {
      if (coefficient.ldegree(variable) < 0) return false;
      coefficient = coefficient.lcoeff(variable);
    }
    return coefficient.info(GiNaC::info_flags::positive) && GiNaC::is_a<GiNaC::numeric>(coefficient);
  };
  if (!GiNaC::is_a<GiNaC::add>(expanded)) return positive_term(expanded);
  for (const ex& term : expanded) {
    if (!positive_term(term)) return false;
  }
  return true;
}

void Proof::equal(const Algebra& algebra, const ex& left, const ex& right) {
  ++identities_;
  const ex remainder = algebra.normal_form(left - right);
  if (!remainder.is_zero()) fail("remainder", remainder);
}

void Proof::positive(const ex& polynomial, const std::vector<symbol>& symbols) {
  ++identities_;
  if (!has_only_positive_coefficients(polynomial, symbols)) fail("not of one sign", polynomial.expand());
}

void Proof::remark(const std::string& text) { note_ += (note_.empty() ? "" : "; ") + text; }

void Proof::fail(const std::string& what, const ex& remainder) {
  if (failures_++ > 0) return;
  std::ostringstream text;
  text << what << " in identity " << identities_ << ": " << remainder;
  constexpr std::size_t longest = 100;
  std::string line = text.str();
  if (line.size() > longest) line = line.substr(0, longest) + " ...";
  remark(line);
}

}  // namespace lubjoint::proofs
