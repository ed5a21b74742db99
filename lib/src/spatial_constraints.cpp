#include "spatial_constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

#include "lubjoint/text/nearest_name.hpp"
#include "scene_drivers.hpp"
#include "scene_parts.hpp"

namespace lubjoint {

namespace {

Vector3<double> read_direction(TableReader& table, const char* key) {
  const Vector3<double> given = table.vector3(key, "-");
  if (is_zero(given)) table.refuse(key, "[0, 0, 0]", "a direction, of any length");
  return direction(given);
}

/// A vector of one body's frame in that of another, at t = 0.
Vector3<double> seen_from(const SpatialScene& scene, std::size_t body, const Vector3<double>& vector,
                          std::size_t other) {
  const Vector3<double> inertial = inertial_vector(frame_at_start(scene, body), vector);
  return transposed_product(frame_at_start(scene, other).rotation, inertial);
}

/// The vector of the axes' normal plane that is nearest to where the other's lies at t = 0.
Vector3<double> across_like(const SpatialScene& scene, const BodyAxes<double>& axes, const BodyAxes<double>& other) {
  const Vector3<double> wanted = seen_from(scene, other.body, other.across, axes.body);
  const Vector3<double> flat = difference(wanted, scaled(dot(axes.axis, wanted), axes.axis));
  return flat.norm() > 1e-6 ? direction(flat) : any_perpendicular(axes.axis);
}

/// All that may be said of a side: {body, point, axis}.
struct Side {
  std::size_t body;
  Vector3<double> point;
  std::optional<Vector3<double>> axis;
};

Side read_side(TableReader table, const SpatialScene& scene) {
  const SpatialBodyPoint<double> at = read_body_point(table, scene, true);
  Side side{at.body, at.point, {}};
  if (table.has("axis")) side.axis = read_direction(table, "axis");
  table.finish();
  return side;
}

void require_two_bodies(const TableReader& table, std::size_t first, std::size_t second) {
  if (first == second) table.refuse("second", "on the same body as first", "another body");
}

/// Joints of parallel axes hold with antiparallel ones as well, and angles about axes that lie across each other are
/// not defined: a start decides which is meant.
void require_near_axes(const TableReader& table, const SpatialScene& scene, const BodyAxes<double>& first,
                       const BodyAxes<double>& second) {
  const Vector3<double> n_i = inertial_vector(frame_at_start(scene, first.body), first.axis);
  const Vector3<double> n_j = inertial_vector(frame_at_start(scene, second.body), second.axis);
  constexpr double least_cosine = 0.5;  // of 60 degrees
  if (dot(n_i, n_j) >= least_cosine) return;
  const auto words = [](const Vector3<double>& v) {
    std::ostringstream text;
    text << "[" << v(0) << ", " << v(1) << ", " << v(2) << "]";
    return text.str();
  };
  table.refuse("second.axis", "along " + words(n_j) + " at the start, inertial, and that of first along " + words(n_i),
               "axes less than 60 degrees apart, pointing the same way; without a second.axis it is that of first");
}

std::pair<BodyAxes<double>, BodyAxes<double>> read_sides(TableReader& table, const SpatialScene& scene) {
  const BodyAxes<double> first = read_axes(table.table("first"), scene);
  const BodyAxes<double> second = read_axes_like(table.table("second"), scene, first);
  require_two_bodies(table, first.body, second.body);
  require_near_axes(table, scene, first, second);
  return {first, second};
}

std::pair<SpatialBodyPoint<double>, SpatialBodyPoint<double>> read_points(TableReader& table,
                                                                          const SpatialScene& scene) {
  const SpatialBodyPoint<double> first = read_spatial_point(table.table("first"), scene);
  const SpatialBodyPoint<double> second = read_spatial_point(table.table("second"), scene);
  require_two_bodies(table, first.body, second.body);
  return {first, second};
}

FixedJoint<double> read_ground_joint(TableReader& table, const SpatialScene& scene) {
  const std::size_t number = read_body_name(table, "body", body_names(scene), false);
  const SpatialSceneBody& body = scene.bodies[number];
  const Vector3<double> position = table.vector3_or("position", body.position, "m");
  const EulerParameters<double> p =
      table.has("orientation") ? read_orientation(table.table("orientation")) : body.orientation;
  const Matrix3<double> a = rotation_matrix(p);
  return {{{{position, a.col(2), a.col(0)}, ground_body}, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, number}}};
}

FixedJoint<double> read_fixed(TableReader& table, const SpatialScene& scene) {
  const auto [first, second] = read_points(table, scene);
  const BodyAxes<double> axes{{second.point, {0, 0, 1}, {1, 0, 0}}, second.body};
  const BodyAxes<double> of_first{{first.point, seen_from(scene, second.body, axes.axis, first.body),
                                   seen_from(scene, second.body, axes.across, first.body)},
                                  first.body};
  return {{of_first, axes}};
}

SphericalJoint<double> read_spherical(TableReader& table, const SpatialScene& scene) {
  const auto [first, second] = read_points(table, scene);
  return {{first, second}};
}

UniversalJoint<double> read_universal(TableReader& table, const SpatialScene& scene) {
  const BodyAxes<double> first = read_axes(table.table("first"), scene);
  const BodyAxes<double> second = read_axes(table.table("second"), scene);
  require_two_bodies(table, first.body, second.body);
  return {{first, second}};
}

template <class Joint>
Joint read_along_axis(TableReader& table, const SpatialScene& scene) {
  const auto [first, second] = read_sides(table, scene);
  return {{first, second}};
}

DistanceJoint<double> read_distance(TableReader& table, const SpatialScene& scene) {
  const auto [first, second] = read_points(table, scene);
  const auto place = [&](const SpatialBodyPoint<double>& at) {
    return point_motion(frame_at_start(scene, at.body), at.point).position;
  };
  const double at_start = difference(place(second), place(first)).norm();
  if (!table.has("length") && !(at_start > 0 && std::isfinite(at_start))) {
    table.refuse("length", "missing, and the points coincide at t = 0, or lie too far apart for double precision",
                 "a finite number above 0 [m]");
  }
  return {{first, second}, table.number_or("length", at_start, Allowed::positive, "m")};
}

constexpr MotionWords turning{"angle", "rad", "rad/s", "rad/s^2"};
constexpr MotionWords sliding{"displacement", "m", "m/s", "m/s^2"};

/// Axes of a constraint about which, or along which, a driver may act.
struct DrivenAxes {
  BodyAxes<double> first, second;
  bool turns, slides;
};

std::optional<DrivenAxes> driven_axes(const SpatialSceneConstraint& constraint) {
  if (const auto* pin = std::get_if<RevoluteJoint<double>>(&constraint.constraint))
    return DrivenAxes{pin->first, pin->second, true, false};
  if (const auto* sleeve = std::get_if<CylindricalJoint<double>>(&constraint.constraint))
    return DrivenAxes{sleeve->first, sleeve->second, true, true};
  if (const auto* slider = std::get_if<PrismaticJoint<double>>(&constraint.constraint))
    return DrivenAxes{slider->first, slider->second, false, true};
  return std::nullopt;
}

AnySpatialConstraint<double> read_spatial_driver(TableReader& table, const SpatialScene& scene) {
  const std::string name = table.text("of");
  const auto found =
      std::find_if(scene.constraints.begin(), scene.constraints.end(), [&](const auto& c) { return c.name == name; });
  const auto axes = found == scene.constraints.end() ? std::nullopt : driven_axes(*found);
  if (!axes) {
    std::string allowed = "the name of a revolute, cylindrical or prismatic constraint before it:";
    for (const SpatialSceneConstraint& each : scene.constraints) {
      if (driven_axes(each)) allowed += " " + in_quotes(each.name);
    }
    table.refuse("of", in_quotes(name), allowed);
  }
  const std::string motion = table.text_or("motion", axes->turns ? "rotation" : "translation");
  if (motion != "rotation" && motion != "translation") {
    table.refuse("motion", in_quotes(motion), "\"rotation\" or \"translation\"");
  }
  const bool turns = motion == "rotation";
  if (turns ? !axes->turns : !axes->slides) {
    table.refuse("motion", in_quotes(motion) + " of " + in_quotes(name),
                 turns ? "\"translation\" of a prismatic constraint" : "\"rotation\" of a revolute constraint");
  }
  // The revolute's axes across coincide at t = 0: the angle is counted from there.
  const double along =
      turns ? 0
            : dot(inertial_vector(frame_at_start(scene, axes->first.body), axes->first.axis),
                  difference(point_motion(frame_at_start(scene, axes->second.body), axes->second.point).position,
                             point_motion(frame_at_start(scene, axes->first.body), axes->first.point).position));
  const MotionWords& words = turns ? turning : sliding;
  const char* other = turns ? sliding.quantity : turning.quantity;
  if (table.has(other)) table.refuse(other, "given for a " + motion, words.quantity);
  const PrescribedMotion<double> prescribed = read_motion(table, scene.run.duration, words, along);
  if (turns) return RotationalDriver<double>{{axes->first, axes->second}, prescribed};
  return TranslationalDriver<double>{{axes->first, axes->second}, prescribed};
}

/// How a type of constraint is read from its table.
struct SpatialConstraintReader {
  std::string_view type;
  AnySpatialConstraint<double> (*read)(TableReader&, const SpatialScene&);
};

template <auto read>
AnySpatialConstraint<double> as_any(TableReader& table, const SpatialScene& scene) {
  return read(table, scene);
}

constexpr SpatialConstraintReader constraint_readers[] = {
    {"ground", as_any<read_ground_joint>},
    {"fixed", as_any<read_fixed>},
    {"spherical", as_any<read_spherical>},
    {"universal", as_any<read_universal>},
    {"revolute", as_any<read_along_axis<RevoluteJoint<double>>>},
    {"cylindrical", as_any<read_along_axis<CylindricalJoint<double>>>},
    {"prismatic", as_any<read_along_axis<PrismaticJoint<double>>>},
    {"planar", as_any<read_along_axis<PlanarJoint<double>>>},
    {"distance", as_any<read_distance>},
    {"driver", as_any<read_spatial_driver>}};
// Two types make a FixedJoint, and one makes both drivers.
static_assert(std::size(constraint_readers) + 1 == std::variant_size_v<AnySpatialConstraint<double>>,
              "a reader for each but held spins, which bodies say");

}  // namespace

