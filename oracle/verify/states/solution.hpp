/// The answer to a state, worked out the way programs do: step by step from the published formulas, in more digits
/// than any program has. A mistake changes the numbers after one of the steps.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/number/vector.hpp"
#include "oracle/verify/states/quantity.hpp"
#include "oracle/verify/states/steady_film.hpp"

namespace lubjoint::verify {

using Real = long double;
using Plane = Vector2<Real>;

/// A film law, by its place among law_names, or after them a law of dry contact.
struct Law {
  std::size_t place = 0;

  friend constexpr bool operator==(Law, Law) = default;
};
/// The laws of the film's state alone.
inline constexpr auto law_names = names_of_laws<StateFilmLaws>;
inline constexpr std::size_t law_count = law_names.size();

/// Laws of dry contact, F_N = K δ^{3/2}(1 + χ δ̇/δ̇₀), never pulling; of the facts of a film their name alone says
/// something. χ: lankarani_nikravesh (1990) ¾(1 − c_r²); hunt_crossley (1975) 3(1 − c_r)/2; flores (2011)
/// 8(1 − c_r)/(5c_r); gonthier (2004) d/c_r with (1 + d/c_r)/(1 − d) = exp(d(1 + 1/c_r)), 0 < d < 1, which gives back
/// exactly c_r of the speed.
inline constexpr std::array<LawFacts, 4> contact_law_facts = [] {
  std::array<LawFacts, 4> all{};
  constexpr std::array<std::string_view, 4> names = {"lankarani_nikravesh", "hunt_crossley", "flores", "gonthier"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = facts_of_laws<StateFilmLaws>[0];
    all[i].name = names[i];
    all[i].words = "dry contact";
    all[i].extent = FilmExtent::full;
    all[i].has_pressure = all[i].kinks = all[i].jumps = all[i].squeeze_only = false;
  }
  return all;
}();
/// Laws that are formulas, and how many.
inline constexpr std::size_t every_law_count = law_count + contact_law_facts.size();

/// After them, the films of the bearing's real length, which a solver knows (SolvedFilms).
inline constexpr auto& solved_film_facts = facts_of_laws<CompiledLaws>;

/// @throws std::invalid_argument that lists the laws of films there are
constexpr Law law_of(std::string_view name) {
  for (std::size_t i = 0; i < contact_law_facts.size(); ++i) {
    if (contact_law_facts[i].name == name) return {law_count + i};
  }
  for (std::size_t i = 0; i < solved_film_facts.size(); ++i) {
    if (solved_film_facts[i].name == name) return {every_law_count + i};
  }
  return {film_law_index<StateFilmLaws>(name)};
}
/// The same, of a name that is checked when it is compiled.
consteval Law operator""_law(const char* name, std::size_t size) { return law_of({name, size}); }

constexpr bool is_contact_law(Law law) { return law.place >= law_count && law.place < every_law_count; }
constexpr bool is_solved_film(Law law) { return law.place >= every_law_count; }
constexpr const LawFacts& facts_of(Law law) {
  if (is_solved_film(law)) return solved_film_facts[law.place - every_law_count];
  return is_contact_law(law) ? contact_law_facts[law.place - law_count] : facts_of_laws<StateFilmLaws>[law.place];
}
constexpr std::string_view name_of(Law law) { return facts_of(law).name; }
constexpr bool is_short(Law law) { return facts_of(law).is_short(); }
/// No oil leaves a long bearing there.
constexpr bool loses_oil_by_its_sides(Law law) { return is_short(law) || is_solved_film(law); }
constexpr bool is_full(Law law) { return facts_of(law).extent == FilmExtent::full; }
constexpr bool is_half(Law law) { return facts_of(law).extent == FilmExtent::half; }
/// Between θs and θe, its pressure integrated: not Pinkus and Sternlicht's, whose force is no integral.
constexpr bool is_dynamic(Law law) { return facts_of(law).extent == FilmExtent::dynamic && facts_of(law).has_pressure; }

/// Steps of the work, in their order; under a load, the scale comes before ε, which kinematics then means.
enum class Step {
  inputs,      ///< what the state says, as read
  shape,       ///< which law it is, and the L/D of a film of the bearing's real length
  kinematics,  ///< r, t, ε, b and the two parts of a
  rates,       ///< a and b
  terms,       ///< F_r/S and F_t/S, each as a wedge term (of a) and a squeeze term (of b); at rest, their slopes
  scale,       ///< S
  film,        ///< radial and tangential force of the film; K and C in (r, t)
  contact,     ///< normal force of the contact, and the weight of the blend
  total,       ///< force on the journal; K and C in x and y
  moments,     ///< moments about the mass centres; torques, power and flow
  answer       ///< the numbers that are given
};

/// A journal at rest under a load.
struct Rest {
  Real load = 0;              ///< W [N]
  Real spin = 0;              ///< ω [rad/s]
  bool radial_alone = false;  ///< W is balanced by F_r, and F_t left out
  SteadySlopes slopes;        ///< over S|ω|, over S
  Real attitude = 0;          ///< from the load to e, positive in the sense of the spin [rad]
  PolarCoefficients polar{};  ///< in (r, t) [N/m, N s/m]
  Entries stiffness{};        ///< in x and y, row by row [N/m]
  Entries damping{};          ///< likewise [N s/m]
};

/// What the film costs, each torque about its body's own centre.
struct Costs {
  ShearExtent shear = ShearExtent::film;
  Real relative_spin = 0;     ///< ω_J − ω_B [rad/s]
  Real couette_integral = 0;  ///< I₁ = ∫dθ/H [-]
  Real couette_rate = 0;      ///< T_C/ω = (μR³L/c) I₁ [N m s]
  Real couette = 0;           ///< T_C [N m]
  Real moment = 0;            ///< e × F [N m]
  Real torque_journal = 0;    ///< −T_C − ½ e × F [N m]
  Real torque_bearing = 0;    ///< T_C − ½ e × F [N m]
  Real squeeze_power = 0;     ///< −c F·u [W]
  Real power = 0;             ///< ω T_C − c F·u [W]
  Real side_flow = 0;         ///< out of both sides, net; NaN for a long bearing, which has none [m³/s]
};

/// What a solver says of the force of a moving film of the bearing's real length, over S = μLR³/c².
struct SolvedForce {
  Real radial = 0, tangential = 0;  ///< F/S [1/s]
  double error = 0;                 ///< bound of the error over |F|
};

/// What a solver says of such a film's flow and shear.
struct SolvedCosts {
  Real side_flow = 0;         ///< Q/(cRL) [1/s]
  Real couette_integral = 0;  ///< I₁ of finite_reynolds; the other films' is a closed form [-]
  double flow_error = 0;      ///< bound of the flow's over 2|u|
  double couette_error = 0;   ///< bound of I₁'s over itself
};

/// What a solver says of such a film's pressure at a place, over μ(R/c)².
struct SolvedPressure {
  Real pressure = 0;  ///< [1/s]
  Real largest = 0;   ///< of the whole film [1/s]
  double error = 0;   ///< bound of the error over the largest
};

/// Numbers on the way from a state to its answer.
struct Solution {
  Quantities quantities = Quantities::cartesian;
  Law law = "short_full"_law;

