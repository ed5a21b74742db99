#include "oracle/plot/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

/// Text in memory that a program we start can open as a file: nothing is left of it, whatever happens to either.
class TextInMemory {
 public:
  TextInMemory() : descriptor_(::memfd_create("gnuplot", 0)) {
    if (descriptor_ < 0) refuse();
  }
  ~TextInMemory() { ::close(descriptor_); }
  TextInMemory(const TextInMemory&) = delete;
  TextInMemory& operator=(const TextInMemory&) = delete;

  std::string name() const { return "/dev/fd/" + std::to_string(descriptor_); }
  void write(const std::string& text) {
    if (::write(descriptor_, text.data(), text.size()) != static_cast<::ssize_t>(text.size())) refuse();
  }
  std::string read() const {
    std::string text(4096, '\0');
    const ::ssize_t size = ::pread(descriptor_, text.data(), text.size(), 0);
    text.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return text;
  }

 private:
  [[noreturn]] static void refuse() {
    throw OutputError("no memory for gnuplot: " + std::generic_category().message(errno));
  }
  int descriptor_;
};

/// What gnuplot draws with a script, on its standard output.
std::string drawn(const std::string& script) {
  TextInMemory commands;
  const TextInMemory complaints;
  commands.write(script);
  const std::string command = "LC_ALL=C gnuplot " + commands.name() + " 2>" + complaints.name();
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) throw OutputError("gnuplot can't be started");
  std::string picture;
  std::array<char, 65536> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) picture.append(buffer.data(), n);
  if (::pclose(pipe) != 0) throw OutputError("gnuplot failed: " + complaints.read());
  return picture;
}

}  // namespace

void draw(const Plot& plot, const std::filesystem::path& folder, const std::string& name) {
  // One after the other on standard output: a PNG begins with bytes that no text has.
  const std::string pictures =
      drawn(fmt::format("set encoding utf8\n"
                        "set terminal svg size {0},{1} font 'Helvetica,12' background '#ffffff'\n{2}\nreset\n"
                        "set terminal pngcairo size {0},{1} font 'Sans,9' background '#ffffff'\n{2}\n",
                        plot.width, plot.height, plot.script));
  const std::size_t png_begin = pictures.find("\x89PNG\r\n");
  if (png_begin == std::string::npos) throw OutputError("gnuplot drew nothing for " + name);
  TemporaryFile svg(folder / (name + ".svg"));
  TemporaryFile png(folder / (name + ".png"));
  svg.write(std::string_view(pictures).substr(0, png_begin));
  png.write(std::string_view(pictures).substr(png_begin));
  svg.keep();
  png.keep();
}

std::vector<std::string> svg_of(const std::vector<Plot>& plots) {
  std::string text = "set encoding utf8\nset terminal svg\n";
  for (const Plot& plot : plots) {
    text += fmt::format("set terminal svg size {},{} font 'Helvetica,14'\n{}\nreset\n", plot.width, plot.height,
                        plot.script);
  }
  // One document after the other, each with its declaration.
  const std::string all = drawn(text);
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
