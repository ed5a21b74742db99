/// CSV fields that may hold commas and quotes, such as messages (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports {

/// A field, in quotes where it needs them. Line breaks become spaces: a row is one line.
inline std::string quoted_field(std::string_view text) {
  std::string field;
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c == '\n' || c == '\r' ? ' ' : c;
  }
  return text.find_first_of(",\"") == std::string_view::npos ? field : "\"" + field + "\"";
}

/// The fields of a row, without their quotes.
inline std::vector<std::string> split_quoted(std::string_view row) {
  std::vector<std::string> fields(1);
  bool inside = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (inside && row[i] == '"' && i + 1 < row.size() && row[i + 1] == '"') {
      fields.back() += row[++i];
    } else if (row[i] == '"') {
      inside = !inside;
    } else if (row[i] == ',' && !inside) {
      fields.emplace_back();
    } else {
      fields.back() += row[i];
    }
  }
  return fields;
}

}  // namespace lubjoint::reports
