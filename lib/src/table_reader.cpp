#include "table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

namespace {

std::string shown(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_table<decltype(value)>) {
      text << "a table";
    } else {
      text << value;
    }
  });
  return text.str();
}

std::string allowed_number(Allowed allowed, std::string_view unit) {
  std::string words = allowed == Allowed::positive       ? "a finite number above 0"
                      : allowed == Allowed::not_negative ? "a finite number, 0 or more"
                                                         : "a finite number";
  if (!unit.empty()) words += " [" + std::string(unit) + "]";
  return words;
}

/// Levenshtein's distance.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, substituted}));
    }
  }
  return row.back();
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::string file, std::string path)
    : table_(table), file_(std::move(file)), path_(std::move(path)) {}

std::string TableReader::key_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

void TableReader::fail(const toml::source_region& where, const std::string& what) const {
  throw SceneError(file_ + ":" + std::to_string(where.begin.line) + ": " + what);
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

const toml::node& TableReader::require(std::string_view key, const std::string& allowed) {
  const toml::node* node = find(key);
  if (!node) fail(table_.source(), key_path(key) + " is missing; required is " + allowed);
  return *node;
}

double TableReader::as_number(std::string_view, const toml::node& node, const std::string& name, Allowed allowed,
                              std::string_view unit) const {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
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

std::string TableReader::text_or(std::string_view key, std::string otherwise) {
  return find(key) ? text(key) : std::move(otherwise);
}

bool TableReader::flag_or(std::string_view key, bool otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (!node->is_boolean()) fail(node->source(), key_path(key) + " is " + shown(*node) + "; allowed is true or false");
  return *node->value<bool>();
}

Vector2<double> TableReader::vector(std::string_view key, std::string_view unit) {
  const std::string allowed = "an array of two finite numbers [" + std::string(unit) + "]";
  const toml::node& node = require(key, allowed);
  const toml::array* array = node.as_array();
  if (!array || array->size() != 2)
    fail(node.source(), key_path(key) + " is " + shown(node) + "; allowed is " + allowed);
  return {as_number(key, *array->get(0), key_path(key) + "[0]", Allowed::any, unit),
          as_number(key, *array->get(1), key_path(key) + "[1]", Allowed::any, unit)};
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
    std::string message = "unknown key " + key_path(name);
    const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
      return distance(a, name) < distance(b, name);
    });
    if (nearest != known_.end() && distance(*nearest, name) <= 1 + name.size() / 2) {
      message += "; did you mean " + key_path(*nearest) + "?";
    }
    message += " Allowed are ";
    for (std::size_t i = 0; i < known_.size(); ++i) message += (i ? ", " : "") + known_[i];
    fail(key.source(), message);
  }
}

}  // namespace lubjoint
