// Mistakes about friction torques, power and side flow.
#include <cmath>

#include "oracle/verify/gallery/gallery.hpp"

namespace lubjoint::verify {

namespace {

using S = Solution;

bool of_losses(Quantities q, Law) { return q == Quantities::losses; }

/// The torques with another Couette torque, and the power with it.
void set_couette(S& s, Real couette) {
  Costs& c = s.costs;
  c.couette = couette;
  c.torque_journal = -couette - c.moment / 2;
  c.torque_bearing = couette - c.moment / 2;
  c.power = c.relative_spin * couette + c.squeeze_power;
}

void scale_integral(S& s, Real integral) { set_couette(s, s.costs.couette / s.costs.couette_integral * integral); }

}  // namespace

std::vector<Mistake> loss_mistakes() {
  return {
      {"torques_exchanged",
       "The torques of journal and bearing are exchanged",
       "Each is right with the other's sign but for e × F",
       of_losses,
       {{Step::moments, [](S& s) { std::swap(s.costs.torque_journal, s.costs.torque_bearing); }}}},
      {"torque_signs",
       "Torques are those that the bodies exert on the oil: the other sign",
       "Both torques have the wrong sign",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal = -s.costs.torque_journal;
           s.costs.torque_bearing = -s.costs.torque_bearing;
         }}}},
      {"pressure_torque_left_out",
       "The torque is that of the sheared oil alone; the pressure's share −½ e × F is left out",
       "Right where e × F vanishes; too small for the journal otherwise, and the torques do not add up to −e × F",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal = -s.costs.couette;
           s.costs.torque_bearing = s.costs.couette;
         }}}},
      {"pressure_torque_sign",
       "The pressure's share of the torques has the other sign: +½ e × F",
       "Right where e × F vanishes",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal += s.costs.moment;
           s.costs.torque_bearing += s.costs.moment;
         }}}},
      {"pressure_torque_doubled",
       "The pressure's share of each torque is e × F where half of it is right",
       "Right where e × F vanishes; the torques add up to −2 e × F",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal -= s.costs.moment / 2;
           s.costs.torque_bearing -= s.costs.moment / 2;
         }}}},
      {"pressure_torque_on_bearing",
       "All of e × F is put on the bearing, and none of it on the journal",
       "The torques add up as they should, and each is off by ½ e × F",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal += s.costs.moment / 2;
           s.costs.torque_bearing -= s.costs.moment / 2;
         }}}},
      {"torque_on_bearing_opposite",
       "The bearing's torque is minus the journal's, as about the journal's centre",
       "The journal's is right; the torques add up to zero",
       of_losses,
       {{Step::moments, [](S& s) { s.costs.torque_bearing = -s.costs.torque_journal; }}}},
      {"friction_force_for_torque",
       "The friction force is given for its torque: R² where R³ is right",
       "The torque of the sheared oil is too large by one over the radius in metres",
       of_losses,
       {{Step::moments, [](S& s) { set_couette(s, s.costs.couette / s.radius); }}}},
      {"shear_of_whole_gap",
       "The cavity is sheared like the film (flooded): I₁ = 2π/√q",
       "Torques and power are too large; full films are right",
       of_losses,
       {{Step::moments, [](S& s) { scale_integral(s, 2 * pi<Real>() / std::sqrt(s.q())); }}}},
      {"shear_of_film_alone",
       "The film alone is sheared where the whole gap, or the cavity's share, is asked for",
       "Torques and power are too small; full films are right",
       of_losses,
       {{Step::total, [](S& s) { s.costs.shear = ShearExtent::film; }}}},
      {"shear_of_half_gap",
       "Half of the gap is sheared, wherever the film is: I₁ = π/√q",
       "Half films are right; of a closing dynamic film, too little",
       of_losses,
       {{Step::moments, [](S& s) { scale_integral(s, pi<Real>() / std::sqrt(s.q())); }}}},
      {"shear_of_concentric_gap",
       "Petroff's torque: the gap is c all around, I₁ = 2π",
       "Full films near the centre are right",
       of_losses,
       {{Step::moments, [](S& s) { scale_integral(s, 2 * pi<Real>()); }}}},
      {"shear_of_spin_sum",
       "The oil is sheared by ω_J + ω_B where ω_J − ω_B is right",
       "Right in a bearing at rest",
       of_losses,
       {{Step::moments, [](S& s) { set_couette(s, s.costs.couette_rate * (s.omega_journal + s.omega_bearing)); }}}},
      {"shear_of_journal_spin",
       "The oil is sheared by ω_J alone where ω_J − ω_B is right",
       "Right in a bearing at rest",
       of_losses,
       {{Step::moments, [](S& s) { set_couette(s, s.costs.couette_rate * s.omega_journal); }}}},
      {"power_of_shear_alone",
       "The power is that of the sheared oil, ω T_C; what the pressure drives is left out",
       "Too small wherever there is a force",
       of_losses,
       {{Step::moments, [](S& s) { s.costs.power = s.costs.relative_spin * s.costs.couette; }}}},
      {"pressure_left_out",
       "Torques and power are those of the sheared oil alone: −½ e × F is left out of the torques, and the power is "
       "−T_J ω_J − T_B ω_B of these",
       "Right where e × F and the journal's rate vanish; the torques add up to zero",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal = -s.costs.couette;
           s.costs.torque_bearing = s.costs.couette;
           s.costs.power = s.costs.relative_spin * s.costs.couette;
         }}}},
      {"power_without_pressure_torque",
       "−½ e × F is left out of the torques, and the power −T_J ω_J − T_B ω_B − F·v is that of these",
       "Right where e × F vanishes; the power is off by ½(ω_J + ω_B) e × F",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.torque_journal = -s.costs.couette;
           s.costs.torque_bearing = s.costs.couette;
           s.costs.power = s.costs.relative_spin * s.costs.couette - dot(s.force, s.v);
         }}}},
      {"power_halved",
       "The power has a factor ½ too many: an energy's, or that of the mean of the spins",
       "Half of what it should be",
       of_losses,
       {{Step::moments, [](S& s) { s.costs.power /= 2; }}}},
      {"power_of_journal_alone",
       "The power is −T_J ω_J: that of the bearing and of the journal's motion are left out",
       "Right where the bearing rests and the journal's centre does, too",
       of_losses,
       {{Step::moments, [](S& s) { s.costs.power = -s.costs.torque_journal * s.omega_journal; }}}},
      {"power_of_torques_alone",
       "The power is −T_J ω_J − T_B ω_B: the journal's motion −F·v is left out",
       "Right where the journal's centre rests",
       of_losses,
       {{Step::moments,
         [](S& s) {
           s.costs.power = -s.costs.torque_journal * s.omega_journal - s.costs.torque_bearing * s.omega_bearing;
         }}}},
      {"flow_of_one_side",
       "The side flow is that of one end of the bearing",
       "Half of what it should be",
       of_losses,
       {{Step::moments, [](S& s) { s.costs.side_flow /= 2; }}}},
      {"flow_doubled",
       "The side flow has a factor 2 too many: the slip rate for its half",
       "Twice what it should be",
       of_losses,
       {{Step::moments, [](S& s) { s.costs.side_flow *= 2; }}}},
      {"flow_of_wedge_alone",
       "The side flow is cRL|a|: what the squeeze drives out is left out",
       "Half films are right, and where there is no squeeze",
       of_losses,
       {{Step::moments,
         [](S& s) {
           if (!is_full(s.law) && is_short(s.law))
             s.costs.side_flow = s.film_clearance * s.radius * s.length * std::abs(s.a);
         }}}},
      {"flow_of_pressure_source_everywhere",
       "The side flow is that of a half film, whatever the law: oil leaves a full film on one side and enters it on "
       "the "
       "other",
       "Full films should have none",
       of_losses,
       {{Step::moments,
         [](S& s) {
           if (is_full(s.law) && is_short(s.law))
             s.costs.side_flow = s.film_clearance * s.radius * s.length * std::abs(s.a);
         }}}},
  };
}

}  // namespace lubjoint::verify
