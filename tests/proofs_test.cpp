#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "oracle/cli/prove.hpp"
#include "oracle/proofs/algebra.hpp"
#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/sommerfeld.hpp"
#include "support/run_program.hpp"

namespace proofs_test {

using namespace lubjoint::proofs;
using lubjoint::test::lubjoint_program;
using lubjoint::test::ProgramResult;

namespace {

ProofResult result_of(Expectation expectation, const std::function<void(Proof&)>& examine) {
  return prove({"test", "statement", "source", expectation, examine});
}

void one_is_one(Proof& proof) { proof.equal(Algebra(), 1, 1); }
void one_is_two(Proof& proof) { proof.equal(Algebra(), 1, 2); }

}  // namespace

TEST_CASE("proofs: every statement that should hold is proved, every wrong one refuted") {
  const std::vector<ProofResult> results = prove_all();
  std::set<std::string> proved_groups;
  std::set<std::string> refuted_groups;
  for (const ProofResult& result : results) {
    INFO(result.group << ": " << result.statement << " (" << result.note << ")");
    CHECK(verdict(result) != "UNDECIDED");
    CHECK(result.as_expected());
    (result.should_hold() ? proved_groups : refuted_groups).insert(result.group);
  }
  CHECK(ledger_closes(results));
  // A group without a wrong statement could not show that its proofs can fail.
  CHECK(proved_groups == refuted_groups);
  const std::string table = ledger_table(results);
  CHECK_THAT(table, Catch::Contains("0 not as expected"));
  CHECK_THAT(table, Catch::Contains("not an identity"));
}

TEST_CASE("proofs: the stored ledger, which the report shows, is what these proofs say") {
  const std::string file = LUBJOINT_SOURCE_DIR "/data/proofs/ledger.json";
  const auto stored = lubjoint::reports::page::read_ledger(lubjoint::test::read_text(file), file);
  const auto fresh = lubjoint::cli::stored_ledger(prove_all());
  CHECK(stored.sources == fresh.sources);
  CHECK(stored.statements == fresh.statements);
}

TEST_CASE("prove: --json has each statement of the ledger with its verdict") {
  const ProgramResult result = lubjoint_program({"prove", "--json"}, {.seconds = 300});
  CHECK(result.status == 0);
  const auto ledger = nlohmann::json::parse(result.out);
  CHECK(ledger["closes"] == true);
  // As many as the README says.
  CHECK_THAT(lubjoint::test::read_text(LUBJOINT_SOURCE_DIR "/README.md"),
             Catch::Contains("`prove`: " + std::to_string(all_statements().size()) + " statements"));
  const auto all = all_statements();
  REQUIRE(ledger["statements"].size() == all.size());
  std::set<std::string> expectations;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& statement = ledger["statements"][i];
    INFO(statement.dump());
    CHECK(statement["group"] == all[i].group);
    CHECK(statement["statement"] == all[i].text);
    CHECK(statement["as_expected"] == true);
    CHECK(statement["proved"] == statement["should_hold"]);
    CHECK(statement["should_hold"] == (statement["expected"] == "holds"));
    CHECK_FALSE(statement["verdict"].get<std::string>().empty());
    expectations.insert(statement["expected"]);
  }
  CHECK(expectations == std::set<std::string>{"holds", "wrong", "not an identity"});
}

TEST_CASE("proofs: no statement stands in the ledger twice") {
  std::set<std::string> seen;
  for (const Statement& statement : all_statements()) {
    INFO(statement.text);
    CHECK(seen.insert(statement.group + ": " + statement.text).second);
    CHECK_FALSE(statement.source.empty());
  }
}

TEST_CASE("proofs: a false identity is refuted with its remainder, and the ledger does not close") {
  const ProofResult result = result_of(Expectation::holds, one_is_two);
  CHECK(verdict(result) == "NOT PROVED");
  CHECK_FALSE(result.proved());
  CHECK_FALSE(result.as_expected());
  CHECK_THAT(result.note, Catch::Contains("remainder") && Catch::Contains("-1"));
  CHECK_FALSE(ledger_closes({result}));
  CHECK_FALSE(ledger_closes({}));
}

TEST_CASE("proofs: a true identity called wrong is noticed") {
  const ProofResult result = result_of(Expectation::wrong, one_is_one);
  CHECK(verdict(result) == "NOT REFUTED");
  CHECK_FALSE(ledger_closes({result}));
}

TEST_CASE("proofs: one false identity among true ones refutes the statement") {
  const ProofResult result = result_of(Expectation::holds, [](Proof& proof) {
    one_is_one(proof);
    one_is_two(proof);
    one_is_one(proof);
  });
  CHECK(result.outcome == Outcome::refuted);
  CHECK(result.identities == 3);
}

TEST_CASE("proofs: a statement without identities, or with a vanishing denominator, is undecided and never proved") {
  CHECK(verdict(result_of(Expectation::holds, [](Proof&) {})) == "UNDECIDED");
  for (const Expectation expectation : {Expectation::holds, Expectation::wrong}) {
    const auto singular = [](Proof& proof) {
      const symbol x("x"), s("s");
      proof.zero(Algebra().root(s, 1 - x * x), 1 / (s * s + x * x - 1));
    };
    const ProofResult result = result_of(expectation, singular);
    CHECK(verdict(result) == "UNDECIDED");
    CHECK_FALSE(result.as_expected());
  }
}

TEST_CASE("proofs: the zero test uses the relation of a root, and only that") {
  const symbol eps("eps"), s("s"), theta("theta");
  const Algebra algebra = Algebra().root(s, 1 - eps * eps).angle(theta);
  CHECK(algebra.vanishes(1 / (1 - eps) - (1 + eps) / (s * s)));
  CHECK(algebra.vanishes(pow(s, 5) - s * pow(1 - eps * eps, 2)));
  CHECK(algebra.vanishes(pow(sin(theta), 4) - pow(1 - pow(cos(theta), 2), 2)));
  CHECK_FALSE(algebra.vanishes(s - (1 - eps * eps)));
  CHECK_FALSE(algebra.vanishes(s - 1 + eps * eps / 2));
  CHECK_FALSE(algebra.vanishes(theta - sin(theta)));
  CHECK_FALSE(algebra.vanishes(Pi - frac(22, 7)));
}

TEST_CASE("proofs: a polynomial with a negative or no coefficient is not taken for positive") {
  const symbol x("x"), y("y");
  CHECK(has_only_positive_coefficients(1 + x * y + 3 * pow(y, 2), {x, y}));
  CHECK(has_only_positive_coefficients(frac(1, 2) * x, {x}));
  CHECK_FALSE(has_only_positive_coefficients(pow(x - y, 2), {x, y}));
  CHECK_FALSE(has_only_positive_coefficients(ex(0), {x}));
  CHECK_FALSE(has_only_positive_coefficients(x + y, {x}));
  CHECK_FALSE(has_only_positive_coefficients(1 / x, {x}));
  CHECK_FALSE(has_only_positive_coefficients(Pi * x, {x}));
}

TEST_CASE("proofs: an antiderivative that is no trigonometric polynomial is refused") {
  const symbol angle("angle");
  CHECK_THROWS_AS(trigonometric_antiderivative(1 / (2 + cos(angle)), angle), std::domain_error);
}

}  // namespace proofs_test