std::vector<std::string> body_names(const SpatialScene& scene) {
  std::vector<std::string> names;
  for (const SpatialSceneBody& body : scene.bodies) names.push_back(body.name);
  return names;
}

EulerParameters<double> read_orientation(TableReader table) {
  const bool by_parameters = table.has("euler_parameters");
  if (by_parameters == (table.has("axis") || table.has("angle"))) {
    table.refuse(by_parameters ? "euler_parameters" : "axis", by_parameters ? "given beside axis or angle" : "missing",
                 "axis and angle, or euler_parameters");
  }
  EulerParameters<double> p;
  if (by_parameters) {
    const std::vector<double> given = table.numbers("euler_parameters", {4}, "-");
    for (std::size_t k = 0; k < 4; ++k) p(static_cast<Eigen::Index>(k)) = given[k];
    if (!(std::abs(p.norm() - 1) <= 1e-6)) {  // as far as rounded numbers of a file may be off
      table.refuse("euler_parameters", "four numbers whose squares add up to " + with_unit(p.squaredNorm(), ""),
                   "four numbers whose squares add up to 1");
    }
    p = normalised(p);
  } else {
    const Vector3<double> axis = read_direction(table, "axis");
    p = euler_parameters(axis, table.number("angle", Allowed::any, "rad"));
  }
  table.finish();
  return p;
}

