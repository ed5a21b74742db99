/// `lubjoint prove`: the proof ledger.
#pragma once

#include <iosfwd>

#include "oracle/page/page.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::cli {

/// Examines the whole ledger and prints it, as a table or as JSON.
/// @param progress  called after every statement; a bar on the terminal, for example
/// @returns the exit status: 0 if everything that should hold is proved and everything wrong is refuted, else 1
int run_prove(bool json, std::ostream& out, const proofs::Progress& progress = {});

/// The ledger as the report shows it.
std::vector<reports::page::ProofEntry> proof_entries(const std::vector<proofs::ProofResult>& results);

}  // namespace lubjoint::cli
