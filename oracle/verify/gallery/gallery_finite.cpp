#include "oracle/verify/gallery/gallery_finite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lubjoint::verify {

namespace {

using oracle::FiniteFilm;
using W = FiniteWork;

bool anywhere(const FiniteClaim&, Quantities) { return true; }
bool in_cartesian(const FiniteClaim&, Quantities q) { return q == Quantities::cartesian; }
bool in_polar(const FiniteClaim&, Quantities q) { return q == Quantities::polar; }
bool where_it_ruptures(const FiniteClaim& claim, Quantities) { return claim.film != FiniteFilm::finite_full; }
bool in_half_film(const FiniteClaim& claim, Quantities) { return claim.film == FiniteFilm::finite_half; }

FiniteWork inputs_of(const FiniteClaim& claim, Quantities quantities, const State& s) {
  FiniteWork w{claim,           quantities,   s.viscosity,  s.length, s.radius, s.clearance, s.omega_bearing,
               s.omega_journal, {s.ex, s.ey}, {s.vx, s.vy}, 0,        0,        0,           0};
  w.epsilon = s.eccentricity_ratio;
  w.wedge = s.eccentricity_ratio * s.omega;
  w.whirl = -2 * s.eccentricity_ratio * s.attitude_rate;
  w.squeeze = s.squeeze_rate;
  return w;
}

void make_rates(FiniteWork& w) {
  if (w.quantities == Quantities::polar) return;
  const Vector2<double> e = w.e / w.clearance;
  const Vector2<double> v = w.v / w.clearance;
  w.radial = direction(e);
  w.epsilon = norm(e);
  // Not through u: with v = 0 the squeeze is zero, and the onset may be pinned.
  w.wedge = w.epsilon * (w.omega_bearing + w.omega_journal);
  w.whirl = -2 * dot(v, perpendicular(w.radial));
  w.squeeze = dot(v, w.radial);
}

/// F/S of the full film without its negative pressure, by the trapezoid rule on a grid.
FiniteAnswer clipped_force(double shape, const PolarFilmState<double>& state) {
  constexpr int angles = 361;
  constexpr int stations = 41;
  const double length = 2 * shape;  // R = 1, c = 1/2 and μ = 1/(4L): S = 1
  const oracle::PressureField field =
      oracle::finite_length_pressure(FiniteFilm::finite_full, Bearing<double>(length, 1, 0.5),
                                     Lubricant<double>(1 / (4 * length)), state, angles, stations);
  Vector2<double> sum(0, 0);
  for (std::size_t i = 0; i + 1 < field.theta.size(); ++i) {  // once around
    const Vector2<double> m(std::cos(field.theta[i]), std::sin(field.theta[i]));
    for (std::size_t j = 0; j < field.z.size(); ++j) {  // both ends are zero
      sum += std::max(field.pressure[i * field.z.size() + j], 0.0) * m;
    }
  }
  const double cell = (field.theta[1] - field.theta[0]) * (field.z[1] - field.z[0]);
  return {Vector2<double>(cell * sum), 5e-3};  // the rule, and the kink at p = 0, at ε = 0.9
}

/// F/S along r and t.
FiniteAnswer solved(const FiniteWork& w, const oracle::FiniteLengthOptions& options) {
  const PolarFilmState<double> state(w.epsilon, w.wedge + w.whirl, w.squeeze);
  if (w.clipped) return clipped_force(w.shape, state);
  const auto ratio = [&](const PolarFilmState<double>& at) {
    const oracle::FiniteForce force = oracle::finite_force(w.claim.film, w.shape, at.in_own_frame(), options);
    return FiniteAnswer{force.ratio, force.relative_error()};
  };
  if (w.mirrored || state.slip_rate >= 0) return ratio(state);
  // On 0…π all the same, where the pressure is linear in a and b.
  FiniteAnswer opposite = ratio(PolarFilmState<double>(w.epsilon, -state.slip_rate, -state.squeeze_rate));
  opposite.force = -opposite.force;
  return opposite;
}

}  // namespace

std::string FiniteClaim::words() const {
  std::string text(oracle::name_of(film));
  if (film != FiniteFilm::finite_reynolds) return text;
  return text + (onset == oracle::FilmOnset::free ? ", free onset" : ", onset at the maximum film");
}