SpatialBodyPoint<double> read_spatial_point(TableReader table, const SpatialScene& scene) {
  const SpatialBodyPoint<double> point = read_body_point(table, scene, true);
  table.finish();
  return point;
}

SpatialBodyPoint<double> read_body_point(TableReader& table, const SpatialScene& scene, bool ground_is_allowed) {
  const std::size_t body = read_body_name(table, "body", body_names(scene), ground_is_allowed);
  if (!table.is_text("point")) return {body, table.vector3_or("point", {0, 0, 0}, "m")};
  static const std::vector<SpatialScenePoint> none;
  const std::string holder = body == ground_body ? std::string() : scene.bodies[body].name;
  return {body,
          find_point(table, "point", holder, body == ground_body ? none : scene.bodies[body].points, "[x, y, z]")};
}

BodyAxes<double> read_axes(TableReader table, const SpatialScene& scene) {
  if (!table.has("axis")) static_cast<void>(table.vector3("axis", "-"));  // says that it is missing
  const Side side = read_side(table, scene);
  return {{side.point, *side.axis, any_perpendicular(*side.axis)}, side.body};
}

BodyAxes<double> read_axes_like(TableReader table, const SpatialScene& scene, const BodyAxes<double>& other) {
  const Side side = read_side(table, scene);
  BodyAxes<double> axes{{side.point, {}, {}}, side.body};
  axes.axis = side.axis ? *side.axis : direction(seen_from(scene, other.body, other.axis, side.body));
  axes.across = across_like(scene, axes, other);
  return axes;
}

