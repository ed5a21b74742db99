#include "oracle/sweep/sweep_grid.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::size_t most_points = 1'000'000;
constexpr const char* forms =
    "KEY=LO:HI:N, KEY=log:LO:HI:N or KEY=A,B,..., such as joints[0].clearance=1e-4:5e-4:5 or "
    "joints[0].film=short_half,long_half";

[[noreturn]] void refuse(const std::string& given, const std::string& what, const std::string& allowed) {
  throw std::invalid_argument(given + ": " + what + "; allowed is " + allowed);
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> pieces;
  while (true) {
    const std::size_t end = text.find(at);
    pieces.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

template <class Number>
std::optional<Number> read_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double bound(const std::string& given, const std::string& piece) {
  const std::optional<double> value = read_number<double>(piece);
  if (!value || !std::isfinite(*value)) refuse(given, "bound \"" + piece + "\"", "a finite number");
  return *value;
}

/// To 15 significant digits, which every decimal of 15 digits survives: 2e-4, not 0.00019999999999999998.
double to_15_digits(long double value) {
  std::array<char, 40> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), static_cast<double>(value),
                                     std::chars_format::scientific, 14);
  double rounded = 0;
  std::from_chars(text.data(), written.ptr, rounded);
  return rounded;
}

/// Values from low to high, both exact.
std::vector<double> spread(const std::string& given, const std::vector<std::string>& pieces, bool ratios) {
  const double low = bound(given, pieces[0]);
  const double high = bound(given, pieces[1]);
  const std::optional<std::size_t> count = read_number<std::size_t>(pieces[2]);
  if (!count || *count == 0 || *count > most_points) {
    refuse(given, "number of values \"" + pieces[2] + "\"", "a whole number from 1 to " + std::to_string(most_points));
  }
  if (*count == 1 && low != high) refuse(given, "one value between two bounds", "N of 2 or more, or LO equal to HI");
  if (ratios && !(low > 0 && high > 0)) refuse(given, "a bound that is not above 0", "log: with bounds above 0");
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < *count; ++i) {
    const long double share = static_cast<long double>(i) / static_cast<long double>(*count - 1);
    const auto mean = [&](long double a, long double b) { return (1 - share) * a + share * b; };
    const long double between =
        ratios ? std::exp(mean(std::log(static_cast<long double>(low)), std::log(static_cast<long double>(high))))
               : mean(low, high);
    values.push_back(i == 0 ? low : to_15_digits(between));
  }
  values.push_back(high);
  return values;
}

SceneValue listed(const std::string& given, const std::string& piece) {
  if (piece.empty()) refuse(given, "an empty value", forms);
  if (piece == "true" || piece == "false") return piece == "true";
  const std::optional<double> value = read_number<double>(piece);
  return value ? SceneValue(*value) : SceneValue(piece);
}

/// A name of a body, joint, constraint or scene: rows and columns are called by it.
bool is_name(const std::string& key) {
  return key == "name" || (key.ends_with("].name") && key.find('.') == key.rfind('.'));
}

}  // namespace

SweptKey parse_swept_key(const std::string& text) {
  const std::string given = "--vary " + text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse(given, "no key and values", forms);
  SweptKey swept{text.substr(0, equals), {}};
  std::string values = text.substr(equals + 1);
  const bool ratios = values.starts_with("log:");
  const std::vector<std::string> pieces = split(ratios ? values.substr(4) : values, ':');
  if (ratios || pieces.size() > 1) {
    if (pieces.size() != 3) refuse(given, "not two bounds and a number", forms);
    for (const double value : spread(given, pieces, ratios)) swept.values.emplace_back(value);
    return swept;
  }
  for (const std::string& piece : split(values, ',')) swept.values.push_back(listed(given, piece));
  return swept;
}

std::vector<double> parse_range(const std::string& option, const std::string& text) {
  const std::string given = option + " " + text;
  const bool ratios = text.starts_with("log:");
  const std::vector<std::string> pieces = split(ratios ? text.substr(4) : text, ':');
  if (pieces.size() != 3) {
    refuse(given, "not two bounds and a number", "LO:HI:N or log:LO:HI:N, such as 50:500:10");
  }
  return spread(given, pieces, ratios);
}

std::string shown(const SceneValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return number(*real);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  return std::get<std::string>(value);
}

SweepGrid::SweepGrid(std::vector<SweptKey> keys) : keys_(std::move(keys)) {
  if (keys_.empty()) throw std::invalid_argument(std::string("--vary is missing; required is ") + forms);
  std::sort(keys_.begin(), keys_.end(), [](const SweptKey& a, const SweptKey& b) { return a.key < b.key; });
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const std::string& key = keys_[i].key;
    if (is_name(key)) refuse("--vary " + key, "a name", "a quantity: rows and columns are called by names");
    if (i > 0 && keys_[i - 1].key == key) refuse("--vary " + key, "given twice", "every key once");
    if (keys_[i].values.size() > most_points / size_) {
      refuse("--vary " + key, "more points than can be meant", "at most " + std::to_string(most_points) + " in all");
    }
    size_ *= keys_[i].values.size();
  }
}

std::vector<SceneChange> SweepGrid::point(std::size_t index) const {
  std::vector<SceneChange> changes(keys_.size());
  for (std::size_t k = keys_.size(); k-- > 0;) {
    const std::size_t count = keys_[k].values.size();
    changes[k] = {keys_[k].key, keys_[k].values[index % count]};
    index /= count;
  }
  return changes;
}

std::string SweepGrid::name(std::size_t index) const {
  std::string text = "point " + std::to_string(index) + " (";
  for (const SceneChange& change : point(index)) {
    if (text.back() != '(') text += ", ";
    text += change.key + " = " + shown(change.value);
  }
  return text + ")";
}

}  // namespace lubjoint::reports
