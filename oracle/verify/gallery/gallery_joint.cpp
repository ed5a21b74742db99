// Mistakes in putting the force together, and about contact, transition and moments.
#include <algorithm>
#include <cmath>

#include "oracle/verify/gallery/gallery.hpp"

namespace lubjoint::verify {

namespace {

bool in_transition(Quantities q, Law) { return q == Quantities::transition; }
bool in_contact(Quantities q, Law) { return q == Quantities::transition || q == Quantities::contact; }
/// Of another law it would be no mistake one makes.
bool in_transition_or_its_law(Quantities q, Law law) {
  return q == Quantities::transition || (q == Quantities::contact && law == "lankarani_nikravesh"_law);
}
bool of_contact(Quantities q, Law) { return q == Quantities::contact; }

template <Law other>
bool is_another_contact(Quantities q, Law law) {
  return q == Quantities::contact && law != other;
}
template <Law other>
void use_contact(Solution& s) {
  s.law = other;
}

bool in_film_forces(Quantities q, Law) { return q == Quantities::cartesian || q == Quantities::wrench; }
bool in_wrench(Quantities q, Law) { return q == Quantities::wrench; }

void set_normal(Solution& s, Real power, Real loss) {
  const Real depth = std::max(s.penetration, Real(0));
  s.loss = loss;
  s.normal = std::max(s.stiffness * std::pow(depth, power) * (1 + loss * s.penetration_rate), Real(0));
}

}  // namespace

std::vector<Mistake> assembly_mistakes() {
  using S = Solution;
  return {
      {"radial_and_tangential_swapped",
       "The radial force acts along t and the tangential one along r",
       "Pure squeeze pushes sideways",
       in_all,
       {{Step::film, [](S& s) { std::swap(s.radial, s.tangential); }}}},
      {"tangential_clockwise",
       "t is r turned clockwise",
       "The tangential force has the wrong sign",
       in_all,
       {{Step::film, [](S& s) { s.tangential = -s.tangential; }}}},
      {"radial_inwards",
       "The radial direction points from the journal's to the bearing's centre when the force is put together",
       "The radial force has the wrong sign: squeeze drives instead of damps",
       in_all,
       {{Step::film, [](S& s) { s.radial = -s.radial; }}}},
      {"force_on_bearing",
       "The force on the bearing is given, not the one on the journal",
       "Every force has the wrong sign",
       in_all,
       {{Step::film,
         [](S& s) {
           if (s.quantities == Quantities::polar) s.radial = -s.radial, s.tangential = -s.tangential;
         }},
        {Step::total,
         [](S& s) {
           if (s.quantities != Quantities::polar) s.force = -s.force;
         }}}},
      {"film_from_minimum_thickness",
       "θ is counted from the minimum film: both force components point the other way",
       "The film's force has the wrong sign",
       in_all,
       {{Step::film, [](S& s) { s.radial = -s.radial, s.tangential = -s.tangential; }}}},
      {"turning_without_quadrant",
       "(F_r, F_t) are turned into x and y by arctan(e_y/e_x), not by atan2(e_y, e_x); the rates are right",
       "The force has the wrong sign for e_x < 0",
       in_film_forces,
       {{Step::film,
         [](S& s) {
           if (!(s.e.x() < 0)) return;
           s.r = -s.r;
           s.t = -s.t;
         }}}},
      {"turning_by_arccos",
       "(F_r, F_t) are turned into x and y by γ = arccos(e_x/|e|), which is never negative",
       "Right for e_y ≥ 0; turned by −γ for e_y < 0",
       in_film_forces,
       {{Step::film,
         [](S& s) {
           if (!(s.e.y() < 0)) return;
           s.r.y() = -s.r.y();
           s.t.x() = -s.t.x();
         }}}},
      {"turned_backwards",
       "(F_r, F_t) are turned into x and y by −γ",
       "Right where e lies on the x axis",
       in_film_forces,
       {{Step::film,
         [](S& s) {
           s.r.y() = -s.r.y();
           s.t.x() = -s.t.x();
         }}}},
      {"y_downwards",
       "y of the force is counted downwards",
       "F_y has the wrong sign",
       in_plane,
       {{Step::answer, [](S& s) { s.answer[1] = -s.answer[1]; }}}},
      {"tangential_left_out",
       "Only the radial force is applied",
       "Pure wedge of a full film gives no force",
       in_all,
       {{Step::film, [](S& s) { s.tangential = 0; }}}},
      {"angle_from_minimum_thickness",
       "The place θ is counted from the minimum film",
       "The pressure is that of the other side of the bearing",
       [](Quantities q, Law) { return q == Quantities::pressure; },
       {{Step::inputs, [](S& s) { s.theta += pi<Real>(); }}}},
      {"axial_place_from_the_end",
       "z is counted from the bearing's end, not from its middle",
       "The film's pressure is largest at an end",
       [](Quantities q, Law law) { return q == Quantities::pressure && (is_short(law) || is_solved_film(law)); },
       {{Step::inputs, [](S& s) { s.z -= s.length / 2; }}}},
      {"film_end_reduced",
       "The film's end is reduced to (−π, π]",
       "Off by 2π where the film passes θ = π",
       [](Quantities q, Law) { return q == Quantities::extent; },
       {{Step::answer,
         [](S& s) {
           if (s.answer[1] > pi<Real>()) s.answer[1] -= 2 * pi<Real>();
         }}}},
      {"x_and_y_swapped",
       "The columns of the two components are exchanged",
       "Right along the diagonals only",
       in_plane,
       {{Step::answer, [](S& s) { std::swap(s.answer[0], s.answer[1]); }}}},
  };
}

std::vector<Mistake> contact_mistakes() {
  using S = Solution;
  return {
      {"film_clearance_without_e1",
       "The film inside the transition uses c, not c + e₁",
       "Wrong at every ε, most near 1; no number where |e| > c",
       in_transition,
       {{Step::inputs, [](S& s) { s.film_widening = 0; }}}},
      {"film_clearance_with_e0",
       "The film inside the transition uses c + e₀, not c + e₁",
       "Wrong at every ε, most near 1",
       in_transition,
       {{Step::inputs, [](S& s) { s.film_widening = s.e0; }}}},
      {"widened_clearance_in_contact",
       "The contact, too, uses c + e₁: penetration is |e| − c − e₁",
       "Wrong beyond c only: contact begins too late",
       in_transition,
       {{Step::contact,
         [](S& s) {
           s.penetration -= s.e1;
           set_normal(s, 1.5L, s.loss);
         }}}},
      {"penetration_from_blend_end",
       "Penetration is counted from c + e₀",
       "Wrong beyond c only: no contact in the blend",
       in_transition,
       {{Step::contact,
         [](S& s) {
           s.penetration -= s.e0;
           set_normal(s, 1.5L, s.loss);
         }}}},
      {"blend_weights_swapped",
       "The weights of film and contact in the blend are exchanged",
       "Wrong in the blend only, with jumps at both of its ends",
       in_transition,
       {{Step::contact,
         [](S& s) {
           if (s.of_dry > 0 && s.of_dry < 1) s.of_dry = 1 - s.of_dry;
         }}}},
      {"no_blend",
       "Film up to c, contact beyond, no blend",
       "Wrong in the blend only, with a jump at c",
       in_transition,
       {{Step::contact,
         [](S& s) {
           if (s.of_dry > 0) s.of_dry = 1;
         }}}},
      {"contact_exponent_1",
       "The contact force is Kδ, not Kδ^{3/2}",
       "Wrong beyond c only, too large by 1/√δ",
       in_contact,
       {{Step::contact, [](S& s) { set_normal(s, 1, s.loss); }}}},
      {"contact_exponent_2",
       "The contact force is Kδ², not Kδ^{3/2}",
       "Wrong beyond c only, too small by √δ",
       in_contact,
       {{Step::contact, [](S& s) { set_normal(s, 2, s.loss); }}}},
      {"contact_exponent_5_2",
       "The contact force is Kδ^{5/2}, not Kδ^{3/2}",
       "Wrong beyond c only, too small by δ",
       in_contact,
       {{Step::contact, [](S& s) { set_normal(s, 2.5L, s.loss); }}}},
      {"restitution_not_squared",
       "3(1 − c_r)/4 instead of 3(1 − c_r²)/4",
       "Wrong beyond c only, where the journal moves radially",
       in_transition_or_its_law,
       {{Step::contact, [](S& s) { set_normal(s, 1.5L, 3 * (1 - s.restitution) / (4 * s.impact_speed)); }}}},
      {"hunt_crossley",
       "Hunt and Crossley's 3(1 − c_r)/2 instead of 3(1 − c_r²)/4",
       "Wrong beyond c only, where the journal moves radially",
       in_transition,
       {{Step::contact, [](S& s) { set_normal(s, 1.5L, 3 * (1 - s.restitution) / (2 * s.impact_speed)); }}}},
      {"contact_loss_left_out",
       "The contact is elastic: no term with the penetration rate",
       "Wrong beyond c only, where the journal moves radially",
       in_contact,
       {{Step::contact, [](S& s) { set_normal(s, 1.5L, 0); }}}},
      {"contact_loss_halved",
       "The term with the penetration rate is half as large: χ/2",
       "Wrong beyond c only, where the journal moves radially",
       in_contact,
       {{Step::contact, [](S& s) { set_normal(s, 1.5L, s.loss / 2); }}}},
      {"penetration_rate_sign",
       "The penetration rate has the wrong sign",
       "Wrong beyond c only: the contact gives energy to the impact",
       in_contact,
       {{Step::contact, [](S& s) { set_normal(s, 1.5L, -s.loss); }}}},
      {"contact_pulls",
       "The contact force may become negative",
       "Wrong beyond c only, for fast separation: the wall pulls",
       in_contact,
       {{Step::contact,
         [](S& s) {
           const Real depth = std::max(s.penetration, Real(0));
           s.normal = s.stiffness * depth * std::sqrt(depth) * (1 + s.loss * s.penetration_rate);
         }}}},
      {"contact_outwards",
       "The contact force acts along +r, not −r",
       "Wrong beyond c only: the wall sucks the journal in",
       in_contact,
       {{Step::contact, [](S& s) { s.normal = -s.normal; }}}},
      {"impact_speed_left_out",
       "The loss is χδ̇ with δ̇ in m/s: not divided by the impact speed",
       "Right where the journal's distance does not change",
       of_contact,
       {{Step::contact, [](S& s) { set_normal(s, 1.5L, s.loss * s.impact_speed); }}}},
      {"loss_without_indentation",
       "The damping does not grow with the indentation: Kδ^{3/2} + Kχδ̇/δ̇₀",
       "A jump at the wall; right where the journal's distance does not change",
       of_contact,
       {{Step::contact,
         [](S& s) {
           if (!(s.penetration > 0)) return;
           const Real elastic = s.stiffness * s.penetration * std::sqrt(s.penetration);
           s.normal = std::max(elastic + s.stiffness * s.loss * s.penetration_rate, Real(0));
         }}}},
      {"speed_for_penetration_rate",
       "The journal's speed |v| is used for the penetration rate",
       "Right where the journal moves straight into the wall",
       of_contact,
       {{Step::contact,
         [](S& s) {
           s.penetration_rate = std::hypot(s.v.x(), s.v.y());
           set_normal(s, 1.5L, s.loss);
         }}}},
      {"contact_inside_clearance",
       "The indentation is |e| − c of either sign: the wall acts inside of the clearance, too",
       "A force where there should be none",
       of_contact,
       {{Step::contact,
         [](S& s) {
           const Real depth = std::abs(s.penetration);
           s.normal = std::max(s.stiffness * depth * std::sqrt(depth) * (1 + s.loss * s.penetration_rate), Real(0));
         }}}},
      {"contact_law_lankarani_nikravesh",
       "The law is Lankarani and Nikravesh's, χ = 3(1 − c_r²)/4",
       "Right where the journal's distance does not change",
       is_another_contact<"lankarani_nikravesh"_law>,
       {{Step::inputs, use_contact<"lankarani_nikravesh"_law>}}},
      {"contact_law_hunt_crossley",
       "The law is Hunt and Crossley's, χ = 3(1 − c_r)/2",
       "Right where the journal's distance does not change",
       is_another_contact<"hunt_crossley"_law>,
       {{Step::inputs, use_contact<"hunt_crossley"_law>}}},
      {"contact_law_flores",
       "The law is that of Flores et al. (2011), χ = 8(1 − c_r)/(5c_r)",
       "Right where the journal's distance does not change",
       is_another_contact<"flores"_law>,
       {{Step::inputs, use_contact<"flores"_law>}}},
      {"contact_law_gonthier",
       "The law is that of Gonthier et al. (2004), χ = d/c_r with (1 + d/c_r)/(1 − d) = exp(d(1 + 1/c_r))",
       "Right where the journal's distance does not change",
       is_another_contact<"gonthier"_law>,
       {{Step::inputs, use_contact<"gonthier"_law>}}},
      {"contact_law_gonthier_approximate",
       "The law is Gonthier's with d taken for 1 − c_r², as by Machado et al. (2012): χ = (1 − c_r²)/c_r",
       "Right where the journal's distance does not change; Gonthier's own χ is exceeded by 30 % at c_r = 0.95, by 21 "
       "% "
       "at 0.8 and by 5 % at 0.5, and missed by 2 % at 0.2",
       of_contact,
       {{Step::contact,
         [](S& s) {
           const Real c = s.restitution;
           set_normal(s, 1.5L, (1 - c) * (1 + c) / (c * s.impact_speed));
         }}}},
      {"transport_moment_left_out",
       "The reaction acts at the bearing's centre: no transport moment e × (−F)",
       "Forces right; the bearing's moment wrong by e × F",
       in_wrench,
       {{Step::total, [](S& s) { s.reaction_arm = 0; }}}},
      {"transport_moment_sign",
       "The transport moment has the wrong sign",
       "Forces right; the bearing's moment wrong by 2 e × F",
       in_wrench,
       {{Step::total, [](S& s) { s.reaction_arm = -1; }}}},
      {"bearing_moment_of_action",
       "The bearing's moment is that of F, not of −F",
       "Forces right; the bearing's moment has the wrong sign",
       in_wrench,
       {{Step::moments, [](S& s) { s.moment_bearing = -s.moment_bearing; }}}},
      {"moments_clockwise",
       "Moments are counted clockwise (F × s)",
       "Forces right; both moments have the wrong sign",
       in_wrench,
       {{Step::moments, [](S& s) { s.moment_bearing = -s.moment_bearing, s.moment_journal = -s.moment_journal; }}}},
      {"moments_exchanged",
       "The two moments are exchanged",
       "Forces right; moments in each other's column",
       in_wrench,
       {{Step::moments, [](S& s) { std::swap(s.moment_bearing, s.moment_journal); }}}},
      {"moments_about_the_joint",
       "The journal's moment is taken about the joint, not about its mass centre: zero",
       "Forces right; the journal's moment is zero",
       in_wrench,
       {{Step::moments, [](S& s) { s.moment_journal = 0; }}}},
  };
}

}  // namespace lubjoint::verify
