#include "scene_changes.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "lubjoint/text/nearest_name.hpp"

namespace lubjoint {

namespace {

/// Where a key leads: an element of an array, or a key of a table that may not be there yet.
struct Place {
  toml::table* table = nullptr;
  std::string key;  ///< of the table
  toml::array* array = nullptr;
  std::size_t element = 0;  ///< of the array
  std::string numbered;

  toml::node* node() const { return table ? table->get(key) : array->get(element); }
};

class Search {
 public:
  Search(toml::table& root, const std::string& key, const std::string& file, bool makes_tables)
      : root_(root), key_(key), file_(file), makes_tables_(makes_tables), rest_(key) {}

  Place find() {
    Place place;
    enter(root_, place);
    while (!rest_.empty()) {
      toml::node* node = place.node();
      if (!node && rest_.front() == '.' && makes_tables_) {
        place.table->insert_or_assign(place.key, toml::table{});
        node = place.node();
      }
      if (!node && rest_.front() == '.') {  // the reader judges what is made there
        place.numbered += rest_;
        return place;
      }
      if (!node) refuse(place.numbered + " is not there", known_keys(*place.table, place.key));
      if (toml::array* array = node->as_array()) {
        enter(*array, place);
      } else if (toml::table* table = node->as_table()) {
        if (rest_.front() != '.') refuse(place.numbered + " is a table", place.numbered + ".KEY");
        rest_.remove_prefix(1);
        enter(*table, place);
      } else {
        refuse(place.numbered + " is a single value", place.numbered);
      }
    }
    const toml::node* node = place.node();
    if (node && node->is_table()) refuse(place.numbered + " is a table", place.numbered + ".KEY");
    if (node && node->is_array()) refuse(place.numbered + " is an array", place.numbered + "[0], or another number");
    return place;
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& allowed) const {
    throw SceneError(file_ + ": key \"" + key_ + "\": " + what + "; allowed is " + allowed);
  }

  static std::string known_keys(const toml::table& table, const std::string& given) {
    std::vector<std::string> names;
    for (const auto& [name, node] : table) names.emplace_back(name.str());
    return one_of(names, given);
  }

  /// A key of a table: up to the next point or bracket.
  void enter(toml::table& table, Place& place) {
    const std::size_t end = std::min(rest_.find_first_of(".["), rest_.size());
    if (end == 0) refuse("a name is missing in it", known_keys(table, ""));
    place.table = &table;
    place.array = nullptr;
    place.key = rest_.substr(0, end);
    if (!place.numbered.empty()) place.numbered += '.';
    place.numbered += place.key;
    rest_.remove_prefix(end);
  }

  /// An element of an array, by number or by the name that it has.
  void enter(toml::array& array, Place& place) {
    const std::optional<std::size_t> element = rest_.front() == '[' ? numbered_element() : named_element(array);
    if (!element || *element >= array.size()) {
      std::string allowed = array.empty() ? "nothing: it is empty" : place.numbered + "[0]";
      if (array.size() > 1) allowed += " to " + place.numbered + "[" + std::to_string(array.size() - 1) + "]";
      for (std::size_t i = 0; i < array.size(); ++i) {
        const std::string name = name_of(array, i);
        if (!name.empty()) allowed += (i ? ", " : ", or by name: ") + place.numbered + "." + name;
      }
      refuse(place.numbered + " has no such element", allowed);
    }
    place.table = nullptr;
    place.array = &array;
    place.element = *element;
    place.numbered += "[" + std::to_string(*element) + "]";
  }

  std::optional<std::size_t> numbered_element() {
    const std::size_t end = rest_.find(']');
    std::size_t number = 0;
    if (end == std::string_view::npos) return std::nullopt;
    const auto [last, error] = std::from_chars(rest_.data() + 1, rest_.data() + end, number);
    if (error != std::errc() || last != rest_.data() + end) return std::nullopt;
    rest_.remove_prefix(end + 1);
    return number;
  }

  static std::string name_of(toml::array& array, std::size_t element) {
    const toml::table* table = array.get(element)->as_table();
    return table ? table->get("name") ? table->get("name")->value_or(std::string()) : std::string() : std::string();
  }

  /// Names may hold points: the longest that fits.
  std::optional<std::size_t> named_element(toml::array& array) {
    const std::string_view words = rest_.substr(1);
    std::optional<std::size_t> found;
    std::size_t length = 0;
    for (std::size_t i = 0; i < array.size(); ++i) {
      const std::string name = name_of(array, i);
      const bool fits = words.starts_with(name) && (words.size() == name.size() || words[name.size()] == '.');
      if (!fits || name.size() <= length) continue;
      found = i;
      length = name.size();
    }
    if (found) rest_.remove_prefix(1 + length);
    return found;
  }

  toml::table& root_;
  const std::string& key_;
  const std::string& file_;
  bool makes_tables_;
  std::string_view rest_;
};

/// Assigns where the type allows: a node of its own has no line for messages.
template <class T>
void put(const Place& place, const T& value) {
  toml::node* node = place.node();
  if (node) {
    if (auto* same = node->as<T>()) {
      *same = value;
      return;
    }
    if constexpr (std::is_same_v<T, double>) {
      auto* whole = node->as_integer();
      if (whole && std::abs(value) < 1e15 && value == std::floor(value)) {
        *whole = static_cast<std::int64_t>(value);
        return;
      }
    }
  }
  if (place.table) {
    place.table->insert_or_assign(place.key, value);
  } else {
    place.array->replace(place.array->cbegin() + static_cast<std::ptrdiff_t>(place.element), value);
  }
}

}  // namespace

std::string change_value(toml::table& root, const SceneChange& change, const std::string& file) {
  const Place place = Search(root, change.key, file, true).find();
  std::visit([&](const auto& value) { put(place, value); }, change.value);
  return place.numbered;
}

std::string find_value(toml::table& root, const std::string& key, const std::string& file) {
  return Search(root, key, file, false).find().numbered;
}

}  // namespace lubjoint