const std::vector<FiniteMistake>& finite_gallery() {
  static const std::vector<FiniteMistake> all = {
      {"full_film_clipped",
       "The film is solved all around, and its negative pressure left out of the force (Gümbel by clipping)",
       "Neither the half film nor the one that ruptures: the pressure does not end at zero slope, nor at 0 and π",
       where_it_ruptures, nullptr, nullptr, [](W& w) { w.clipped = true; }},
      {"film_not_mirrored", "The half film lies on 0…π also where a < 0, and pulls there",
       "Right where a ≥ 0; where it turns the other way the force has the wrong direction", in_half_film, nullptr,
       nullptr, [](W& w) { w.mirrored = false; }},
      {"half_bearing_not_doubled", "Half of the bearing is solved, from its middle to its end, and not counted twice",
       "Every force is half as large", anywhere, nullptr, nullptr, [](W& w) { w.factor *= 0.5; }},
      {"six_for_twelve", "The right side of Reynolds' equation has half of its factor: 6μ ∂h/∂t + 3μU ∂h/∂x",
       "Every force is half as large", anywhere, nullptr, nullptr, [](W& w) { w.factor *= 0.5; }},
      {"twelve_for_six",
       "The right side of Reynolds' equation has twice its factor: the sum of the wall speeds in place of its half",
       "Every force is twice as large", anywhere, nullptr, nullptr, [](W& w) { w.factor *= 2; }},
      {"force_on_bearing", "The force is the one on the bearing", "Every force has the wrong sign", anywhere, nullptr,
       nullptr, [](W& w) { w.factor *= -1; }},
      {"squeeze_left_out", "There is no squeeze: ∂h/∂t is missing", "Right in steady rotation; undamped elsewhere",
       anywhere, nullptr, [](W& w) { w.squeeze = 0; }, nullptr},
      {"squeeze_rate_halved", "The squeeze term is 6μ ∂h/∂t where 12μ is right",
       "The squeeze's force is halved; pure wedge is right", anywhere, nullptr, [](W& w) { w.squeeze /= 2; }, nullptr},
      {"squeeze_rate_doubled", "The squeeze term is 24μ ∂h/∂t where 12μ is right",
       "The squeeze's force is doubled; pure wedge is right", anywhere, nullptr, [](W& w) { w.squeeze *= 2; }, nullptr},
      {"squeeze_rate_sign", "∂h/∂t has the wrong sign", "Squeeze drives instead of damps; pure wedge is right",
       anywhere, nullptr, [](W& w) { w.squeeze *= -1; }, nullptr},
      {"slip_rate_halved", "The wedge term has half its factor: the mean of the wall speeds is taken twice",
       "The wedge's force is halved; pure squeeze is right", anywhere, nullptr,
       [](W& w) {
         w.wedge /= 2;
         w.whirl /= 2;
       },
       nullptr},
      {"slip_rate_doubled", "The wedge term has twice its factor: 12μU in place of 6μU",
       "The wedge's force is doubled; pure squeeze is right", anywhere, nullptr,
       [](W& w) {
         w.wedge *= 2;
         w.whirl *= 2;
       },
       nullptr},
      {"spins_in_revolutions", "Spins in rad/s are taken for revolutions per second and converted: times 2π",
       "The wedge is larger by a factor 6.28 where spin causes it; pure squeeze is right", anywhere, nullptr,
       [](W& w) { w.wedge *= 2 * pi<double>(); }, nullptr},
      {"spins_to_revolutions", "Spins are converted to revolutions per second and used as such: times 1/2π",
       "The wedge is smaller by a factor 6.28 where spin causes it; pure squeeze is right", anywhere, nullptr,
       [](W& w) { w.wedge /= 2 * pi<double>(); }, nullptr},
      {"attitude_rate_left_out", "The line of centres does not turn: a = εω",
       "Right in steady rotation; wrong wherever the line of centres turns", anywhere, nullptr,
       [](W& w) { w.whirl = 0; }, nullptr},
      {"attitude_rate_not_doubled", "The wedge term is a = ε(ω − γ̇)",
       "Right in steady rotation; a whirl at half the spin still carries load", anywhere, nullptr,
       [](W& w) { w.whirl /= 2; }, nullptr},
      {"bearing_spin_left_out", "Only the journal's spin enters: a = εω_J − 2v·t/c",
       "Right while the bearing is at rest", in_cartesian, [](W& w) { w.omega_bearing = 0; }, nullptr, nullptr},
      {"steady_only", "The equation of a steadily loaded bearing: no squeeze, no whirl",
       "Right in steady rotation, and nowhere else", anywhere, nullptr, [](W& w) { w.whirl = w.squeeze = 0; }, nullptr},
      {"diameter_for_radius", "The journal's diameter stands where its radius belongs, in L/D and in the force",
       "Forces are twice (short bearing) to eight times (long) too large", anywhere, [](W& w) { w.radius *= 2; },
       nullptr, nullptr},
      {"radius_for_diameter", "The radius is taken for the diameter and halved",
       "Forces are half (short bearing) to an eighth (long) of what they should be", anywhere,
       [](W& w) { w.radius /= 2; }, nullptr, nullptr},
      {"diametral_clearance", "The radial clearance is taken twice: as if a diametral one were asked for",
       "Forces are too small, the more the thinner the film", in_cartesian, [](W& w) { w.clearance *= 2; }, nullptr,
       nullptr},
      {"clearance_halved", "The clearance is taken for the diametral one and halved",
       "Forces are too large; above half of the clearance there is none", in_cartesian, [](W& w) { w.clearance /= 2; },
       nullptr, nullptr},
      {"diametral_clearance_in_scale", "The force has the diametral clearance in its scale: (2c)² for c²",
       "Every force is a quarter", in_polar, nullptr, nullptr, [](W& w) { w.factor /= 4; }},
      {"length_doubled", "The length is taken for that from the middle to an end", "As a bearing of twice the length",
       anywhere, [](W& w) { w.length *= 2; }, nullptr, nullptr},
      {"length_halved", "Half of the length stands where the length belongs", "As a bearing of half the length",
       anywhere, [](W& w) { w.length /= 2; }, nullptr, nullptr},
      {"length_over_radius", "L/R stands where L/D belongs: the axial term is (R/L)² ∂²p/∂ζ² with ζ from −1 to 1",
       "Too large, four times in a short bearing, right in a long one", anywhere, nullptr, nullptr,
       [](W& w) { w.shape *= 2; }},
      {"one_end_closed", "p = 0 at one end only, no flow across the other",
       "As a film of twice the length, of which half is counted", anywhere, nullptr, nullptr,
       [](W& w) { w.shape *= 2; }},
      {"axial_coordinate_over_length",
       "The axial coordinate runs over z/L, from −½ to ½, and its term keeps the factor (D/L)² of 2z/L",
       "Too small, a quarter in a short bearing, right in a long one", anywhere, nullptr, nullptr,
       [](W& w) { w.shape /= 2; }},
      {"length_to_diameter_not_squared", "The axial term has D/L where (D/L)² belongs",
       "Right at L = D; too stiff for shorter bearings, too soft for longer ones", anywhere, nullptr, nullptr,
       [](W& w) { w.shape = std::sqrt(w.shape); }},
      {"length_to_diameter_inverted", "The axial term has (L/D)² where (D/L)² belongs",
       "Right at L = D; a short bearing is taken for a long one", anywhere, nullptr, nullptr,
       [](W& w) { w.shape = 1 / w.shape; }},
      {"tangential_clockwise", "The tangential direction is clockwise of the radial one",
       "The tangential force has the wrong sign", anywhere, nullptr, nullptr, [](W& w) { w.clockwise = true; }},
  };
  return all;
}

