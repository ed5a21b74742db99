/// `lubjoint prove`: the proof ledger.
#pragma once

#include <iosfwd>

#include "oracle/page/proof_ledger.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::cli {

/// Examines the whole ledger and prints it, as a table or as JSON.
/// @param progress  called after every statement; a bar on the terminal, for example
/// @param store  a file for the ledger as the page reads it; empty: none
/// @returns the exit status: 0 if everything that should hold is proved and everything wrong is refuted, else 1
int run_prove(bool json, std::ostream& out, const proofs::Progress& progress = {}, const std::string& store = {});

/// The ledger as it is stored, and as the page shows it.
reports::page::ProofLedger stored_ledger(const std::vector<proofs::ProofResult>& results);

}  // namespace lubjoint::cli
