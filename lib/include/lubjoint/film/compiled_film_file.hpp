/// Compiled films as text files: one film a file, numbers that read back as the same doubles, and a checksum.
///
///   lubjoint compiled film 1
///   film finite_full
///   length_over_diameter 0.5
///   ratio_limit 0.99
///   error 3.1e-09
///   coefficients 56
///   0.98…                      (one a line)
///   checksum 0123456789abcdef  (of all that is above)
#pragma once

#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lubjoint/film/compiled_law.hpp"

namespace lubjoint {

/// Text that is not a compiled film, or not all of one.
class CompiledFilmError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace detail {

inline constexpr std::string_view compiled_film_title = "lubjoint compiled film 1";

/// FNV-1a, 64 bits (Fowler, Noll and Vo): finds what was changed or cut off by accident.
inline std::uint64_t text_checksum(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

template <class Number, class... Format>
std::string number_text(Number number, Format... format) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number, format...).ptr;
  return std::string(buffer, end);
}

/// Lines of a text, one after the other.
class FilmLines {
 public:
  explicit FilmLines(std::string_view text) : rest_(text) {}

  std::string_view next() {
    ++line_;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) refuse("ends too early");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }
  /// What follows a keyword.
  std::string_view after(std::string_view keyword) {
    const std::string_view line = next();
    if (!line.starts_with(keyword) || line.size() <= keyword.size() || line[keyword.size()] != ' ') {
      refuse("should start with \"" + std::string(keyword) + " \"");
    }
    return line.substr(keyword.size() + 1);
  }
  template <class Number, class... Format>
  Number number(std::string_view text, Format... format) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, format...);
    if (error != std::errc() || end != text.data() + text.size()) refuse("has no number where one should be");
    return number;
  }
  std::size_t left() const { return rest_.size(); }
  [[noreturn]] void refuse(const std::string& reason) const {
    throw CompiledFilmError("no compiled film: line " + std::to_string(line_) + " " + reason);
  }

 private:
  std::string_view rest_;
  int line_ = 0;
};

}  // namespace detail

/// The text of a compiled film.
inline std::string compiled_film_text(const CompiledFilm& film) {
  const auto number = [](auto x) { return detail::number_text(x); };
  std::string text = std::string(detail::compiled_film_title) + "\nfilm " + film.film + "\nlength_over_diameter " +
                     number(film.shape) + "\nratio_limit " + number(film.ratio_limit) + "\nerror " +
                     number(film.error) + "\ncoefficients " + number(film.coefficients.size()) + "\n";
  for (const double c : film.coefficients) text += number(c) + "\n";
  return text + "checksum " + detail::number_text(detail::text_checksum(text), 16) + "\n";
}

/// The film of a text.
/// @throws CompiledFilmError that says in which line what is wrong; if the checksum is not the text's; if something
///         follows
inline CompiledFilm read_compiled_film(std::string_view text) {
  detail::FilmLines lines(text);
  if (lines.next() != detail::compiled_film_title) {
    lines.refuse("should be \"" + std::string(detail::compiled_film_title) + "\"");
  }
  CompiledFilm film;
  film.film = lines.after("film");
  film.shape = lines.number<double>(lines.after("length_over_diameter"));
  film.ratio_limit = lines.number<double>(lines.after("ratio_limit"));
  film.error = lines.number<double>(lines.after("error"));
  const auto count = lines.number<std::size_t>(lines.after("coefficients"));
  if (count > lines.left()) lines.refuse("asks for more coefficients than follow");
  for (std::size_t i = 0; i < count; ++i) film.coefficients.push_back(lines.number<double>(lines.next()));
  const std::size_t body = text.size() - lines.left();
  const auto checksum = lines.number<std::uint64_t>(lines.after("checksum"), 16);
  if (checksum != detail::text_checksum(text.substr(0, body))) lines.refuse("is not the checksum of what is above");
  if (lines.left() > 0) lines.refuse("should be the last");
  return film;
}

}  // namespace lubjoint
