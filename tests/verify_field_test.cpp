#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/film/extent.hpp"
#include "support/verify_answers.hpp"

namespace verify_field_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;

TEST_CASE("verify: the pressures that it expects have the law's force as their integral") {
  for (const std::string_view law : film_law_names) {
    if (law == "pinkus_sternlicht") continue;
    for (const auto& [ratio, omega, attitude_rate, b] : std::vector<std::array<double, 4>>{
             {0.5, 3, 0.5, 1}, {0.7, -2, 0.25, 0.5}, {0.25, 1, 1, -2}, {0.6, 5, -2, -1}}) {
      State s;
      s.viscosity = 0.04, s.length = 0.04, s.radius = 0.01, s.clearance = 2e-4;
      s.eccentricity_ratio = ratio, s.omega = omega, s.attitude_rate = attitude_rate, s.squeeze_rate = b;
      const Solution ends = solve(Quantities::extent, law_of(law), s);
      Real radial = 0, tangential = 0;
      constexpr int steps = 20000;
      const Real width = (ends.theta_e - ends.theta_s) / steps;
      for (int i = 0; i < steps; ++i) {
        s.theta = static_cast<double>(ends.theta_s + (i + 0.5L) * width);
        const Real p = solve(Quantities::pressure, law_of(law), s).answer[0];
        radial += p * std::cos(Real(s.theta)) * width * s.radius;
        tangential += p * std::sin(Real(s.theta)) * width * s.radius;
      }
      const Real axial = is_short(law_of(law)) ? 2 * s.length / 3 : s.length;  // of a parabola; of a constant
      const auto force = library_answer<long double>(Quantities::polar, law, s);
      INFO(law << " at " << ratio << ", squeeze rate " << b);
      const Real size = std::hypot(force[0], force[1]);
      CHECK(std::abs(axial * radial - force[0]) <= 1e-6L * size);      // midpoint rule, 20000 steps: h²
      CHECK(std::abs(axial * tangential - force[1]) <= 1e-6L * size);  // the same
    }
  }
}

TEST_CASE("verify: the film's ends that it expects are the library's") {
  const std::vector<State> states = states_to_verify(Quantities::extent, 200, 1);
  for_each_film_law([&]<class Law>() {
    for (const State& s : states) {
      const long double ratio = s.eccentricity_ratio;
      const PolarFilmState<long double> state(ratio, ratio * (s.omega - 2 * static_cast<long double>(s.attitude_rate)),
                                              static_cast<long double>(s.squeeze_rate));
      const FilmBounds<long double> bounds = film_bounds(Law::extent, state);
      const Solution ends = solve(Quantities::extent, law_of(Law::name), s);
      CHECK(std::abs(bounds.start - ends.theta_s) <= 1e-18L);  // two roundings of long double
      CHECK(std::abs(bounds.end - ends.theta_e) <= 1e-18L);    // the same
    }
  });
}

TEST_CASE("verify: pressures are refused for the law that has none") {
  CHECK_THROWS_WITH(verified(Quantities::pressure, "pinkus_sternlicht", designed_states(Quantities::pressure), {}),
                    Catch::Contains("pinkus_sternlicht"));
}

namespace {

/// θs, or the short dynamic film's pressure, as a program in T computes them.
template <class T>
std::array<T, most_answers> short_dynamic(Quantities quantities, const State& s) {
  const auto t = [](double x) { return static_cast<T>(x); };
  const T ratio = t(s.eccentricity_ratio), b = t(s.squeeze_rate);
  const T a = ratio * (t(s.omega) - 2 * t(s.attitude_rate));
  const T start = std::atan2(2 * b, a);
  if (quantities == Quantities::extent) return {start, start + pi<T>(), 0, 0};
  const T h = t(s.clearance) * (1 + ratio * std::cos(t(s.theta)));
  const T source = a * std::sin(t(s.theta)) - 2 * b * std::cos(t(s.theta));
  const T p =
      3 * t(s.viscosity) * t(s.clearance) / (h * h * h) * (t(s.length) * t(s.length) / 4 - t(s.z) * t(s.z)) * source;
  return {std::max(p, T(0)), 0, 0, 0};
}

}  // namespace

TEST_CASE("verify: correct pressures and ends of the film pass in double, in single, and printed with seven digits") {
  for (const Quantities quantities : {Quantities::extent, Quantities::pressure}) {
    const std::vector<State> states = states_to_verify(quantities, 2000, 6);
    const auto check = [&](const Answers& answers, const std::string& words) {
      const Verification v = verified(quantities, "short_dynamic", states, answers);
      INFO(text_report(v));
      CHECK(v.verdict == Verdict::agrees);
      CHECK_THAT(v.judgement.precision.words(), Catch::StartsWith(words));
    };
    const Answers in_double =
        answers_of(quantities, states, [&](const State& s) { return short_dynamic<double>(quantities, s); });
    check(in_double, "double precision");
    check(through_text(quantities, in_double, "{:.7g}"), "double precision, 7 digits");
    check(answers_of(quantities, states, [&](const State& s) { return short_dynamic<float>(quantities, s); }),
          "single precision");
  }
}

}  // namespace verify_field_test
