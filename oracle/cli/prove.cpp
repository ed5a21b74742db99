#include "oracle/cli/prove.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "oracle/cli/command.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/files.hpp"
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

reports::page::ProofLedger stored_ledger(const std::vector<proofs::ProofResult>& results) {
  reports::page::ProofLedger ledger{reports::proof_sources(), {}};
  ledger.statements.reserve(results.size());
  for (const proofs::ProofResult& each : results) {
    ledger.statements.push_back({each.group, each.statement, each.source, proofs::verdict(each), each.as_expected()});
  }
  return ledger;
}

int run_prove(bool json, std::ostream& out, const proofs::Progress& progress, const std::string& store) {
  const std::vector<proofs::ProofResult> results = proofs::prove_all(progress);
  if (json) {
    out << as_json(results).dump(2) << "\n";
  } else {
    out << proofs::ledger_table(results);
  }
  if (!store.empty()) reports::write_file(store, ledger_json(stored_ledger(results)));
  return proofs::ledger_closes(results) ? 0 : 1;
}

void add_prove(CLI::App& app, Action& action) {
  auto json = std::make_shared<bool>(false);
  auto store = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("prove", words_of("prove"));
  command->add_flag("--json", *json, "One JSON object");
  command->add_option("--store", *store, "File for the ledger that the report shows: data/proofs/ledger.json");
  command->callback([json, store, &action] {
    action = [json, store] {
      std::optional<reports::ProgressBar> bar;
      return run_prove(
          *json, std::cout,
          [&bar](const proofs::ProofResult&, std::size_t, std::size_t total) {
            if (!bar) bar.emplace("proofs", total);
            bar->advance();
          },
          *store);
    };
  });
}

}  // namespace lubjoint::cli
