#include "scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lubjoint/text/nearest_name.hpp"
#include "scene_drivers.hpp"

namespace lubjoint {

namespace {

constexpr std::string_view contact_form_names[] = {"point", "cylinder"};  // in the order of ContactForm

SceneContact read_contact_table(TableReader table, double length) {
  SceneContact contact;
  contact.bearing_modulus = table.number("bearing_modulus", Allowed::positive, "Pa");
  contact.journal_modulus = table.number("journal_modulus", Allowed::positive, "Pa");
  const auto poisson = [&](const char* key) {
    const double value = table.number(key, Allowed::any, "-");
    if (!(value > -1 && value <= 0.5)) table.refuse(key, with_unit(value, ""), "a number above -1, at most 0.5");
    return value;
  };
  contact.bearing_poisson = poisson("bearing_poisson");
  contact.journal_poisson = poisson("journal_poisson");
  contact.restitution = table.number("restitution", Allowed::not_negative, "-");
  if (contact.restitution > 1) table.refuse("restitution", with_unit(contact.restitution, ""), "a number in [0, 1]");
  contact.min_impact_speed = table.number("min_impact_speed", Allowed::positive, "m/s");
  contact.friction = table.number_or("friction", 0, Allowed::not_negative, "-");
  contact.slow_sliding = table.number_or("slow_sliding", contact.slow_sliding, Allowed::positive, "m/s");
  const std::string form = table.text_or("form", "point");
  const auto* known = std::ranges::find(contact_form_names, form);
  if (known == std::end(contact_form_names)) table.refuse("form", in_quotes(form), "\"point\" or \"cylinder\"");
  contact.form = static_cast<ContactForm>(known - contact_form_names);
  if (contact.form == ContactForm::cylinder && length == 0) {
    table.refuse("form", in_quotes(form) + " without a length of the bearing", "length beside it, or \"point\"");
  }
  table.finish();
  return contact;
}

/// Both sides of a pin or a guide.
std::pair<SceneAnchor, SceneAnchor> read_sides(TableReader& table, const Scene& scene) {
  const SceneAnchor first = read_anchor(table.table("first"), scene);
  const SceneAnchor second = read_anchor(table.table("second"), scene);
  if (first.body == second.body) table.refuse("second", "on the same body as first", "another body");
  return {first, second};
}

GroundConstraint<double> read_ground(TableReader& table, const Scene& scene) {
  const std::size_t number = read_body_name(table, "body", scene, false);
  const SceneBody& body = scene.bodies[number];
  const Vector2<double> position = table.vector_or("position", body.position, "m");
  return {number, position, table.number_or("angle", body.angle, Allowed::any, "rad")};
}

Revolute<double> read_revolute(TableReader& table, const Scene& scene) {
  const auto [first, second] = read_sides(table, scene);
  return {first, second};
}

Translational<double> read_translational(TableReader& table, const Scene& scene) {
  const auto [first, second] = read_sides(table, scene);
  Vector2<double> axis = table.vector("axis", "-");
  const double largest = axis.cwiseAbs().maxCoeff();  // first, lest squares overflow or vanish
  if (!(largest > 0)) table.refuse("axis", "[0, 0]", "a direction, fixed to the body of first");
  axis /= largest;
  axis /= axis.norm();
  return {first, axis, second, table.number_or("angle", 0, Allowed::any, "rad")};
}

/// How a type of constraint is read from its table.
struct ConstraintReader {
  std::string_view type;
  AnyConstraint<double> (*read)(TableReader&, const Scene&);
};

template <auto read>
AnyConstraint<double> as_any(TableReader& table, const Scene& scene) {
  return read(table, scene);
}

constexpr ConstraintReader constraint_readers[] = {{"ground", as_any<read_ground>},
                                                   {"revolute", as_any<read_revolute>},
                                                   {"translational", as_any<read_translational>},
                                                   {"driver", read_driver}};
static_assert(std::size(constraint_readers) + 1 == std::variant_size_v<AnyConstraint<double>>,
              "a reader for each; that of drivers reads both that turn and that slide");

}  // namespace

std::string with_unit(double value, const char* unit) {
  std::ostringstream text;
  text << value;
  if (*unit) text << ' ' << unit;
  return text.str();
}

std::size_t read_body_name(TableReader& table, std::string_view key, const std::vector<std::string>& names,
                           bool ground_is_allowed) {
  const std::string name = table.text(key);
  if (ground_is_allowed && name == "ground") return ground_body;
  const auto body = std::find(names.begin(), names.end(), name);
  if (body == names.end()) {
    std::string allowed = "the name of a body:";
    for (const std::string& known : names) allowed += " " + in_quotes(known);
    if (ground_is_allowed) allowed += " or \"ground\"";
    table.refuse(key, in_quotes(name), allowed);
  }
  return static_cast<std::size_t>(body - names.begin());
}

std::size_t read_body_name(TableReader& table, std::string_view key, const Scene& scene, bool ground_is_allowed) {
  std::vector<std::string> names;
  for (const SceneBody& body : scene.bodies) names.push_back(body.name);
  return read_body_name(table, key, names, ground_is_allowed);
}

SceneAnchor read_anchor(TableReader table, const Scene& scene) {
  SceneAnchor anchor;
  anchor.body = read_body_name(table, "body", scene, true);
  anchor.point = read_point(table, "point", scene, anchor.body);
  table.finish();
  return anchor;
}

Vector2<double> read_point(TableReader& table, std::string_view key, const Scene& scene, std::size_t body) {
  if (!table.is_text(key)) return table.vector_or(key, Vector2<double>(0, 0), "m");
  static const std::vector<ScenePoint> none;
  const std::string holder = body == ground_body ? std::string() : scene.bodies[body].name;
  return find_point(table, key, holder, body == ground_body ? none : scene.bodies[body].points, "[x, y]");
}

void read_contact(TableReader& joint_table, SceneJoint& joint) {
  const bool dry = joint.film == no_film;
  if (joint_table.has("transition")) {
    if (dry)
      joint_table.refuse("transition", "given", "no transition where film is \"none\": contact starts at the wall");
    TableReader table = joint_table.table("transition");
    SceneTransition transition;
    transition.e0 = table.number("e0", Allowed::positive, "m");
    transition.e1 = table.number("e1", Allowed::positive, "m");
    if (transition.e1 <= transition.e0) {
      table.refuse("e1", with_unit(transition.e1, "m"), "more than e0, " + with_unit(transition.e0, "m"));
    }
    table.finish();
    joint.transition = transition;
  }
  const bool needed = dry || joint.transition;
  if (needed) {
    joint.contact = read_contact_table(joint_table.table("contact"), joint.length);
  } else if (joint_table.has("contact")) {
    joint_table.refuse("contact", "given without a transition",
                       "transition = {e0, e1} beside it, or film = \"none\" for a dry joint");
  }
}

SceneConstraint read_constraint(TableReader table, const Scene& scene) {
  SceneConstraint constraint;
  constraint.name = table.name("name");
  if (is_taken(scene.constraints, constraint.name) || is_taken(scene.joints, constraint.name)) {
    table.refuse("name", in_quotes(constraint.name), "a name that no other constraint or joint has");
  }
  const std::string type = table.text("type");
  const auto* known = std::ranges::find(constraint_readers, type, &ConstraintReader::type);
  if (known == std::end(constraint_readers)) {
    std::vector<std::string_view> types;
    for (const ConstraintReader& each : constraint_readers) types.push_back(each.type);
    table.refuse("type", in_quotes(type), one_of(types, type));
  }
  constraint.constraint = known->read(table, scene);
  table.finish();
  return constraint;
}

SceneCoordinates read_coordinates(TableReader& root, bool constrained, const SceneStabilisation& stabilisation) {
  const std::string name = root.text_or("coordinates", "auto");
  if (name == "auto") return SceneCoordinates::automatic;
  if (name != "independent" && name != "absolute") {
    root.refuse("coordinates", in_quotes(name), "\"auto\", \"independent\" or \"absolute\"");
  }
  if (!constrained) {
    root.refuse("coordinates", in_quotes(name) + " in a scene without constraints, where both are the same",
                "to leave the key out");
  }
  if (name == "absolute") return SceneCoordinates::absolute;
  if (stabilisation.asked) {
    root.refuse("coordinates",
                in_quotes(name) + " beside a stabilisation table, which independent coordinates don't need",
                "one of the two, or \"absolute\"");
  }
  return SceneCoordinates::independent;
}

SceneStabilisation read_stabilisation(TableReader table) {
  SceneStabilisation stabilisation;
  const std::string method = table.text("method");
  if (method == "baumgarte") {
    stabilisation.alpha = table.number_or("alpha", stabilisation.alpha, Allowed::not_negative, "1/s");
    stabilisation.beta = table.number_or("beta", stabilisation.beta, Allowed::not_negative, "1/s");
  } else if (method == "projection") {
    stabilisation = {true, 0, 0};
  } else {
    table.refuse("method", in_quotes(method), "\"baumgarte\" or \"projection\"");
  }
  const std::string at_singular = table.text_or("singular_positions", "stop");
  if (at_singular != "stop" && at_singular != "pass") {
    table.refuse("singular_positions", in_quotes(at_singular), "\"stop\" or \"pass\"");
  }
  stabilisation.passes_singular = at_singular == "pass";
  stabilisation.asked = true;
  if (stabilisation.passes_singular && !stabilisation.projection) {
    table.refuse("singular_positions", "\"pass\" with Baumgarte's terms, whose drift decides where a run leaves one",
                 "\"stop\", or \"pass\" with method = \"projection\"");
  }
  table.finish();
  return stabilisation;
}

}  // namespace lubjoint
