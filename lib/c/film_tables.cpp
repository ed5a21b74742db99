#include "film_tables.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <vector>

#include "array_rows.hpp"
#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint::c {

namespace {

struct Tables {
  std::mutex mutex;
  std::vector<std::shared_ptr<const FilmTable>> kept;
};

Tables& tables() {
  static Tables all;
  return all;
}

std::string_view name_of(const FilmTable& table) {
  return std::visit([](const auto& law) { return law.name; }, table.law);
}

/// As require_shape_of: to rounding of the bearing's dimensions.
bool is_for(const FilmTable& table, std::string_view law, double shape) {
  return name_of(table) == law && std::abs(table.shape - shape) <= 1e-12 * shape;
}

}  // namespace

void keep_table(std::string_view text) {
  const CompiledFilm film = read_compiled_film(text);
  std::optional<AnyCompiledLaw> law;
  with_compiled_law(film, [&law](const auto& compiled) { law.emplace(compiled); });
  auto table = std::make_shared<const FilmTable>(FilmTable{*law, film.shape, film.ratio_limit, film.error});
  const std::lock_guard lock(tables().mutex);
  for (auto& kept : tables().kept) {
    if (!is_for(*kept, film.film, film.shape)) continue;
    kept = std::move(table);
    return;
  }
  tables().kept.push_back(std::move(table));
}

std::shared_ptr<const FilmTable> table_of(std::string_view law, const Bearing<double>& bearing) {
  if (!is_compiled_law(law)) {
    require_film_law<NamedFilmLaws>(law);
    return nullptr;
  }
  const double shape = length_to_diameter(bearing);
  require_compiled_shape(law, shape);
  {
    const std::lock_guard lock(tables().mutex);
    for (const auto& table : tables().kept) {
      if (is_for(*table, law, shape)) return table;
    }
  }
  Message message;
  message << "the law " << law << " is a table, and none was given for length over diameter " << shape
          << "; required is lubjoint_load_film with a file of `lubjoint compile-film`";
  throw NoTableError(message.str());
}

}  // namespace lubjoint::c

using namespace lubjoint;
using namespace lubjoint::c;

int lubjoint_use_film(const char* text) {
  return guarded([&] {
    require("text", text);
    keep_table(text);
  });
}

int lubjoint_load_film(const char* file) {
  return guarded([&] {
    require("file", file);
    std::ifstream stream(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    if (!stream || text.empty()) {
      throw std::invalid_argument("\"" + std::string(file) + "\" can't be read, or is empty");
    }
    try {
      keep_table(text);
    } catch (const std::exception& error) {
      throw std::invalid_argument("\"" + std::string(file) + "\" is refused: " + error.what());
    }
  });
}

int lubjoint_film_of(const char* law, const lubjoint_bearing* bearing, lubjoint_film* film) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("film", film);
    const auto table = table_of(law, bearing_of(*bearing));
    if (table == nullptr) {
      throw std::invalid_argument("the law " + std::string(law) + " is a formula, and no table; allowed are " +
                                  listed_film_laws<CompiledLaws>());
    }
    *film = {table->shape, table->ratio_limit, table->error};
  });
}
