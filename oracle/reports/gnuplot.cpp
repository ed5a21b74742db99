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
  struct Format {
    const char* extension;
    std::string terminal;
  };
  const std::array<Format, 2> formats = {
      Format{"svg", fmt::format("svg size {},{} font 'Helvetica,12' background '#ffffff'", plot.width, plot.height)},
      Format{"png", fmt::format("pngcairo size {},{} font 'Sans,9' background '#ffffff'", plot.width, plot.height)}};
  const fs::path script = folder / (name + ".gnuplot.part");
  std::string text = "set encoding utf8\n";
  for (const Format& format : formats) {
    text += "set terminal " + format.terminal + "\nset output " +
            quoted(folder / (name + "." + format.extension + ".part")) + "\n" + plot.script + "\nunset output\nreset\n";
  }
  std::error_code error;
  try {
    write_file(script, text);
    run(script);
  } catch (...) {
    fs::remove(script, error);
    for (const Format& format : formats) fs::remove(folder / (name + "." + format.extension + ".part"), error);
    throw;
  }
  fs::remove(script, error);
  for (const Format& format : formats) {
    fs::rename(folder / (name + "." + format.extension + ".part"), folder / (name + "." + format.extension));
  }
}

}  // namespace lubjoint::reports