  Real viscosity = 0, length = 0, radius = 0, clearance = 0;
  Real omega_bearing = 0, omega_journal = 0;
  Plane e{0, 0}, v{0, 0};
  Real polar_ratio = 0, polar_squeeze = 0, polar_omega = 0, polar_attitude = 0;
  Plane arm_bearing{0, 0}, arm_journal{0, 0};
  Real e0 = 0, e1 = 0, stiffness = 0, restitution = 0, impact_speed = 1;
  Real film_widening = 0;    ///< e₁ in a transition
  Real film_clearance = 0;   ///< c, or c + e₁ in a transition
  bool mirrors_half = true;  ///< half film: on π…2π for a < 0
  bool pulls = false;        ///< the film force acts the other way

  // Of a film that a solver knows.
  const SolvedFilms* films = nullptr;
  Real shape = 0;  ///< L/D
  SolvedForce moving;
  SolvedCosts moving_costs;

  Plane r{1, 0}, t{0, 1};
  Real ratio = 0;          ///< ε
  Real ratio_gap = 1;      ///< 1 − ε, formed from lengths
  Real spin_part = 0;      ///< ε(ω_B + ω_J), or εω in polar quantities
  Real attitude_part = 0;  ///< −2 v·t/c, or −2εγ̇
  Real a = 0, b = 0;
  Real radial_wedge = 0, radial_squeeze = 0, tangential_wedge = 0, tangential_squeeze = 0;
  Real scale = 0;
  Real radial = 0, tangential = 0;  ///< of the film [N]
  Real penetration = 0, penetration_rate = 0;
  Real loss = 0;          ///< χ/δ̇₀; in a transition, χ = 3(1 − c_r²)/4
  Real normal = 0;        ///< F_N [N]
  Real of_dry = 0;        ///< weight of the contact in the blend
  Plane force{0, 0};      ///< on the journal
  Real reaction_arm = 1;  ///< factor of the transport moment
  Real moment_bearing = 0, moment_journal = 0;
  Real theta = 0, z = 0;
  Real theta_s = 0, theta_e = 0;
  Real pressure = 0;
  Real pressure_terms = 0;    ///< sum of the magnitudes that the pressure is made of; the film's largest, of a solver's
  double pressure_error = 0;  ///< bound of the solver's error over the film's largest
  Rest rest;                  ///< of a load
  Costs costs;                ///< of losses
  std::array<Real, most_answers> answer{};

