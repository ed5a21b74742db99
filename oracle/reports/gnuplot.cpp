#include "oracle/reports/gnuplot.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "oracle/reports/files.hpp"

namespace lubjoint::reports {

namespace fs = std::filesystem;

namespace {

/// A path inside gnuplot's single quotes.
std::string quoted(const fs::path& path) {
  std::string text = "'";
  for (const char c : path.string()) text += c == '\'' ? std::string("''") : std::string(1, c);
  return text + "'";
}

/// A path inside the shell's single quotes.
std::string shell_quoted(const fs::path& path) {
  std::string text = "'";
  for (const char c : path.string()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void run(const fs::path& script) {
  const std::string command = "LC_ALL=C gnuplot " + shell_quoted(script) + " 2>&1";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) throw OutputError("gnuplot can't be started");
  std::string said;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) said.append(buffer.data(), count);
  if (::pclose(pipe) != 0) throw OutputError("gnuplot failed: " + said);
}

}  // namespace

void draw(const Plot& plot, const fs::path& folder, const std::string& name) {
  TemporaryFile script(folder / (name + ".gnuplot.part"));
  TemporaryFile svg(folder / (name + ".svg.part"));
  TemporaryFile png(folder / (name + ".png.part"));
  std::string text = "set encoding utf8\n";
  text += fmt::format(
      "set terminal svg size {},{} font 'Helvetica,12' background '#ffffff'\nset output {}\n{}\nunset output\nreset\n",
      plot.width, plot.height, quoted(svg.path()), plot.script);
  text += fmt::format(
      "set terminal pngcairo size {},{} font 'Sans,9' background '#ffffff'\nset output {}\n{}\nunset output\n",
      plot.width, plot.height, quoted(png.path()), plot.script);
  write_file(script.path(), text);
  run(script.path());
  svg.rename_to(folder / (name + ".svg"));
  png.rename_to(folder / (name + ".png"));
}

std::vector<std::string> svg_of(const std::vector<Plot>& plots, const fs::path& folder) {
  TemporaryFile script(folder / "panels.gnuplot.part");
  TemporaryFile drawn(folder / "panels.svg.part");
  std::string text = "set encoding utf8\nset terminal svg\nset output " + quoted(drawn.path()) + "\n";
  for (const Plot& plot : plots) {
    text += fmt::format("set terminal svg size {},{} font 'Helvetica,14'\n{}\nreset\n", plot.width, plot.height,
                        plot.script);
  }
  write_file(script.path(), text + "unset output\n");
  run(script.path());
  // One document after the other, each with its declaration.
  const std::string all = read_input(drawn.path().string());
  constexpr std::string_view declaration = "<?xml";
  std::vector<std::string> documents;
  for (std::size_t at = all.find(declaration); at != std::string::npos;) {
    const std::size_t next = all.find(declaration, at + 1);
    documents.push_back(all.substr(at, next == std::string::npos ? next : next - at));
    at = next;
  }
  if (documents.size() != plots.size()) {
    throw OutputError(fmt::format("gnuplot drew {} of {} plots", documents.size(), plots.size()));
  }
  return documents;
}

}  // namespace lubjoint::reports
