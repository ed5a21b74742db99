/// Reading one table of a scene file, with messages that name file, line, key, value and what is allowed.
#pragma once

#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/number/vector3.hpp"

namespace lubjoint {

/// What a number of a scene may be.
enum class Allowed { any, positive, not_negative };

class TableReader {
 public:
  /// @param path  how the table is reached from the root, "" for the root itself
  TableReader(const toml::table& table, std::string file, std::string path);

  /// @throws SceneError  as do all below
  double number(std::string_view key, Allowed allowed, std::string_view unit);
  double number_or(std::string_view key, double otherwise, Allowed allowed, std::string_view unit);
  std::string text(std::string_view key);
  /// Text that can be part of a file name and of a CSV column.
  std::string name(std::string_view key);
  std::string text_or(std::string_view key, std::string otherwise);
  Vector2<double> vector(std::string_view key, std::string_view unit);
  Vector2<double> vector_or(std::string_view key, const Vector2<double>& otherwise, std::string_view unit);
  Vector3<double> vector3(std::string_view key, std::string_view unit);
  Vector3<double> vector3_or(std::string_view key, const Vector3<double>& otherwise, std::string_view unit);
  /// An array of finite numbers, as many as one of the sizes says.
  std::vector<double> numbers(std::string_view key, const std::vector<std::size_t>& sizes, std::string_view unit);
  bool flag_or(std::string_view key, bool otherwise);
  TableReader table(std::string_view key);
  bool has(std::string_view key) const { return table_.contains(key); }
  bool is_table(std::string_view key) const { return table_[key].is_table(); }
  /// Every table of an array of tables; none if the key is missing.
  std::vector<TableReader> tables(std::string_view key);

  std::size_t line() const { return table_.source().begin.line; }

  /// Refuses keys that nobody asked for, naming the nearest that there is.
  void finish() const;

  /// Refuses the value of a key (or, if there is no such key, the table).
  [[noreturn]] void refuse(std::string_view key, const std::string& given, const std::string& allowed) const;

 private:
  const toml::node* find(std::string_view key);
  std::vector<std::string> unknown_keys() const;
  const toml::node& require(std::string_view key, const std::string& allowed);
  double as_number(std::string_view key, const toml::node& node, const std::string& key_path, Allowed allowed,
                   std::string_view unit) const;
  std::string key_path(std::string_view key) const;
  [[noreturn]] void fail(const toml::source_region& where, const std::string& what) const;

  const toml::table& table_;
  std::string file_;
  std::string path_;
  std::vector<std::string> known_;
};

}  // namespace lubjoint