  Real q() const { return ratio_gap * (1 + ratio); }  ///< 1 − ε²
  Real d() const { return 2 + ratio * ratio; }        ///< 2 + ε²
  void scale_lengths(Real factor);                    ///< all lengths and speeds read in another unit
  /// −1 where a half film that is not mirrored pulls on 0…π: a solver's film, linear in a and b, is that of −a and −b.
  Real pull() const { return is_half(law) && !mirrors_half && a < 0 ? -1 : 1; }
};

/// A change of the numbers after a step.
struct Change {
  Step step;
  void (*apply)(Solution&);
};

/// Works out the answer; the changes that a step has are made after it, in their order.
/// Where no film exists (ε ≥ 1) the answer is NaN; so is the pressure of Pinkus and Sternlicht's law, which has none.
Solution solve(Quantities quantities, Law law, const State& state, std::span<const Change> changes = {});

/// Of a journal at rest under a load, in this order: ε from the load; K and C in (r, t) from the slopes; attitude, and
/// K and C in x and y.
void find_rest(Solution& solution);
void find_polar_coefficients(Solution& solution);
void find_inertial_coefficients(Solution& solution);

/// T_C, torques, power and side flow; need force and rates.
void find_costs(Solution& solution);
/// The magnitudes of what torques, power and flow are the sums of.
std::array<Real, 4> size_of_costs(const Solution& solution);

/// χ of a law of contact.
Real contact_loss(Law law, Real restitution);

/// θs and θe of the law's film, and the pressure at (θ, z); need the rates.
void find_extent(Solution& solution);
void find_pressure(Solution& solution);

/// Sum of the magnitudes of the terms that the film force is the sum of [N]: what rounding is proportional to. For
/// the dynamic films, those of the integrals over the film that their formulas combine. Of a pressure [Pa] and of the
/// film's ends [rad] likewise.
Real size_of_terms(const Solution& solution);

}  // namespace lubjoint::verify
