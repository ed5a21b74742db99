#include "lubjoint/scene/scene_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/losses.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/text/nearest_name.hpp"
#include "lubjoint/text/printable.hpp"
#include "scene_changes.hpp"
#include "scene_forces.hpp"
#include "scene_parts.hpp"

namespace lubjoint {

namespace {

/// [s]; far below any run's, far above where an output interval would lose its digits.
constexpr double shortest_duration = 1e-290;

SceneBody read_body(TableReader table, const std::vector<SceneBody>& others) {
  SceneBody body;
  body.name = table.name("name");
  body.line = table.line();
  if (body.name == "ground" || is_taken(others, body.name)) {
    table.refuse("name", in_quotes(body.name), "a name that no other body has; \"ground\" is what never moves");
  }
  body.mass = table.number("mass", Allowed::not_negative, "kg");
  // A journal without mass may keep its inertia: one number then gives it a mass.
  body.inertia = body.mass == 0 ? table.number_or("inertia", 0, Allowed::positive, "kg m^2")
                                : table.number("inertia", Allowed::positive, "kg m^2");
  body.position = table.vector_or("position", body.position, "m");
  body.angle = table.number_or("angle", 0, Allowed::any, "rad");
  body.velocity = table.vector_or("velocity", body.velocity, "m/s");
  if (table.has("points")) {
    TableReader points = table.table("points");
    for (const std::string& name : points.keys()) body.points.push_back({name, points.vector(name, "m")});
  }
  if (table.is_table("spin")) {
    TableReader spin = table.table("spin");
    if (!spin.has("held")) {
      table.refuse("spin", "a table without held",
                   "a finite number [rad/s], or {held = NUMBER} where it is prescribed");
    }
    body.spin = spin.number("held", Allowed::any, "rad/s");
    body.spin_is_held = true;
    spin.finish();
  } else {
    body.spin = table.number_or("spin", 0, Allowed::any, "rad/s");
  }
  if (body.mass == 0 && !body.spin_is_held) {
    table.refuse("mass", "0 kg for a body whose spin is not held",
                 "a number above 0 [kg], or 0 with spin = {held = NUMBER}: a journal whose film carries the load");
  }
  if (body.mass == 0 && !is_zero(body.velocity)) {
    table.refuse("velocity", "given for a body without mass", "none: the load on its film says how it moves");
  }
  table.finish();
  return body;
}

/// The friction of a joint's film, if there is one.
std::optional<ShearExtent> read_shear(TableReader& table, const std::string& film) {
  if (!table.has("shear")) return std::nullopt;
  const std::string name = table.text("shear");
  if (film == no_film) table.refuse("shear", in_quotes(name), "no shear where film is \"none\": there is no oil");
  if (std::find(shear_extent_names.begin(), shear_extent_names.end(), name) == shear_extent_names.end()) {
    table.refuse("shear", in_quotes(name), one_of(shear_extent_names, name));
  }
  const ShearExtent shear = shear_extent(name);
  if (!with_film_law<NamedFilmLaws>(film, [&]<class Law>() { return has_shear<Law>(shear); })) {
    const bool free = with_film_law<NamedFilmLaws>(film, [&]<class Law>() { return FreeBoundaryLaw<Law>; });
    table.refuse(
        "shear", in_quotes(name) + " with " + film,
        free ? "flooded: the law does not know the bounds of its film" : "film or flooded; striated is for half films");
  }
  return shear;
}

/// A law of finite length is not made for every L/D.
void require_shape_of_joint(TableReader& table, const SceneJoint& joint) {
  with_film_law<NamedFilmLaws>(joint.film, [&]<class Law>() {
    const double shape = joint.length / (2 * joint.journal_radius);
    std::ostringstream allowed;
    if constexpr (ShapedFilmLaw<Law>) {
      if (shape <= Law::longest) return;
      allowed << "a bearing whose length is at most " << Law::longest << " of its diameter, or another law";
    } else if constexpr (CompiledLaw<Law>) {
      if (shape >= least_compiled_shape && shape <= largest_compiled_shape) return;
      allowed << "a bearing whose length is from " << least_compiled_shape << " to " << largest_compiled_shape
              << " of its diameter, or another law";
    } else {
      return;
    }
    std::ostringstream given;
    given << in_quotes(joint.film) << " in a bearing of L/D = " << shape;
    table.refuse("film", given.str(), allowed.str());
  });
}

}  // namespace

SceneJoint read_joint_film(TableReader& table) {
  SceneJoint joint;
  joint.name = table.name("name");
  joint.line = table.line();
  joint.film = table.text("film");
  const bool dry = joint.film == no_film;
  if (!dry && std::find(named_film_laws.begin(), named_film_laws.end(), joint.film) == named_film_laws.end()) {
    std::vector<std::string_view> names(named_film_laws.begin(), named_film_laws.end());
    names.push_back(no_film);
    table.refuse("film", in_quotes(joint.film), one_of(names, joint.film));
  }
  // A dry joint may keep its oil and length: one word then changes it.
  joint.viscosity = dry ? table.number_or("viscosity", 0, Allowed::positive, "Pa s")
                        : table.number("viscosity", Allowed::positive, "Pa s");
  joint.length =
      dry ? table.number_or("length", 0, Allowed::positive, "m") : table.number("length", Allowed::positive, "m");
  joint.journal_radius = table.number("journal_radius", Allowed::positive, "m");
  joint.clearance = table.number("clearance", Allowed::positive, "m");
  if (joint.clearance >= joint.journal_radius) {
    std::ostringstream given;
    given << joint.clearance << " m";
    std::ostringstream allowed;
    allowed << "less than journal_radius, " << joint.journal_radius << " m";
    table.refuse("clearance", given.str(), allowed.str());
  }
  if (!dry) require_shape_of_joint(table, joint);
  read_contact(table, joint);
  joint.shear = read_shear(table, joint.film);
  if (table.has("density")) {
    const double density = table.number("density", Allowed::positive, "kg/m^3");
    if (dry)
      table.refuse("density", with_unit(density, "kg/m^3"), "no density where film is \"none\": there is no oil");
    joint.density = density;
  }
  return joint;
}

void read_integrator(TableReader table, std::string& name, RunSettings& run) {
  name = table.text_or("name", name);
  if (std::find(integrator_names().begin(), integrator_names().end(), name) == integrator_names().end()) {
    table.refuse("name", in_quotes(name), one_of(integrator_names(), name));
  }
  run.relative_tolerance = table.number_or("relative_tolerance", run.relative_tolerance, Allowed::positive, "-");
  if (run.relative_tolerance >= 1 || run.relative_tolerance < 1e-14) {
    std::ostringstream given;
    given << run.relative_tolerance;
    table.refuse("relative_tolerance", given.str(), "a number from 1e-14 to below 1");
  }
  run.absolute_tolerance =
      table.number_or("absolute_tolerance", run.relative_tolerance, Allowed::positive, "clearances");
  const double steps = table.number_or("max_steps", static_cast<double>(run.max_steps), Allowed::positive, "-");
  if (steps < 1 || steps > 1e12 || steps != std::floor(steps)) {
    std::ostringstream given;
    given << steps;
    table.refuse("max_steps", given.str(), "a whole number from 1 to 1e12");
  }
  run.max_steps = static_cast<std::size_t>(steps);
  table.finish();
}

bool read_output(TableReader table, RunSettings& run) {
  run.output_interval = table.number_or("interval", run.output_interval, Allowed::positive, "s");
  const bool energy_ledger = table.flag_or("energy_ledger", false);
  // A file of more rows than this is a slip of the pen, not a request.
  if (run.duration / run.output_interval > 1e7) {
    std::ostringstream given;
    given << run.output_interval << " s";
    table.refuse("interval", given.str(), "at least a ten-millionth of the duration");
  }
  table.finish();
  return energy_ledger;
}

double read_duration(TableReader& root) {
  const double duration = root.number("duration", Allowed::positive, "s");
  if (duration < shortest_duration) {
    root.refuse("duration", with_unit(duration, "s"), "at least " + with_unit(shortest_duration, "s"));
  }
  return duration;
}

namespace {

SceneJoint read_joint(TableReader table, const Scene& scene, bool is_rough) {
  SceneJoint joint = read_joint_film(table);
  if (is_taken(scene.joints, joint.name)) {
    table.refuse("name", in_quotes(joint.name), "a name that no other joint has");
  }
  joint.bearing = read_anchor(table.table("bearing"), scene);
  joint.journal = read_anchor(table.table("journal"), scene);
  if (joint.bearing.body == joint.journal.body) {
    table.refuse("journal", "on the same body as the bearing", "another body");
  }
  const Vector2<double> e = (position_of(joint.journal, scene) - position_of(joint.bearing, scene)) / joint.clearance;
  if (!is_rough && !joint.contact && !(one_minus_squared_norm(e.x(), e.y()) > 0)) {
    std::ostringstream given;
    given << "at eccentricity ratio " << e.norm() << " in its bearing";
    table.refuse("journal", given.str(),
                 "a journal that starts inside it, at an eccentricity ratio in [0, 1), or a joint with contact");
  }
  table.finish();
  return joint;
}

/// A body without mass is a journal alone on its film: all else would need its inertia.
void require_massless_journals(const TableReader& root, const Scene& scene) {
  const bool any = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& b) { return b.mass == 0; });
  if (!any || is_free_journal(scene)) return;
  const bool alone = scene.bodies.size() == 1 && scene.joints.size() == 1 && scene.constraints.empty();
  const bool steady =
      std::all_of(scene.loads.begin(), scene.loads.end(), [](const auto& l) { return l.is_constant(); });
  const char* why = !alone                    ? "in a mechanism"
                    : !scene.springs.empty()  ? "on a spring"
                    : !scene.sensors.empty()  ? "in a scene with sensors"
                    : !steady                 ? "under a load that is not constant, inertial and through its centre"
                    : scene.joints[0].contact ? "in a bearing whose wall it may touch"
                    : scene.energy_ledger     ? "in a scene with an energy ledger, whose kinetic energy it has none of"
                                              : "with a moment, or a bearing or a pin off the centres";
  root.refuse(
      "bodies", std::string("a body of mass 0 ") + why,
      "a mass above 0, or a journal alone, at the mass centre of its body, on a film in a bearing on the ground");
}

