#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/cli/verify_words.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/reynolds/film_onset.hpp"
#include "oracle/verify/report.hpp"
#include "oracle/verify/states/finite_film.hpp"
#include "oracle/verify/states/foreign_program.hpp"
#include "oracle/verify/states/solved_film_states.hpp"
#include "oracle/verify/trajectory/scene_suspects.hpp"
#include "oracle/verify/trajectory/trajectory_report.hpp"

namespace lubjoint::cli {

namespace {

struct VerifyOptions {
  std::string law;
  std::string quantities = "cartesian";
  std::size_t states = 1000;
  std::uint64_t seed = 1;
  std::string golden = golden_folder();
  double timeout = 60;
  std::optional<double> state_timeout;
  std::optional<std::size_t> at_most;
  std::string states_out;
  std::string answers;
  std::string scene;
  std::string trajectory;
  std::optional<double> tolerance;
  double unit = 1;  ///< of answers without dimensions, over S ω
  std::string only;
  bool steady = false;
  std::string onset;           ///< of finite_reynolds
  std::string shear = "film";  ///< of losses
  std::string language;        ///< of the template to print
  bool list_mistakes = false;
  bool markdown = false;
  bool json = false;
  std::vector<std::string> program;
  std::vector<std::string> given;  ///< names of the options on the command line
};

/// An option that would do nothing is refused.
void refuse_options_without_effect(const VerifyOptions& o) {
  const auto allow = [&](const char* what, std::vector<std::string_view> names) {
    for (const std::string& name : o.given) {
      if (std::ranges::find(names, name) != names.end()) continue;
      throw std::invalid_argument(name + " does nothing " + what);
    }
  };
  if (o.list_mistakes) return allow("with --list-mistakes", {"--list-mistakes", "--markdown"});
  if (!o.language.empty()) return allow("with --template", {"--template"});
  if (!o.scene.empty() || !o.trajectory.empty()) {
    return allow("for a trajectory (--scene)",
                 {"--scene", "--trajectory", "--law", "--golden", "--tolerance", "--json"});
  }
  if (!o.states_out.empty() && o.program.empty() && o.answers.empty()) {
    return allow("with --states-out", {"--states-out", "--law", "--onset", "--quantities", "--states", "--seed",
                                       "--golden", "--only", "--steady", "--shear", "--at-most"});
  }
  if (!o.answers.empty() && o.program.empty()) {
    return allow("with --answers",
                 {"--answers", "--states-out", "--law", "--onset", "--quantities", "--states", "--seed", "--golden",
                  "--tolerance", "--unit", "--only", "--steady", "--shear", "--at-most", "--json"});
  }
  for (const std::string& name : o.given) {
    if (name == "--markdown") throw std::invalid_argument("--markdown does nothing without --list-mistakes");
  }
}

/// Is a film of finite length claimed, which the solver judges?
bool claims_finite_film(const VerifyOptions& o) { return is_compiled_law(o.law); }

/// What --law may be.
std::vector<std::string_view> laws_for(verify::Quantities quantities) {
  std::vector<std::string_view> names = {"auto"};
  if (quantities == verify::Quantities::contact) {
    for (const LawFacts& law : verify::contact_law_facts) names.push_back(law.name);
  } else {
    names.insert(names.end(), verify::law_names.begin(), verify::law_names.end());
    const auto& finite = names_of_laws<CompiledLaws>;
    names.insert(names.end(), finite.begin(), finite.end());
  }
  return names;
}

/// Options that mean nothing for a table, or for other tables.
void check_table(const VerifyOptions& o) {
  const auto is_given = [&](const char* name) { return std::ranges::find(o.given, name) != o.given.end(); };
  const verify::Quantities quantities = verify::quantities_of(o.quantities);
  shear_extent(o.shear);  // refuses what is none
  if (is_given("--shear") && quantities != verify::Quantities::losses) {
    throw std::invalid_argument("--shear does nothing with --quantities " + o.quantities +
                                "; allowed is it with losses");
  }
  if (o.steady) static_cast<void>(verify::steady_conditions(quantities));  // refuses
  if (o.shear != "striated") return;
  if (o.law == "auto" || o.law.empty() || verify::facts_of(verify::law_of(o.law)).extent != FilmExtent::half) {
    throw std::invalid_argument(
        "--shear striated is defined for half films alone; allowed are film and flooded, or "
        "--law short_half, long_half, long_half_eq5 or finite_half");
  }
}

void check(const VerifyOptions& o) {
  if (o.law.empty() && o.states_out.empty()) {
    std::string list;
    for (const std::string_view name : laws_for(verify::quantities_of(o.quantities))) {
      list.append(list.empty() ? "" : ", ").append(name);
    }
    throw std::invalid_argument("--law is missing; allowed are " + list);
  }
  if (!o.law.empty()) {
    require_name("--law", o.law, laws_for(verify::quantities_of(o.quantities)));
  }
  if (o.state_timeout) {
    require_option("--state-timeout", *o.state_timeout, *o.state_timeout > 0, "a time in seconds above 0");
  }
  require_option("--timeout", o.timeout, o.timeout > 0, "a time in seconds above 0");
  if (o.tolerance) {
    require_option("--tolerance", *o.tolerance, *o.tolerance > 0 && *o.tolerance <= 0.1, "a number above 0, to 0.1");
  }
  const bool has_unit = std::ranges::find(o.given, "--unit") != o.given.end();
  if (has_unit && o.quantities != "dimensionless") {
    throw std::invalid_argument("--unit does nothing with --quantities " + o.quantities +
                                "; allowed is it with dimensionless");
  }
  if (o.quantities == "dimensionless" && std::ranges::find(o.given, "--golden") != o.given.end()) {
    throw std::invalid_argument("--golden does nothing with --quantities dimensionless: the golden data have SI units");
  }
  check_table(o);
  require_option("--unit", o.unit, std::isfinite(o.unit) && o.unit > 0, "a number above 0");
  const int ways = (o.program.empty() ? 0 : 1) + (o.answers.empty() ? 0 : 1) + (o.states_out.empty() ? 0 : 1);
  if (ways == 1) return;
  throw std::invalid_argument(
      "verify needs one of: --scene FILE --trajectory FILE, -- PROGRAM [ARGS], --answers FILE (with the states of "
      "--states-out), --states-out FILE");
}

/// Prints the report; the exit status says the verdict.
template <class Result>
int report(const Result& result, bool json) {
  if (json) {
    std::cout << verify::json_report(result).dump(2) << '\n';
  } else {
    std::cout << verify::text_report(result);
  }
  if (result.accepted()) return 0;
  return result.verdict == verify::Verdict::undecided ? 2 : 1;
}

/// A trajectory against our own run of its scene.
int verify_trajectory(const VerifyOptions& o) {
  if (o.scene.empty() || o.trajectory.empty()) {
    throw std::invalid_argument("--scene and --trajectory go together; one of them is missing");
  }
  const double tolerance = o.tolerance.value_or(1e-3);
  require_option("--tolerance", tolerance, tolerance >= 1e-6 && tolerance <= 0.1, "a number from 1e-6 to 0.1");
  SceneOptions options;
  options.file = o.scene;
  if (!o.law.empty()) options.law = o.law;
  const Scene scene = options.load();
  const std::string given = reports::read_input(o.trajectory);
  const verify::SceneReference reference = verify::scene_reference(scene, tolerance);
  const auto golden = verify::golden_agreement(reference, scenes_folder(), o.golden);
  if (golden && !golden->confirms()) {
    throw verify::UnjudgedError("our own run is not the golden trajectory " + golden->file +
                                ": allowed is a golden folder as it came with this lubjoint");
  }
  reports::ProgressBar bar("looking for the mistake", verify::runs_of_search(scene));
  const auto result =
      verify::verify_trajectory(reference, given, reports::input_name(o.trajectory), [&] { bar.advance(); });
  if (o.json) {
    std::cout << verify::json_report(result, golden).dump(2) << '\n';
  } else {
    std::cout << verify::text_report(result, golden);
  }
  return result.agrees() ? 0 : 1;
}

/// Says why something could not be judged.
int refuse(const VerifyOptions& o, const verify::UnjudgedError& error) {
  if (o.json) {
    const nlohmann::json refused = {{"verdict", "undecided"}, {"message", error.what()}};
    std::cout << refused.dump(2) << '\n';
  }
  std::cerr << "lubjoint: could not be judged: " << error.what() << '\n';
  return 2;
}

/// Steady rotation in a bearing at rest, and what --only says.
verify::Conjunction domain_of(const VerifyOptions& o, verify::Quantities quantities) {
  verify::Conjunction domain;
  if (!o.only.empty()) domain = verify::read_conditions(quantities, o.only);
  if (!o.steady) return domain;
  for (const verify::Condition& condition : verify::steady_conditions(quantities)) domain.push_back(condition);
  return domain;
}

/// The states to ask about. Golden data that were cut off or changed would judge a right program to be wrong.
std::vector<verify::State> states_of(const VerifyOptions& o, verify::Quantities quantities) {
  if (quantities != verify::Quantities::dimensionless) {  // which asks about no golden data
    if (const auto differences = reports::manifest_differences(o.golden); !differences.empty()) {
      throw std::invalid_argument("golden data in \"" + o.golden + "\": " + differences.front().text() +
                                  "; allowed is the folder data/golden that comes with lubjoint, as it came");
    }
  }
  std::vector<verify::State> states =
      verify::states_to_verify(quantities, o.golden, o.states, o.seed, domain_of(o, quantities));
  const ShearExtent shear = shear_extent(o.shear);
  for (verify::State& state : states) {
    state.shear = shear;
    if (shear != ShearExtent::film) state.golden.reset();  // certified are the films' own losses
  }
  return states;
}

/// What the program answers, with a line on a terminal that counts.
std::string answers_of_program(const VerifyOptions& o, const std::string& states, std::size_t count) {
  reports::ProgressBar bar("waiting for answers", count);
  verify::ProgramLimits limits;
  limits.in_all = std::chrono::duration<double>(o.timeout);
  if (o.state_timeout) {
    limits.between_lines = std::chrono::duration<double>(*o.state_timeout);
    if (std::ranges::find(o.given, "--timeout") == o.given.end()) limits.in_all.reset();
  }
  std::size_t answered = 0;
  limits.on_lines = [&](std::size_t lines) {
    for (; answered + 1 < lines && answered < count; ++answered) bar.advance();  // the first line is the header
  };
  return verify::run_program(o.program, states, limits);
}

/// Writes the states that --states-out asks for.
int put_states(const VerifyOptions& o, const std::string& csv) {
  if (o.states_out == "-") {
    std::cout << csv;
  } else {
    reports::prepare_file(o.states_out);
    reports::write_file(o.states_out, csv);
  }
  return 0;
}

/// The answers to be judged: those of --answers, or of the program.
verify::Answers answers_to(const VerifyOptions& o, verify::Quantities quantities, const std::string& states,
                           std::size_t count) {
  const bool from_file = !o.answers.empty();
  const std::string text = from_file ? reports::read_input(o.answers) : answers_of_program(o, states, count);
  const std::string name = from_file ? reports::input_name(o.answers) : "answers of \"" + o.program[0] + "\"";
  return verify::read_answers(quantities, text, name, count);
}

/// The judgement of answers to these states, by the program or in the file.
template <class Judge>
int judged(const VerifyOptions& o, verify::Quantities quantities, std::vector<verify::State> states,
           const Judge& judge) {
  if (o.at_most) states = verify::covering_states(quantities, std::move(states), *o.at_most);
  const std::string csv = verify::states_csv(quantities, states);
  if (!o.states_out.empty()) return put_states(o, csv);
  try {
    verify::Answers answers = answers_to(o, quantities, csv, states.size());
    return report(judge(std::move(states), std::move(answers)), o.json);
  } catch (const verify::UnjudgedError& error) {
    return refuse(o, error);
  }
}

/// A film of finite length: its states are its own, and so is the judge of its forces.
int run_finite(const VerifyOptions& o) {
  const verify::Quantities quantities = verify::quantities_of(o.quantities);
  for (const std::string& name : o.given) {
    for (const char* other : {"--states", "--seed", "--golden", "--unit"}) {
      if (name == other) throw std::invalid_argument(name + " does nothing with --law " + o.law);
    }
  }
  const auto onset = o.onset.empty() ? std::nullopt : std::optional(o.onset);
  const verify::FiniteClaim claim{oracle::finite_film_of(o.law), oracle::film_onset_of(o.law, onset, "--onset")};
  const verify::Conjunction domain = domain_of(o, quantities);
  const double tolerance = o.tolerance.value_or(verify::finite_tolerance);
  const unsigned threads = reports::available_cores();
  if (verify::is_finite_force(quantities)) {
    return judged(o, quantities, verify::finite_states(quantities, domain), [&](auto&& states, auto&& answers) {
      return verify::verify_finite_film(claim, quantities, std::move(states), std::move(answers), tolerance, threads,
                                        verify::words(domain));
    });
  }
  return judged(o, quantities, verify::solved_film_states(claim, quantities, domain, shear_extent(o.shear), threads),
                [&](auto&& states, auto&& answers) {
                  return verify::verify_answers(quantities, o.law, std::move(states), std::move(answers),
                                                {tolerance, verify::words(domain)});
                });
}

int run(const VerifyOptions& o) {
  refuse_options_without_effect(o);
  if (o.list_mistakes) {
    std::cout << (o.markdown ? verify::gallery_markdown() + verify::finite_gallery_markdown()
                             : verify::described_gallery() + verify::described_finite_gallery());
    return 0;
  }
  if (!o.language.empty()) {
    std::cout << verify_template(o.language);
    return 0;
  }
  if (!o.scene.empty() || !o.trajectory.empty()) {
    try {
      return verify_trajectory(o);
    } catch (const verify::UnjudgedError& error) {
      return refuse(o, error);
    }
  }
  check(o);
  if (claims_finite_film(o)) return run_finite(o);
  if (!o.onset.empty()) throw std::invalid_argument("--onset does nothing without --law finite_reynolds");
  const verify::Quantities quantities = verify::quantities_of(o.quantities);
  return judged(o, quantities, states_of(o, quantities), [&](auto&& states, auto&& answers) {
    verify::scale(answers, o.unit);
    const verify::VerifySettings settings{o.tolerance.value_or(0), verify::words(domain_of(o, quantities))};
    return verify::verify_answers(quantities, o.law, std::move(states), std::move(answers), settings);
  });
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", words_of("verify"));
  command->add_option("--law", options->law,
                      "Film law that it claims, or auto: find out; with --scene, in place of the scene's. finite_full, "
                      "finite_half,\nfinite_dynamic or finite_reynolds: the film of the bearing's length, by the "
                      "solver, with every\n--quantities but dimensionless and contact; where it lies (extent) "
                      "not of finite_reynolds");
  command->add_option("--onset", options->onset,
                      "Where the film of finite_reynolds begins in steady rotation: free (default) or maximum_film");
  command->add_option(
      "--quantities", options->quantities,
      "cartesian, polar, wrench, transition, extent, pressure, dimensionless, coefficients, equilibrium, "
      "losses or contact");
  command->add_option("--states", options->states, "Random states beside the golden and the designed ones")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000}));
  command->add_option("--seed", options->seed, "Seed of the random states");
  command->add_option("--golden", options->golden, "Folder of the golden data that comes with lubjoint");
  command->add_option("--timeout", options->timeout, "Seconds that the program may take");
  command->add_option("--state-timeout", options->state_timeout,
                      "Seconds from one answer to the next that the program may take; then --timeout has no default");
  command->add_option("--at-most", options->at_most, "States in all, chosen to cover the regimes: for a slow program")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
  command->add_option("--states-out", options->states_out, "Write the states to this file and do no more; - is stdout");
  command->add_option("--answers", options->answers,
                      "Judge the answers in this file; --quantities, --states and --seed as for --states-out");
  command->add_option("--scene", options->scene, "Scene file whose trajectory is judged, with --trajectory");
  command->add_option("--trajectory", options->trajectory,
                      "CSV with t and any columns of those that simulate --out writes; - is stdin");
  command->add_option("--tolerance", options->tolerance,
                      "Of answers: error over |F| that is right, for a numerical program (default: rounding, by each "
                      "state's conditioning). Of a trajectory: places in clearances, the rest in its largest value "
                      "(default: 1e-3)");
  command->add_option("--unit", options->unit,
                      "Unit of the force without dimensions, over S omega (default 1; Capone's is 0.25)");
  command->add_option(
      "--only", options->only,
      "Domain that the program is meant for: conditions such as \"omega_sum > 0, eccentricity_ratio > 0\"");
  command->add_flag("--steady", options->steady, "Steady states alone: no squeeze, no whirl, the bearing at rest");
  command->add_option("--shear", options->shear,
                      "With --quantities losses, the part of the gap that shears: film (default), flooded or, of half "
                      "films, striated");
  command->add_option("--template", options->language,
                      "Print an adapter with a place for one's own film force and do no more: python, octave (and "
                      "MATLAB), c, cpp, fortran or julia");
  command->add_flag("--list-mistakes", options->list_mistakes, "Describe the known mistakes and do no more");
  command->add_flag("--markdown", options->markdown, "The known mistakes as a table");
  command->add_flag("--json", options->json, "One JSON object");
  command->add_option("program", options->program, "-- PROGRAM [ARGS]: reads states, writes answers, both CSV");
  command->footer(described_quantities());
  command->callback([options, command, &action] {
    for (const CLI::Option* option : command->get_options()) {
      if (option->count() > 0 && !option->get_lnames().empty())
        options->given.push_back("--" + option->get_lnames()[0]);
    }
    std::erase(options->given, "--program");
    action = [options] { return run(*options); };
  });
}

}  // namespace lubjoint::cli
