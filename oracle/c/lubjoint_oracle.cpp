#include "oracle/c/lubjoint_oracle.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "lib/c/guarded.hpp"
#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/laws/film_store.hpp"
#include "oracle/reynolds/film_integral.hpp"
#include "oracle/reynolds/film_onset.hpp"
#include "oracle/reynolds/finite_length.hpp"
#include "oracle/reynolds/solved_film.hpp"

namespace {

using namespace lubjoint;

using c::copied;
using c::require;

thread_local c::LastMessage message;

template <class Work>
int guarded(const Work& work) noexcept {
  return c::guarded(message, work);
}

/// A number with the estimated bound of its error.
struct Solved {
  double radial, tangential, radial_error, tangential_error;
};

/// What is asked of the error over |F|; each kind of film has an end of its own.
double tolerance_of(bool one_dimensional, double given) {
  if (given == 0) {
    return one_dimensional ? oracle::FilmQuadratureOptions().relative_tolerance
                           : oracle::FiniteLengthOptions().relative_tolerance;
  }
  const double least = one_dimensional ? 1e-15 : 1e-12;
  if (given >= least && given <= 0.1) return given;
  std::ostringstream words;
  words << "tolerance is " << given << "; allowed is a number from " << least << " to 0.1";
  throw std::invalid_argument(words.str());
}

}  // namespace

const char* lubjoint_oracle_message(void) { return message.text(); }

int lubjoint_oracle_film(const char* law, double length_to_diameter, const char* shipped,
                         lubjoint_oracle_progress progress, char** text, char** notes) {
  return guarded([&] {
    require("law", law);
    require("text", text);
    require_film_law<CompiledLaws>(law);
    require_compiled_shape(law, length_to_diameter);
    reports::CompilerOptions options{reports::available_cores(), {}};
    if (progress != nullptr) options.progress = progress;
    std::string said;
    const CompiledFilm film =
        reports::film_at_hand(law, length_to_diameter, reports::user_film_store(shipped == nullptr ? "" : shipped),
                              options, [&said](const std::string& line) { said += line + "\n"; });
    char* const notes_copy = notes == nullptr ? nullptr : copied(said);
    try {
      *text = copied(compiled_film_text(film));
    } catch (...) {
      std::free(notes_copy);
      throw;
    }
    if (notes != nullptr) *notes = notes_copy;
  });
}

void lubjoint_oracle_free(char* text) { std::free(text); }

int lubjoint_oracle_force(const char* film, const double bearing[4], const char* onset, double tolerance, size_t n,
                          const double* eccentricity_ratio, const double* slip_rate, const double* squeeze_rate,
                          double* radial, double* tangential, double* radial_error, double* tangential_error) {
  return guarded([&] {
    require("film", film);
    require("bearing", bearing);
    if (n > 0) {
      const std::array<const double*, 7> arrays = {eccentricity_ratio, slip_rate,    squeeze_rate,    radial,
                                                   tangential,         radial_error, tangential_error};
      for (const double* array : arrays) require("an array", array);
    }
    oracle::require_solved_film(film, "film");
    const bool one_dimensional = oracle::is_one_dimensional(film);
    const oracle::FilmOnset begin =
        oracle::film_onset_of(film, onset == nullptr ? std::nullopt : std::optional<std::string>(onset), "onset");
    const double asked = tolerance_of(one_dimensional, tolerance);
    const Bearing<double> geometry(bearing[1], bearing[2], bearing[3]);
    const Lubricant<double> oil(bearing[0]);
    const auto solved = [&](const PolarFilmState<double>& state) -> Solved {
      if (one_dimensional) {
        const auto force =
            film_force_by_gauss_legendre(oracle::one_dimensional_film(film), geometry, oil, state, asked);
        return {force.radial.value, force.tangential.value, force.radial.error, force.tangential.error};
      }
      const auto force = finite_length_force(oracle::finite_film_of(film), geometry, oil, state, {asked, begin});
      return {force.radial, force.tangential, force.radial_error, force.tangential_error};
    };
    for (std::size_t i = 0; i < n; ++i) {
      try {
        const Solved force = solved({eccentricity_ratio[i], slip_rate[i], squeeze_rate[i]});
        for (const double each : {force.radial, force.tangential, force.radial_error, force.tangential_error}) {
          if (!std::isfinite(each))
            throw std::range_error("row " + std::to_string(i) + ": the force is beyond the range of double");
        }
        radial[i] = force.radial;
        tangential[i] = force.tangential;
        radial_error[i] = force.radial_error;
        tangential_error[i] = force.tangential_error;
      } catch (const FilmDomainError& error) {
        throw FilmDomainError("row " + std::to_string(i) + ": " + error.what());
      }
    }
  });
}
