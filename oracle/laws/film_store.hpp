/// Where compiled films lie: those that ship, and those that were made on this machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "lubjoint/film/compiled_law.hpp"
#include "oracle/laws/film_compiler.hpp"

namespace lubjoint::reports {

/// Folders of compiled films. A file is named by what its content depends on: the law, L/D and the format's version.
struct FilmStore {
  std::filesystem::path shipped;                        ///< read only; may be absent
  std::filesystem::path cache;                          ///< written to; empty: nothing is kept
  std::uintmax_t size_limit = std::uintmax_t{4} << 20;  ///< of the cache [bytes]; about 200 films of the largest kind
};

/// Those that ship in a folder, and lubjoint/films in XDG_CACHE_HOME, or else in ~/.cache. Without either nothing is
/// kept.
FilmStore user_film_store(const std::filesystem::path& shipped);

/// What a cached film's file is called.
std::string film_file_name(std::string_view film, double shape);

/// The film of a file, if it is that law's and made for that L/D.
/// @throws std::invalid_argument if the file can't be read, holds no compiled film, or another
CompiledFilm read_film_file(const std::filesystem::path& file, std::string_view film, double shape);

/// The table of a law for one L/D: one that ships, or from the cache, or compiled now and kept there. A file that is
/// damaged or another film's is refused with a message, and made again. Over the size limit the films that were made
/// first are removed.
/// @param say  takes a line for the user: what is refused, what can't be kept
CompiledFilm film_at_hand(std::string_view film, double shape, const FilmStore& store, const CompilerOptions& options,
                          const std::function<void(const std::string&)>& say);

/// Keeps a film in the store's cache and removes what is too much there. @returns its file, empty if there is no cache
/// @throws OutputError
std::filesystem::path keep_film(const CompiledFilm& film, const FilmStore& store);

}  // namespace lubjoint::reports
