#include "oracle/cli/prove.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace lubjoint::cli {

namespace {

const char* name_of(proofs::Expectation expectation) {
  switch (expectation) {
    case proofs::Expectation::holds:
      return "holds";
    case proofs::Expectation::wrong:
      return "wrong";
    case proofs::Expectation::not_an_identity:
      break;
  }
  return "not an identity";
}

nlohmann::ordered_json as_json(const std::vector<proofs::ProofResult>& results) {
  nlohmann::ordered_json statements = nlohmann::ordered_json::array();
  for (const proofs::ProofResult& result : results) {
    statements.push_back({{"group", result.group},
                          {"statement", result.statement},
                          {"source", result.source},
                          {"expected", name_of(result.expectation)},
                          {"verdict", proofs::verdict(result)},
                          {"should_hold", result.should_hold()},
                          {"proved", result.proved()},
                          {"as_expected", result.as_expected()},
                          {"identities", result.identities},
                          {"seconds", result.seconds},
                          {"note", result.note}});
  }
  return {{"closes", proofs::ledger_closes(results)}, {"statements", std::move(statements)}};
}

}  // namespace

int run_prove(bool json, std::ostream& out, const proofs::Progress& progress) {
  const std::vector<proofs::ProofResult> results = proofs::prove_all(progress);
  if (json) {
    out << as_json(results).dump(2) << "\n";
  } else {
    out << proofs::ledger_table(results);
  }
  return proofs::ledger_closes(results) ? 0 : 1;
}

}  // namespace lubjoint::cli
