/// Compiled films for commands: at hand, or made with a progress bar.
#pragma once

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>

#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/laws/film_store.hpp"
#include "oracle/laws/scene_films.hpp"

namespace lubjoint::cli {

/// All cores, and a bar that appears if it takes long.
inline reports::CompilerOptions compiler_with_progress(const std::string& film, double shape) {
  auto bar = std::make_shared<std::unique_ptr<reports::ProgressBar>>();
  const std::string label = fmt::format("compiling {}, L/D {:.6g}", film, shape);
  return {reports::available_cores(), [bar, label](std::size_t, std::size_t all) {
            if (*bar == nullptr) *bar = std::make_unique<reports::ProgressBar>(label, all);
            (*bar)->advance();
          }};
}

/// Where this program's user has compiled films.
inline reports::FilmStore film_store() { return reports::user_film_store(reports::data_folder() / "films"); }

/// The table of a law for a bearing, from the user's store; what is refused or can't be kept goes to standard error.
inline CompiledFilm film_for_user(const std::string& film, double shape) {
  return reports::film_at_hand(film, shape, film_store(), compiler_with_progress(film, shape),
                               [](const std::string& text) { std::cerr << "warning: " << text << '\n'; });
}

/// Tables for all scenes of this program, from the user's store.
inline reports::SceneFilms& scene_films() {
  static reports::SceneFilms films(film_for_user);
  return films;
}

/// What a user should know of a table, one line.
inline std::string stated_error(const CompiledFilm& film) {
  return fmt::format(
      "{}, compiled for length over diameter {:.6g}: within {:.1e} of |F| of the solved film up to an eccentricity "
      "ratio of {}",
      film.film, film.shape, film.error, film.ratio_limit);
}

}  // namespace lubjoint::cli
