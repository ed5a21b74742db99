#include "oracle/measure/stress/stress_references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"

namespace lubjoint::reports {

namespace {

constexpr const char* table_header =
    "motion,case,law,rows,places_apart,rates_apart,forces_apart,rate_unit,force_unit,checksum,methods,why_none\n";
constexpr const char* motions_header = "motion,t,ex_over_c,ey_over_c,wx,wy,fx,fy,growth,force_gain\n";

std::string pair_of(const Vector2<double>& v) { return number(v.x()) + " " + number(v.y()); }

std::string body_number(std::size_t body) { return body == ground_body ? "ground" : std::to_string(body); }

std::string anchor_of(const SceneAnchor& anchor) { return body_number(anchor.body) + " " + pair_of(anchor.point); }

/// What a driver's motion has beside its start, speed and acceleration; nothing where there is nothing.
std::string shape_of(const std::shared_ptr<const MotionShape<double>>& shape) {
  if (!shape) return {};
  std::string words =
      fmt::format(" swing {} {} {}", number(shape->amplitude), number(shape->rate), number(shape->phase));
  if (!shape->table) return words;
  words += fmt::format(" table {}", number(shape->delay));
  for (const double knot : shape->table->knots())
    words += fmt::format(" {} {}", number(knot), number(shape->table->at(knot)[0]));
  return words;
}

/// What a constraint is, for the key; one that is not known here does not compile.
struct Words {
  std::string operator()(const GroundConstraint<double>& g) const {
    return fmt::format("ground {} {} {}", g.body, pair_of(g.position), number(g.angle));
  }
  std::string operator()(const Revolute<double>& r) const {
    return fmt::format("revolute [{}] [{}]", anchor_of(r.first), anchor_of(r.second));
  }
  std::string operator()(const Translational<double>& s) const {
    return fmt::format("guide [{}] {} [{}] {}", anchor_of(s.first), pair_of(s.axis), anchor_of(s.second),
                       number(s.angle));
  }
  std::string operator()(const Driver<double>& d) const {
    return fmt::format("driver {} {} {} {} {}{}", d.second, body_number(d.first), number(d.angle), number(d.speed),
                       number(d.acceleration), shape_of(d.shape));
  }
  std::string operator()(const SlideDriver<double>& d) const {
    return fmt::format("slide [{}] {} [{}] {} {} {}{}", anchor_of(d.first), pair_of(d.axis), anchor_of(d.second),
                       number(d.position), number(d.speed), number(d.acceleration), shape_of(d.shape));
  }
};

/// To a share of its unit: digits below the methods' disagreement are noise.
std::string rounded(double value, double unit) {
  constexpr int digits = 16;
  if (value == 0 || !(std::abs(value) > unit * 1e-15)) return "0";
  const int below = static_cast<int>(std::floor(std::log10(std::max(unit, std::abs(value)) / std::abs(value))));
  return fmt::format("{:.{}g}", value, std::clamp(digits - below, 1, digits));
}

std::string motion_rows(const StressReference& reference) {
  std::string text;
  for (const ReferencePlace& row : reference.rows) {
    text += fmt::format("{},{}", reference.key, number(row.t));
    for (const double v : {row.place.x(), row.place.y()}) text += "," + rounded(v, 1);
    // Ten digits of the unit: no run in double precision has more of a rate or a force in a film.
    for (const double v : {row.rate.x(), row.rate.y()}) text += fmt::format(",{:.11g}", v);
    for (const double v : {row.force.x(), row.force.y()}) text += fmt::format(",{:.11g}", v);
    text += fmt::format(",{:.2e},{:.2e}\n", row.growth, row.force_gain);
  }
  return text;
}

std::string checksum_of(const StressReference& reference) { return sha256(motion_rows(reference)).substr(0, 16); }

std::string one_field(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::string motion_key(const Scene& scene) {
  std::string text = "gravity " + pair_of(scene.gravity);
  for (const SceneBody& b : scene.bodies) {
    text += fmt::format("\nbody {} {} {} {} {} {}", number(b.mass), number(b.inertia), pair_of(b.position),
                        number(b.angle), pair_of(b.velocity), number(b.spin));
  }
  for (const SceneLoad& l : scene.loads)
    text += fmt::format("\nload {} {} {}", l.body, pair_of(l.force), number(l.moment));
  for (const SceneJoint& j : scene.joints) {
    text += fmt::format("\njoint {} {} {} {} {} [{}] [{}]", j.film, number(j.viscosity), number(j.length),
                        number(j.journal_radius), number(j.clearance), anchor_of(j.bearing), anchor_of(j.journal));
    if (j.transition) text += fmt::format(" transition {} {}", number(j.transition->e0), number(j.transition->e1));
    if (!j.contact) continue;
    text += " contact";
    const SceneContact& c = *j.contact;
    for (const double v : {c.bearing_modulus, c.bearing_poisson, c.journal_modulus, c.journal_poisson, c.restitution,
                           c.min_impact_speed, c.friction, c.slow_sliding}) {
      text += " " + number(v);
    }
  }
  for (const SceneConstraint& each : scene.constraints) {
    text += "\nconstraint ";
    text += std::visit(Words{}, each.constraint);
  }
  text += fmt::format("\nrun {} {}", number(scene.run.duration), number(scene.run.output_interval));
  return sha256(text).substr(0, 16);
}

void StressReferences::add(StressReference reference) {
  const std::string key = reference.key;
  by_key_.insert_or_assign(key, std::move(reference));
}

const StressReference* StressReferences::find(const std::string& key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? nullptr : &found->second;
}

StressReference StressReferences::of(const Scene& scene) const {
  const std::string key = motion_key(scene);
  if (const StressReference* found = find(key)) return *found;
  StressReference none;
  none.scenario = scene.name;
  none.law = scene.joints.front().film;
  none.key = key;
  none.why_none = "none was made for this motion; `stress --references FOLDER` makes those that are missing";
  return none;
}

StressReferences StressReferences::read(const std::filesystem::path& folder) {
  const std::string table_name = (folder / reference_table_name).string();
  const std::string motions_name = (folder / reference_motions_name).string();
  const CsvTable table(read_input(table_name), table_name);
  const CsvTable motions(read_input(motions_name), motions_name);
  StressReferences references;
  const auto text = [](const CsvTable& of, std::size_t row, const char* column) {
    return std::string(of.field(row, of.column(column)));
  };
  const auto value = [](const CsvTable& of, std::size_t row, const char* column) {
    return of.number(row, of.column(column));
  };
  std::map<std::string, std::vector<ReferencePlace>> rows;
  for (std::size_t i = 0; i < motions.rows(); ++i) {
    const auto n = [&](const char* column) { return value(motions, i, column); };
    rows[text(motions, i, "motion")].push_back({n("t"),
                                                {n("ex_over_c"), n("ey_over_c")},
                                                {n("wx"), n("wy")},
                                                {n("fx"), n("fy")},
                                                n("growth"),
                                                n("force_gain")});
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    StressReference each;
    each.key = text(table, i, "motion");
    each.scenario = text(table, i, "case");
    each.law = text(table, i, "law");
    each.methods = text(table, i, "methods");
    each.why_none = text(table, i, "why_none");
    each.apart = {value(table, i, "places_apart"), value(table, i, "rates_apart"), value(table, i, "forces_apart")};
    each.rate_unit = value(table, i, "rate_unit");
    each.force_unit = value(table, i, "force_unit");
    each.rows = std::move(rows[each.key]);
    if (checksum_of(each) != text(table, i, "checksum")) {
      throw std::invalid_argument(fmt::format(
          "\"{}\": the rows of motion {} (case \"{}\", law \"{}\") are not those that were made: their checksum is {}, "
          "and \"{}\" has {}",
          motions_name, each.key, each.scenario, each.law, checksum_of(each), table_name, text(table, i, "checksum")));
    }
    references.add(std::move(each));
  }
  return references;
}

void StressReferences::write(const std::filesystem::path& folder) const {
  std::vector<const StressReference*> ordered;
  for (const auto& [key, each] : by_key_) ordered.push_back(&each);
  std::sort(ordered.begin(), ordered.end(), [](const StressReference* a, const StressReference* b) {
    return std::tie(a->scenario, a->law, a->key) < std::tie(b->scenario, b->law, b->key);
  });
  std::string table = table_header;
  std::string motions = motions_header;
  for (const StressReference* each : ordered) {
    table +=
        fmt::format("{},{},{},{},{:.1e},{:.1e},{:.1e},{},{},{},{},{}\n", each->key, each->scenario, each->law,
                    each->rows.size(), each->apart[0], each->apart[1], each->apart[2], number(each->rate_unit),
                    number(each->force_unit), checksum_of(*each), one_field(each->methods), one_field(each->why_none));
    motions += motion_rows(*each);
  }
  write_file(folder / reference_motions_name, motions);
  write_file(folder / reference_table_name, table);
}

}  // namespace lubjoint::reports
