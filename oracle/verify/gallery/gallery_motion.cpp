// Mistakes about how the journal moves: spins, rates, directions.
#include <algorithm>
#include <cmath>

#include "oracle/verify/gallery/gallery.hpp"

namespace lubjoint::verify {

namespace {

/// r and t reversed: what arctan(e_y/e_x) gives for e_x < 0.
void reverse_directions(Solution& s) {
  if (!(s.e.x() < 0)) return;
  s.r = -s.r;
  s.t = -s.t;
  s.b = -s.b;
  s.attitude_part = -s.attitude_part;
}

}  // namespace

std::vector<Mistake> motion_mistakes() {
  using S = Solution;
  return {
      {"inertial_attitude_rate",
       "The relative spin ω_J − ω_B is combined with the attitude rate γ̇ of the inertial frame: a = ε(ω_J − ω_B) − "
       "2v·t/c",
       "Right while the bearing is at rest; wrong by −2εω_B in a where it turns: the force depends on the observer",
       in_plane,
       {{Step::kinematics, [](S& s) { s.spin_part = s.ratio * (s.omega_journal - s.omega_bearing); }}}},
      {"bearing_spin_left_out",
       "Only the journal's spin enters: a = εω_J − 2v·t/c",
       "Right while the bearing is at rest; wrong by −εω_B in a where it turns",
       in_plane,
       {{Step::kinematics, [](S& s) { s.spin_part = s.ratio * s.omega_journal; }}}},
      {"attitude_rate_left_out",
       "The wedge term is a = εω, as in a steadily loaded bearing",
       "Right in a steady state; wrong wherever the line of centres turns",
       in_all,
       {{Step::kinematics, [](S& s) { s.attitude_part = 0; }}}},
      {"attitude_rate_not_doubled",
       "The wedge term is a = ε(ω − γ̇)",
       "Right in a steady state; a whirl at half the spin still carries load",
       in_all,
       {{Step::kinematics, [](S& s) { s.attitude_part /= 2; }}}},
      {"attitude_rate_sign",
       "The wedge term is a = ε(ω + 2γ̇)",
       "Right in a steady state only",
       in_all,
       {{Step::kinematics, [](S& s) { s.attitude_part = -s.attitude_part; }}}},
      {"slip_rate_sign",
       "The wedge term is a = ε(2γ̇ − ω), or angles are counted clockwise",
       "The tangential force of the wedge points the wrong way; pure squeeze is right",
       in_all,
       {{Step::rates, [](S& s) { s.a = -s.a; }}}},
      {"slip_rate_absolute",
       "The wedge term is |a|",
       "Wrong in the tangential force where the journal swings back",
       in_all,
       {{Step::rates, [](S& s) { s.a = std::abs(s.a); }}}},
      {"slip_rate_halved",
       "The wedge term is a/2: the mean of the wall speeds is taken twice",
       "The wedge's force is halved; pure squeeze is right",
       in_all,
       {{Step::rates, [](S& s) { s.a /= 2; }}}},
      {"slip_rate_doubled",
       "The wedge term is 2a: the sum of the wall speeds instead of their mean",
       "The wedge's force is doubled; pure squeeze is right",
       in_all,
       {{Step::rates, [](S& s) { s.a *= 2; }}}},
      {"squeeze_rate_halved",
       "The factor 2 of the squeeze term in Reynolds' equation (12μ ḣ against 6μU ∂h/∂x) is missing",
       "The squeeze's force is halved; pure wedge is right",
       in_all,
       {{Step::rates, [](S& s) { s.b /= 2; }}}},
      {"squeeze_rate_sign",
       "b = −ε̇: the squeeze film pushes the way the journal moves",
       "Squeeze drives instead of damps; pure wedge is right",
       in_all,
       {{Step::rates, [](S& s) { s.b = -s.b; }}}},
      {"squeeze_rate_not_over_clearance",
       "b = ė in m/s, not divided by the clearance",
       "The squeeze's force is smaller by the clearance in metres, as if it were not there",
       in_plane,
       {{Step::rates, [](S& s) { s.b *= s.film_clearance; }}}},
      {"squeeze_rate_over_clearance_twice",
       "ε̇ is taken for ė and divided by the clearance once more",
       "The squeeze's force is larger by one over the clearance in metres",
       [](Quantities q, Law) { return is_polar(q); },
       {{Step::rates, [](S& s) { s.b /= s.clearance; }}}},
      {"slide_not_over_clearance",
       "v·t in m/s, not divided by the clearance: a = ε(ω_B + ω_J) − 2v·t",
       "As if the line of centres did not turn",
       in_plane,
       {{Step::kinematics, [](S& s) { s.attitude_part *= s.film_clearance; }}}},
      {"squeeze_left_out",
       "There is no squeeze: b = 0",
       "Right where the film's thickness does not change; undamped elsewhere",
       in_all,
       {{Step::rates, [](S& s) { s.b = 0; }}}},
      {"steady_only",
       "The formulas of a steadily loaded bearing: a = ε(ω_J − ω_B), no whirl, no squeeze",
       "Right in steady rotation while the bearing is at rest, and nowhere else",
       in_all,
       {{Step::kinematics,
         [](S& s) {
           if (!is_polar(s.quantities)) s.spin_part = s.ratio * (s.omega_journal - s.omega_bearing);
           s.attitude_part = 0;
         }},
        {Step::rates, [](S& s) { s.b = 0; }}}},
      {"steady_only_journal_spin",
       "The formulas of a steadily loaded bearing with the journal's spin alone: a = εω_J, no whirl, no squeeze",
       "Right in steady rotation while the bearing is at rest, and nowhere else",
       in_plane,
       {{Step::kinematics, [](S& s) { s.spin_part = s.ratio * s.omega_journal, s.attitude_part = 0; }},
        {Step::rates, [](S& s) { s.b = 0; }}}},
      {"steady_only_both_spins",
       "The formulas of a steadily loaded bearing with both spins: a = ε(ω_J + ω_B), no whirl, no squeeze",
       "Right where the journal's centre rests, and nowhere else",
       in_plane,
       {{Step::kinematics, [](S& s) { s.attitude_part = 0; }}, {Step::rates, [](S& s) { s.b = 0; }}}},
      {"spins_clockwise",
       "Spins are counted clockwise: a = −ε(ω_J + ω_B) − 2v·t/c",
       "Squeeze and whirl are right; the wedge of the spin has the wrong sign",
       in_plane,
       {{Step::kinematics, [](S& s) { s.spin_part = -s.spin_part; }}}},
      {"motion_without_quadrant",
       "The direction of the motion is arctan of a ratio, without the quadrant: Capone's α where e_x(ω_J + ω_B) > 2v_y",
       "Where e_x(ω_J + ω_B) > 2v_y the film lies on the opposite side: the force of the reversed motion",
       [](Quantities q, Law law) { return !is_polar(q) && is_dynamic(law); },
       {{Step::rates,
         [](S& s) {
           if (!(s.e.x() * (s.omega_bearing + s.omega_journal) > 2 * s.v.y())) return;
           s.a = -s.a;
           s.b = -s.b;
         }}}},
      {"squeeze_rate_doubled",
       "The squeeze term has 4b where 2b is right",
       "The squeeze's force is doubled; pure wedge is right",
       in_all,
       {{Step::rates, [](S& s) { s.b *= 2; }}}},
      {"spin_sum_absolute",
       "|ω_J + ω_B| instead of ω_J + ω_B",
       "Right while the spins add up to a positive number; the wedge is on the wrong side elsewhere",
       in_plane,
       {{Step::kinematics, [](S& s) { s.spin_part = std::abs(s.spin_part); }}}},
      {"spin_sum_halved",
       "The mean of the spins is used for their sum: a = ε(ω_J + ω_B)/2 − 2v·t/c",
       "The wedge of the spin is halved; squeeze and whirl are right",
       in_plane,
       {{Step::kinematics, [](S& s) { s.spin_part /= 2; }}}},
      {"velocities_times_spin",
       "Velocities that a form without dimensions wants over cω are given over c: they count ω_J + ω_B times too much",
       "Right in steady rotation; squeeze and whirl are multiplied by the spin, and absent without one",
       in_plane,
       {{Step::kinematics, [](S& s) { s.attitude_part *= s.omega_bearing + s.omega_journal; }},
        {Step::rates, [](S& s) { s.b *= s.omega_bearing + s.omega_journal; }}}},
      {"ratio_clamped_at_0.99",
       "ε is not let beyond 0.99",
       "Right up to ε = 0.99, too small beyond",
       [](Quantities q, Law) { return q != Quantities::transition; },
       {{Step::kinematics,
         [](S& s) {
           if (!(s.ratio_gap < 0.01L)) return;
           s.spin_part *= 0.99L / s.ratio;
           s.ratio = 0.99L;
           s.ratio_gap = 0.01L;
         }}}},
      {"ratio_clamped_at_0.999",
       "ε is not let beyond 0.999",
       "Right up to ε = 0.999, too small beyond",
       [](Quantities q, Law) { return q != Quantities::transition; },
       {{Step::kinematics,
         [](S& s) {
           if (!(s.ratio_gap < 0.001L)) return;
           s.spin_part *= 0.999L / s.ratio;
           s.ratio = 0.999L;
           s.ratio_gap = 0.001L;
         }}}},
      {"separating_squeeze_left_out",
       "The squeeze is left out where the film opens: b = max(ε̇, 0)",
       "Wrong for b < 0, right for b ≥ 0",
       in_all,
       {{Step::rates, [](S& s) { s.b = std::max(s.b, Real(0)); }}}},
      {"squeeze_rate_absolute",
       "|ε̇| instead of ε̇",
       "Wrong for b < 0, right for b ≥ 0",
       in_all,
       {{Step::rates, [](S& s) { s.b = std::abs(s.b); }}}},
      {"attitude_without_quadrant",
       "The attitude angle is arctan(e_y/e_x), not atan2(e_y, e_x): r points inwards for e_x < 0",
       "Wrong for e_x < 0 only, unless the law is odd in r and t",
       in_plane,
       {{Step::kinematics, reverse_directions}}},
      {"half_film_not_mirrored",
       "The printed forms of the half film are used for a < 0, too: a for |a|, no sgn(a)",
       "Wrong for a < 0: the film sits on the side where it would cavitate",
       in_half_films,
       {{Step::inputs, [](S& s) { s.mirrors_half = false; }}}},
      {"half_film_tangential_not_mirrored",
       "|a| in the radial force, but no sgn(a) in the squeeze's tangential force",
       "Wrong in the tangential force for a < 0",
       in_half_films,
       {{Step::terms,
         [](S& s) {
           if (s.a < 0) s.tangential_squeeze = -s.tangential_squeeze;
         }}}},
      {"sign_of_zero_is_zero",
       "sgn(0) = 0 instead of +1 in the half film",
       "The squeeze's tangential force is missing where a = 0 exactly",
       // Without dimensions a is never 0 but as a difference, and either side is right there.
       [](Quantities q, Law law) { return is_half(law) && q != Quantities::dimensionless; },
       {{Step::terms,
         [](S& s) {
           if (s.a == 0) s.tangential_squeeze = 0;
         }}}},
      {"film_start_without_quadrant",
       "The film starts at arctan(2b/a), not at atan2(2b, a)",
       "Wrong for a < 0: the film sits where the pressure is negative, and pulls",
       [](Quantities, Law law) { return is_dynamic(law); },
       {{Step::rates,
         [](S& s) {
           // The other half of the film, where −p(θ; a, b) = p(θ; −a, −b) is positive.
           if (!(s.a < 0)) return;
           s.a = -s.a;
           s.b = -s.b;
           s.pulls = !s.pulls;
         }}}},
  };
}

}  // namespace lubjoint::verify
