#include "oracle/reynolds/film_sums.hpp"

#include <limits>
#include <numbers>

#include "oracle/quadrature/gauss_legendre.hpp"
#include "oracle/quadrature/quadrature_error.hpp"
#include "oracle/reynolds/pressure_slope.hpp"

namespace lubjoint::oracle {

namespace {

constexpr std::size_t first_rung = 1;  // 32 points on each side of the minimum film

/// Rounding of a sum over its magnitude: H³ is four roundings from the state and the weights are a few from φ.
constexpr double rounding_units = 8 * std::numeric_limits<double>::epsilon();

/// Climbs the ladder of Gauss–Legendre rules until two rungs agree.
template <class SumsOnRung>
FilmPair climb(const SumsOnRung& sums_on_rung, const FilmWindow& window, double relative_tolerance) {
  FilmSums coarse = sums_on_rung(first_rung);
  double difference = 0;
  for (std::size_t rung = first_rung + 1; rung < gauss_legendre_ladder.size(); ++rung) {
    const FilmSums fine = sums_on_rung(rung);
    std::array<double, 2> error{};
    for (std::size_t i = 0; i < 2; ++i) error[i] = std::abs(fine.value[i] - coarse.value[i]);
    difference = std::max(error[0], error[1]);
    const double rounding = rounding_units * fine.largest_magnitude();
    if (difference <= std::max(relative_tolerance * fine.norm(), rounding)) {
      return {{fine.value[0], error[0] + rounding_units * fine.magnitude[0]},
              {fine.value[1], error[1] + rounding_units * fine.magnitude[1]}};
    }
    coarse = fine;
  }
  const Request request{"Gauss-Legendre over the film", window.from, window.to, {relative_tolerance, 0}};
  fail_before_tolerance(request, {coarse.norm(), difference});
}

/// The scalar rules do one component at a time; the size of the whole, for their tolerance, is that of a fixed rule.
template <class Component>
FilmPair componentwise(const Component& component, const FilmSums& preview, const NarrowGap& gap,
                       const FilmWindow& window, const FilmRule& rule, double relative_tolerance) {
  const auto estimate = [&](std::size_t i) {
    const double below_rounding = rounding_units * preview.magnitude[i];
    const Tolerance tolerance{0, std::max(relative_tolerance * preview.norm(), below_rounding)};
    if (preview.magnitude[i] == 0) return Estimate{};
    Estimate answer = rule.integrator(
        rule.rule, gap, window, [&](double phi) { return component(phi, i); }, tolerance);
    // An adaptive rule's estimate is at times far below its error, by luck of its nodes. No more is claimed than was
    // asked.
    answer.error = std::max(answer.error, tolerance.absolute) + below_rounding;
    return answer;
  };
  return {estimate(0), estimate(1)};
}

FilmSums add_up(const KnownPressure& pressure, const FilmNodes& nodes) {
  FilmSums sums;
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
    const FilmSums terms = pressure.terms(nodes.phi[n]);
    for (std::size_t i = 0; i < 2; ++i) {
      sums.value[i] += nodes.weight[n] * terms.value[i];
      sums.magnitude[i] += nodes.weight[n] * terms.magnitude[i];
    }
  }
  return sums;
}

/// −∫ (G − Ḡ)(X − X̄)/H³ and −∫ (G − Ḡ)(Y − Ȳ)/H³ at one place.
FilmSums slope_terms(const PressureSlope& slope, const PressureSlope::Place& p, const WeightedMeans& means) {
  const PressureSlope::Place mean{means.x, means.y, 0};
  const double g_mean = slope.g(mean);
  const double g_size = slope.g_magnitude(p) + slope.g_magnitude(mean);
  const double g = slope.g(p) - g_mean;
  const double x = p.x - means.x;
  const double y = p.y - means.y;
  FilmSums terms;
  terms.value = {-p.weight * g * x, -p.weight * g * y};
  terms.magnitude = {p.weight * (std::abs(g) * (std::abs(p.x) + std::abs(means.x)) + g_size * std::abs(x)),
                     p.weight * (std::abs(g) * (p.y + means.y) + g_size * std::abs(y))};
  return terms;
}

struct SlopeSums {
  FilmSums covariances;
  WeightedMeans means;
  double weight = 0;
};

SlopeSums add_up(const PressureSlope& slope, const FilmNodes& nodes) {
  thread_local std::vector<PressureSlope::Place> places;
  places.clear();
  SlopeSums sums;
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
    PressureSlope::Place place = slope.at(nodes.phi[n]);
    place.weight *= nodes.weight[n];
    sums.weight += place.weight;
    sums.means.x += place.weight * place.x;
    sums.means.y += place.weight * place.y;
    places.push_back(place);
  }
  sums.means.x /= sums.weight;
  sums.means.y /= sums.weight;
  for (const PressureSlope::Place& place : places) {
    const FilmSums terms = slope_terms(slope, place, sums.means);
    for (std::size_t i = 0; i < 2; ++i) {
      sums.covariances.value[i] += terms.value[i];
      sums.covariances.magnitude[i] += terms.magnitude[i];
    }
  }
  return sums;
}

