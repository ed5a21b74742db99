// Numbers written into the text of a scene file.
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "lubjoint/scene/scene_assembly.hpp"
#include "lubjoint/text/printable.hpp"

namespace lubjoint {

namespace {

/// Digits that read back as the same number.
std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value);
  if (error != std::errc()) throw std::logic_error("a number has more digits than there are");
  return {text.data(), end};
}

std::string shown(const std::vector<double>& numbers) {
  if (numbers.size() == 1) return shortest(numbers[0]);
  std::string text = "[";
  for (const double number : numbers) text += (text.size() > 1 ? ", " : "") + shortest(number);
  return text + "]";
}

/// Byte of a place that is given by line and character, both from 1.
std::size_t byte_of(const std::string& text, const toml::source_position& place) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // byte order mark
  for (toml::source_index line = 1; line < place.line; ++line) at = text.find('\n', at) + 1;
  for (toml::source_index column = 1; column < place.column && at < text.size(); ++column) {
    do {
      ++at;
    } while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80);
  }
  return at;
}

struct Edit {
  std::size_t begin;
  std::size_t end;
  std::string by;
};

}  // namespace

std::string with_numbers(const SceneFile& file, const std::vector<WrittenNumbers>& all) {
  std::string text = file.text();
  const toml::table root = [&] {
    try {
      return toml::parse(text, file.name());
    } catch (const toml::parse_error& failure) {
      throw SceneError(file.name() + ": not valid TOML: " + printable(failure.description()) + "; allowed is TOML 1.0");
    }
  }();
  std::vector<Edit> edits;
  for (const WrittenNumbers& each : all) {
    const toml::table* table = root[each.table][each.element].as_table();
    if (table == nullptr) throw std::logic_error("a scene has no " + each.table + " of that number");
    if (const toml::node* value = table->get(each.key)) {
      edits.push_back({byte_of(text, value->source().begin), byte_of(text, value->source().end), shown(each.numbers)});
      continue;
    }
    const bool is_zero = std::all_of(each.numbers.begin(), each.numbers.end(), [](double x) { return x == 0; });
    if (is_zero && each.zero_is_default) continue;
    // Behind the name, which every element has.
    const std::size_t end = byte_of(text, table->get("name")->source().end);
    const std::string added = each.key + " = " + shown(each.numbers);
    if (table->is_inline()) {
      edits.push_back({end, end, ", " + added});
    } else {
      const std::size_t line_end = std::min(text.find('\n', end), text.size());
      edits.push_back({line_end, line_end, "\n" + added});
    }
  }
  // From the end, so that earlier places stay; what is added at one place keeps its order.
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
    text.replace(edit->begin, edit->end - edit->begin, edit->by);
  return text;
}

}  // namespace lubjoint
