/// The proof ledger: statements about the formulas of this project, each proved or refuted by exact algebra.
///
/// A statement is a list of identities. An identity is proved when the difference of its sides normalises to zero in a
/// field of rational functions with square roots (algebra.hpp); it is refuted when a non-zero normal form is left. No
/// step samples numbers. Wrong statements stand in the ledger too: a prover that cannot fail would prove them.
///
/// GiNaC counts references without locks: one thread at a time. It orders the terms of a sum by addresses, so the
/// remainders quoted in the notes may come in another order in another run; the verdicts do not change.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lubjoint::proofs {

class Proof;

/// What is known of a statement before it is examined.
enum class Expectation {
  holds,           ///< an identity
  wrong,           ///< a common mistake or a deliberate one: must be refuted
  not_an_identity  ///< an approximation: must be refuted, and the difference is measured
};

enum class Outcome {
  proved,    ///< every identity of the statement normalised to zero
  refuted,   ///< an identity of the statement left a non-zero normal form
  undecided  ///< the algebra failed (the note says how)
};

/// A statement and the way to examine it.
struct Statement {
  std::string group;
  std::string text;
  std::string source;  ///< equation of Flores et al. (2009), or where the formula was derived
  Expectation expectation = Expectation::holds;
  std::function<void(Proof&)> examine;
  std::string note = {};
};

struct ProofResult {
  std::string group;
  std::string statement;
  std::string source;
  Expectation expectation = Expectation::holds;
  Outcome outcome = Outcome::undecided;
  int identities = 0;  ///< number of identities examined
  double seconds = 0;
  std::string note;

  bool should_hold() const { return expectation == Expectation::holds; }
  bool proved() const { return outcome == Outcome::proved; }
  /// True if what should hold was proved, and what is wrong was refuted.
  bool as_expected() const { return outcome == (should_hold() ? Outcome::proved : Outcome::refuted); }
};

/// Called after every statement with its result, its place (from 1) and the number of statements.
using Progress = std::function<void(const ProofResult&, std::size_t, std::size_t)>;

/// Every statement of the ledger, group by group.
std::vector<Statement> all_statements();

/// Examines one statement. Never throws: what the algebra could not do is an undecided result.
ProofResult prove(const Statement& statement);

/// Examines the whole ledger.
std::vector<ProofResult> prove_all(const Progress& progress = {});

/// True if every result is as expected.
bool ledger_closes(const std::vector<ProofResult>& results);

/// "proved", "refuted", "NOT PROVED", "NOT REFUTED", "not an identity" or "UNDECIDED".
std::string verdict(const ProofResult& result);

/// The ledger for people: group, verdict, time, source, statement, note, and a last line with the totals.
std::string ledger_table(const std::vector<ProofResult>& results);

// One function a file of proofs.
std::vector<Statement> reynolds_field_statements();
std::vector<Statement> force_integral_statements();
std::vector<Statement> dynamic_moment_statements();
std::vector<Statement> dynamic_frame_statements();
std::vector<Statement> limit_statements();
std::vector<Statement> symmetry_statements();
std::vector<Statement> passivity_statements();
std::vector<Statement> pinkus_sternlicht_statements();
std::vector<Statement> mechanics_statements();
std::vector<Statement> contact_statements();
std::vector<Statement> loss_statements();
std::vector<Statement> coefficient_statements();
std::vector<Statement> squeeze_statements();
std::vector<Statement> potential_statements();
std::vector<Statement> mobility_statements();
std::vector<Statement> spatial_mechanics_statements();
std::vector<Statement> spatial_joint_statements();
std::vector<Statement> spatial_chart_statements();

}  // namespace lubjoint::proofs
