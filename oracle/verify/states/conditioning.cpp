#include "oracle/verify/states/conditioning.hpp"

#include <algorithm>
#include <cmath>

#include "lubjoint/film/every_law.hpp"

namespace lubjoint::verify {

namespace {

using Answer = std::array<double, most_answers>;

double size_of(const Plane& v) {
  const Real size = std::hypot(v.x(), v.y());
  return std::isfinite(size) ? static_cast<double>(size) : 0;
}

/// Exponents of L and R in the force scale.
struct ScaleExponents {
  Real length, radius;
};
ScaleExponents exponents_of(Law law) { return is_short(law) ? ScaleExponents{3, 1} : ScaleExponents{1, 3}; }

/// Of a force from a motion in the plane [N].
template <class FilmLaw>
double plane_conditioning(const Solution& s) {
  using D = Dual<Real, 4>;
  const Real c = s.film_clearance, mean_spin = (s.omega_bearing + s.omega_journal) / 2;
  const Plane e(s.e.x() / c, s.e.y() / c);
  const Plane u(s.v.x() / c + mean_spin * e.y(), s.v.y() / c - mean_spin * e.x());
  const FilmState<D> film({D::variable(e.x(), 0), D::variable(e.y(), 1)},
                          {D::variable(u.x(), 2), D::variable(u.y(), 3)});
  const Vector2<D> ratio = force_ratio<FilmLaw>(film);
  const auto slope = [&](Eigen::Index k) {
    return Plane(s.scale * ratio.x().derivatives()[k], s.scale * ratio.y().derivatives()[k]);
  };
  const auto times = [](Real x, const Plane& v) { return x == 0 ? Plane(0, 0) : Plane(x * v); };
  const Plane along_e = times(e.x(), slope(0)) + times(e.y(), slope(1));
  const Plane along_u = times(u.x(), slope(2)) + times(u.y(), slope(3));
  const Plane turning = times(e.y() / 2, slope(2)) - times(e.x() / 2, slope(3));  // ∂F/∂ω of either spin
  const auto [of_length, of_radius] = exponents_of(s.law);
  return (1 + static_cast<double>(of_length + of_radius)) * size_of(s.force) +  // viscosity, length, radius
         size_of(Plane(-2 * s.force - along_e - along_u)) +                     // clearance
         size_of(times(e.x(), slope(0)) - times(e.x() * mean_spin, slope(3))) +
         size_of(times(e.y(), slope(1)) + times(e.y() * mean_spin, slope(2))) + size_of(times(s.v.x() / c, slope(2))) +
         size_of(times(s.v.y() / c, slope(3))) + size_of(times(s.omega_bearing, turning)) +
         size_of(times(s.omega_journal, turning));
}

/// Of a force from ε and rates [N].
template <class FilmLaw>
double polar_conditioning(const Solution& s) {
  using D = Dual<Real, 3>;
  const PolarForce<D> ratio =
      polar_force_ratio<FilmLaw>(PolarFilmState<D>(D::variable(s.ratio, 0), D::variable(s.a, 1), D::variable(s.b, 2)));
  const auto slope = [&](Eigen::Index k) {
    return Plane(s.scale * ratio.radial.derivatives()[k], s.scale * ratio.tangential.derivatives()[k]);
  };
  const auto [of_length, of_radius] = exponents_of(s.law);
  return (3 + static_cast<double>(of_length + of_radius)) * size_of(s.force) +  // viscosity, length, radius, clearance
         size_of(Plane(s.ratio * slope(0) + s.a * slope(1))) + size_of(Plane(s.b * slope(2))) +
         size_of(Plane(s.spin_part * slope(1))) + size_of(Plane(s.attitude_part * slope(1)));
}

constexpr double step = 0x1p-24;  // far below the distance to any seam; half the digits of a tolerance are enough

/// How far the columns of a table move, those of a group together.
void add_difference(const Solution& from, const Solution& to, Answer& sum) {
  for (std::size_t k = 0; k < answer_columns(from.quantities).size(); ++k) {
    const ColumnGroup group = group_of(from.quantities, k);
    Real square = 0;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      square += (to.answer[i] - from.answer[i]) * (to.answer[i] - from.answer[i]);
    }
    if (!std::isnan(square)) sum[k] += static_cast<double>(std::sqrt(square) / step);
  }
}

/// Of a table: the inputs, and under a load ε, too, which a program works out and rounds.
Answer of_table(const State& state, const Solution& s) {
  Answer sum{};
  for (const StateColumn& column : state_columns(s.quantities)) {
    if (state.*column.value == 0) continue;
    State moved = state;
    moved.*column.value *= 1 - step;
    Solution there = solve(s.quantities, s.law, moved);
    if (!(there.q() > 0)) {
      moved.*column.value = state.*column.value * (1 + step);
      there = solve(s.quantities, s.law, moved);
    }
    add_difference(s, there, sum);
  }
  if (!is_of_load(s.quantities)) return sum;
  const Change rounded{Step::kinematics, [](Solution& there) {
                         there.ratio_gap += step * there.ratio;
                         there.ratio -= step * there.ratio;
                       }};
  add_difference(s, solve(s.quantities, s.law, state, std::span(&rounded, 1)), sum);
  return sum;
}

Answer by_differences(const State& state, const Solution& s) {
  Answer sum{};
  const std::size_t columns = answer_columns(s.quantities).size();
  for (const StateColumn& column : state_columns(s.quantities)) {
    const double given = state.*column.value;
    if (given == 0) continue;
    State moved = state;
    moved.*column.value = given * (1 - step);
    std::array<Real, most_answers> answer = solve(s.quantities, s.law, moved).answer;
    if (std::isnan(answer[0])) {
      moved.*column.value = given * (1 + step);
      answer = solve(s.quantities, s.law, moved).answer;
    }
    const double plane = static_cast<double>(std::hypot(answer[0] - s.answer[0], answer[1] - s.answer[1]) / step);
    sum[0] += plane;
    sum[1] += plane;
    for (std::size_t k = 2; k < columns; ++k) sum[k] += static_cast<double>(std::abs(answer[k] - s.answer[k]) / step);
  }
  return sum;
}

Answer of_formula(const State& state, const Solution& s) {
  if (is_table(s.quantities)) return of_table(state, s);
  if (!is_film_force(s.quantities)) return by_differences(state, s);
  const double force = with_film_law<StateFilmLaws>(name_of(s.law), [&]<class FilmLaw>() {
    return is_polar(s.quantities) ? polar_conditioning<FilmLaw>(s) : plane_conditioning<FilmLaw>(s);
  });
  Answer result{force, force};
  if (s.quantities != Quantities::wrench) return result;
  // Moments s × F: the force's, and the arm's own rounding once for each of its numbers.
  const double size = size_of(s.force), e = size_of(s.e);
  const double arms[2] = {size_of(s.arm_bearing) + e, size_of(s.arm_journal)};
  for (std::size_t k = 0; k < 2; ++k) result[2 + k] = arms[k] * (force + 2 * size);
  return result;
}

/// The formula whose answers move with their inputs about as those of a film that a solver knows.
Law formula_like(Law film) {
  if (is_full(film)) return "long_full"_law;
  return is_half(film) ? "long_half"_law : "long_dynamic"_law;
}

/// What the columns are as large as: of losses each for itself; of pressures the film's largest, of forces the film's.
std::array<Real, most_answers> film_sizes(const Solution& s) {
  std::array<Real, most_answers> sizes;
  if (s.quantities == Quantities::losses) {
    std::ranges::copy(size_of_costs(s), sizes.begin());
  } else {
    sizes.fill(s.quantities == Quantities::pressure ? s.pressure_terms : std::hypot(s.radial, s.tangential));
  }
  return sizes;
}

/// Of a film that a solver knows: a difference of solutions would be their noise. The formula's, as many times as its
/// answers are larger.
Answer like_a_formula(const State& state, const Solution& s) {
  const Solution formula = solve(s.quantities, formula_like(s.law), state);
  Answer sum = of_formula(state, formula);
  const std::array<Real, most_answers> sizes = film_sizes(s), formula_sizes = film_sizes(formula);
  for (std::size_t k = 0; k < answer_columns(s.quantities).size(); ++k) {
    if (formula_sizes[k] > 0) sum[k] *= static_cast<double>(sizes[k] / formula_sizes[k]);
  }
  return sum;
}

}  // namespace

Answer input_conditioning(const State& state, const Solution& s) {
  if (std::isnan(s.answer[0])) return {};
  // A load's is by differences of tables, which are smooth; a film's ends are the formula's.
  const bool is_solved = !is_of_load(s.quantities) && s.quantities != Quantities::extent && is_solved_film(s.law);
  return is_solved ? like_a_formula(state, s) : of_formula(state, s);
}

}  // namespace lubjoint::verify
