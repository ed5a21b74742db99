#include "oracle/verify/states/answers.hpp"

#include <algorithm>
#include <cmath>

#include "fuzz/targets.hpp"
#include "oracle/files/csv_table.hpp"

namespace lubjoint::fuzz {

namespace {

/// Every number against the C library's reading of its field; what is no number there must be NaN here.
void require_same_numbers(const verify::Answers& answers, verify::Quantities quantities, std::string_view csv) {
  const reports::CsvTable table(csv, "any.csv");
  // Without ids the rows are in the order of the states.
  const bool has_ids = std::ranges::find(table.columns(), "id") != table.columns().end();
  const auto& names = verify::answer_columns(quantities);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t place = has_ids ? static_cast<std::size_t>(table.number(row, table.column("id"))) - 1 : row;
    for (const std::size_t k : answers.columns) {
      const double read = answers.values.at(place)[k];
      require(!std::isinf(read), "no infinite number is accepted");
      const std::string field(table.field(row, table.column(names[k])));
      if (field.empty()) {
        require(std::isnan(read) && names[k] == "side_flow", "a flow alone may be left empty");
        continue;
      }
      char* end = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      if (end != field.c_str() + field.size()) {
        require(std::isnan(read), "what is no number is NaN: " + field);
      } else {
        require(std::isfinite(value) ? read == value : std::isnan(read), "a number is read as it is: " + field);
      }
    }
  }
}

}  // namespace

void answers(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto kind =
      static_cast<verify::Quantities>(static_cast<unsigned char>(bytes[0]) % verify::quantities_names.size());
  bytes.remove_prefix(1);
  constexpr std::size_t count = 3;
  try {
    const verify::Answers answers = verify::read_answers(kind, bytes, "any.csv", count);
    require(answers.values.size() == count, "an answer for every state");
    require_same_numbers(answers, kind, bytes);
    const verify::TextPrecision& text = answers.text;
    require(text.digits >= 1 && text.digits <= 17, "digits are from 1 to 17");
    require(text.decimals >= -1, "decimals are counted, or -1");
    require(text.relative >= 0 && text.relative <= 0.5, "half a unit of the last of one digit or more");
    require(text.absolute >= 0 && text.absolute <= 0.5, "half a unit of the last decimal");
    require(text.relative == 0 || text.absolute == 0, "rounding is relative or absolute");
  } catch (const verify::UnjudgedError& error) {
    require_refusal(error.what(), "any.csv");
  }
}

}  // namespace lubjoint::fuzz
