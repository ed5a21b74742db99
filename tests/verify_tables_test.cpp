// Tables: stiffness and damping, equilibrium, losses. What answers are judged by comes from the pressure, what they are
// compared with in search of a mistake from closed forms, and the library has a third way.
#include <catch2/catch.hpp>

#include "lubjoint/film/coefficients.hpp"
#include "lubjoint/film/losses.hpp"
#include "oracle/verify/states/golden_states.hpp"
#include "oracle/verify/states/losses_oracle.hpp"
#include "oracle/verify/states/steady_slopes.hpp"
#include "support/verify_answers.hpp"

namespace verify_tables_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

constexpr std::array tables = {Quantities::coefficients, Quantities::equilibrium, Quantities::losses};

bool has_table(Quantities quantities, Law law) { return !is_of_load(quantities) || has_rest(law); }

/// The library's answer in its own precision T, ε taken from elsewhere: a root of two lines.
template <class T>
std::array<T, most_answers> library_table(Quantities quantities, Law law, const State& s, RestPlace place) {
  const auto t = [](double x) { return static_cast<T>(x); };
  const Bearing<T> bearing{t(s.length), t(s.radius), t(s.clearance)};
  const Lubricant<T> oil{t(s.viscosity)};
  if (quantities == Quantities::losses) {
    return with_film_law<StateFilmLaws>(name_of(law), [&]<class F>() -> std::array<T, most_answers> {
      const JournalMotion<T> motion{{t(s.ex), t(s.ey)}, {t(s.vx), t(s.vy)}, t(s.omega_bearing), t(s.omega_journal)};
      const FilmState<T> film = film_state(motion, bearing.clearance());
      const FilmLosses<T> l = film_losses<F>(bearing, oil, film, T(t(s.omega_journal) - t(s.omega_bearing)), s.shear);
      return {l.torque_journal, l.torque_bearing, l.power(),
              side_flow<F>(bearing, film).value_or(std::numeric_limits<T>::quiet_NaN())};
    });
  }
  return with_film_law(name_of(law), [&]<class F>() -> std::array<T, most_answers> {
    const T ratio = static_cast<T>(place.ratio), gap = static_cast<T>(place.gap);
    const SteadyFilm<T> rest = steady_film<F, T>(bearing, oil, SteadyPlace<T>(ratio, T(gap * (1 + ratio))), t(s.omega));
    // x along the load, here −y; y along x.
    const auto &k = rest.stiffness, &c = rest.damping;
    return {ratio, rest.attitude, k(1, 1), -k(1, 0), -k(0, 1), k(0, 0), c(1, 1), -c(1, 0), -c(0, 1), c(0, 0)};
  });
}

RestPlace place_of(Quantities quantities, Law law, const State& state) {
  if (!is_of_load(quantities)) return {};
  const Solution s = solve(quantities, law, state);
  return {s.ratio, s.ratio_gap};
}

std::string first_suspicion(const Verification& v) {
  if (v.suspicions.empty()) return "nothing";
  std::string names;
  for (const Mistake* m : v.suspicions[0].mistakes) names += std::string(m->name) + " ";
  return names;
}

void check_all_mistakes(Quantities quantities, std::size_t at_least) {
  const std::vector<State> states = states_to_verify(quantities, 0, 5);
  for (std::size_t i = 0; i < law_count; ++i) {
    const Law law{i};
    if (!has_table(quantities, law)) continue;
    const auto known = mistakes_for(quantities, law);
    std::size_t of_its_own = 0;
    for (const Mistake* mistake : known) {
      if (!mistake->applies(Quantities::cartesian, law)) ++of_its_own;
      INFO(name_of(law) << " with " << mistake->name);
      const Verification v =
          verified(quantities, name_of(law), states, mistaken_answers(quantities, law, states, {mistake}));
      const bool of_other_shear = mistake->name == "shear_of_film_alone" ||
                                  (mistake->name == "shear_of_half_gap" && is_half(law));  // asked for below
      if (of_other_shear) continue;
      REQUIRE(v.verdict == Verdict::disagrees);
      INFO("taken for " << first_suspicion(v));
      REQUIRE(!v.suspicions.empty());
      CHECK(v.suspicions[0].names({mistake}));
      CHECK(v.suspicions[0].explains_all());
    }
    INFO(name_of(law));
    CHECK(of_its_own >= at_least);
  }
}

}  // namespace

