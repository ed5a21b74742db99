/// The stored proof ledger: what the page shows without GiNaC.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// Version, and a checksum (SHA-256, 12 digits) of oracle/proofs: what the ledger's verdicts come from.
std::string proof_sources();

namespace page {

/// A statement of the proof ledger.
struct ProofEntry {
  std::string group;
  std::string statement;
  std::string source;
  std::string verdict;
  bool as_expected = false;

  friend bool operator==(const ProofEntry&, const ProofEntry&) = default;
};

/// The ledger, and which sources made it.
struct ProofLedger {
  std::string sources;  ///< as proof_sources said
  std::vector<ProofEntry> statements;

  bool is_of_these_sources() const { return sources == proof_sources(); }
  bool closes() const;  ///< is every verdict as expected?
};

/// As JSON; the same ledger gives the same bytes.
std::string ledger_json(const ProofLedger& ledger);

/// @throws std::invalid_argument that names the file
ProofLedger read_ledger(const std::string& json, const std::string& file);

}  // namespace page

}  // namespace lubjoint::reports
