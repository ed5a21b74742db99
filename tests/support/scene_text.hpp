/// The text of a scene that ships, field by field, for tests that change one of them.
#pragma once

#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace lubjoint::test {

enum class FieldKind { number, vector, text, table };

struct SceneField {
  std::string path;   ///< as messages name it: "joints[0].bearing.point"
  std::string table;  ///< "joints[0].bearing", "" for the root
  std::string key;
  std::string value;  ///< as the file writes it
  FieldKind kind;
  std::size_t line;        ///< counted from 1
  std::size_t table_line;  ///< where the table begins
  std::size_t begin;       ///< of "key = value" in its line
  std::size_t length;
};

/// Lines of a scene file, and the fields in them. Reads what journal.toml uses: one field a line, [tables],
/// [[arrays of tables]] and inline tables.
class SceneText {
 public:
  explicit SceneText(const std::string& text) {
    std::istringstream stream(text);
    std::string table;
    std::size_t table_line = 1;
    std::map<std::string, int> count;
    for (std::string line; std::getline(stream, line);) {
      lines_.push_back(line);
      std::smatch match;
      if (std::regex_search(line, match, std::regex(R"(^\[\[(\w+)\]\])"))) {
        table = match[1].str() + "[" + std::to_string(count[match[1]]++) + "]";
        table_line = lines_.size();
      } else if (std::regex_search(line, match, std::regex(R"(^\[(\w+)\])"))) {
        table = match[1];
        table_line = lines_.size();
      } else {
        const std::string code = line.substr(0, line.find('#'));
        if (code.find('=') != std::string::npos) read(code, 0, table, table_line);
      }
    }
  }

  const std::vector<SceneField>& fields() const { return fields_; }

  const SceneField& field(const std::string& path) const {
    for (const SceneField& each : fields_) {
      if (each.path == path) return each;
    }
    throw std::out_of_range("the scene has no field " + path);
  }

  /// The file with another value for a field.
  std::string with(const SceneField& field, const std::string& value) const {
    return replaced(field, field.key + " = " + value);
  }
  std::string with(const std::string& path, const std::string& value) const { return with(field(path), value); }

  /// The file without a field; its lines keep their numbers.
  std::string without(const SceneField& field) const {
    std::string text = replaced(field, "");
    for (const char* loose : {"{, ", ", }"}) {  // commas of an inline table
      const std::size_t at = text.find(loose);
      if (at != std::string::npos) text.replace(at, 3, std::string(loose) == "{, " ? "{" : "}");
    }
    return text;
  }

  /// The file with "key = value" in place of a field.
  std::string replaced(const SceneField& field, const std::string& by) const {
    std::string text;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      std::string line = lines_[i];
      if (i + 1 == field.line) line.replace(field.begin, field.length, by);
      text += line + "\n";
    }
    return text;
  }

 private:
  /// Fields of a piece of a line: one of a table, or those inside of an inline table.
  void read(const std::string& code, std::size_t offset, const std::string& table, std::size_t table_line) {
    static const std::regex pair(R"((\w+)\s*=\s*(\{.*\}|\[[^\]]*\]|"[^"]*"|[^\s,}]+))");
    for (auto it = std::sregex_iterator(code.begin(), code.end(), pair); it != std::sregex_iterator(); ++it) {
      const std::string key = (*it)[1];
      const std::string value = (*it)[2];
      const FieldKind kind = value[0] == '{'   ? FieldKind::table
                             : value[0] == '[' ? FieldKind::vector
                             : value[0] == '"' ? FieldKind::text
                                               : FieldKind::number;
      const std::string path = table.empty() ? key : table + "." + key;
      const auto begin = offset + static_cast<std::size_t>(it->position(0));
      fields_.push_back({path, table, key, value, kind, lines_.size(), table_line, begin, it->str(0).size()});
      if (kind == FieldKind::table) {
        read(value.substr(1), offset + static_cast<std::size_t>(it->position(2)) + 1, path, lines_.size());
      }
    }
  }

  std::vector<std::string> lines_;
  std::vector<SceneField> fields_;
};

inline const std::string journal_scene_file = LUBJOINT_SOURCE_DIR "/data/scenes/journal.toml";

inline const SceneText& journal_text() {
  static const SceneText text(read_text(journal_scene_file));
  return text;
}

}  // namespace lubjoint::test
