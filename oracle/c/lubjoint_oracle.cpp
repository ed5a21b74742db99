#include "oracle/c/lubjoint_oracle.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>

#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/laws/film_store.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace {

using namespace lubjoint;

thread_local std::array<char, 512> message{};

void say(const char* text) noexcept {
  std::strncpy(message.data(), text, message.size() - 1);
  message.back() = '\0';
}

/// A force that no double holds.
struct ForceRange : std::range_error {
  using std::range_error::range_error;
};

template <class Work>
int guarded(const Work& work) noexcept {
  try {
    work();
    return 0;
  } catch (const FilmDomainError& error) {
    say(error.what());
    return EDOM;
  } catch (const ForceRange& error) {
    say(error.what());
    return ERANGE;
  } catch (const std::bad_alloc&) {
    say("no memory");
    return ENOMEM;
  } catch (const std::exception& error) {
    say(error.what());
    return EINVAL;
  }
}

template <class Pointer>
void require(const char* name, const Pointer& pointer) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
}

char* copied(const std::string& text) {
  char* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

oracle::FilmOnset onset_of(oracle::FiniteFilm film, const char* given) {
  if (given == nullptr) return oracle::FilmOnset::free;
  if (film != oracle::FiniteFilm::finite_reynolds) {
    throw std::invalid_argument("onset has no effect on " + std::string(name_of(film)) +
                                "; allowed with finite_reynolds alone");
  }
  const std::string name = given;
  if (name == "free") return oracle::FilmOnset::free;
  if (name == "maximum_film") return oracle::FilmOnset::maximum_film;
  throw std::invalid_argument("onset is \"" + name + "\"; allowed are free, maximum_film");
}

}  // namespace

const char* lubjoint_oracle_message(void) { return message.data(); }

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
    const oracle::FiniteFilm kind = oracle::finite_film_of(film);
    oracle::FiniteLengthOptions options{tolerance, onset_of(kind, onset)};
    if (!(tolerance >= 1e-12 && tolerance <= 0.1)) {
      std::ostringstream given;
      given << "tolerance is " << tolerance << "; allowed is a number from 1e-12 to 0.1";
      throw std::invalid_argument(given.str());
    }
    const Bearing<double> geometry(bearing[1], bearing[2], bearing[3]);
    const Lubricant<double> oil(bearing[0]);
    for (std::size_t i = 0; i < n; ++i) {
      try {
        const PolarFilmState<double> state(eccentricity_ratio[i], slip_rate[i], squeeze_rate[i]);
        const oracle::FiniteLengthResult force = oracle::finite_length_force(kind, geometry, oil, state, options);
        for (const double each : {force.radial, force.tangential, force.radial_error, force.tangential_error}) {
          if (!std::isfinite(each))
            throw ForceRange("row " + std::to_string(i) + ": the force is beyond the range of double");
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
