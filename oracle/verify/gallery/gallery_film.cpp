// Mistakes in the film laws themselves: cavitation, brackets, exponents, the wrong law.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "oracle/verify/gallery/gallery.hpp"
#include "oracle/verify/states/film_terms.hpp"

namespace lubjoint::verify {

namespace {

bool pinkus_sternlicht(Quantities, Law law) { return law == "pinkus_sternlicht"_law; }
bool full(Quantities, Law law) { return is_full(law); }
bool polynomial(Quantities, Law law) {
  return !is_dynamic(law) && law != "pinkus_sternlicht"_law && !is_solved_film(law);
}
bool short_polynomial(Quantities q, Law law) { return is_short(law) && polynomial(q, law); }
bool long_polynomial(Quantities q, Law law) { return !is_short(law) && polynomial(q, law); }
bool long_closed(Quantities, Law law) { return !is_short(law) && !is_dynamic(law) && !is_solved_film(law); }

/// Pinkus and Sternlicht's φ written anew. @param phi  from K, B and the sign of b
template <class Phi>
void set_phi(Solution& s, Real k, const Phi& phi) {
  const Real q = s.q(), q12 = std::sqrt(q);
  const Real big_b = s.ratio * std::abs(s.b);
  const Real value = k == 0 && big_b == 0 ? Real(1) : phi(k, big_b);
  s.radial_wedge = -24 * s.ratio * k / (s.d() * q * q12);
  s.radial_squeeze = -6 * pi<Real>() * s.b * value / (q * q12);
  s.tangential_wedge = 6 * pi<Real>() * s.a * value / (s.d() * q12);
}

Real resultant(const Solution& s) { return std::sqrt(s.q() * (s.a * s.a / 4 + s.b * s.b)); }

template <Law other>
void use_law(Solution& s) {
  s.law = other;
}
/// A film that a solver knows is taken for another one where one of them is asked about.
template <Law other>
bool is_not(Quantities, Law law) {
  return law != other && (is_solved_film(law) || !is_solved_film(other));
}

/// "law_NAME" and its description: kept for as long as the gallery is.
struct OtherLawWords {
  std::string name;
  std::string description;
};

OtherLawWords words_of(Law law) {
  return {"law_" + std::string(name_of(law)), "The law is " + std::string(name_of(law))};
}

/// Laws from one place on.
template <std::size_t first, std::size_t... place>
std::vector<Mistake> other_laws(std::index_sequence<place...>) {
  static const std::array words = {words_of(Law{first + place})...};
  return {Mistake{words[place].name,
                  words[place].description,
                  "Another law: see its formula",
                  is_not<Law{first + place}>,
                  {{Step::shape, use_law<Law{first + place}>}}}...};
}

/// Squeeze films that carry pressure on one side alone.
bool one_sided_squeeze(Quantities, Law law) { return facts_of(law).squeeze_only && !is_full(law); }

/// H = 1 − ε cosθ with the rest unchanged is the law at −ε, and F(−ε, a, b) = −F(ε, −a, −b).
void negate_ratio(Solution& s) {
  s.a = -s.a;
  s.b = -s.b;
  s.pulls = !s.pulls;
}

}  // namespace

std::vector<Mistake> film_mistakes() {
  using S = Solution;
  std::vector<Mistake> mistakes = {
      {"separating_bracket_sign",
       "For ε̇ < 0 the bracket of Pinkus and Sternlicht's radial force has −4kε² as printed, not +4kε²",
       "Wrong in the radial force for b < 0, where it jumps at b = 0",
       pinkus_sternlicht,
       {{Step::terms,
         [](S& s) {
           if (s.b < 0) s.radial_wedge = -s.radial_wedge;
         }}}},
      {"closing_factor_for_both_signs",
       "(k + 3)/(k + 3/2) is used for ε̇ < 0, too",
       "Wrong for b < 0, most as ε → 1",
       pinkus_sternlicht,
       {{Step::terms,
         [](S& s) { set_phi(s, resultant(s), [](Real k, Real b) { return (k + 3 * b) / (k + 1.5L * b); }); }}}},
      {"opening_factor_for_both_signs",
       "k/(k + 3/2) is used for ε̇ > 0, too",
       "Wrong for b > 0, most as ε → 1",
       pinkus_sternlicht,
       {{Step::terms, [](S& s) { set_phi(s, resultant(s), [](Real k, Real b) { return k / (k + 1.5L * b); }); }}}},
      {"factors_of_the_signs_swapped",
       "The forms for ε̇ > 0 and ε̇ < 0 are exchanged",
       "Wrong wherever ε̇ ≠ 0",
       pinkus_sternlicht,
       {{Step::terms,
         [](S& s) {
           const bool opens = s.b < 0;
           set_phi(s, resultant(s), [=](Real k, Real b) { return (opens ? k + 3 * b : k) / (k + 1.5L * b); });
         }}}},
      {"k_without_one_minus_ratio_squared",
       "k² = ((ω − 2γ̇)/(2ε̇))² + 1/ε², without the factor 1 − ε²",
       "Right at the centre, wrong as ε → 1",
       pinkus_sternlicht,
       {{Step::terms,
         [](S& s) {
           const bool opens = s.b < 0;
           set_phi(s, std::sqrt(s.a * s.a / 4 + s.b * s.b),
                   [=](Real k, Real b) { return (opens ? k : k + 3 * b) / (k + 1.5L * b); });
         }}}},
      {"k_without_factor_2",
       "k² = (1 − ε²)[((ω − 2γ̇)/ε̇)² + 1/ε²], the 2 below the spin forgotten",
       "Right in pure squeeze, wrong in the wedge's radial force",
       pinkus_sternlicht,
       {{Step::terms,
         [](S& s) {
           const bool opens = s.b < 0;
           set_phi(s, std::sqrt(s.q() * (s.a * s.a + s.b * s.b)),
                   [=](Real k, Real b) { return (opens ? k : k + 3 * b) / (k + 1.5L * b); });
         }}}},
      {"pressure_at_half_turn",
       "The full film's pressure is cut at θ = π, where it is not zero (p(π) ≠ 0)",
       "Wrong wherever there is squeeze, even at the centre: a tangential force answers a radial velocity",
       [](Quantities, Law law) { return law == "long_half"_law; },
       {{Step::rates, use_law<"long_half_eq5"_law>}}},
      {"half_film_not_halved",
       "The half film's force is not halved, or both halves are counted",
       "Twice the force",
       in_half_films,
       {{Step::film, [](S& s) { s.radial *= 2, s.tangential *= 2; }}}},
      {"full_film_halved",
       "The full film's force is halved, as if half of the film carried pressure symmetrically",
       "Half the force",
       full,
       {{Step::film, [](S& s) { s.radial /= 2, s.tangential /= 2; }}}},
      {"wedge_on_radial_left_out",
       "The wedge's radial force, which only a cavitated film has, is left out",
       "Pure wedge gives no radial force; the attitude angle is 90° at any load",
       [](Quantities, Law law) {
         return in_half_formulas(Quantities::cartesian, law) || law == "pinkus_sternlicht"_law;
       },
       {{Step::terms, [](S& s) { s.radial_wedge = 0; }}}},
      {"squeeze_on_tangential_left_out",
       "The squeeze's tangential force of the half film is left out",
       "Wrong in the tangential force where there is squeeze",
       in_half_formulas,
       {{Step::terms, [](S& s) { s.tangential_squeeze = 0; }}}},
      {"squeeze_exponent",
       "The power of 1 − ε² below the squeeze term is one too small (3/2 for 5/2, 1/2 for 3/2)",
       "Right at the centre, too small as ε → 1",
       polynomial,
       {{Step::terms, [](S& s) { s.radial_squeeze *= s.q(); }}}},
      {"wedge_exponent",
       "The power of 1 − ε² below the wedge's tangential force is one too large",
       "Right at the centre, too large as ε → 1",
       polynomial,
       {{Step::terms, [](S& s) { s.tangential_wedge /= s.q(); }}}},
      {"root_left_out",
       "√(1 − ε²) is left out of the wedge's tangential force",
       "Right at the centre, too small as ε → 1",
       polynomial,
       {{Step::terms, [](S& s) { s.tangential_wedge *= std::sqrt(s.q()); }}}},
      {"squeeze_root_left_out",
       "√(1 − ε²) is left out of the squeeze term's denominator (2 for 5/2, 1 for 3/2)",
       "Right at the centre, too small as ε → 1",
       polynomial,
       {{Step::terms, [](S& s) { s.radial_squeeze *= std::sqrt(s.q()); }}}},
      {"radial_wedge_exponent",
       "The power of 1 − ε² below the wedge's radial force is one too small",
       "Right at the centre, too small as ε → 1",
       in_half_formulas,
       {{Step::terms, [](S& s) { s.radial_wedge *= s.q(); }}}},
      {"squeeze_on_tangential_without_ratio",
       "The squeeze's tangential force of the half film lacks its factor ε",
       "At the centre a force across the velocity; right as ε → 1",
       [](Quantities, Law law) { return law == "short_half"_law || law == "long_half"_law; },
       {{Step::terms,
         [](S& s) {
           const Real side = s.mirrors_half && s.a < 0 ? -1 : 1;
           s.tangential_squeeze = side * s.b / s.q() * (s.law == "short_half"_law ? 2 / s.q() : 24 / s.d());
         }}}},
      {"radial_squeeze_doubled",
       "The squeeze's radial force of the half film is not halved",
       "The radial force of the squeeze is doubled; the rest is right",
       in_half_formulas,
       {{Step::terms, [](S& s) { s.radial_squeeze *= 2; }}}},
      {"radial_wedge_doubled",
       "The wedge's radial force of the half film is not halved",
       "The radial force of the wedge is doubled; the rest is right",
       in_half_formulas,
       {{Step::terms, [](S& s) { s.radial_wedge *= 2; }}}},
      {"tangential_wedge_doubled",
       "The wedge's tangential force of the half film is not halved",
       "The tangential force of the wedge is doubled; the rest is right",
       in_half_formulas,
       {{Step::terms, [](S& s) { s.tangential_wedge *= 2; }}}},
      {"two_plus_ratio_squared_left_out_of_radial",
       "2 + ε² is left out of the denominator of the long film's radial wedge force",
       "Too large by 2 + ε² there; the rest is right",
       [](Quantities, Law law) { return law == "long_half"_law || law == "long_half_eq5"_law; },
       {{Step::terms, [](S& s) { s.radial_wedge *= s.d(); }}}},
      {"pi_left_out_of_squeeze",
       "π is missing in the squeeze term of the radial force",
       "The radial force of the squeeze is 1/π of what it should be; the rest is right",
       polynomial,
       {{Step::terms, [](S& s) { s.radial_squeeze /= pi<Real>(); }}}},
      {"pi_left_out_of_wedge",
       "π is missing in the wedge's tangential force",
       "The tangential force of the wedge is 1/π of what it should be; the rest is right",
       polynomial,
       {{Step::terms, [](S& s) { s.tangential_wedge /= pi<Real>(); }}}},
      {"pi_left_out_of_bracket",
       "8/(2 + ε²) for 8/(π(2 + ε²)) in the long half film's squeeze term",
       "The radial force of the squeeze is wrong, of the wrong sign for thick films; the rest is right",
       [](Quantities, Law law) { return law == "long_half"_law; },
       {{Step::terms,
         [](S& s) {
           const Real q = s.q();
           s.radial_squeeze = -6 * s.b / (q * std::sqrt(q)) * (pi<Real>() - 16 / s.d());
         }}}},
      {"squeeze_on_radial_sign",
       "The squeeze's radial force has the wrong sign",
       "Squeeze drives instead of damps in the radial direction; the rest is right",
       polynomial,
       {{Step::terms, [](S& s) { s.radial_squeeze = -s.radial_squeeze; }}}},
      {"wedge_on_radial_sign",
       "The wedge's radial force points outwards",
       "The film draws the journal to the wall; the rest is right",
       [](Quantities, Law law) {
         return in_half_formulas(Quantities::cartesian, law) || law == "pinkus_sternlicht"_law;
       },
       {{Step::terms, [](S& s) { s.radial_wedge = -s.radial_wedge; }}}},
      {"two_plus_ratio_squared_for_squeeze",
       "2 + ε² instead of 1 + 2ε² in the short film's squeeze term",
       "Twice too large at the centre, right as ε → 1",
       short_polynomial,
       {{Step::terms, [](S& s) { s.radial_squeeze *= s.d() / (1 + 2 * s.ratio * s.ratio); }}}},
      {"one_plus_ratio_squared",
       "1 + ε² instead of 1 + 2ε² in the short film's squeeze term",
       "Right at the centre, too small by up to a third as ε → 1",
       short_polynomial,
       {{Step::terms, [](S& s) { s.radial_squeeze *= (1 + s.ratio * s.ratio) / (1 + 2 * s.ratio * s.ratio); }}}},
      {"two_plus_ratio",
       "2 + ε instead of 2 + ε² in the long film's wedge terms",
       "Wrong in the middle, right at ε = 0 and 1",
       long_polynomial,
       {{Step::terms,
         [](S& s) {
           s.radial_wedge *= s.d() / (2 + s.ratio);
           s.tangential_wedge *= s.d() / (2 + s.ratio);
         }}}},
      {"two_plus_ratio_squared_left_out",
       "2 instead of 2 + ε² in the long film's wedge terms",
       "Right at the centre, too large by up to a half as ε → 1",
       long_closed,
       {{Step::terms,
         [](S& s) {
           s.radial_wedge *= s.d() / 2;
           s.tangential_wedge *= s.d() / 2;
         }}}},
      {"film_thickness_sign",
       "h = c(1 − ε cosθ) with θ still from the maximum film in the rest of the formulas",
       "The terms that are odd in ε have the wrong sign; a full film shows nothing",
       [](Quantities, Law law) { return !is_full(law); },
       {{Step::rates, negate_ratio}}},
      {"closing_film_for_both_signs",
       "The squeeze film that closes (p > 0 on π/2…3π/2) is used for ε̇ < 0, too",
       "Wrong for b < 0, where the film hardly resists: too large by any factor as ε → 1; b > 0 is right",
       one_sided_squeeze,
       {{Step::terms,
         [](S& s) {
           if (!(s.b < 0)) return;
           S closing = s;
           closing.b = -s.b;
           find_terms(closing);
           s.radial_wedge = -closing.radial_wedge;
         }}}},
  };
  for (auto* laws :
       {+[] { return other_laws<0>(std::make_index_sequence<law_count>()); },
        +[] { return other_laws<every_law_count>(std::make_index_sequence<solved_film_facts.size()>()); }}) {
    for (Mistake& each : laws()) mistakes.push_back(std::move(each));
  }
  return mistakes;
}

}  // namespace lubjoint::verify
