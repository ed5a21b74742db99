// report.html as a file: complete, by itself, the same for the same content; what a browser makes of it is asked by
// tests/page/page_in_browser.sh.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "oracle/files/csv_table.hpp"
#include "oracle/page/html.hpp"
#include "oracle/page/panel.hpp"
#include "support/page_content.hpp"

namespace page_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
namespace page = reports::page;

namespace {

page::Content full_content() {
  page::Content content = quick_page_content();
  content.run_times = page::read_run_times(invented_data("bench-scenes.csv"), "bench-scenes.csv");
  content.stability = page::read_stability(invented_data("stress.csv"), "stress.csv");
  content.proofs = page::ProofLedger{
      reports::proof_sources(),
      {{"group", "a statement", "eq. 1", "proved", true}, {"group", "a wrong one", "", "refuted", true}}};
  return content;
}

std::string page_of(const page::Content& content) {
  const TemporaryFolder folder;
  const std::string html = page::report_page(content);
  CHECK(folder.entries().empty());
  return html;
}

const std::string& full_page() {
  static const std::string html = page_of(full_content());
  return html;
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(piece, at)) != std::string::npos; at += piece.size()) ++found;
  return found;
}

/// What stands between `begin` and the next `end`, at every place.
std::vector<std::string> between(const std::string& text, const std::string& begin, const std::string& end) {
  std::vector<std::string> pieces;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    pieces.push_back(text.substr(at, text.find(end, at) - at));
  }
  return pieces;
}

/// Data that the page carries under an id.
nlohmann::json embedded(const std::string& html, const std::string& id) {
  const auto found = between(html, "<script type=\"application/json\" id=\"" + id + "\">", "</script>");
  REQUIRE(found.size() == 1);
  return nlohmann::json::parse(found.front());
}

std::string section(const std::string& html, const std::string& id) {
  const auto found = between(html, "<section id=\"" + id + "\"", "</section>");
  REQUIRE(found.size() == 1);
  return found.front();
}

}  // namespace

TEST_CASE("report: one file that asks for nothing outside of itself") {
  const std::string& html = full_page();
  CHECK(html.size() < 6'000'000);  // a page that can be mailed: ten megabytes, of which the encoding takes a quarter
  std::string rest = html;
  const std::string name_space = "http://www.w3.org/2000/svg";
  for (std::size_t at = 0; (at = rest.find(name_space)) != std::string::npos;) rest.erase(at, name_space.size());
  for (const char* reference : {"http://", "https://", "src=", "url(", "@import", "<link rel=\"stylesheet", "fetch(",
                                "XMLHttpRequest", "import("}) {
    INFO(reference);
    CHECK(count(rest, reference) == 0);
  }
  CHECK(count(html, "<!DOCTYPE html>") == 1);
  CHECK(count(html, "</html>") == 1);
  CHECK_THAT(html, Contains("name=\"viewport\""));
}

TEST_CASE("report: the contents list every section, the verdict first, and every link and id has its place") {
  const std::string& html = full_page();
  const std::vector<std::string> expected = {"verdict",      "motion",    "journal", "equilibrium", "losses",
                                             "slider-crank", "space",     "laws",    "model-error", "proofs",
                                             "run-time",     "stability", "verify",  "provenance"};
  CHECK(between(between(html, "<nav", "</nav>").front(), "href=\"#", "\"") == expected);
  CHECK(between(html, "<section id=\"", "\"") == expected);
  const std::vector<std::string> ids = between(html, " id=\"", "\"");
  const std::set<std::string> unique(ids.begin(), ids.end());
  CHECK(unique.size() == ids.size());
  for (const std::string& target : between(html, "href=\"#", "\"")) {
    INFO(target);
    CHECK(unique.contains(target));
  }
}

TEST_CASE("report: every table has a caption and headings that say what they head") {
  const std::string& html = full_page();
  const std::vector<std::string> tables = between(html, "<table>", "</table>");
  CHECK(tables.size() >= 18);
  for (const std::string& table : tables) {
    INFO(table.substr(0, 200));
    CHECK(table.starts_with("\n<caption>"));
    CHECK(table.find("<caption></caption>") == std::string::npos);
    CHECK(count(table, "<th ") == count(table, "<th scope=\"col\"") + count(table, "<th scope=\"row\""));
    CHECK(count(table, "<th>") == 0);
    CHECK(count(table, "<tr>") == 1 + count(table, "<th scope=\"row\""));  // every row but the first has its heading
  }
}

