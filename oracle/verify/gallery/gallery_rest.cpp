// Mistakes about a journal at rest under a load: where it is, and the stiffness and damping of its film.
#include <cmath>

#include "oracle/verify/gallery/gallery.hpp"

namespace lubjoint::verify {

namespace {

using S = Solution;

bool of_load(Quantities q, Law) { return is_of_load(q); }
bool of_coefficients(Quantities q, Law) { return q == Quantities::coefficients; }

const Real half_turn = pi<Real>();

void scale(Entries& m, Real factor) {
  for (Real& x : m) x *= factor;
}
void transpose(Entries& m) { std::swap(m[1], m[2]); }
void turn_cross_terms(Entries& m) {
  m[1] = -m[1];
  m[2] = -m[2];
}
void swap_axes(Entries& m) {
  std::swap(m[0], m[3]);
  std::swap(m[1], m[2]);
}
template <auto change>
void in_both(S& s) {
  change(s.rest.stiffness);
  change(s.rest.damping);
}

/// x along the load, y 90° counter-clockwise of it: the axes of `lubjoint coefficients`.
void axes_of_load(Entries& m) {
  swap_axes(m);
  turn_cross_terms(m);
}

void damping_symmetric(S& s) { s.rest.damping[2] = s.rest.damping[1]; }

}  // namespace

std::vector<Mistake> rest_mistakes() {
  return {
      {"load_halved",
       "Half of the load is carried, as by each of a rotor's two bearings",
       "The eccentricity is too small wherever it is",
       of_load,
       {{Step::inputs, [](S& s) { s.rest.load /= 2; }}}},
      {"load_doubled",
       "Twice the load is carried, as if the one given were that of one of two bearings",
       "The eccentricity is too large wherever it is",
       of_load,
       {{Step::inputs, [](S& s) { s.rest.load *= 2; }}}},
      {"load_of_radial_force",
       "The load is balanced by the radial force alone; the tangential one is left out",
       "The eccentricity is too large, most where it is small; the attitude angle at an ε is right",
       of_load,
       {{Step::inputs, [](S& s) { s.rest.radial_alone = true; }}}},
      {"half_spin_at_rest",
       "The mean spin ω/2 is used where ω is meant: the factor 2 of Reynolds' equation is lost",
       "The eccentricity is that of half the speed",
       of_load,
       {{Step::inputs, [](S& s) { s.omega_journal /= 2; }}}},
      {"twice_the_spin_at_rest",
       "Twice the spin is used: the factor ½ of the wedge is lost",
       "The eccentricity is that of twice the speed",
       of_load,
       {{Step::inputs, [](S& s) { s.omega_journal *= 2; }}}},
      {"eccentricity_in_metres",
       "The eccentricity e is given where e/c is asked for",
       "Too small by the clearance in metres",
       of_load,
       {{Step::answer, [](S& s) { s.answer[0] *= s.clearance; }}}},
      {"thickness_for_eccentricity",
       "The least thickness over the clearance, 1 − ε, is given for ε",
       "Large where the load is small",
       of_load,
       {{Step::answer, [](S& s) { s.answer[0] = s.ratio_gap; }}}},
      {"attitude_in_degrees",
       "The attitude angle is in degrees",
       "57.3 times too large",
       of_load,
       {{Step::answer, [](S& s) { s.answer[1] *= 180 / half_turn; }}}},
      {"attitude_from_the_load_backwards",
       "The attitude angle is measured from the direction against the load: π − φ",
       "Between π/2 and π where 0 to π/2 is right",
       of_load,
       {{Step::answer, [](S& s) { s.answer[1] = half_turn - s.answer[1]; }}}},
      {"attitude_from_across_the_load",
       "The attitude angle is measured from the direction across the load: π/2 − φ",
       "Small where it should be nearly π/2: at small loads",
       of_load,
       {{Step::answer, [](S& s) { s.answer[1] = half_turn / 2 - s.answer[1]; }}}},
      {"attitude_against_the_spin",
       "The attitude angle is counted against the sense of the spin",
       "The angle has the other sign",
       of_load,
       {{Step::answer, [](S& s) { s.answer[1] = -s.answer[1]; }}}},
      {"attitude_counter_clockwise",
       "The attitude angle is counted counter-clockwise, whichever way the journal turns",
       "The angle has the other sign where ω < 0",
       of_load,
       {{Step::answer, [](S& s) { s.answer[1] *= s.rest.spin < 0 ? -1 : 1; }}}},
      {"coefficients_transposed",
       "xy and yx are exchanged: the first index is taken for the displacement's direction, not the force's",
       "kxx and kyy are right, kxy and kyx each other's",
       of_coefficients,
       {{Step::total, in_both<transpose>}}},
      {"coefficients_in_radial_axes",
       "The matrices are given in radial and tangential axes and not turned into x and y",
       "The attitude angle is missing: right where it is a right angle and the axes are exchanged",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           s.rest.stiffness = s.rest.polar.stiffness;
           s.rest.damping = s.rest.polar.damping;
         }}}},
      {"coefficients_in_load_axes",
       "x is along the load and y 90° counter-clockwise of it, where y is against the load",
       "kxx and kyy are each other's, kxy is −kyx",
       of_coefficients,
       {{Step::total, in_both<axes_of_load>}}},
      {"coefficients_axes_exchanged",
       "x and y are exchanged: the load is along −x",
       "kxx and kyy are each other's, kxy and kyx, too",
       of_coefficients,
       {{Step::total, in_both<swap_axes>}}},
      {"cross_coefficients_sign",
       "The cross terms have the other sign: an axis points the other way, or the journal turns the other way",
       "kxx and kyy are right, the others have the wrong sign",
       of_coefficients,
       {{Step::total, in_both<turn_cross_terms>}}},
      {"coefficients_not_mirrored",
       "The coefficients are those of |ω|: the cross terms keep their sign where the journal turns the other way",
       "Right for ω > 0; kxy, kyx, cxy and cyx have the wrong sign for ω < 0",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           if (s.rest.spin < 0) in_both<turn_cross_terms>(s);
         }}}},
      {"coefficients_sign",
       "K and C are the derivatives of the force, F = K e + C v, where F = −K e − C v is asked for",
       "Every entry has the wrong sign",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           scale(s.rest.stiffness, -1);
           scale(s.rest.damping, -1);
         }}}},
      {"cross_coefficients_left_out",
       "The cross terms are left out: two springs and two dampers",
       "kxy, kyx, cxy and cyx are zero",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           for (Entries* m : {&s.rest.stiffness, &s.rest.damping}) (*m)[1] = (*m)[2] = 0;
         }}}},
      {"damping_made_symmetric",
       "cyx is set to cxy, as if damping were always symmetric",
       "cyx alone is wrong, in films without a potential",
       of_coefficients,
       {{Step::total, damping_symmetric}}},
      {"damping_doubled",
       "The damping has a factor 2 too many",
       "K is right, C twice too large",
       of_coefficients,
       {{Step::total, [](S& s) { scale(s.rest.damping, 2); }}}},
      {"damping_halved",
       "The damping lacks its factor 2: the squeeze term of Reynolds' equation is −b cosθ where −2b cosθ is right",
       "K is right, C half as large",
       of_coefficients,
       {{Step::total, [](S& s) { scale(s.rest.damping, 0.5L); }}}},
      {"damping_per_radian",
       "The damping is that of time in 1/ω: not divided by the spin",
       "K is right, C too large by the spin in rad/s",
       of_coefficients,
       {{Step::total, [](S& s) { scale(s.rest.damping, std::abs(s.rest.spin)); }}}},
      {"coefficients_per_ratio",
       "The derivatives are in e/c and v/c: not divided by the clearance",
       "Every entry is too small by the clearance in metres",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           scale(s.rest.stiffness, s.film_clearance);
           scale(s.rest.damping, s.film_clearance);
         }}}},
      {"coefficients_over_load",
       "The coefficients are without dimensions, cK/W and cωC/W; asked for are N/m and N s/m",
       "Of the order of one where the right ones are of the order of W/c",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           scale(s.rest.stiffness, s.clearance / s.rest.load);
           scale(s.rest.damping, s.clearance * std::abs(s.rest.spin) / s.rest.load);
         }}}},
      {"coefficients_over_scale",
       "The coefficients are without dimensions, cK/(Sω) and cC/S with the force scale S; asked for are N/m and N s/m",
       "A function of the eccentricity alone",
       of_coefficients,
       {{Step::total,
         [](S& s) {
           scale(s.rest.stiffness, s.film_clearance / (s.scale * std::abs(s.rest.spin)));
           scale(s.rest.damping, s.film_clearance / s.scale);
         }}}},
      {"attitude_held",
       "The derivatives are taken at a fixed attitude: e moves along its own direction alone, and that r and t turn "
       "with "
       "it is left out (K_rt = K_tt = 0)",
       "C is right; K is singular",
       of_coefficients,
       {{Step::film, [](S& s) { s.rest.polar.stiffness[1] = s.rest.polar.stiffness[3] = 0; }}}},
      {"slip_rate_held",
       "a is held where a = εω moves with ε",
       "C is right; K is too stiff or too soft along e",
       of_coefficients,
       {{Step::film,
         [](S& s) {
           const Real unit = s.scale * std::abs(s.rest.spin) / s.film_clearance;
           s.rest.polar.stiffness[0] = -unit * s.rest.slopes.radial_by_ratio;
           s.rest.polar.stiffness[2] = -unit * (s.rest.spin < 0 ? -1 : 1) * s.rest.slopes.tangential_by_ratio;
         }}}},
      {"whirl_damping_halved",
       "The factor 2 of the whirl, a = ε(ω − 2γ̇), is lost in the damping across e",
       "K and the damping along e are right",
       of_coefficients,
       {{Step::film,
         [](S& s) {
           s.rest.polar.damping[1] /= 2;
           s.rest.polar.damping[3] /= 2;
         }}}},
      {"squeeze_damping_halved",
       "The factor 2 of the squeeze, a sinθ − 2b cosθ, is lost in the damping along e",
       "K and the damping across e are right",
       of_coefficients,
       {{Step::film,
         [](S& s) {
           s.rest.polar.damping[0] /= 2;
           s.rest.polar.damping[2] /= 2;
         }}}},
  };
}

}  // namespace lubjoint::verify
