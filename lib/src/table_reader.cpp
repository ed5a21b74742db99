#include "table_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/text/nearest_name.hpp"
#include "lubjoint/text/printable.hpp"

namespace lubjoint {

namespace {

/// As it would be written in a file. Arrays element by element: toml++ 3.3 measures a whole one for its line breaks,
/// which is undefined for numbers below 0.1.
void show(std::ostream& text, const toml::node& node) {
  node.visit([&](const auto& value) {
    if constexpr (toml::is_table<decltype(value)>) {
      text << "a table";
    } else if constexpr (toml::is_array<decltype(value)>) {
      const char* between = "[ ";
      for (const toml::node& element : value) {
        text << std::exchange(between, ", ");
        show(text, element);
      }
      text << (value.empty() ? "[]" : " ]");
    } else {
      text << value;
    }
  });
}

std::string shown(const toml::node& node) {
  std::ostringstream text;
  show(text, node);
  return text.str();
}

std::string allowed_number(Allowed allowed, std::string_view unit) {
  std::string words = allowed == Allowed::positive       ? "a finite number above 0"
                      : allowed == Allowed::not_negative ? "a finite number, 0 or more"
                                                         : "a finite number";
  if (!unit.empty()) words += " [" + std::string(unit) + "]";
  return words;
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::string file, std::string path)
    : table_(table), file_(std::move(file)), path_(std::move(path)) {}

std::string TableReader::key_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

void TableReader::fail(const toml::source_region& where, const std::string& what) const {
  // A value that was put in place of the file's, and a table made for it, have no line: that of the table, or the
  // first.
  const auto line = where.begin.line ? where.begin.line : std::max<toml::source_index>(1, table_.source().begin.line);
  throw SceneError(file_ + ":" + std::to_string(line) + ": " + printable(what));
}

void TableReader::refuse(std::string_view key, const std::string& given, const std::string& allowed) const {
  const toml::node* node = table_.get(key);
  const std::string name = node || path_.empty() || !key.empty() ? key_path(key) : path_;
  fail(node ? node->source() : table_.source(), name + " is " + given + "; allowed is " + allowed);
}

const toml::node* TableReader::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_.get(key);
}

std::vector<std::string> TableReader::unknown_keys() const {
  std::vector<std::string> unknown;
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) == known_.end()) unknown.emplace_back(key.str());
  }
  return unknown;
}

const toml::node& TableReader::require(std::string_view key, const std::string& allowed) {
  const toml::node* node = find(key);
  if (node) return *node;
  std::string message = key_path(key) + " is missing; required is " + allowed;
  const std::string misspelt = nearest_name(unknown_keys(), key);
  if (!misspelt.empty() && edit_distance(misspelt, key) <= 1 + key.size() / 3) {
    message += "; line " + std::to_string(table_.get(misspelt)->source().begin.line) + " has " + key_path(misspelt) +
               ": did you mean " + std::string(key) + "?";
  }
  fail(table_.source(), message);
}

double TableReader::as_number(std::string_view, const toml::node& node, const std::string& name, Allowed allowed,
                              std::string_view unit) const {
  std::optional<double> value;
  if (const auto* real = node.as_floating_point()) value = real->get();
  if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
  const bool fits = value && std::isfinite(*value) && (allowed != Allowed::positive || *value > 0) &&
                    (allowed != Allowed::not_negative || *value >= 0);
  if (!fits) fail(node.source(), name + " is " + shown(node) + "; allowed is " + allowed_number(allowed, unit));
  return *value;
}

double TableReader::number(std::string_view key, Allowed allowed, std::string_view unit) {
  return as_number(key, require(key, allowed_number(allowed, unit)), key_path(key), allowed, unit);
}

double TableReader::number_or(std::string_view key, double otherwise, Allowed allowed, std::string_view unit) {
  const toml::node* node = find(key);
  return node ? as_number(key, *node, key_path(key), allowed, unit) : otherwise;
}

std::string TableReader::text(std::string_view key) {
  const toml::node& node = require(key, "a string");
  const auto value = node.value<std::string>();
  if (!node.is_string() || value->empty()) {
    fail(node.source(), key_path(key) + " is " + shown(node) + "; allowed is a string that is not empty");
  }
  return *value;
}

