#include "oracle/page/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "oracle/page/resources.hpp"

namespace lubjoint::reports::page {

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string with_minus(std::string number) {
  if (number == "-0") return "0";
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

namespace {

/// "10⁻⁸"
std::string power_of_ten(int exponent) {
  constexpr const char* superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  for (const char c : fmt::format("{}", exponent)) text += c == '-' ? "⁻" : superscripts[c - '0'];
  return text;
}

}  // namespace

std::string scientific(double value, int digits) {
  if (value == 0) return "0";
  if (std::abs(value) >= 0.01 && std::abs(value) < 1000) {
    const int decimals = digits - static_cast<int>(std::floor(std::log10(std::abs(value))));
    return with_minus(fmt::format("{:.{}f}", value, std::max(decimals, 0)));
  }
  if (!std::isfinite(value)) return "not a number";
  const std::string plain = fmt::format("{:.{}e}", value, digits);
  const std::size_t e = plain.find('e');
  return with_minus(plain.substr(0, e) + " × " + power_of_ten(std::stoi(plain.substr(e + 1))));
}

std::string with_powers(const std::string& words) {
  static const std::regex power("(\\b[0-9]+(?:\\.[0-9]+)?)e([+-]?[0-9]+)\\b");
  std::string text;
  auto rest = words.cbegin();
  for (std::smatch match; std::regex_search(rest, words.cend(), match, power); rest = match.suffix().first) {
    text.append(rest, match[0].first);
    text += (match[1] == "1" ? std::string() : match[1].str() + " × ") + power_of_ten(std::stoi(match[2]));
  }
  return text.append(rest, words.cend());
}

std::string percent(double share) {
  const double hundredfold = 100 * share;
  if (share == 0) return "0 %";
  if (share >= 10) return scientific(share) + " times";
  if (hundredfold != 0 && std::abs(hundredfold) < 0.1) return fmt::format("{:.2g} %", hundredfold);
  return fmt::format("{:.{}f} %", hundredfold, std::abs(hundredfold) < 10 ? 1 : 0);
}

std::string filled(std::string_view resource_name, const Fields& fields) {
  const std::string_view text = resource(resource_name);
  std::string html;
  std::map<std::string, int, std::less<>> used;
  for (std::size_t at = 0;;) {
    const std::size_t open = text.find("{{", at);
    html += text.substr(at, open == std::string_view::npos ? open : open - at);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    if (close == std::string_view::npos) throw std::logic_error(std::string(resource_name) + ": {{ without }}");
    const std::string name(text.substr(open + 2, close - open - 2));
    const auto field = fields.find(name);
    if (field == fields.end()) throw std::logic_error(std::string(resource_name) + " asks for {{" + name + "}}");
    html += field->second;
    ++used[name];
    at = close + 2;
  }
  for (const auto& [name, value] : fields) {
    if (!used.contains(name)) throw std::logic_error(std::string(resource_name) + " does not use {{" + name + "}}");
  }
  return html;
}

Cell verdict_cell(bool good, const std::string& words) { return {(good ? "✓ " : "✗ ") + words, good ? "good" : "bad"}; }

Table::Table(std::string caption, std::vector<Column> columns)
    : caption_(std::move(caption)), columns_(std::move(columns)) {}

void Table::row(std::vector<Cell> cells) {
  if (cells.size() != columns_.size()) throw std::logic_error("table \"" + caption_ + "\": a row of another length");
  rows_.push_back(std::move(cells));
}

std::string Table::html() const {
  std::string html = fmt::format(
      "<div class=\"scroll{1}\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\">\n<table>\n<caption>{0}</caption>\n"
      "<thead><tr>",
      escaped(caption_), cards_ ? " cards" : "");
  for (const Column& column : columns_) {
    const std::string unit =
        column.unit.empty() ? std::string() : " <span class=\"unit\">[" + escaped(column.unit) + "]</span>";
    html += fmt::format("<th scope=\"col\"{}>{}{}</th>", column.number ? " class=\"number\"" : "", escaped(column.head),
                        unit);
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : rows_) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::string look = row[i].look;
      if (columns_[i].number) look += look.empty() ? "number" : " number";
      if (!look.empty()) look = " class=\"" + escaped(look) + "\"";
      html += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", look, escaped(row[i].text))
                     : fmt::format("<td{}{}>{}</td>", look,
                                   cards_ ? fmt::format(" data-head=\"{}\"", escaped(columns_[i].head)) : "",
                                   escaped(columns_[i].number ? with_minus(row[i].text) : row[i].text));
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string json_block(std::string_view id, std::string_view json) {
  // A "<" appears only inside of JSON's strings: there it has another spelling, which no HTML parser takes for a tag.
  std::string safe;
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", escaped(id), safe);
}

std::string csv_block(std::string_view id, std::string_view file_name, std::string_view csv) {
  constexpr auto replace = nlohmann::json::error_handler_t::replace;  // bytes that are no UTF-8
  return json_block(id, nlohmann::json(std::string(csv)).dump(-1, ' ', false, replace)) +
         fmt::format(
             "<p class=\"download\"><button type=\"button\" data-csv=\"{0}\" data-file=\"{1}\">Save {1}</button></p>\n",
             escaped(id), escaped(file_name));
}

}  // namespace lubjoint::reports::page
