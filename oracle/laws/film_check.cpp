#include "oracle/laws/film_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <mutex>
#include <numbers>
#include <random>
#include <vector>

#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::reports {

FilmDifference difference_from_solver(const CompiledFilm& film, double eccentricity_ratio, double direction) {
  const FilmState<double> state(Vector2<double>(eccentricity_ratio, 0),
                                Vector2<double>(std::cos(direction), std::sin(direction)));
  const oracle::FiniteFilm name = oracle::finite_film_of(film.film);
  const double tolerance = name == oracle::FiniteFilm::finite_reynolds ? 1e-4 : 1e-8;
  const oracle::FiniteForce solved = oracle::finite_force(name, film.shape, state, {tolerance});
  Vector2<double> force;
  with_compiled_law(film, [&](const auto& law) { force = compiled_force_ratio(law, state); });
  return {(force - solved.ratio).norm() / solved.ratio.norm(), solved.relative_error()};
}

FilmCheck check_film(const CompiledFilm& film, int states, const CompilerOptions& options) {
  std::mt19937_64 random(20261128);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  struct Seen {
    double eccentricity_ratio, direction;
    FilmDifference off;
  };
  std::vector<Seen> all(static_cast<std::size_t>(states));
  for (Seen& seen : all) {
    seen.eccentricity_ratio = film.ratio_limit * uniform();
    seen.direction = (2 * uniform() - 1) * std::numbers::pi;
  }
  std::mutex mutex;
  std::size_t done = 0;
  run_parallel(all.size(), options.threads, [&](std::size_t i) {
    all[i].off = difference_from_solver(film, all[i].eccentricity_ratio, all[i].direction);
    if (!options.progress) return;
    const std::lock_guard lock(mutex);
    options.progress(++done, all.size());
  });
  FilmCheck check;
  check.states = states;
  for (const Seen& seen : all) {
    const double off = seen.off.difference;
    if (!(off <= film.error + seen.off.bound)) ++check.beyond;  // also what is not a number
    if (off <= check.worst) continue;
    check.worst = off;
    check.eccentricity_ratio = seen.eccentricity_ratio;
    check.direction = seen.direction;
    check.bound = seen.off.bound;
  }
  return check;
}

std::string film_check_row(const CompiledFilm& film, const FilmCheck& check) {
  return fmt::format("{},{},{},{},{:.3g},{},{},{:.2g},{:.3g}", film.film, number(film.shape), check.states,
                     check.beyond, check.worst, number(check.eccentricity_ratio), number(check.direction), check.bound,
                     film.error);
}

}  // namespace lubjoint::reports
