/// What a foreign program answered.
#pragma once

#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/verify/states/quantity.hpp"

namespace lubjoint::verify {

/// Answers that can't be judged; the message says why, and what is expected.
class UnjudgedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Answer = std::array<double, most_answers>;

/// How far numbers were rounded on their way to us.
struct TextPrecision {
  double relative = 0;      ///< half a unit of the last significant digit printed, 0 for 17 digits and more
  double absolute = 0;      ///< half a unit of the last decimal, where all numbers have as many decimals
  int digits = 17;          ///< significant digits printed, at most
  int decimals = -1;        ///< where all numbers have as many
  bool all_single = false;  ///< every number is one of single precision
};

/// Answers in the order of the states; what is not finite is NaN.
struct Answers {
  std::vector<Answer> values;
  TextPrecision text;
  std::vector<std::size_t> columns;  ///< that were given; of a table any of them, of other quantities all
};

/// The columns of these quantities, all of them.
std::vector<std::size_t> all_columns(Quantities quantities);

/// Reads answers and puts them in the order of the states by their id. A byte-order mark, carriage returns and another
/// order are fine. Of a table (is_table) any columns may be left out, and a side flow may be empty where a bearing has
/// none.
/// @param name  of the source, for messages;  @param count  of states, ids 1…count
/// @throws UnjudgedError for a missing column, an id that is unknown, missing or there twice, or a field that is no
/// number
Answers read_answers(Quantities quantities, std::string_view csv, const std::string& name, std::size_t count);

/// Answers in another unit, which is so many of ours. A unit that is a power of two leaves their digits as they were.
void scale(Answers& answers, double unit);

/// Answers that were never text. Numbers that are not finite become NaN; a table's column without any number counts as
/// not given.
Answers answers_from_numbers(Quantities quantities, std::vector<Answer> values);

}  // namespace lubjoint::verify
