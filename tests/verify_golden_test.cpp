// The golden data as questions of `verify`.
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/film/law_facts.hpp"
#include "oracle/verify/states/golden_states.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/verify_answers.hpp"

namespace verify_golden_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;

namespace {

constexpr Quantities every_quantity[] = {Quantities::cartesian,  Quantities::polar,  Quantities::wrench,
                                         Quantities::transition, Quantities::extent, Quantities::pressure};

/// A copy of the golden data in which a text of one file is replaced, once.
void copy_changed(const TemporaryFolder& folder, const std::string& file, const std::string& from,
                  const std::string& to) {
  for (const auto& entry : std::filesystem::directory_iterator(golden_folder())) {
    if (entry.is_regular_file()) std::filesystem::copy_file(entry.path(), folder.path() / entry.path().filename());
  }
  std::string text = read_text(golden_folder() / file);
  const std::size_t place = text.find(from);
  REQUIRE(place != std::string::npos);
  folder.write(file, text.replace(place, from.size(), to));
}

}  // namespace

TEST_CASE("golden forces without dimensions: over S omega they are those that data/README.md makes of them") {
  std::size_t compared = 0;
  for (const CsvRow& row : parse_csv(read_text(golden_folder() / "film_force.csv"))) {
    const auto value = [&row](const char* name) { return number(row.at(name)); };
    const Law law = law_of(row.at("law"));
    const double ratio = value("eccentricity_ratio"), a = value("slip_rate"), b = value("squeeze_rate");
    const double omega = std::max(std::abs(a), std::abs(b));
    if (!(ratio >= 1e-3 && ratio <= 0.99 && omega > 1e-9 && omega < 1e9)) continue;
    if (a != 0 && std::abs(a) < 0.01 * omega) continue;  // v_y would round a away
    State state;
    state.viscosity = state.length = state.radius = state.clearance = state.omega_journal = 1;
    state.ex = ratio;
    state.vx = b / omega;
    state.vy = (ratio - a / omega) / 2;
    const Solution s = solve(Quantities::dimensionless, law, state);
    const double size = is_short(law) ? value("length") : value("radius");
    const double unit = value("viscosity") * value("length") * value("radius") * size * size /
                        (value("clearance") * value("clearance")) * omega;
    const double radial = value("radial") / unit, tangential = value("tangential") / unit;
    INFO(row.at("law") << " at " << ratio << ", a " << a << ", b " << b);
    const double off =
        std::hypot(static_cast<double>(s.answer[0]) - radial, static_cast<double>(s.answer[1]) - tangential);
    // 1e-12: rounding of v_y, of a hundredth of its size, and up to 1/(1 − ε) of that of ε.
    CHECK(off <= 1e-12 * std::hypot(radial, tangential));
    ++compared;
  }
  CHECK(compared > 1000);
}

TEST_CASE("verify: the certified answers of the golden states are those of its own work") {
  for (const Quantities quantities : every_quantity) {
    const std::vector<State> states = golden_states(quantities, golden_folder());
    const std::size_t columns = answer_columns(quantities).size();
    for (std::size_t law = 0; law < law_count; ++law) {
      std::size_t certified = 0;
      for (const State& state : states) {
        const auto& row = state.golden->row[law];
        if (!row) continue;
        ++certified;
        const Reference reference = references(quantities, Law{law}, {state})[0];
        const Solution own = solve(quantities, Law{law}, state);
        INFO(name_of(quantities) << " " << name_of(Law{law}) << ", " << state.golden->file << ", line " << row->line);
        CHECK(reference.golden == &*row);
        for (std::size_t k = 0; k < columns; ++k) {
          CHECK(reference.expected[k] == row->answer[k]);
          const double error = static_cast<double>(std::abs(row->answer[k] - own.answer[k]));
          CHECK(error <=
                0x1p-63 * reference.sensitivity[k]);  // rounding of long double, times the state's conditioning
        }
      }
      INFO(name_of(quantities) << " " << name_of(Law{law}) << ": " << certified << " of " << states.size());
      const bool of_field = quantities == Quantities::extent || quantities == Quantities::pressure;
      if (of_field && law_facts(name_of(Law{law})).squeeze_only) {
        CHECK(certified == 0);  // the tables' fields have a wedge
      } else if (quantities == Quantities::pressure) {
        const bool has_none = name_of(Law{law}) == "pinkus_sternlicht";
        CHECK((has_none ? certified == 0 : certified >= 60));
      } else {
        CHECK(certified == states.size());
      }
    }
  }
}