TEST_CASE("report: powers of ten are written as such, and nothing else is") {
  CHECK(page::with_powers("at most 2.0e-10 c; 1e-06 to 3e-05 of its peak") ==
        "at most 2.0 × 10⁻¹⁰ c; 10⁻⁶ to 3 × 10⁻⁵ of its peak");
  CHECK(page::with_powers("the rate e/c, eq5, 1e+08") == "the rate e/c, eq5, 10⁸");
  CHECK(page::with_powers("") == "");
}

TEST_CASE("report: tables of words are cards on a phone, where each cell says its heading") {
  page::Table table("T", {{"what", {}, false}, {"found <here>"}});
  table.row({"a", "-1"});
  CHECK(table.html().find("data-head") == std::string::npos);
  CHECK_THAT(table.as_cards().html(), Contains("<div class=\"scroll cards\"") &&
                                          Contains("<td class=\"number\" data-head=\"found &lt;here&gt;\">−1</td>"));
}

TEST_CASE("report: figures 9 to 11 and 13 to 21 are drawn, described, and stand beside the paper's words") {
  const std::string& html = full_page();
  std::vector<std::string> panels = {"figure-14-orbit", "figure-15-orbit"};
  for (const std::string number : {"9", "10", "11"}) {
    for (const char letter : {'a', 'b', 'c', 'd', 'e'}) panels.push_back("figure-" + number + letter);
  }
  for (const std::string number : {"13", "16", "17", "18", "19", "20", "21"}) {
    for (const char letter : {'a', 'b'}) panels.push_back("figure-" + number + letter);
  }
  for (const std::string& id : panels) {
    INFO(id);
    const auto found = between(html, "<figure class=\"panel\" id=\"" + id + "\">", "</figure>");
    REQUIRE(found.size() == 1);
    CHECK(count(found.front(), "<path") > 5);
    CHECK_THAT(found.front(), Contains("role=\"img\" aria-label=\"") && Contains("<figcaption>"));
    CHECK_THAT(found.front(), Contains("["));  // units
  }
  for (const int number : {9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21}) {
    INFO(number);
    const auto found = between(html, "<article id=\"figure-" + std::to_string(number) + "\">", "</article>");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found.front(), Contains("The paper:") && Contains("Here:"));
    CHECK_THAT(found.front(), Contains("Checked:</span> ") && Contains("(allowed ") && Contains("✓</p>"));
  }
  CHECK(count(html, "aria-label=\"\"") == 0);
}

TEST_CASE("report: drawings take the page's colours and fonts") {
  for (const std::string& panel : between(full_page(), "<figure class=\"panel\"", "</figure>")) {
    INFO(panel.substr(0, 100));
    CHECK(count(panel, "var(--grid)") + count(panel, "crispEdges") > 0);
    for (const char* own : {"font-family", "black", "white", "id='gp", "<title", "<rect x=\"0\" y=\"0\" fill=\"#"}) {
      INFO(own);
      CHECK(count(panel, own) == 0);
    }
    // A fixed colour that is none of the page's: only the maps of the model error have them.
    if (count(panel, "crispEdges") == 0) CHECK(count(panel, "rgb(") == 0);
  }
}

TEST_CASE("report: the same content gives the same bytes") { CHECK(page_of(full_content()) == full_page()); }

TEST_CASE("report: each check of a verdict is listed with what it is held against, what is allowed and why") {
  const page::Content content = full_content();
  const auto listed = [](const std::string& html, const std::vector<const reports::Verdict*>& verdicts) {
    for (const reports::CheckSummary& line : reports::summary_of_checks(verdicts)) {
      INFO(line.what);
      const std::string row = "<th scope=\"row\">" + line.letter + "</th><td data-head=\"what\">" +
                              page::escaped(line.what) + "</td><td data-head=\"against\">";
      CHECK_THAT(html,
                 Contains(row + page::escaped(line.passed > 0 ? page::with_powers(line.against) : "–") + "</td>"));
      CHECK_THAT(html, Contains(">" + page::escaped(page::with_powers(line.reason)) + "</td>"));
    }
  };
  listed(section(full_page(), "equilibrium"), content.journal.verdicts());
  listed(section(full_page(), "slider-crank"), content.slider_crank.verdicts());
  listed(section(full_page(), "space"), {&content.space.verdict});
  listed(section(full_page(), "verdict"), {&content.slider_crank.ideal_verdict});
  page::Content other = full_content();
  for (auto& law : other.journal.laws) law.verdict.checks.back() = reports::paper_check(law.found, "-");
  CHECK_THAT(section(page_of(other), "equilibrium"),
             Contains(">the paper has no such law</td><td data-head=\"outcome\">–</td>"));
}