/// Means by a scalar rule. An error δ in each mean changes a covariance by the product of two δ only.
WeightedMeans means_by(const FilmRule& rule, const PressureSlope& slope, const SlopeSums& preview, const NarrowGap& gap,
                       const FilmWindow& window, double relative_tolerance) {
  const auto moment = [&](const auto& coordinate, double size) {
    const Tolerance tolerance{0, std::max(relative_tolerance, rounding_units) * size};
    return rule
        .integrator(
            rule.rule, gap, window,
            [&](double phi) {
              const PressureSlope::Place p = slope.at(phi);
              return p.weight * coordinate(p);
            },
            tolerance)
        .value;
  };
  const double weight = moment([](const PressureSlope::Place&) { return 1.0; }, preview.weight);
  // X is odd about the minimum film: its mean may vanish, so its size is taken from Y ~ X²/2.
  const double x_size = preview.weight * std::sqrt(2 * preview.means.y);
  const double x = moment([](const PressureSlope::Place& p) { return p.x; }, x_size);
  const double y = moment([](const PressureSlope::Place& p) { return p.y; }, preview.weight * preview.means.y);
  return {x / weight, y / weight};
}

}  // namespace

KnownPressure::Parts KnownPressure::pressure(const GapPlace& place) const {
  if (is_short_) {
    const double h3 = place.cubed_thickness();
    return {place.wedge / h3, place.squeeze / h3};
  }
  const double h = place.thickness;
  const double widest = 1 + gap_.epsilon();
  const double d = 2 + gap_.epsilon() * gap_.epsilon();
  return {place.wedge * (1 + h) / (d * h * h),
          gap_.squeeze() * place.one_plus_cos * (h + widest) / (h * h * widest * widest)};
}

FilmSums KnownPressure::terms(double phi) const {
  const GapPlace place = gap_.at(phi);
  const Parts p = pressure(place);
  FilmSums terms;
  if (folded_) {
    terms.value = {-p.squeeze * place.cos, -p.wedge * place.sin};
    terms.magnitude = {std::abs(terms.value[0]), std::abs(terms.value[1])};
    return terms;
  }
  const double sum = p.wedge + p.squeeze;
  const double size = std::abs(p.wedge) + std::abs(p.squeeze);
  terms.value = {-sum * place.cos, -sum * place.sin};
  terms.magnitude = {size * std::abs(place.cos), size * std::abs(place.sin)};
  return terms;
}

FilmPair integrate_known_pressure(const KnownPressure& pressure, const NarrowGap& gap, const FilmWindow& window,
                                  const FilmRule& rule, double relative_tolerance) {
  const FilmWindow side = pressure.folded() ? FilmWindow{0, window.to} : window;
  thread_local FilmNodes nodes;
  const auto on_rung = [&](std::size_t rung) {
    place_film_nodes(gap, side, rung, nodes);
    return add_up(pressure, nodes);
  };
  if (rule.rule == FilmQuadratureRule::gauss_legendre) return climb(on_rung, side, relative_tolerance);
  const FilmSums preview = on_rung(first_rung + 1);
  const auto component = [&](double phi, std::size_t i) { return pressure.terms(phi).value[i]; };
  if (rule.rule != FilmQuadratureRule::trapezoid) {
    return componentwise(component, preview, gap, side, rule, relative_tolerance);
  }
  FilmPair turn = componentwise(component, preview, gap, window, rule, relative_tolerance);
  for (Estimate* e : {&turn.first, &turn.second}) *e = {0.5 * e->value, 0.5 * e->error};
  return turn;
}

FilmPair integrate_pressure_slope(const NarrowGap& gap, const FilmWindow& window, bool edges_are_zeros,
                                  const FilmRule& rule, double relative_tolerance) {
  const PressureSlope slope(gap, window, edges_are_zeros);
  thread_local FilmNodes nodes;
  const auto on_rung = [&](std::size_t rung) {
    place_film_nodes(gap, window, rung, nodes);
    return add_up(slope, nodes);
  };
  FilmPair pair;
  if (rule.rule == FilmQuadratureRule::gauss_legendre) {
    pair = climb([&](std::size_t rung) { return on_rung(rung).covariances; }, window, relative_tolerance);
  } else {
    const SlopeSums preview = on_rung(first_rung + 1);
    const WeightedMeans means = means_by(rule, slope, preview, gap, window, relative_tolerance);
    const auto component = [&](double phi, std::size_t i) { return slope_terms(slope, slope.at(phi), means).value[i]; };
    pair = componentwise(component, preview.covariances, gap, window, rule, relative_tolerance);
  }
  // From the axes at φ₀ to σ = sinφ = sinφ₀ (1 − Y) + cosφ₀ X and 1 − cosφ = 1 − cosφ₀ (1 − Y) + sinφ₀ X.
  const double s = slope.sin_origin();
  const double c = slope.cos_origin();
  const auto combined = [&](double with_x, double with_y) {
    return Estimate{with_x * pair.first.value + with_y * pair.second.value,
                    std::abs(with_x) * pair.first.error + std::abs(with_y) * pair.second.error};
  };
  return {combined(c, -s), combined(s, c)};
}

}  // namespace lubjoint::oracle