std::string TableReader::name(std::string_view key) {
  std::string given = text(key);
  const bool fits = given.front() != '.' && std::none_of(given.begin(), given.end(), [](char c) {
                      return static_cast<unsigned char>(c) < 0x20 ||
                             std::string_view(",\"'/\\\x7f").find(c) != std::string_view::npos;
                    });
  if (!fits) {
    fail(table_.get(key)->source(), key_path(key) + " is " + shown(*table_.get(key)) +
                                        "; allowed is a name without commas, quotes, slashes and line breaks that "
                                        "does not begin with a point: files and columns are called by it");
  }
  return given;
}

std::string TableReader::text_or(std::string_view key, std::string otherwise) {
  return find(key) ? text(key) : std::move(otherwise);
}

bool TableReader::flag_or(std::string_view key, bool otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (!node->is_boolean()) fail(node->source(), key_path(key) + " is " + shown(*node) + "; allowed is true or false");
  return *node->value<bool>();
}

std::vector<double> TableReader::numbers(std::string_view key, const std::vector<std::size_t>& sizes,
                                         std::string_view unit) {
  constexpr std::array<const char*, 7> words = {"no", "one", "two", "three", "four", "five", "six"};
  std::string allowed = "an array of ";
  for (std::size_t i = 0; i < sizes.size(); ++i) allowed += (i ? std::string(" or ") : "") + words.at(sizes[i]);
  allowed += " finite numbers [" + std::string(unit) + "]";
  const toml::node& node = require(key, allowed);
  const toml::array* array = node.as_array();
  if (!array || std::find(sizes.begin(), sizes.end(), array->size()) == sizes.end())
    fail(node.source(), key_path(key) + " is " + shown(node) + "; allowed is " + allowed);
  std::vector<double> values;
  for (std::size_t i = 0; i < array->size(); ++i) {
    values.push_back(as_number(key, *array->get(i), key_path(key) + "[" + std::to_string(i) + "]", Allowed::any, unit));
  }
  return values;
}

Vector2<double> TableReader::vector(std::string_view key, std::string_view unit) {
  const std::vector<double> values = numbers(key, {2}, unit);
  return {values[0], values[1]};
}

Vector3<double> TableReader::vector3(std::string_view key, std::string_view unit) {
  const std::vector<double> values = numbers(key, {3}, unit);
  return {values[0], values[1], values[2]};
}

Vector3<double> TableReader::vector3_or(std::string_view key, const Vector3<double>& otherwise, std::string_view unit) {
  return find(key) ? vector3(key, unit) : otherwise;
}

Vector2<double> TableReader::vector_or(std::string_view key, const Vector2<double>& otherwise, std::string_view unit) {
  return find(key) ? vector(key, unit) : otherwise;
}

TableReader TableReader::table(std::string_view key) {
  const toml::node& node = require(key, "a table");
  const toml::table* inner = node.as_table();
  if (!inner) fail(node.source(), key_path(key) + " is " + shown(node) + "; allowed is a table");
  return {*inner, file_, key_path(key)};
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
  std::vector<TableReader> result;
  const toml::node* node = find(key);
  if (!node) return result;
  const toml::array* array = node->as_array();
  if (!array) fail(node->source(), key_path(key) + " is " + shown(*node) + "; allowed is an array of tables");
  for (std::size_t i = 0; i < array->size(); ++i) {
    const std::string name = key_path(key) + "[" + std::to_string(i) + "]";
    const toml::table* inner = array->get(i)->as_table();
    if (!inner) fail(array->get(i)->source(), name + " is " + shown(*array->get(i)) + "; allowed is a table");
    result.emplace_back(*inner, file_, name);
  }
  return result;
}

void TableReader::finish() const {
  for (const auto& [key, node] : table_) {
    const std::string_view name = key.str();
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    std::string message = "unknown key " + key_path(name) + "; allowed are ";
    for (std::size_t i = 0; i < known_.size(); ++i) message += (i ? ", " : "") + known_[i];
    const std::string nearest = nearest_name(known_, name);
    if (!nearest.empty()) message += "; did you mean " + key_path(nearest) + "?";
    fail(key.source(), message);
  }
}

}  // namespace lubjoint