std::size_t read_angle(TableReader& table, std::string_view key, SpatialScene& scene, double zero) {
  std::vector<SpatialSceneConstraint> pivots;
  std::copy_if(scene.constraints.begin(), scene.constraints.end(), std::back_inserter(pivots), [](const auto& each) {
    const auto axes = driven_axes(each);
    return axes && axes->turns;
  });
  const std::size_t named = find_named(table, key, table.text(key), pivots, "revolute or cylindrical constraint");
  const DrivenAxes axes = *driven_axes(pivots[named]);
  const auto same_side = [](const BodyAxes<double>& a, const BodyAxes<double>& b) {
    return a.body == b.body && a.point == b.point && a.axis == b.axis && a.across == b.across;
  };
  const auto known = std::find_if(scene.angles.begin(), scene.angles.end(), [&](const CountedAngle<double>& each) {
    return each.zero == zero && same_side(each.first, axes.first) && same_side(each.second, axes.second);
  });
  const auto number = static_cast<std::size_t>(known - scene.angles.begin());
  if (known == scene.angles.end()) scene.angles.push_back({axes.first, axes.second, zero});
  return number;
}

SpatialSceneConstraint read_spatial_constraint(TableReader table, const SpatialScene& scene) {
  SpatialSceneConstraint constraint;
  constraint.name = table.name("name");
  const bool joint_has_it = std::any_of(scene.joints.begin(), scene.joints.end(),
                                        [&](const auto& joint) { return joint.plane.name == constraint.name; });
  if (joint_has_it || is_taken(scene.constraints, constraint.name)) {
    table.refuse("name", in_quotes(constraint.name), "a name that no other constraint or joint has");
  }
  const std::string type = table.text("type");
  const auto* known = std::ranges::find(constraint_readers, type, &SpatialConstraintReader::type);
  if (known == std::end(constraint_readers)) {
    std::vector<std::string_view> types;
    for (const SpatialConstraintReader& each : constraint_readers) types.push_back(each.type);
    table.refuse("type", in_quotes(type), one_of(types, type));
  }
  constraint.constraint = known->read(table, scene);
  table.finish();
  return constraint;
}

}  // namespace lubjoint
