#include "oracle/verify/states/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <locale>
#include <numeric>
#include <optional>
#include <sstream>

#include "oracle/files/csv_table.hpp"
#include "oracle/verify/states/single_precision.hpp"

namespace lubjoint::verify {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A number beyond the range of doubles: 0 if it is too small for them, as from a program in extended precision.
double tiny_or_nan(std::string_view field) {
  std::istringstream stream{std::string(field)};
  stream.imbue(std::locale::classic());
  double value = 0;
  return stream >> value ? value : nan;
}

/// NaN also for the words and overflows that programs print where they have no number.
std::optional<double> number_or_nan(std::string_view field) {
  field = reports::without_plus(field);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool complete = end == field.data() + field.size() && !field.empty();
  if (complete && error == std::errc()) return std::isfinite(value) ? value : nan;
  if (complete && error == std::errc::result_out_of_range) return tiny_or_nan(field);
  std::string word(field);
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view none : {"nan", "-nan", "na", "none", "inf", "-inf", "infinity", "-infinity", "nan(ind)",
                                      "-nan(ind)", "1.#qnan", "-1.#ind", "1.#inf"}) {
    if (word == none) return nan;
  }
  return std::nullopt;
}

/// Significant digits and decimals of the numbers seen so far.
class DigitCounter {
 public:
  void see(std::string_view field) {
    int digits = 0;
    int decimals = -1;
    bool leading = true;
    for (const char c : field) {
      if (c == 'e' || c == 'E') {
        fixed_ = false;
        break;
      }
      if (c == '.') {
        decimals = 0;
        continue;
      }
      if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
      if (decimals >= 0) ++decimals;
      leading = leading && c == '0';
      if (!leading) ++digits;
    }
    if (digits == 0) return;
    if (numbers_ > 0 && decimals != decimals_) fixed_ = false;
    varies_ = varies_ || (numbers_ > 0 && digits != last_digits_);
    decimals_ = decimals;
    last_digits_ = digits;
    most_digits_ = std::max(most_digits_, digits);
    ++numbers_;
  }

  TextPrecision result() const {
    TextPrecision text;
    if (numbers_ == 0) return text;
    if (fixed_ && varies_ && numbers_ >= 10 && decimals_ > 0) {
      text.decimals = decimals_;
      text.absolute = 0.5 * std::pow(10.0, -decimals_);
    }
    text.digits = std::min(most_digits_, 17);
    // 17 digits name a double; 16 may be the shortest form that does.
    if (text.digits < 16) text.relative = 0.5 * std::pow(10.0, 1 - text.digits);
    if (text.decimals >= 0) text.relative = 0;
    return text;
  }

 private:
  int numbers_ = 0;
  int most_digits_ = 0;
  int last_digits_ = 0;
  int decimals_ = -1;
  bool fixed_ = true;
  bool varies_ = false;
};

/// True if every number is exact in single precision, and there are enough of them for that to be no accident.
bool all_in_single(const std::vector<Answer>& values, const std::vector<std::size_t>& columns) {
  std::size_t numbers = 0;
  for (const Answer& answer : values) {
    for (const std::size_t k : columns) {
      if (std::isnan(answer[k]) || answer[k] == 0) continue;
      if (!is_single(answer[k])) return false;
      ++numbers;
    }
  }
  return numbers >= 10;
}

std::optional<std::size_t> id_of(std::string_view field, std::size_t count) {
  const std::optional<double> value = number_or_nan(field);  // some programs print ids as 1.0
  if (!value || !(*value >= 1) || *value > static_cast<double>(count) || *value != std::floor(*value)) return {};
  return static_cast<std::size_t>(*value) - 1;
}

std::string expected_header(Quantities quantities) {
  std::string header = is_table(quantities) ? "" : "id";
  for (const std::string_view name : answer_columns(quantities)) header.append(header.empty() ? "" : ",").append(name);
  return header;
}

}  // namespace

