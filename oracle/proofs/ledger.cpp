#include "oracle/proofs/ledger.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iomanip>
#include <sstream>

#include "oracle/proofs/algebra.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LUBJOINT_LEAK_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define LUBJOINT_LEAK_SANITIZER
#endif

#ifdef LUBJOINT_LEAK_SANITIZER
// CLN, which GiNaC computes with, never frees a string of its start-up code: 26 bytes in every program linked with it.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libcln.so\n"; }
#endif

namespace lubjoint::proofs {

std::vector<Statement> all_statements() {
  std::vector<Statement> all;
  for (const auto group :
       {reynolds_field_statements, force_integral_statements, dynamic_moment_statements, dynamic_frame_statements,
        limit_statements, symmetry_statements, passivity_statements, pinkus_sternlicht_statements, mechanics_statements,
        contact_statements, loss_statements, coefficient_statements, squeeze_statements, potential_statements,
        mobility_statements, spatial_mechanics_statements, spatial_joint_statements, spatial_chart_statements}) {
    for (Statement& statement : group()) {
      // Beside the others of its group, in the order in which the groups first appear.
      const auto same_group = [&](const Statement& other) { return other.group == statement.group; };
      const auto last = std::find_if(all.rbegin(), all.rend(), same_group);
      all.insert(last == all.rend() ? all.end() : last.base(), std::move(statement));
    }
  }
  return all;
}

ProofResult prove(const Statement& statement) {
  using Clock = std::chrono::steady_clock;
  ProofResult result;
  result.group = statement.group;
  result.statement = statement.text;
  result.source = statement.source;
  result.expectation = statement.expectation;
  result.note = statement.note;
  const Clock::time_point start = Clock::now();
  Proof proof;
  try {
    statement.examine(proof);
    if (proof.examined()) result.outcome = proof.holds() ? Outcome::proved : Outcome::refuted;
    if (!proof.examined()) proof.remark("no identity was examined");
  } catch (const std::exception& error) {
    result.outcome = Outcome::undecided;
    proof.remark(error.what());
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  result.identities = proof.identities();
  if (!proof.note().empty()) result.note += (result.note.empty() ? "" : "; ") + proof.note();
  return result;
}

std::vector<ProofResult> prove_all(const Progress& progress) {
  const std::vector<Statement> statements = all_statements();
  std::vector<ProofResult> results;
  results.reserve(statements.size());
  for (const Statement& statement : statements) {
    results.push_back(prove(statement));
    if (progress) progress(results.back(), results.size(), statements.size());
  }
  return results;
}

bool ledger_closes(const std::vector<ProofResult>& results) {
  return !results.empty() && std::ranges::all_of(results, &ProofResult::as_expected);
}

std::string verdict(const ProofResult& result) {
  if (result.outcome == Outcome::undecided) return "UNDECIDED";
  if (result.should_hold()) return result.proved() ? "proved" : "NOT PROVED";
  if (result.proved()) return "NOT REFUTED";
  return result.expectation == Expectation::wrong ? "refuted" : "not an identity";
}

std::string ledger_table(const std::vector<ProofResult>& results) {
  std::ostringstream table;
  table << std::fixed << std::setprecision(2);
  std::string group;
  double seconds = 0;
  int identities = 0;
  std::size_t proved = 0;
  std::size_t refuted = 0;
  std::size_t unexpected = 0;
  for (const ProofResult& result : results) {
    if (result.group != group) {
      group = result.group;
      table << "\n" << group << "\n";
    }
    table << "  " << std::left << std::setw(16) << verdict(result) << std::right << std::setw(6) << result.seconds
          << " s  " << result.statement << "  [" << result.source << "]\n";
    if (!result.note.empty()) table << std::string(28, ' ') << "(" << result.note << ")\n";
    seconds += result.seconds;
    identities += result.identities;
    proved += result.should_hold() && result.proved() ? 1U : 0U;
    refuted += !result.should_hold() && result.as_expected() ? 1U : 0U;
    unexpected += result.as_expected() ? 0U : 1U;
  }
  table << "\n"
        << results.size() << " statements: " << proved << " proved, " << refuted << " refuted as they should be, "
        << unexpected << " not as expected; " << identities << " identities in " << seconds << " s\n";
  return table.str();
}

}  // namespace lubjoint::proofs