TEST_CASE("verify: most golden rows are asked about, and each as the table says it") {
  const GoldenTable forces("film_force.csv");
  const std::vector<State> polar = golden_states(Quantities::polar, golden_folder());
  CHECK(polar.size() >= 380);  // of 448: not ε = 0 with a slip rate, not 1e±100 and beyond
  for (const State& state : polar) {
    const std::size_t row = state.golden->row[0]->line - 2;
    const PolarState given = forces.polar(row);
    CHECK(state.viscosity == forces.number(row, "viscosity"));
    CHECK(state.eccentricity_ratio == given.eccentricity_ratio);
    CHECK(state.squeeze_rate == given.squeeze_rate);
    using Exact = boost::multiprecision::cpp_bin_float_100;
    const Exact a = Exact(state.eccentricity_ratio) * (Exact(state.omega) - 2 * Exact(state.attitude_rate));
    CHECK(abs(a - given.slip_rate) <= Exact(0x1p-104) * std::abs(given.slip_rate));  // two doubles
  }
  CHECK(golden_states(Quantities::cartesian, golden_folder()).size() >= 85);   // of 90
  CHECK(golden_states(Quantities::transition, golden_folder()).size() == 73);  // all
  CHECK(golden_states(Quantities::pressure, golden_folder()).size() >= 250);   // of 360: not at θ = 0 and π
}

TEST_CASE("verify: what it expects is what the golden file says") {
  const GoldenTable forces("film_force.csv");
  const std::size_t row = 60;
  std::string changed = forces.text(row, "radial");
  changed[9] = changed[9] == '5' ? '6' : '5';
  const TemporaryFolder folder;
  copy_changed(folder, "film_force.csv", forces.text(row, "radial"), changed);
  const std::string law = forces.text(row, "law");
  const std::vector<State> states = verify::states_to_verify(Quantities::polar, folder.path(), 10, 1);
  const Answers answers = answers_of(Quantities::polar, states, [&](const State& state) {
    return library_answer<double>(Quantities::polar, law, state);
  });
  const Verification v = verified(Quantities::polar, law, states, answers);
  CHECK(v.verdict == Verdict::disagrees);
  CHECK(v.judgement.failing.size() == 1);
  CHECK_THAT(text_report(v), Catch::Contains("certified: film_force.csv, line " + std::to_string(row + 2)));
}

TEST_CASE("verify: golden states that single precision can't decide are left out of it, and said so") {
  const std::vector<State> states = golden_states(Quantities::polar, golden_folder());
  for (const std::string_view law : film_law_names) {
    const auto answer = [&]<class T>(T) {
      return verified(Quantities::polar, law, states, answers_of(Quantities::polar, states, [&](const State& state) {
                        return library_answer<T>(Quantities::polar, law, state);
                      }));
    };
    const Verification in_double = answer(double());
    CHECK(in_double.verdict == Verdict::agrees);
    CHECK(in_double.judgement.left_out == 0);
    const Verification in_single = answer(float());
    INFO(law << "\n" << text_report(in_single));
    CHECK(in_single.verdict == Verdict::agrees);
    CHECK(in_single.judgement.left_out > 0);
    CHECK(in_single.judgement.judged() > 200);
    CHECK_THAT(text_report(in_single), Catch::Contains("left out"));
  }
}

TEST_CASE("verify: golden data that are missing or changed are refused with their place") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& golden, const std::string& word) {
    const ProgramResult result =
        lubjoint_program({"verify", "--law", "short_full", "--golden", golden, "--states-out", folder / "states.csv"});
    INFO(result.err);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Catch::Contains(golden) && Catch::Contains(word));
    CHECK(!std::filesystem::exists(folder / "states.csv"));
  };
  refused(folder / "nowhere", "data/golden");
  const TemporaryFolder changed;
  copy_changed(changed, "joint_wrench.csv", "0.03125", "0.03225");
  refused(changed.path().string(), "joint_wrench.csv");
}

}  // namespace verify_golden_test