std::optional<FiniteAnswer> finite_answer(const FiniteClaim& claim, Quantities quantities, const State& state,
                                          const std::vector<const FiniteMistake*>& mistakes,
                                          const oracle::FiniteLengthOptions& options) {
  FiniteWork w = inputs_of(claim, quantities, state);
  for (const FiniteMistake* each : mistakes) {
    if (each->to_inputs != nullptr) each->to_inputs(w);
  }
  make_rates(w);
  for (const FiniteMistake* each : mistakes) {
    if (each->to_rates != nullptr) each->to_rates(w);
  }
  w.shape = w.length / (2 * w.radius);
  for (const FiniteMistake* each : mistakes) {
    if (each->to_equation != nullptr) each->to_equation(w);
  }
  constexpr double touching = 1e-9;  // rounding decides whether there is a film
  if (!(w.epsilon < 1 - touching)) return {};
  FiniteAnswer answer = solved(w, options);
  const double scale =
      w.factor * force_scale(BearingLimit::long_bearing, Bearing<double>(w.length, w.radius, w.clearance),
                             Lubricant<double>(w.viscosity));
  const double across = w.clockwise ? -answer.force.y() : answer.force.y();
  answer.force = scale * (answer.force.x() * w.radial + across * perpendicular(w.radial));
  return answer;
}

PolarMotion polar_motion(Quantities quantities, const State& state) {
  FiniteWork w = inputs_of({}, quantities, state);
  make_rates(w);
  const bool at_rest = quantities == Quantities::polar || w.omega_bearing == 0;
  return {w.epsilon, w.wedge + w.whirl, w.squeeze, w.whirl, w.wedge != 0 && at_rest, w.radial};
}

bool is_on_finite_jump(const FiniteClaim& claim, Quantities quantities, const State& state) {
  if (claim.film != FiniteFilm::finite_half) return false;
  const PolarMotion motion = polar_motion(quantities, state);
  constexpr double rounding = 1e-9;
  return std::abs(motion.slip) <= rounding * std::abs(motion.squeeze);
}

std::string described_finite_gallery() {
  std::string text;
  for (const FiniteMistake& each : finite_gallery()) {
    text += fmt::format("{}\n    {}\n    How it shows: {}\n", each.name, each.description, each.symptom);
  }
  return text;
}

std::string finite_gallery_markdown() {
  std::string text =
      "\n## Films of finite length\n\n"
      "`lubjoint verify --law finite_full`, `finite_half`, `finite_dynamic` and `finite_reynolds` recognise these, and "
      "pairs of\nthem; and the force of another film, or of one of the laws.\n\n"
      "| name | mistake | how it shows |\n|---|---|---|\n";
  for (const FiniteMistake& each : finite_gallery()) {
    text += fmt::format("| `{}` | {} | {} |\n", each.name, each.description, each.symptom);
  }
  return text;
}

}  // namespace lubjoint::verify
