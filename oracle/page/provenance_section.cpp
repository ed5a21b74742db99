#include <fmt/format.h>

#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

std::string table_of(const std::string& caption, const char* what, const NamedWords& rows) {
  Table table(caption, {{what, {}, false}, {"value", {}, false}});
  for (const auto& [name, words] : rows) table.row({name, words});
  return table.html();
}

}  // namespace

Section verify_section(const Content&) { return {"verify", "Verify your own code", filled("verify.html", {})}; }

Section provenance_section(const Content& content) {
  const LawCheckSettings& laws = content.laws.settings;
  const NamedWords seeds = {
      {"random states of the quadrature check", fmt::format("{}, {} states a law", laws.seed, laws.states)},
      {"random directions of the 100-digit check", fmt::format("{}, {} at each ε", laws.seed, laws.directions)},
      {"trajectories, equilibria, model error", "nothing random"},
  };
  return {"provenance", "Versions, machine, seeds",
          filled("provenance.html",
                 {{"software", table_of("What made this page", "software", content.provenance.software)},
                  {"machine", table_of("Where it ran", "machine", content.provenance.machine)},
                  {"seeds", table_of("Seeds of the Mersenne Twister (64 bits)", "what is drawn", seeds)}})};
}

}  // namespace lubjoint::reports::page