std::vector<std::size_t> all_columns(Quantities quantities) {
  std::vector<std::size_t> all(answer_columns(quantities).size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

Answers read_answers(Quantities quantities, std::string_view csv, const std::string& name, std::size_t count) {
  const std::string wanted = std::string("; expected are the columns ") +
                             (is_table(quantities) ? "id and any of " : "") + expected_header(quantities) +
                             " and one row a state";
  const auto& names = answer_columns(quantities);
  try {
    const reports::CsvTable table(csv, name);
    // Without ids a program has kept the order, if there is a row for every state.
    const auto has = [&](std::string_view column) {
      return std::ranges::find(table.columns(), column) != table.columns().end();
    };
    Answers answers;
    for (const std::size_t k : all_columns(quantities)) {
      if (!is_table(quantities) || has(names[k])) answers.columns.push_back(k);
    }
    if (answers.columns.empty()) throw UnjudgedError(name + ": none of the columns is there" + wanted);
    const bool in_order =
        !has("id") && std::ranges::all_of(answers.columns, [&](std::size_t k) { return has(names[k]); });
    if (in_order && table.rows() != count) {
      throw UnjudgedError(fmt::format("{}: {} rows without ids for {} states; allowed is one row a state, in order",
                                      name, table.rows(), count) +
                          wanted);
    }
    const std::size_t id = in_order ? 0 : table.column("id");
    std::vector<std::size_t> columns;
    columns.reserve(answers.columns.size());
    for (const std::size_t k : answers.columns) columns.push_back(table.column(names[k]));
    answers.values.assign(count, Answer{});
    std::vector<bool> seen(count, false);
    DigitCounter digits;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::optional<std::size_t> place = in_order ? row : id_of(table.field(row, id), count);
      if (!place) {
        table.refuse(row, fmt::format("id is \"{}\"; allowed is a whole number from 1 to {}, the id of a state",
                                      table.field(row, id), count));
      }
      if (seen[*place]) table.refuse(row, fmt::format("id {} is there twice; allowed is one row a state", *place + 1));
      seen[*place] = true;
      for (std::size_t n = 0; n < columns.size(); ++n) {
        const std::size_t k = answers.columns[n];
        const std::string_view field = table.field(row, columns[n]);
        const bool undefined = field.empty() && names[k] == "side_flow";
        const std::optional<double> value = undefined ? nan : number_or_nan(field);
        if (!value) table.refuse(row, fmt::format("{} is \"{}\"; allowed is a number", names[k], field));
        answers.values[*place][k] = *value;
        if (!std::isnan(*value)) digits.see(field);
      }
    }
    const auto missing = std::ranges::find(seen, false);
    if (missing != seen.end()) {
      throw UnjudgedError(fmt::format("{}: {} of {} states are answered; the first without an answer has id {}", name,
                                      std::ranges::count(seen, true), count, missing - seen.begin() + 1) +
                          wanted);
    }
    answers.text = digits.result();
    answers.text.all_single = all_in_single(answers.values, answers.columns);
    return answers;
  } catch (const reports::CsvError& error) {
    throw UnjudgedError(error.what() + wanted);
  }
}

void scale(Answers& answers, double unit) {
  if (unit == 1) return;
  for (Answer& answer : answers.values) {
    for (double& number : answer) number *= unit;
  }
  answers.text.absolute *= unit;
}

Answers answers_from_numbers(Quantities quantities, std::vector<Answer> values) {
  for (Answer& answer : values) {
    for (double& value : answer) {
      if (!std::isfinite(value)) value = nan;
    }
  }
  Answers answers{std::move(values), {}, {}};
  for (const std::size_t k : all_columns(quantities)) {
    const bool any = std::ranges::any_of(answers.values, [&](const Answer& a) { return !std::isnan(a[k]); });
    if (any || !is_table(quantities)) answers.columns.push_back(k);
  }
  if (answers.columns.empty()) answers.columns = all_columns(quantities);
  answers.text.all_single = all_in_single(answers.values, answers.columns);
  return answers;
}

}  // namespace lubjoint::verify