TEST_CASE("report: the verdict is good when everything agrees, and names what does not") {
  const std::string good = section(full_page(), "verdict");
  CHECK_THAT(good, Contains("class=\"verdict good\"") && Contains("✓ Everything") && !Contains("✗"));
  page::Content content = full_content();
  content.slider_crank.cases[2].verdict.checks[1] =
      reports::Check::at_most("e/c", "minimal coordinates", 1e-3, 1e-8, "c", "steps of 1e-10");
  CHECK_FALSE(content.passed());
  const std::string bad = page_of(content);
  CHECK_THAT(section(bad, "verdict"), Contains("class=\"verdict bad\"") && Contains("✗ 4 of 5 agree"));
  CHECK_THAT(section(bad, "slider-crank"), Contains("✗ e/c: 1.0e-03 c, allowed 1e-08"));
  CHECK_THAT(section(bad, "slider-crank"), Contains("✗ 1 failed, 4 passed"));
  CHECK_THAT(section(bad, "slider-crank"), Contains("<p class=\"checked bad\">"));
  content = full_content();
  for (auto& law : content.journal.laws) law.verdict.checks.clear();  // nothing was checked: that is no agreement
  CHECK_FALSE(content.passed());
  content = full_content();
  content.space.verdict.checks[1] =
      reports::Check::at_most("e/c", "minimal coordinates", 1e-3, 1e-6, "c", "steps of 1e-7");
  CHECK_FALSE(content.passed());
  const std::string wrong_in_space = page_of(content);
  CHECK_THAT(section(wrong_in_space, "verdict"),
             Contains("class=\"verdict bad\"") && Contains("✗ e/c: 1.0e-03 c, allowed 1e-06"));
  CHECK_THAT(section(wrong_in_space, "space"), Contains("<p class=\"checked bad\">"));
  content = full_content();
  content.laws.laws[0].quadrature->largest = 1e-3;
  CHECK_FALSE(content.passed());
  CHECK_THAT(section(page_of(content), "verdict"), Contains("✗ 6 of 7 agree"));
  content = full_content();
  content.stability->rows[3].status = page::RowStatus::wrong;
  CHECK(content.passed());  // it is no run of this program's
  CHECK_FALSE(content.stored_runs_are_right());
  const std::string unstable = page_of(content);
  CHECK_THAT(section(unstable, "verdict"), Contains(" 1 wrong") && Contains("class=\"verdict bad\"") &&
                                               Contains("✗ Everything that this run checked agrees, but"));
  CHECK(count(section(unstable, "stability"), "<td class=\"level-wrong\"") == 1);
  // The extreme cases' own row says yes only where something was held against a reference to its end.
  const auto row_of = [](const page::Content& of) {
    const auto rows = between(section(page_of(of), "verdict"), "extreme cases", "</tr>");
    REQUIRE(rows.size() == 1);
    return rows.front();
  };
  content = full_content();
  CHECK_THAT(row_of(content), Contains("✓ ") && Contains(" 0 wrong"));
  for (auto& row : content.stability->rows) {
    if (row.status == page::RowStatus::finished) row.status = page::RowStatus::unreferenced;
  }
  CHECK_THAT(row_of(content), !Contains("✓") && Contains("– 0 finished"));
  content.stability->rows[3].status = page::RowStatus::wrong;
  CHECK_THAT(row_of(content), Contains("✗ 0 finished") && Contains(" 1 wrong"));
  content = full_content();
  content.proofs->statements[1].as_expected = false;
  CHECK_FALSE(content.passed());
  CHECK_THAT(section(page_of(content), "verdict"), Contains("✗ 1 of 2 as they should be"));
}

TEST_CASE("report: a stored ledger of other sources is shown, said to be so, and ticks nothing") {
  page::Content content = full_content();
  content.proofs->sources = "0.0 of another day";
  const std::string html = page_of(content);
  CHECK_THAT(section(html, "proofs"), Contains("0.0 of another day") && Contains(reports::proof_sources()));
  CHECK_THAT(section(html, "verdict"), Contains("– 2 of 2 as they should be, proved of other sources"));
}

TEST_CASE("report: the stored ledger ships, is of these sources, closes, and comes back from its JSON") {
  const std::string file = LUBJOINT_SOURCE_DIR "/data/proofs/ledger.json";
  const page::ProofLedger ledger = page::read_ledger(read_text(file), file);
  CHECK(ledger.is_of_these_sources());  // else: ./lubjoint prove --store data/proofs/ledger.json
  CHECK(ledger.closes());
  CHECK(page::ledger_json(ledger) == read_text(file));
  CHECK_THROWS_WITH(page::read_ledger("{\"sources\": 1}", "mine.json"),
                    Contains("mine.json is no proof ledger") && Contains("prove --store"));
  CHECK_FALSE(page::ProofLedger{reports::proof_sources(), {}}.closes());
}