TEST_CASE("verify tables: slopes from the pressure are those of the closed forms, for every law that carries a load") {
  for (std::size_t i = 0; i < law_count; ++i) {
    const Law law{i};
    if (!has_rest(law)) continue;
    for (const Real gap : {0.9999L, 0.99L, 0.7L, 0.4L, 0.1L, 0.01L, 1e-3L, 1e-5L}) {
      const Real ratio = 1 - gap;
      const SteadySlopes closed = published_slopes(law, ratio, gap), summed = slopes_by_quadrature(law, ratio, gap);
      INFO(name_of(law) << " at 1 - e/c " << static_cast<double>(gap));
      const auto near = [&](Real x, Real y, Real size) {
        CHECK(static_cast<double>(std::abs(x - y)) <= static_cast<double>(1e-17L / gap * size));  // as it says
      };
      const Real size =
          std::abs(closed.radial_by_ratio) + std::abs(closed.tangential_by_ratio) + std::abs(closed.radial_by_squeeze);
      near(closed.radial, summed.radial, size);
      near(closed.tangential, summed.tangential, size);
      near(closed.radial_by_ratio, summed.radial_by_ratio, size);
      near(closed.tangential_by_ratio, summed.tangential_by_ratio, size);
      near(closed.radial_by_slip, summed.radial_by_slip, size);
      near(closed.tangential_by_slip, summed.tangential_by_slip, size);
      near(closed.radial_by_squeeze, summed.radial_by_squeeze, size);
      near(closed.tangential_by_squeeze, summed.tangential_by_squeeze, size);
    }
  }
}

TEST_CASE("verify tables: the library's coefficients and losses agree in double, printed, and rounded to single") {
  for (const Quantities quantities : tables) {
    const std::vector<State> states = states_to_verify(quantities, 300, 9);
    for (std::size_t i = 0; i < law_count; ++i) {
      const Law law{i};
      if (!has_table(quantities, law)) continue;
      INFO(name_of(quantities) << " " << name_of(law));
      const Answers exact = answers_of(quantities, states, [&](const State& s) {
        return library_table<double>(quantities, law, s, place_of(quantities, law, s));
      });
      const Verification v = verified(quantities, name_of(law), states, exact);
      INFO(text_report(v));
      CHECK(v.verdict == Verdict::agrees);
      CHECK(20 * v.judgement.undecided <= states.size());
      CHECK(verified(quantities, name_of(law), states, through_text(quantities, exact, "{:.6e}")).verdict ==
            Verdict::agrees);
      Answers single = exact;
      for (Answer& answer : single.values) {
        for (double& x : answer) x = static_cast<float>(x);
      }
      single = answers_from_numbers(quantities, std::move(single.values));
      CHECK(verified(quantities, name_of(law), states, single).verdict == Verdict::agrees);
    }
  }
}

TEST_CASE("verify tables: flooded and striated shear are judged by what is sheared beyond the film") {
  std::vector<State> states = states_to_verify(Quantities::losses, 50, 9);
  for (const ShearExtent shear : {ShearExtent::flooded, ShearExtent::striated}) {
    for (State& state : states) state.shear = shear, state.golden.reset();
    for (const std::string_view name : {"short_half", "long_half_eq5"}) {
      const Law law = law_of(name);
      INFO(name << " " << shear_extent_names[static_cast<std::size_t>(shear)]);
      const Answers right = answers_of(Quantities::losses, states, [&](const State& s) {
        return library_table<double>(Quantities::losses, law, s, {});
      });
      CHECK(verified(Quantities::losses, name, states, right).verdict == Verdict::agrees);
      const Answers of_film = answers_of(Quantities::losses, states, [&](State s) {
        s.shear = ShearExtent::film;
        return library_table<double>(Quantities::losses, law, s, {});
      });
      const Verification wrong = verified(Quantities::losses, name, states, of_film);
      CHECK(wrong.verdict == Verdict::disagrees);
      CHECK(wrong.suspicions.at(0).names({&mistake_of("shear_of_film_alone")}));
    }
  }
}

