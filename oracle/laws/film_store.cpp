#include "oracle/laws/film_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace fs = std::filesystem;

namespace {

/// Raised whenever a table of the same law and L/D would come out otherwise.
constexpr int version = 2;
constexpr std::string_view ending = ".txt";

/// L/D of two bearings that are the same to rounding of their dimensions; as require_shape_of.
bool is_same_shape(double one, double other) { return std::abs(one - other) <= 1e-12 * one; }

/// The shipped film, if there is one for this L/D; its names end with the L/D.
std::optional<fs::path> shipped_film(const fs::path& folder, std::string_view film, double shape) {
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    const std::string name = entry.path().filename().string();
    const std::string start = std::string(film) + "-";
    if (!name.starts_with(start) || !name.ends_with(ending)) continue;
    const std::string shown = name.substr(start.size(), name.size() - start.size() - ending.size());
    double found = 0;
    const auto [end, error] = std::from_chars(shown.data(), shown.data() + shown.size(), found);
    if (error == std::errc() && end == shown.data() + shown.size() && is_same_shape(found, shape)) return entry.path();
  }
  return {};
}

/// Removes the oldest films but this one until the rest is within the limit. Another process may do the same.
void prune(const FilmStore& store, const fs::path& kept) {
  struct File {
    fs::path path;
    fs::file_time_type time;
    std::uintmax_t size;
  };
  std::vector<File> files;
  std::uintmax_t total = 0;
  std::error_code gone;
  for (const fs::directory_entry& entry : fs::directory_iterator(store.cache, gone)) {
    if (entry.path().extension() != ending) continue;
    const std::uintmax_t size = entry.file_size(gone);
    if (gone) continue;
    files.push_back({entry.path(), entry.last_write_time(gone), size});
    total += size;
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.time < b.time; });
  for (const File& file : files) {
    if (total <= store.size_limit) return;
    if (file.path == kept) continue;
    fs::remove(file.path, gone);
    total -= file.size;
  }
}

}  // namespace

FilmStore user_film_store(const fs::path& shipped) {
  FilmStore store;
  store.shipped = shipped;
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache != nullptr && fs::path(cache).is_absolute()) {  // the XDG specification ignores relative ones
    store.cache = fs::path(cache) / "lubjoint" / "films";
  } else if (home != nullptr && *home != '\0') {
    store.cache = fs::path(home) / ".cache" / "lubjoint" / "films";
  }
  return store;
}

std::string film_file_name(std::string_view film, double shape) {
  return fmt::format("{}-{}-v{}{}", film, shape, version, ending);
}

CompiledFilm read_film_file(const fs::path& file, std::string_view film, double shape) {
  const auto refuse = [&file](const std::string& reason) {
    return std::invalid_argument("\"" + file.string() + "\" is refused: " + reason);
  };
  const std::string text = read_input(file.string());
  try {
    CompiledFilm table = read_compiled_film(text);
    if (table.film != film) throw refuse("it is the film of " + table.film + ", not of " + std::string(film));
    if (!is_same_shape(table.shape, shape)) {
      throw refuse(fmt::format("it is made for length over diameter {}, not for {}", table.shape, shape));
    }
    try {
      with_compiled_law(table, [](const auto&) {});
    } catch (const std::invalid_argument& error) {  // not whole
      throw refuse(error.what());
    }
    return table;
  } catch (const CompiledFilmError& error) {
    throw refuse(error.what());
  }
}

CompiledFilm film_at_hand(std::string_view film, double shape, const FilmStore& store, const CompilerOptions& options,
                          const std::function<void(const std::string&)>& say) {
  std::vector<fs::path> candidates;
  if (const auto shipped = shipped_film(store.shipped, film, shape)) candidates.push_back(*shipped);
  if (!store.cache.empty()) candidates.push_back(store.cache / film_file_name(film, shape));
  for (const fs::path& file : candidates) {
    std::error_code missing;
    if (!fs::exists(file, missing)) continue;
    try {
      return read_film_file(file, film, shape);
    } catch (const std::invalid_argument& error) {
      say(error.what());
    }
  }
  const CompiledFilm made = compile_film(film, shape, options);
  try {
    keep_film(made, store);
  } catch (const OutputError& error) {
    say(std::string("the compiled film is not kept: ") + error.what());
  }
  return made;
}

fs::path keep_film(const CompiledFilm& film, const FilmStore& store) {
  if (store.cache.empty()) return {};
  const fs::path file = store.cache / film_file_name(film.film, film.shape);
  prepare_folder(store.cache);
  write_file(file, compiled_film_text(film));
  prune(store, file);
  return file;
}

}  // namespace lubjoint::reports
