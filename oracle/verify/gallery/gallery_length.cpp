// Mistakes about a film of the bearing's real length.
#include <cmath>

#include "oracle/verify/gallery/gallery.hpp"
#include "oracle/verify/states/solved_films.hpp"

namespace lubjoint::verify {

namespace {

using S = Solution;

bool of_length(Quantities q, Law law) {
  return is_solved_film(law) &&
         (is_table(q) || q == Quantities::wrench || q == Quantities::transition || q == Quantities::pressure);
}
bool flow_of_length(Quantities q, Law law) { return q == Quantities::losses && is_solved_film(law) && !is_full(law); }

bool of_an_onset(Quantities q, Law law) {
  const bool is_asked_of_both = q != Quantities::coefficients && q != Quantities::losses;
  return law == "finite_reynolds"_law && of_length(q, law) && is_asked_of_both;
}

}  // namespace

std::vector<Mistake> length_mistakes() {
  return {
      {"length_over_radius",
       "L/R stands where L/D belongs: the axial term is (R/L)² ∂²p/∂ζ² with ζ from −1 to 1",
       "As a bearing of twice the length that has this one's scale: nearly right where it is long",
       of_length,
       {{Step::shape, [](S& s) { s.shape *= 2; }}}},
      {"axial_coordinate_over_length",
       "The axial coordinate runs over z/L, from −½ to ½, and its term keeps the factor (D/L)² of 2z/L",
       "As a bearing of half the length that has this one's scale: nearly right where it is long",
       of_length,
       {{Step::shape, [](S& s) { s.shape /= 2; }}}},
      {"length_to_diameter_not_squared",
       "The axial term has D/L where (D/L)² belongs",
       "Right at L = D; too stiff for shorter bearings, too soft for longer ones",
       of_length,
       {{Step::shape, [](S& s) { s.shape = std::sqrt(s.shape); }}}},
      {"length_to_diameter_inverted",
       "The axial term has (L/D)² where (D/L)² belongs",
       "Right at L = D; a short bearing is taken for a long one",
       of_length,
       {{Step::shape, [](S& s) { s.shape = 1 / s.shape; }}}},
      {"half_bearing_not_doubled",
       "Half of the bearing is solved, from its middle to its end, and its force not counted twice",
       "The film carries half as much: the journal lies farther out, or e × F is halved",
       of_length,
       {{Step::scale, [](S& s) { s.scale /= 2; }}}},
      {"film_force_doubled",
       "The right side of Reynolds' equation has twice its factor: the sum of the wall speeds in place of its half",
       "The film carries twice as much: the journal lies nearer to the centre, or e × F is doubled",
       of_length,
       {{Step::scale, [](S& s) { s.scale *= 2; }}}},
      {"other_onset",
       "The film begins at the maximum film where a free onset is asked for, or the other way round",
       "Right in squeeze; wrong in steady rotation",
       of_an_onset,
       {{Step::shape, [](S& s) { s.films = &s.films->with_other_onset(); }}}},
      {"flow_of_short_bearing",
       "The side flow is that of a bearing without length, where nothing flows around it: cRL|a| of half films, "
       "cRL√(a² + 4b²) of others",
       "Nearly right where L/D is small; too large by more the longer the bearing is",
       flow_of_length,
       {{Step::moments,
         [](S& s) {
           const Real rate = is_half(s.law) ? std::abs(s.a) : std::hypot(s.a, 2 * s.b);
           s.costs.side_flow = s.film_clearance * s.radius * s.length * rate;
         }}}},
  };
}

}  // namespace lubjoint::verify