TEST_CASE("verify tables: certified losses, equilibria and contacts are its own quadrature's") {
  for (const Quantities quantities : {Quantities::losses, Quantities::equilibrium, Quantities::contact}) {
    const std::vector<State> states = golden_states(quantities, golden_folder());
    CHECK(states.size() >= 15);
    std::size_t certified = 0;
    for (const State& state : states) {
      for (std::size_t i = 0; i < every_law_count; ++i) {
        if (!state.golden->row[i]) continue;
        ++certified;
        State bare = state;
        bare.golden.reset();
        const Reference own = references(quantities, Law{i}, {bare})[0],
                        given = references(quantities, Law{i}, {state})[0];
        INFO(name_of(Law{i}) << ", " << state.golden->file << ", line " << state.golden->row[i]->line);
        CHECK(given.golden != nullptr);
        for (std::size_t k = 0; k < answer_columns(quantities).size(); ++k) {
          if (std::isnan(given.expected[k])) continue;
          const double error = static_cast<double>(std::abs(own.expected[k] - given.expected[k]));
          CHECK(error <= own.error[k] + 0x1p-63 * own.sensitivity[k]);  // its own, and rounding of long double
        }
      }
    }
    CHECK(certified >= (quantities == Quantities::contact ? 70 : 60));
  }
}

TEST_CASE("gallery: every mistake about stiffness and damping is caught and named first, for every law") {
  check_all_mistakes(Quantities::coefficients, 21);
}
TEST_CASE("gallery: every mistake about a place of rest is caught and named first, for every law") {
  check_all_mistakes(Quantities::equilibrium, 8);
}
TEST_CASE("gallery: every mistake about torques, power and flow is caught and named first, for every law") {
  check_all_mistakes(Quantities::losses, 11);
}

TEST_CASE("gallery: every mistake about dry contact is caught and named first, for every law of contact") {
  const std::vector<State> states = states_to_verify(Quantities::contact, 40, 5);
  for (std::size_t i = law_count; i < every_law_count; ++i) {
    const Law law{i};
    const auto known = mistakes_for(Quantities::contact, law);
    CHECK(known.size() >= 15);
    CHECK(verified(Quantities::contact, name_of(law), states, mistaken_answers(Quantities::contact, law, states, {}))
              .verdict == Verdict::agrees);
    for (const Mistake* mistake : known) {
      INFO(name_of(law) << " with " << mistake->name);
      const Verification v = verified(Quantities::contact, name_of(law), states,
                                      mistaken_answers(Quantities::contact, law, states, {mistake}));
      REQUIRE(v.verdict == Verdict::disagrees);
      INFO("taken for " << first_suspicion(v));
      REQUIRE(!v.suspicions.empty());
      CHECK(v.suspicions[0].names({mistake}));
    }
  }
}

