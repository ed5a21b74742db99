#include "oracle/page/panel.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "oracle/files/files.hpp"
#include "oracle/page/html.hpp"

namespace lubjoint::reports::page {

namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t found = 0; (found = text.find(from, at)) != std::string::npos; at = found + from.size()) {
    result.append(text, at, found - at);
    result += to;
  }
  text = result.append(text, at);
}

/// Cuts every piece from `begin` up to and with the next `end`.
void cut_all(std::string& text, std::string_view begin, std::string_view end) {
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    const std::size_t last = text.find(end, at + begin.size());
    if (last == std::string::npos) return;
    text.erase(at, last + end.size() - at);
  }
}

/// Groups that hold nothing: gnuplot opens one at every change of the pen.
void cut_empty_groups(std::string& text) {
  for (std::size_t at = 0; (at = text.find("<g ", at)) != std::string::npos;) {
    const std::size_t end = text.find('>', at) + 1;
    const std::size_t next = text.find_first_not_of(" \t\n", end);
    if (next != std::string::npos && text.compare(next, 4, "</g>") == 0) {
      text.erase(at, next + 4 - at);
      at = at ? text.rfind("<g ", at - 1) : 0;  // the group around it may be empty now
      if (at == std::string::npos) at = 0;
    } else {
      at = end;
    }
  }
}

/// Colours as gnuplot writes them, and the variables of page.css.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> colours = {{
    {"rgb(  0, 114, 178)", "var(--blue)"},
    {"rgb(213,  94,   0)", "var(--vermillion)"},
    {"rgb(  0, 158, 115)", "var(--green)"},
    {"rgb(204, 121, 167)", "var(--purple)"},
    {"rgb(230, 159,   0)", "var(--orange)"},
    {"rgb( 86, 180, 233)", "var(--sky)"},
    {"rgb( 85,  85,  85)", "var(--muted)"},
    {"rgb(221, 221, 221)", "var(--grid)"},
    {"'black'", "'currentColor'"},
}};

}  // namespace

std::string inline_svg(const std::string& document, const Panel& panel) {
  const std::size_t begin = document.find("<g id=\"gnuplot_canvas\"");
  const std::size_t end = document.rfind("</svg>");
  if (begin == std::string::npos || end == std::string::npos) throw OutputError("gnuplot drew no SVG: " + panel.id);
  std::string body = document.substr(begin, end - begin);
  const std::size_t drawing = body.find("</defs>");
  const bool uses_symbols = drawing != std::string::npos && body.find("href='#gpPt", drawing) != std::string::npos;
  if (uses_symbols) {
    cut_all(body, "<filter", "</filter>");
  } else {
    cut_all(body, "<defs>", "</defs>");
  }
  cut_all(body, "<title>", "</title>");
  cut_all(body, " id=\"", "\"");
  cut_all(body, " font-family=\"", "\"");
  for (const char* pen : {" color=\"black\"", " color=\"white\"", " color=\"gray\""}) replace_all(body, pen, "");
  replace_all(body, "\"black\"", "\"currentColor\"");
  for (const auto& [from, to] : colours) replace_all(body, from, to);
  replace_all(body, " id='", " id='" + panel.id + "-");
  replace_all(body, "xlink:href='#", "href='#" + panel.id + "-");
  cut_empty_groups(body);
  for (const char* blank : {"\n\t\t", "\n\t", "\n "}) replace_all(body, blank, " ");
  while (body.find("\n\n") != std::string::npos) replace_all(body, "\n\n", "\n");
  return fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>", panel.plot.width,
                     panel.plot.height, escaped(panel.description), body);
}

std::string draw_panels(const std::vector<Panel>& panels) {
  std::vector<Plot> plots;
  plots.reserve(panels.size());
  for (const Panel& panel : panels) plots.push_back(panel.plot);
  const std::vector<std::string> documents = svg_of(plots);
  std::string html;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    html += fmt::format("<figure class=\"panel\" id=\"{}\">\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
                        escaped(panels[i].id), inline_svg(documents[i], panels[i]), escaped(panels[i].caption));
  }
  return html;
}

}  // namespace lubjoint::reports::page
