/// Which columns of a table are wrong, and how.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/states/judgement.hpp"

namespace lubjoint::verify {

/// right: at every decided state.  absent: zero.  factor: times one number.  other: what another column should be, or
/// minus that.  wrong: none of these.  undecided: at no state is there a number to be right.
enum class ColumnVerdict { right, absent, factor, other, wrong, undecided };
inline constexpr std::array<std::string_view, 6> column_verdict_names = {"right", "absent", "factor",
                                                                         "other", "wrong",  "undecided"};

/// One column of the answers.
struct ColumnResult {
  std::string_view name;
  ColumnVerdict verdict = ColumnVerdict::undecided;
  std::size_t states = 0;             ///< decided
  std::size_t failing = 0;            ///< of them
  double digits = 17;                 ///< that 95 % of them have, over the size of the column's vector or matrix
  std::optional<double> factor = {};  ///< "factor": of what it should be; "other": 1 or −1
  std::string factor_text = {};       ///< in words; may be empty
  std::string_view other = {};        ///< the column whose numbers it has

  bool is_off_as_a_whole() const {
    return verdict == ColumnVerdict::absent || verdict == ColumnVerdict::factor || verdict == ColumnVerdict::other;
  }
  std::string words() const;  ///< "2 times what it should be"
};

/// The columns that are judged, in their order; none for quantities that are no table.
std::vector<ColumnResult> columns_of(const Judgement& judgement, const Answers& answers);

}  // namespace lubjoint::verify