TEST_CASE(
    "verify: a free impact by Gonthier's law gives back exactly its restitution, by Lankarani and Nikravesh's not") {
  // v dv/dδ = −(K/m)δ^{3/2}(1 + χv/v₀) has the first integral of χv/v₀ − log(1 + χv/v₀): v₀ in, −v₁ out.
  for (const double restitution : {0.05, 0.3, 0.5, 0.8, 0.95}) {
    for (std::size_t i = law_count; i < every_law_count; ++i) {
      const auto chi = static_cast<double>(contact_loss(Law{i}, restitution));
      const auto left = [=](double out) { return chi - std::log1p(chi) + chi * out + std::log1p(-chi * out); };
      double low = 0, high = std::min(1.0, 1 / chi);  // at 0 left is positive, at 1 or 1/χ it is not
      for (int k = 0; k < 60; ++k) (left((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
      INFO(name_of(Law{i}) << " at restitution " << restitution);
      if (name_of(Law{i}) == "gonthier") {
        CHECK(std::abs(low - restitution) < 1e-14);
      } else if (name_of(Law{i}) == "lankarani_nikravesh" && restitution <= 0.5) {
        CHECK(std::abs(low - restitution) > 1e-3);
      }
    }
  }
}

TEST_CASE("gallery: how far (1 − c_r²)/c_r is off Gonthier's loss is what its mistake says") {
  const std::string_view said = mistake_of("contact_law_gonthier_approximate").symptom;
  for (const auto& [restitution, percent, words] :
       {std::tuple{0.95L, 30, "exceeded by 30 % at c_r = 0.95"}, std::tuple{0.8L, 21, "by 21 % at 0.8"},
        std::tuple{0.5L, 5, "by 5 % at 0.5"}, std::tuple{0.2L, -2, "missed by 2 % at 0.2"}}) {
    const Real off =
        (1 - restitution) * (1 + restitution) / restitution / contact_loss("gonthier"_law, restitution) - 1;
    CHECK(std::abs(100 * off - percent) < 0.5L);  // half of the last digit that is printed
    CHECK_THAT(std::string(said), Contains(words));
  }
}

TEST_CASE("verify tables: one entry off by a thousandth for one sense of the spin is caught, whichever it is") {
  const std::vector<State> states = states_to_verify(Quantities::coefficients, 50, 3);
  for (const std::string_view name : {"short_half", "long_dynamic"}) {
    const Answers right = mistaken_answers(Quantities::coefficients, law_of(name), states, {});
    for (const std::size_t k : all_columns(Quantities::coefficients)) {
      for (const double factor :
           {1.001, 1.05}) {  // the larger one leaves no digits that a numerical program might have
        Answers wrong = right;
        for (std::size_t i = 0; i < states.size(); ++i) {
          if (states[i].omega < 0) wrong.values[i][k] *= factor;
        }
        INFO(name << " " << answer_columns(Quantities::coefficients)[k] << " times " << factor);
        const Verification v = verified(Quantities::coefficients, name, states, wrong);
        CHECK(v.verdict == Verdict::disagrees);
        if (factor > 1.01) CHECK(words(v.wrong_where) == "omega < 0");
      }
    }
  }
}

TEST_CASE("verify tables: any columns may be given, and none, unknown ones and a long bearing's flow are refused") {
  const std::vector<State> states = states_to_verify(Quantities::losses, 0, 1);
  const Answers all = mistaken_answers(Quantities::losses, "long_half"_law, states, {});
  std::string power = "power\n", flow = "id,side_flow\n", full = "id,torque_journal,power,side_flow\n";
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::string id = std::to_string(i + 1);
    power += fmt::format("{}\n", all.values[i][2]);
    flow += id + ",1\n";
    full += fmt::format("{},{},{},\n", id, all.values[i][0], all.values[i][2]);
  }
  const auto read = [&](const std::string& csv) {
    return read_answers(Quantities::losses, csv, "answers", states.size());
  };
  CHECK(read(power).columns == std::vector<std::size_t>{2});
  CHECK(verified(Quantities::losses, "long_half", states, read(power)).verdict == Verdict::agrees);
  CHECK(verified(Quantities::losses, "long_half", states, read(full)).verdict == Verdict::agrees);
  CHECK_THROWS_WITH(verified(Quantities::losses, "long_half", states, read(flow)), Contains("side_flow alone"));
  CHECK_THROWS_WITH(read("id,heat\n1,2\n"),
                    Contains("none of the columns is there") && Contains("any of torque_journal"));
  CHECK_THROWS_WITH(verified(Quantities::equilibrium, "squeeze_short", {}, {}), Contains("carries no load"));
}

}  // namespace verify_tables_test
