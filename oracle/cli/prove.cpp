#include "oracle/cli/prove.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "oracle/cli/command.hpp"
#include "oracle/files/progress.hpp"

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

std::vector<reports::page::ProofEntry> proof_entries(const std::vector<proofs::ProofResult>& results) {
  std::vector<reports::page::ProofEntry> entries;
  entries.reserve(results.size());
  for (const proofs::ProofResult& result : results) {
    entries.push_back({result.group, result.statement, result.source, proofs::verdict(result), result.as_expected()});
  }
  return entries;
}

int run_prove(bool json, std::ostream& out, const proofs::Progress& progress) {
  const std::vector<proofs::ProofResult> results = proofs::prove_all(progress);
  if (json) {
    out << as_json(results).dump(2) << "\n";
  } else {
    out << proofs::ledger_table(results);
  }
  return proofs::ledger_closes(results) ? 0 : 1;
}

void add_prove(CLI::App& app, Action& action) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("prove", "The proof ledger: formulas proved symbolically, mistakes refuted");
  command->add_flag("--json", *json, "One JSON object");
  command->callback([json, &action] {
    action = [json] {
      std::optional<reports::ProgressBar> bar;
      return run_prove(*json, std::cout, [&bar](const proofs::ProofResult&, std::size_t, std::size_t total) {
        if (!bar) bar.emplace("proofs", total);
        bar->advance();
      });
    };
  });
}

}  // namespace lubjoint::cli
