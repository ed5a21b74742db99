// Mistakes about units and about which length is meant.
#include "oracle/verify/gallery/gallery.hpp"

namespace lubjoint::verify {

namespace {

constexpr Real pi = 3.14159265358979323846264338327950288L;

bool short_film(Quantities, Law law) { return is_short(law); }
bool long_film(Quantities, Law law) { return !is_short(law); }
bool without_dimensions(Quantities q, Law) { return q == Quantities::dimensionless; }

void scale_film(Solution& s, Real factor) {
  s.radial *= factor;
  s.tangential *= factor;
}

void scale_spins_by(Solution& s, Real factor) {
  for (Real* spin : {&s.omega_bearing, &s.omega_journal, &s.polar_omega}) *spin *= factor;
}
template <int numerator, int denominator>
void scale_spins(Solution& s) {
  scale_spins_by(s, pi * numerator / denominator);
}
template <int numerator, int denominator>
void unscale_spins(Solution& s) {
  scale_spins_by(s, denominator / (pi * numerator));
}

}  // namespace

std::vector<Mistake> unit_and_geometry_mistakes() {
  using S = Solution;
  return {
      {"unit_a_quarter",
       "The force is in S ω/4, Capone's unit, where S ω is the one that is asked for (--unit 0.25 says so)",
       "Every force is four times too large",
       without_dimensions,
       {{Step::film, [](S& s) { scale_film(s, 4); }}}},
      {"unit_a_half",
       "The force is in S ω/2, of the mean spin, where S ω is the one that is asked for (--unit 0.5 says so)",
       "Every force is twice too large",
       without_dimensions,
       {{Step::film, [](S& s) { scale_film(s, 2); }}}},
      {"unit_twice",
       "The force is in 2 S ω where S ω is the one that is asked for (--unit 2 says so)",
       "Every force is half as large",
       without_dimensions,
       {{Step::film, [](S& s) { scale_film(s, 0.5L); }}}},
      {"time_over_mean_spin",
       "Velocities are taken for clearances times ω/2, of the mean spin, not times ω",
       "Steady rotation is right; squeeze and whirl are halved",
       without_dimensions,
       {{Step::rates,
         [](S& s) {
           s.a -= s.attitude_part / 2;
           s.b /= 2;
         }}}},
      {"time_in_half",
       "Velocities are taken for clearances times 2ω, not times ω",
       "Steady rotation is right; squeeze and whirl are doubled",
       without_dimensions,
       {{Step::rates,
         [](S& s) {
           s.a += s.attitude_part;
           s.b *= 2;
         }}}},
      {"velocities_of_turning_frame",
       "Velocities are taken for those in axes that turn with the journal",
       "Squeeze is right; the wedge has the other sign and three times the size in steady rotation",
       without_dimensions,
       {{Step::rates, [](S& s) { s.a -= 2 * s.spin_part; }}}},
      {"spins_in_rpm",
       "Spins in rad/s are taken for revolutions per minute and converted: times 2π/60",
       "The wedge is smaller by a factor 9.55 where spin causes it; pure squeeze is right",
       in_all,
       {{Step::inputs, scale_spins<2, 60>}}},
      {"spins_in_degrees",
       "Spins in rad/s are taken for degrees per second and converted: times π/180",
       "The wedge is smaller by a factor 57.3 where spin causes it; pure squeeze is right",
       in_all,
       {{Step::inputs, scale_spins<1, 180>}}},
      {"spins_to_rpm",
       "Spins are converted to revolutions per minute and used as such: times 60/2π",
       "The wedge is larger by a factor 9.55 where spin causes it; pure squeeze is right",
       in_all,
       {{Step::inputs, unscale_spins<1, 30>}}},
      {"spins_in_revolutions",
       "Spins in rad/s are taken for revolutions per second and converted: times 2π",
       "The wedge is larger by a factor 6.28 where spin causes it; pure squeeze is right",
       in_all,
       {{Step::inputs, scale_spins<2, 1>}}},
      {"spins_to_revolutions",
       "Spins are converted to revolutions per second and used as such: times 1/2π",
       "The wedge is smaller by a factor 6.28 where spin causes it; pure squeeze is right",
       in_all,
       {{Step::inputs, unscale_spins<2, 1>}}},
      {"lengths_in_millimetres",
       "Lengths are in millimetres while the viscosity stays in Pa s",
       "Every film force is a million times too large",
       in_all,
       {{Step::inputs, [](S& s) { s.scale_lengths(1000); }}}},
      {"lengths_from_millimetres",
       "Lengths in metres are taken for millimetres and converted",
       "Every film force is a million times too small",
       in_all,
       {{Step::inputs, [](S& s) { s.scale_lengths(Real(1) / 1000); }}}},
      {"viscosity_in_millipascal",
       "The viscosity in Pa s is taken for mPa s (cP) and converted",
       "Every film force is a thousand times too small",
       in_all,
       {{Step::inputs, [](S& s) { s.viscosity /= 1000; }}}},
      {"viscosity_to_millipascal",
       "The viscosity is converted to mPa s (cP) and used as such",
       "Every film force is a thousand times too large",
       in_all,
       {{Step::inputs, [](S& s) { s.viscosity *= 1000; }}}},
      {"viscosity_in_poise",
       "The viscosity is in poise, or cP times 0.01, where Pa s is wanted: 400 cP as 4 Pa s",
       "Every film force is ten times too large",
       in_all,
       {{Step::inputs, [](S& s) { s.viscosity *= 10; }}}},
      {"viscosity_from_poise",
       "The viscosity in Pa s is taken for poise and converted",
       "Every film force is a tenth of what it should be",
       in_all,
       {{Step::inputs, [](S& s) { s.viscosity /= 10; }}}},
      {"force_in_kilogram_force",
       "The force is given in kilograms: over 9.80665 m/s²",
       "Every force is 9.8 times too small",
       in_plane,
       {{Step::answer,
         [](S& s) {
           for (Real& number : s.answer) number /= 9.80665L;
         }}}},
      {"diameter_for_radius",
       "The journal's diameter is used for its radius",
       "Short film: twice the force; long film: eight times",
       in_all,
       {{Step::inputs, [](S& s) { s.radius *= 2; }}}},
      {"radius_from_diameter",
       "The given radius is taken for a diameter and halved",
       "Short film: half the force; long film: an eighth",
       in_all,
       {{Step::inputs, [](S& s) { s.radius /= 2; }}}},
      {"bearing_for_journal_radius",
       "The bearing's radius R + c is used for the journal's",
       "Short film: too large by the factor 1 + c/R; long film: (1 + c/R)³: under one percent",
       in_all,
       {{Step::inputs, [](S& s) { s.radius += s.clearance; }}}},
      {"journal_radius_from_bearing",
       "The given radius is taken for the bearing's, and c is subtracted",
       "Short film: too small by the factor 1 − c/R; long film: (1 − c/R)³",
       in_all,
       {{Step::inputs, [](S& s) { s.radius -= s.clearance; }}}},
      {"diametral_clearance",
       "The diametral clearance 2c is used for the radial one",
       "Eccentricity ratios are half of what they are; the force is a quarter and less",
       in_all,
       {{Step::inputs, [](S& s) { s.clearance *= 2; }}}},
      {"length_halved",
       "L/2 is used for L",
       "Short film: an eighth of the force; long film: half",
       in_all,
       {{Step::inputs, [](S& s) { s.length /= 2; }}}},
      {"length_doubled",
       "2L is used for L",
       "Short film: eight times the force; long film: twice",
       in_all,
       {{Step::inputs, [](S& s) { s.length *= 2; }}}},
      {"length_squared",
       "L² instead of L³ in the short film's scale μRL³/c²",
       "Too large by one over the length in metres, the same factor in both components",
       short_film,
       {{Step::scale, [](S& s) { s.scale /= s.length; }}}},
      {"radius_squared",
       "R² instead of R³ in the long film's scale μLR³/c²",
       "Too large by one over the radius in metres, the same factor in both components",
       long_film,
       {{Step::scale, [](S& s) { s.scale /= s.radius; }}}},
      {"short_scale_in_long_film",
       "The scale of the short film, μRL³/c², in the long film's law",
       "The factor (L/R)² in every force",
       long_film,
       {{Step::scale, [](S& s) { s.scale *= (s.length / s.radius) * (s.length / s.radius); }}}},
      {"long_scale_in_short_film",
       "The scale of the long film, μLR³/c², in the short film's law",
       "The factor (R/L)² in every force",
       short_film,
       {{Step::scale, [](S& s) { s.scale *= (s.radius / s.length) * (s.radius / s.length); }}}},
      {"clearance_not_squared",
       "c instead of c² in the force scale",
       "Too small by the clearance in metres, the same factor in both components",
       in_all,
       {{Step::scale, [](S& s) { s.scale *= s.film_clearance; }}}},
      {"clearance_cubed",
       "c³ instead of c² in the force scale: a velocity law's scale with rates already over c",
       "Too large by one over the clearance in metres, the same factor in both components",
       in_all,
       {{Step::scale, [](S& s) { s.scale /= s.film_clearance; }}}},
  };
}

}  // namespace lubjoint::verify
