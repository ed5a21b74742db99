#include <fmt/format.h>

#include <cmath>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/losses.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/files/files.hpp"
#include "oracle/page/sections.hpp"
#include "oracle/results/coefficient_table.hpp"

namespace lubjoint::reports::page {

namespace {

std::string csv_field(const std::optional<double>& value) {
  if (!value) return {};
  return std::isinf(*value) ? std::string("inf") : number(*value);
}

/// A value in another unit to four digits, or a dash.
std::string words(const std::optional<double>& value, double unit = 1) {
  if (!value) return "–";
  return std::isinf(*value) ? std::string("every mass is stable") : with_minus(fmt::format("{:.4g}", *value / unit));
}

ShearExtent shear_of(const Scene& scene) { return scene.joints.front().shear.value_or(ShearExtent::film); }

}  // namespace

RestLosses losses_at_rest(const Example1Law& item) {
  const JournalScene parts = journal_scene(item.scene);
  const JournalDrive<double>& drive = parts.drive;
  const double c = parts.bearing.clearance();
  const JournalMotion<double> motion{c * item.rest.eccentricity, Vector2<double>(0.0, 0.0), drive.bearing_spin,
                                     drive.journal_spin};
  RestLosses row;
  with_film_law(item.law, [&]<class Law>() {
    const FilmState<double> film = film_state(motion, c);
    const FilmLosses<double> losses = film_losses<Law, double>(
        parts.bearing, parts.oil, film, drive.journal_spin - drive.bearing_spin, shear_of(item.scene));
    row.torque_journal = losses.torque_journal;
    row.torque_bearing = losses.torque_bearing;
    row.power = losses.power();
    row.side_flow = side_flow<Law>(parts.bearing, film);
  });
  const double load = std::hypot(drive.load.x(), drive.load.y());
  if (load == 0 || drive.journal_spin == 0) return row;  // no direction is the load's, or nothing carries it
  if (const auto rest = coefficients_under({item.law, parts.bearing, parts.oil}, load, drive.journal_spin)) {
    row.critical_mass = rest->critical_mass;
    row.whirl_ratio = rest->whirl_ratio;
  }
  return row;
}

std::string losses_at_rest_csv(const Example1& example) {
  std::string csv = "law,eccentricity_ratio,torque_journal,torque_bearing,power,side_flow,critical_mass,whirl_ratio\n";
  for (const Example1Law& item : example.laws) {
    const RestLosses row = losses_at_rest(item);
    csv += item.law + "," + number(item.rest.eccentricity_ratio) + "," + number(row.torque_journal) + "," +
           number(row.torque_bearing) + "," + number(row.power) + "," + csv_field(row.side_flow) + "," +
           csv_field(row.critical_mass) + "," + csv_field(row.whirl_ratio) + "\n";
  }
  return csv;
}

Section losses_section(const Content& content) {
  Table table("At rest under the load of example 1: what the film costs, and the mass it keeps stable",
              {{"law", {}, false},
               {"ε at rest", "–"},
               {"torque on journal", "mN·m"},
               {"torque on bearing", "mN·m"},
               {"power lost", "W"},
               {"side flow", "cm³/s"},
               {"critical mass", "kg"},
               {"whirl over spin", "–"}});
  std::string warnings;
  for (const Example1Law& item : content.journal.laws) {
    const RestLosses row = losses_at_rest(item);
    table.row({item.law, words(item.rest.eccentricity_ratio), words(row.torque_journal, 1e-3),
               words(row.torque_bearing, 1e-3), words(row.power), words(row.side_flow, 1e-6), words(row.critical_mass),
               words(row.whirl_ratio)});
    const std::string warning = stability_warning(item.law);
    if (!warning.empty()) warnings += fmt::format("<div class=\"note\"><p>{}.</p></div>\n", escaped(warning));
  }
  const Scene& scene = content.journal.laws.at(0).scene;
  const std::string shear(shear_extent_names.at(static_cast<std::size_t>(shear_of(scene))));
  const std::string ledger =
      scene.joints.front().shear
          ? "The scene says <code>shear</code>: its runs carry this torque in their ledger."
          : "The scene does not say <code>shear</code>: no torque acts in its runs, and none is in their ledger.";
  return {"losses", "Losses and rotor stability",
          filled("losses.html", {{"table", table.html()},
                                 {"ledger", ledger},
                                 {"shear", shear},
                                 {"mass", fmt::format("{:.4g}", scene.bodies.front().mass)},
                                 {"warnings", warnings},
                                 {"csv", csv_block("csv-losses", "losses.csv", losses_at_rest_csv(content.journal))}})};
}

}  // namespace lubjoint::reports::page
