// The report's section on losses and stability, held against what shares no formula with it: quadrature of shear stress
// and dissipation, and the eigenvalues of the journal on the stiffness and damping of exact derivatives.
#include <array>
#include <catch2/catch.hpp>
#include <regex>

#include "lubjoint/film/rotor_modes.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/page/sections.hpp"
#include "oracle/results/coefficient_table.hpp"
#include "oracle/reynolds/film_losses.hpp"
#include "support/page_content.hpp"

namespace page_losses_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
namespace page = reports::page;

namespace {

/// A row's numbers in SI: ε, T_J, T_B, P, Q, m_c and whirl over spin; a dash is none.
using Row = std::vector<std::optional<double>>;

/// The numbers that the table shows for a law.
Row shown(const std::string& html, const std::string& law) {
  const std::string head = "<th scope=\"row\">" + law + "</th>";
  const std::size_t begin = html.find(head);
  REQUIRE(begin != std::string::npos);
  const std::string line = html.substr(begin, html.find("</tr>", begin) - begin);
  const std::array<double, 7> units = {1, 1e-3, 1e-3, 1, 1e-6, 1, 1};
  const std::regex cell("<td[^>]*>([^<]*)</td>");
  Row row;
  for (auto at = std::sregex_iterator(line.begin(), line.end(), cell); at != std::sregex_iterator(); ++at) {
    const std::string text = std::regex_replace((*at)[1].str(), std::regex("−"), "-");
    row.push_back(text == "–" ? std::nullopt : std::optional<double>(std::stod(text) * units.at(row.size())));
  }
  return row;
}

/// What the row should say. long_half_eq5's power, and pinkus_sternlicht's torque and power, are by definition: they
/// are held against the balance of moments and of power.
Row expected(const reports::Example1Law& item) {
  const JournalScene parts = journal_scene(item.scene);
  const double spin = parts.drive.journal_spin;
  const double epsilon = item.rest.eccentricity_ratio;
  const PolarFilmState<double> state(epsilon, epsilon * spin, 0.0);
  Row row{epsilon};
  const double moment = parts.bearing.clearance() * cross(item.rest.eccentricity, item.rest.force);
  if (item.law == "pinkus_sternlicht") {
    // The Couette torque of the film that it approximates, which has the same extent.
    const double couette = oracle::film_losses_by_quadrature(oracle::OneDimensionalFilm::long_dynamic, parts.bearing,
                                                             parts.oil, state, spin)
                               .couette_power.value /
                           spin;
    row.insert(row.end(), {-couette - moment / 2, couette - moment / 2, (couette + moment / 2) * spin, std::nullopt});
  } else {
    for (const auto& film : oracle::one_dimensional_films) {
      if (film.name != item.law) continue;
      const auto wall = oracle::film_losses_by_quadrature(film.film, parts.bearing, parts.oil, state, spin);
      const bool by_balance = item.law == "long_half_eq5";
      const double power = by_balance ? -wall.torque_journal.value * spin  // the only body that moves
                                      : wall.couette_power.value + wall.pressure_power.value;
      row.insert(row.end(), {wall.torque_journal.value, wall.torque_bearing.value, power,
                             wall.side_flow ? std::optional<double>(wall.side_flow->value) : std::nullopt});
    }
  }
  using Wide = long double;
  const double unit = item.rest.force.norm() / (parts.bearing.clearance() * spin * spin);
  const Eigen::Matrix<Wide, 2, 2> stiffness = item.rest.stiffness.cast<Wide>();
  const Eigen::Matrix<Wide, 2, 2> damping = item.rest.damping.cast<Wide>();
  const auto threshold = eigenvalue_threshold<Wide>(stiffness, damping, Wide(unit), Wide(std::abs(spin)));
  row.emplace_back(static_cast<double>(threshold.critical_mass));
  row.push_back(threshold.whirl_frequency
                    ? std::optional<double>(static_cast<double>(*threshold.whirl_frequency / std::abs(spin)))
                    : std::nullopt);
  return row;
}

bool agrees(const Row& row, const Row& reference, double tolerance) {
  if (row.size() != reference.size()) return false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].has_value() != reference[i].has_value()) return false;
    const double rounding = 1e-15;  // of a side flow that is 0; the others are 1e-7 and more
    if (row[i] && !(std::abs(*row[i] - *reference[i]) <= tolerance * std::abs(*reference[i]) + rounding)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("report: losses and stability of example 1 are those of quadrature and of eigenvalues, and no others pass") {
  page::Content content;
  content.journal = quick_example_1();
  const std::string html = page::losses_section(content).html;
  const reports::CsvTable csv(page::losses_at_rest_csv(content.journal), "losses.csv");
  REQUIRE(csv.rows() == film_law_names.size());
  for (std::size_t n = 0; n < csv.rows(); ++n) {
    const reports::Example1Law& item = content.journal.laws[n];
    INFO(item.law);
    const Row reference = expected(item);
    const Row row = shown(html, item.law);
    REQUIRE(row.size() == 7);
    const double digits = 5.5e-4;  // four digits are right to 5e-4
    CHECK(agrees(row, reference, digits));
    Row carried;
    for (std::size_t i = 1; i < csv.columns().size(); ++i) {
      carried.push_back(csv.field(n, i).empty() ? std::nullopt : std::optional<double>(csv.number(n, i)));
    }
    CHECK(csv.field(n, 0) == item.law);
    CHECK(agrees(carried, reference, 1e-5));  // a full film's whirl is by a mass of 1e-6 of the unit, in place of 0
    for (std::size_t i = 0; i < row.size(); ++i) {
      Row wrong = row;
      wrong[i] = row[i] && *row[i] != 0 ? std::optional<double>(1.01 * *row[i]) : std::optional<double>(1.0);
      INFO("column " << i);
      CHECK_FALSE(agrees(wrong, reference, digits));
    }
  }
}

TEST_CASE("report: the section on losses warns of the laws whose whirl is not half, and says what the ledger holds") {
  page::Content content;
  content.journal = quick_example_1();
  const std::string html = page::losses_section(content).html;
  std::size_t warned = 0;
  for (const reports::Example1Law& item : content.journal.laws) {
    const std::string warning = reports::stability_warning(item.law);
    if (warning.empty()) continue;
    ++warned;
    CHECK_THAT(html, Contains(page::escaped(warning)));
  }
  CHECK(warned == 2);  // long_half and long_half_eq5: neither is isotropic at the centre
  CHECK_THAT(html, Contains("does not say <code>shear</code>"));
  for (auto& item : content.journal.laws) {
    item.scene.joints.front().shear = ShearExtent::flooded;
    item.scene.bodies.front().spin_is_held = true;
  }
  const std::string flooded = page::losses_section(content).html;
  CHECK_THAT(flooded, Contains("The scene says <code>shear</code>") && Contains("<code>flooded</code>"));
  CHECK(*shown(flooded, "short_half")[3] > 1.5 * *shown(html, "short_half")[3]);
}

}  // namespace page_losses_test