TEST_CASE("report: what was not measured is said, with the command that measures it") {
  const std::string html = page_of(quick_page_content());
  CHECK_THAT(section(html, "run-time"), Contains("./lubjoint bench") && Contains("bench-scenes.csv"));
  CHECK_THAT(section(html, "stability"), Contains("./lubjoint stress") && Contains("stress.csv"));
  CHECK_THAT(section(html, "proofs"), Contains("./lubjoint prove"));
  CHECK_THAT(section(html, "verdict"), Contains("no stored ledger"));
  CHECK(count(html, "csv-run-time\"") == 0);
}

TEST_CASE("report: run times and stability are carried as they were given") {
  const std::string& html = full_page();
  CHECK(embedded(html, "csv-run-time").get<std::string>() == invented_data("bench-scenes.csv"));
  CHECK(embedded(html, "csv-stability").get<std::string>() == invented_data("stress.csv"));
  const std::string stability = section(html, "stability");
  const page::Content content = full_content();
  const auto stopped = std::count_if(content.stability->rows.begin(), content.stability->rows.end(),
                                     [](const auto& row) { return row.status == page::RowStatus::stopped; });
  CHECK(count(stability, "<td class=\"level-stop\"") == static_cast<std::size_t>(stopped));
  const auto unreferenced = std::count_if(content.stability->rows.begin(), content.stability->rows.end(),
                                          [](const auto& r) { return r.status == page::RowStatus::unreferenced; });
  CHECK(count(stability, "title=\"finished, without a reference") == static_cast<std::size_t>(unreferenced));
  CHECK_THAT(stability, Contains("Measured by 0.0.0 invented, not by this program"));
  CHECK(count(stability, "title=\"finished") + count(stability, "title=\"stopped") == content.stability->rows.size());
}

TEST_CASE("report: the fastest integrator at equal error is that of the data") {
  page::Content content = quick_page_content();
  content.run_times = page::read_run_times(
      "scene,formulation,integrator,tolerance,error,seconds,steps,rejected,rhs_evaluations,jacobian_evaluations,"
      "factorisations,status,message\n"
      "s,journal,radau_iia5,1e-6,1e-5,0.5,1,0,1,0,0,finished,\n"
      "s,journal,bulirsch_stoer,1e-6,2e-3,0.001,1,0,1,0,0,finished,\n"
      "s,journal,cvode_adams,1e-6,1e-5,0.002,1,0,1,0,0,finished,\n"
      "s,journal,dopri5,1e-6,1e-5,0.003,1,0,1,0,0,finished,\n"
      "s,journal,ida,1e-6,,0.0001,1,0,1,,,stopped,gave up\n",
      "table");
  content.run_times->measured_by = "a program & <a machine>";
  const std::string words = section(page_of(content), "run-time");
  CHECK_THAT(words,
             Contains("<td>500 ms</td><td>dopri5, 3 ms</td><td>cvode_adams, 2 ms</td><td>–</td></tr>") &&
                 Contains("<td>cvode_adams</td><td>cvode_adams; of lubjoint&#39;s own dopri5, 1.5 times as long</td>"));
  CHECK_THAT(words, Contains("<td>–</td><td>–</td><td>–</td><td>–</td></tr>") &&
                        Contains("<td>–</td><td>none reaches it</td>"));
  CHECK_THAT(words, Contains("stopped: gave up"));
  CHECK_THAT(words, Contains("Measured by a program &amp; &lt;a machine&gt;."));
}

TEST_CASE("report: text of others is text, not HTML") {
  page::Content content = full_content();
  const std::string hostile = "<script>alert('x')</script>&\"";
  content.journal.laws[0].verdict.checks[0] = reports::Check::holds("runs", hostile, false, hostile, hostile);
  content.provenance.machine.emplace_back("name " + hostile, hostile);
  std::string csv = content.stability->csv;
  csv += "case " + hostile + ",l,i,stopped,,,,,0,1,1,1.0 abc,<!-- " + hostile + "\n";
  content.stability = page::read_stability(csv, "stress.csv");
  const std::string html = page_of(content);
  CHECK(count(html, "<script>alert") == 0);
  CHECK(count(html, "alert('x')</script") == 0);
  CHECK(count(html, "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&amp;&quot;") >= 4);
  CHECK(count(html, "<script") == count(html, "</script>"));
  CHECK(count(html, "<script") == count(full_page(), "<script"));
  CHECK(embedded(html, "csv-stability").get<std::string>() == csv);
}

