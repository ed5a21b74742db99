/// What a verdict rests on: a list of checks, from which tables, CSV, page and exit status are made.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lubjoint::reports {

enum class CheckOutcome { passed, failed, not_checked };

/// One comparison with something that could have said no.
struct Check {
  std::string what;             ///< that is judged; the same for all items of a table
  std::string against;          ///< what it is held against
  std::optional<double> value;  ///< the difference found; none where words are compared, or nothing was checked
  std::optional<double> limit;  ///< the largest difference allowed
  std::string unit;             ///< of both; "" for none
  std::string found;            ///< in words, where no number is compared
  std::string reason;           ///< why the limit; of what was not checked, why it was not
  CheckOutcome outcome = CheckOutcome::not_checked;

  /// The check in which |value| ≤ limit is required; a value that is not a number fails.
  static Check at_most(std::string what, std::string against, double value, double limit, std::string unit,
                       std::string reason);
  /// The check of a statement.
  static Check holds(std::string what, std::string against, bool good, std::string found, std::string reason);
  static Check not_checked(std::string what, std::string reason);

  /// "e/c: 3.0e-06 c, allowed 1e-08", or in words what was found.
  std::string words() const;
};

/// A verdict on one item: what was checked of it.
struct Verdict {
  std::vector<Check> checks;

  std::size_t count(CheckOutcome outcome) const;
  bool failed() const { return count(CheckOutcome::failed) > 0; }
  /// At least one check could have said no, and none did.
  bool agrees() const { return !failed() && count(CheckOutcome::passed) > 0; }
  /// Words of the failed checks.
  std::vector<std::string> failures() const;
  /// "yes ABD", with a letter for each check that passed and "–" for each that was not made; "NO: " and what failed;
  /// "–" where nothing was checked. The letters are those of the legend.
  std::string in_letters() const;
  /// "yes", "no" or "-".
  std::string in_a_word() const;
};

/// Letter of check i in tables and legends: A … Z.
std::string check_letter(std::size_t i);

/// One line of a legend: a check over all items of a table.
struct CheckSummary {
  std::string letter;
  std::string what;
  std::string against;
  std::string largest;  ///< difference found, with its unit; "–" where words are compared
  std::string allowed;  ///< a limit, or a range of them
  std::string reason;
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t not_checked = 0;
};

/// The legend of a table whose items have the same checks in the same order.
/// @throws std::logic_error if they have not
std::vector<CheckSummary> summary_of_checks(const std::vector<const Verdict*>& verdicts);

/// The legend as text under a table, wrapped.
std::string check_legend(const std::vector<const Verdict*>& verdicts);

/// CSV, a row a check: item, check, what, outcome, value, limit, unit, found, against, reason.
std::string checks_csv(const std::vector<std::string>& items, const std::vector<const Verdict*>& verdicts);

}  // namespace lubjoint::reports