/// @param is_rough  are places guesses, which a journal may have outside its bearing?
Scene read_scene(TableReader root, const std::string& file, bool is_rough = false) {
  Scene scene;
  scene.file = file;
  if (const double dimension = root.number_or("dimension", 2, Allowed::positive, "-"); dimension != 2) {
    root.refuse("dimension", with_unit(dimension, ""),
                dimension == 3 ? "2 here: scenes in space are for simulate, cost and bench scenes alone"
                               : "2, or 3 in space");
  }
  // A table that nobody asks for is refused first: what it was meant to be would only be missed later.
  root.require_tables_among({"name", "gravity", "duration", "bodies", "loads", "joints", "constraints", "springs",
                             "sensors", "stabilisation", "integrator", "output"});
  scene.name = root.name("name");
  scene.gravity = root.vector_or("gravity", scene.gravity, "m/s^2");
  scene.run.duration = read_duration(root);
  for (const TableReader& table : root.tables("bodies")) scene.bodies.push_back(read_body(table, scene.bodies));
  if (scene.bodies.empty()) root.refuse("bodies", "missing or empty", "at least one [[bodies]] table");
  for (const TableReader& table : root.tables("loads")) scene.loads.push_back(read_load(table, scene));
  for (const TableReader& table : root.tables("joints")) scene.joints.push_back(read_joint(table, scene, is_rough));
  for (const TableReader& table : root.tables("constraints")) {
    scene.constraints.push_back(read_constraint(table, scene));
  }
  for (const TableReader& table : root.tables("springs")) scene.springs.push_back(read_spring(table, scene));
  for (const TableReader& table : root.tables("sensors")) scene.sensors.push_back(read_sensor(table, scene));
  if (!root.has("joints") && !root.has("constraints")) {  // a file cut off there would run as free flight
    root.refuse("joints", "missing, and so is constraints",
                "at least one [[joints]] or [[constraints]] table, or joints = [] for bodies that fly freely");
  }
  if (root.has("stabilisation")) scene.stabilisation = read_stabilisation(root.table("stabilisation"));
  scene.coordinates = read_coordinates(root, !scene.constraints.empty(), scene.stabilisation);
  scene.run.output_interval = scene.run.duration / 1000;
  if (root.has("integrator")) read_integrator(root.table("integrator"), scene.integrator, scene.run);
  if (root.has("output")) scene.energy_ledger = read_output(root.table("output"), scene.run);
  require_massless_journals(root, scene);
  root.finish();
  return scene;
}

}  // namespace