TEST_CASE("report: tables of others are refused with file, line and what is allowed") {
  const std::string head =
      "scene,formulation,integrator,tolerance,error,seconds,steps,rejected,rhs_evaluations,jacobian_evaluations,"
      "factorisations,status,message\n";
  const auto refused = [](const std::string& csv) {
    try {
      page::read_run_times(csv, "bench-scenes.csv");
    } catch (const reports::CsvError& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  CHECK(refused(head) == "taken");
  CHECK_THAT(refused("scene,integrator\na,b\n"), Contains("bench-scenes.csv:1") && Contains("steps"));
  CHECK_THAT(refused(head + "s,f,i,1e-6,1e-8,1,1,0,1,0,0,done,\n"), Contains(":2: status is \"done\"; allowed are"));
  CHECK_THAT(refused(head + "s,f,i,1e-6,nan,1,1,0,1,0,0,finished,\n"), Contains(":2: error is \"nan\""));
  CHECK_THAT(refused(head + "s,f,i,1e-6,-1,1,1,0,1,0,0,finished,\n"), Contains("error is negative; allowed"));
  CHECK_THAT(refused(head + "s,f,i,1e-6,1,-1,1,0,1,0,0,finished,\n"), Contains("seconds is negative; allowed"));
  CHECK_THAT(refused(head + "s,f,i,1e-6,,1,1,0,1,0,0,finished,\n"), Contains("error is \"\"; allowed"));
  CHECK(refused(head + "s,f,i,1e-6,,,1,0,1,,,stopped,gave up\n") == "taken");
  CHECK_THAT(refused(head + ",f,i,1e-6,1,1,1,0,1,0,0,finished,\n"), Contains("scene is empty; allowed"));
  const std::string stress = "case,law,integrator,status,error,rate_error,force_error,seconds,steps,program,message\n";
  const std::string row = "c,l,i,finished,1e-9,1e-9,1e-8,1,1,1.0 abc,\n";
  const auto status = [&](const std::string& line) {
    return page::read_stability(stress + line + "\n", "t").rows[0].status;
  };
  CHECK(status("c,l,i,coarse,0.1,0.1,0.2,1,1,1.0 abc,warned") == page::RowStatus::coarse);
  CHECK(status("c,l,i,unreferenced,,,,1,1,1.0 abc,no reference") == page::RowStatus::unreferenced);
  CHECK(status("c,l,i,wrong,,,,1,1,1.0 abc,off") == page::RowStatus::wrong);
  // "finished" without all three comparisons would say more than was checked.
  for (const char* unchecked : {"c,l,i,finished,,,,1,1,1.0 abc,", "c,l,i,finished,1e-9,,1e-8,1,1,1.0 abc,",
                                "c,l,i,finished,1e-9,1e-9,,1,1,1.0 abc,"}) {
    CHECK_THROWS_WITH(status(unchecked), Contains("allowed without them is \"unreferenced\""));
  }
  CHECK(page::read_stability(stress + row, "stress.csv").rows.size() == 1);
  CHECK_THROWS_WITH(page::read_stability(stress + row + row, "stress.csv"), Contains("stress.csv:3"));
}

TEST_CASE("report: numbers read as people write them") {
  CHECK(page::scientific(1.25e-8) == "1.2 × 10⁻⁸");
  CHECK(page::scientific(-3e15, 0) == "−3 × 10¹⁵");
  CHECK(page::scientific(0.26) == "0.26");
  CHECK(page::scientific(327.4) == "327");
  CHECK(page::scientific(-1) == "−1.0");
  CHECK(page::scientific(0) == "0");
  CHECK(page::scientific(std::nan("")) == "not a number");
  CHECK(page::percent(0.0031) == "0.3 %");
  CHECK(page::percent(0.378) == "38 %");
  CHECK(page::percent(0) == "0 %");
  CHECK(page::percent(0.000088) == "0.0088 %");
  CHECK(page::percent(72.3) == "72 times");
  CHECK(page::with_minus("-0") == "0");
}

TEST_CASE("report: a template and its fields belong together") {
  CHECK_THROWS_WITH(page::filled("proofs.html", {}), Contains("asks for {{ledger}}"));
  CHECK_THROWS_WITH(page::filled("proofs.html", {{"ledger", ""}, {"other", ""}}), Contains("does not use {{other}}"));
  CHECK_THROWS_WITH(page::filled("absent.html", {}), Contains("absent.html"));
}

}  // namespace page_test
