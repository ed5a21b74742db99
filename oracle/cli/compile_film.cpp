#include <memory>
#include <optional>

#include "lubjoint/film/compiled_film_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/film_check.hpp"

namespace lubjoint::cli {

namespace {

struct CompileOptions {
  std::string film;
  std::optional<double> length, radius, shape;
  std::optional<double> tolerance;
  std::optional<int> states;
  std::optional<std::string> out;

  /// @throws std::invalid_argument that names the option
  double length_to_diameter() const {
    if (shape) {
      if (length || radius) {
        throw std::invalid_argument(
            "--length-to-diameter is given beside --length or --radius; allowed is one or the "
            "other");
      }
      require_shape("--length-to-diameter", *shape);
      return *shape;
    }
    if (!length || !radius) {
      throw std::invalid_argument(
          "the bearing's shape is missing; allowed is --length-to-diameter, or --length and "
          "--radius");
    }
    require_option("--length", *length, *length > 0, "a finite number above 0");
    require_option("--radius", *radius, *radius > 0, "a finite number above 0");
    const double given = *length / (2 * *radius);
    require_shape("--length over twice --radius", given);
    return given;
  }

 private:
  static void require_shape(const std::string& name, double given) {
    require_option(name, given, given >= least_compiled_shape && given <= largest_compiled_shape,
                   fmt::format("a number from {} to {}", least_compiled_shape, largest_compiled_shape));
  }
};

/// Holds the table that the laws would use against the solver at many states.
int check(const CompileOptions& options, double shape) {
  if (options.out || options.tolerance) {
    throw std::invalid_argument(
        "--states is given beside --out or --tolerance; allowed is it alone, for the table that the laws use");
  }
  require_option("--states", *options.states, *options.states >= 1 && *options.states <= 1000000,
                 "a whole number from 1 to 1000000");
  const CompiledFilm film = film_for_user(options.film, shape);
  std::unique_ptr<reports::ProgressBar> bar;
  const reports::FilmCheck made =
      reports::check_film(film, *options.states, {reports::available_cores(), [&bar](std::size_t, std::size_t all) {
                                                    if (!bar) {
                                                      bar = std::make_unique<reports::ProgressBar>("states", all);
                                                    }
                                                    bar->advance();
                                                  }});
  bar.reset();
  std::cout << reports::film_check_header << '\n' << reports::film_check_row(film, made) << '\n';
  std::cerr << stated_error(film) << '\n';
  if (made.beyond > 0) {
    std::cerr << fmt::format("at {} of {} states it is off by more than that and the solver's bound\n", made.beyond,
                             made.states);
  }
  return made.beyond > 0 ? 1 : 0;
}

int compile(const CompileOptions& options) {
  require_name("--film", options.film, names_of_laws<CompiledLaws>);
  const double shape = options.length_to_diameter();
  if (options.tolerance) {
    require_option("--tolerance", *options.tolerance, *options.tolerance > 0 && *options.tolerance < 1,
                   "a number between 0 and 1");
  }
  if (options.states) return check(options, shape);
  if (options.out) reports::prepare_file(*options.out);
  const CompiledFilm film = reports::compile_film(options.film, shape, compiler_with_progress(options.film, shape));
  std::cout << stated_error(film) << '\n';
  if (options.tolerance && film.error > *options.tolerance) {
    std::cerr << fmt::format("its error is above --tolerance {:g}: nothing is written\n", *options.tolerance);
    return 1;
  }
  if (options.out) {
    reports::write_file(*options.out, compiled_film_text(film));
    std::cerr << *options.out << " written\n";
    return 0;
  }
  const auto file = reports::keep_film(film, film_store());
  if (file.empty()) {
    std::cerr << "nothing is kept: there is neither XDG_CACHE_HOME nor HOME; --out names a file\n";
    return 1;
  }
  std::cerr << file.string() << " written\n";
  return 0;
}

}  // namespace

void add_compile_film(CLI::App& app, Action& action) {
  auto options = std::make_shared<CompileOptions>();
  CLI::App* command = app.add_subcommand("compile-film", words_of("compile-film"));
  command->add_option("--film", options->film, "finite_full, finite_half, finite_dynamic or finite_reynolds")
      ->required();
  command->add_option("--length", options->length, "Bearing length [m]");
  command->add_option("--radius", options->radius, "Journal radius [m]");
  command->add_option("--length-to-diameter", options->shape, "L/D, in place of --length and --radius");
  command->add_option("--tolerance", options->tolerance, "Largest error over |F| that is accepted, else exit 1");
  command->add_option("--out", options->out, "File, in place of the user's cache");
  command->add_option("--states", options->states,
                      "Writes no table: holds the one that the laws use against the solver at so many random states,\n"
                      "CSV out (data/measured/compiled-films.csv); exit 1 where its stated error does not hold");
  command->callback([options, &action] { action = [options] { return compile(*options); }; });
}

}  // namespace lubjoint::cli
