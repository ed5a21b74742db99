#include "oracle/page/proof_ledger.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace lubjoint::reports::page {

bool ProofLedger::closes() const {
  return !statements.empty() && std::ranges::all_of(statements, &ProofEntry::as_expected);
}

std::string ledger_json(const ProofLedger& ledger) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ProofEntry& each : ledger.statements) {
    list.push_back({{"group", each.group},
                    {"statement", each.statement},
                    {"source", each.source},
                    {"verdict", each.verdict},
                    {"as_expected", each.as_expected}});
  }
  return nlohmann::ordered_json{{"sources", ledger.sources}, {"statements", std::move(list)}}.dump(1) + "\n";
}

ProofLedger read_ledger(const std::string& json, const std::string& file) {
  try {
    const auto given = nlohmann::json::parse(json);
    ProofLedger ledger{given.at("sources"), {}};
    for (const auto& each : given.at("statements")) {
      ledger.statements.push_back({each.at("group"), each.at("statement"), each.at("source"), each.at("verdict"),
                                   each.at("as_expected").get<bool>()});
    }
    return ledger;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(file + " is no proof ledger (" + error.what() +
                                "); allowed is what lubjoint prove --store has written");
  }
}

}  // namespace lubjoint::reports::page