SceneFile::SceneFile(const std::filesystem::path& file) : name_(file.string()) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw SceneError(name_ + ": is a folder; allowed is a scene file (TOML)");
  }
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 4096> piece{};
  while (stream.read(piece.data(), piece.size()) || stream.gcount() > 0) {
    text_.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) throw SceneError(name_ + ": can't be read; allowed is a scene file (TOML)");
}

namespace {
/// Place behind the string that opens at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool long_one = text.substr(begin, 3) == three;
  std::size_t i = begin + (long_one ? 3 : 1);
  while (i < text.size()) {
    if (long_one ? text.substr(i, 3) == three : text[i] == quote) return i + (long_one ? 3 : 1);
    if (!long_one && text[i] == '\n') return i;  // never closed: the parser says so
    i += quote == '"' && text[i] == '\\' ? 2 : 1;
  }
  return text.size();
}

/// May a string open at this quote? Within a word it is part of a value that is not allowed, up to whose end toml++
/// reads on.
bool opens_string(std::string_view text, std::size_t quote) {
  return quote == 0 || std::string_view(" \t\r\n=,[{.").find(text[quote - 1]) != std::string_view::npos;
}

/// Place of the first byte beyond ASCII outside of strings and comments, if there is one. TOML has none there, and
/// toml++ 3.3 does not define what it makes of some.
std::optional<std::size_t> bare_letter(std::string_view text) {
  std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // byte order mark
  while (i < text.size()) {
    if (text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if ((text[i] == '"' || text[i] == '\'') && opens_string(text, i)) {
      i = end_of_string(text, i);
    } else if (static_cast<unsigned char>(text[i]) >= 0x80) {
      return i;
    } else {
      ++i;
    }
  }
  return {};
}

}  // namespace

toml::table parse_scene_text(const std::string& text, const std::string& name) {
  if (const auto place = bare_letter(text)) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(*place);
    throw SceneError(name + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')) +
                     ": a character beyond ASCII outside of strings and comments; allowed in keys are letters A to Z, "
                     "digits, _ and -");
  }
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& failure) {
    throw SceneError(name + ":" + std::to_string(failure.source().begin.line) +
                     ": not valid TOML: " + printable(failure.description()) + "; allowed is TOML 1.0");
  }
}

Scene SceneFile::scene(const std::vector<SceneChange>& changes) const {
  toml::table table = parse_scene_text(text_, name_);
  for (const SceneChange& change : changes) change_value(table, change, name_);
  return read_scene(TableReader(table, name_, ""), name_);
}

Scene SceneFile::rough_scene() const {
  const toml::table table = parse_scene_text(text_, name_);
  return read_scene(TableReader(table, name_, ""), name_, true);
}

std::string SceneFile::numbered_key(const std::string& key) const {
  toml::table table = parse_scene_text(text_, name_);
  return find_value(table, key, name_);
}

}  // namespace lubjoint
