#include <fmt/format.h>

#include <algorithm>

#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

std::string ledger(const ProofLedger& proofs) {
  const auto good = std::count_if(proofs.statements.begin(), proofs.statements.end(),
                                  [](const ProofEntry& each) { return each.as_expected; });
  Table table("The proof ledger",
              {{"group", {}, false}, {"statement", {}, false}, {"source", {}, false}, {"verdict", {}, false}});
  for (const ProofEntry& proof : proofs.statements) {
    table.row({proof.group, proof.statement, proof.source, verdict_cell(proof.as_expected, proof.verdict)});
  }
  return fmt::format(
      "<p>{} statements, {} of them as they should be. This is the stored ledger, proved of the sources {}{}. "
      "<code>./lubjoint prove</code> proves everything anew in a few seconds and prints the remainders that "
      "refute.</p>\n<details>\n<summary>All statements</summary>\n{}</details>\n",
      proofs.statements.size(), good, escaped(proofs.sources),
      proofs.is_of_these_sources() ? ", which are this program’s" : ", and this program’s are " + proof_sources(),
      table.html());
}

}  // namespace

Section proofs_section(const Content& content) {
  return {"proofs", "Proof ledger",
          filled("proofs.html",
                 {{"ledger", content.proofs
                                 ? ledger(*content.proofs)
                                 : "<p>The stored ledger is not with this program’s data. <code>./lubjoint "
                                   "prove</code> proves everything in a few seconds, and prints the ledger.</p>"}})};
}

}  // namespace lubjoint::reports::page
