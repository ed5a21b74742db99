#include <fmt/format.h>

#include <algorithm>

#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

std::string ledger(const std::vector<ProofEntry>& proofs) {
  const auto good = std::count_if(proofs.begin(), proofs.end(), [](const ProofEntry& p) { return p.as_expected; });
  Table table("The proof ledger",
              {{"group", {}, false}, {"statement", {}, false}, {"source", {}, false}, {"verdict", {}, false}});
  for (const ProofEntry& proof : proofs) {
    table.row({proof.group, proof.statement, proof.source, verdict_cell(proof.as_expected, proof.verdict)});
  }
  return fmt::format(
      "<p>{} statements, {} of them as they should be. The remainders that refute are printed by <code>./lubjoint "
      "prove</code>.</p>\n<details>\n<summary>All statements</summary>\n{}</details>\n",
      proofs.size(), good, table.html());
}

}  // namespace

Section proofs_section(const Content& content) {
  return {"proofs", "Proof ledger",
          filled("proofs.html",
                 {{"ledger", content.proofs ? ledger(*content.proofs)
                                            : "<p>The program that wrote this page was built without GiNaC. "
                                              "<code>./lubjoint prove</code> installs it, proves everything in a few "
                                              "seconds, and prints the ledger.</p>"}})};
}

}  // namespace lubjoint::reports::page
