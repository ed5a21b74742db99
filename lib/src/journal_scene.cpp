#include "lubjoint/scene/journal_scene.hpp"

#include <sstream>

#include "lubjoint/film/losses.hpp"
#include "lubjoint/joint/chosen_film.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

namespace {

std::string listed_massless_laws() {
  std::string list;
  for_each_film_law<NamedFilmLaws>([&]<class Law>() {
    if constexpr (moves_massless_journal<Law>) (list += list.empty() ? "" : ", ") += Law::name;
  });
  return list;
}

}  // namespace

JournalScene journal_scene(const Scene& scene) {
  const auto refuse = [&](const std::string& what, std::size_t line = 1) {
    throw SceneError(scene.file + ":" + std::to_string(line) + ": " + what);
  };
  if (scene.bodies.size() != 1) {
    refuse("bodies has " + std::to_string(scene.bodies.size()) +
               " entries; allowed is one, a journal that floats in a bearing on the ground",
           scene.bodies.empty() ? 1 : scene.bodies.back().line);
  }
  if (scene.joints.size() != 1) {
    refuse("joints has " + std::to_string(scene.joints.size()) + " entries; allowed is one, the journal's bearing",
           scene.joints.empty() ? 1 : scene.joints.back().line);
  }
  if (!scene.constraints.empty()) {
    refuse("constraints has " + std::to_string(scene.constraints.size()) + " entries; a free journal has none");
  }
  const SceneBody& body = scene.bodies.front();
  const SceneJoint& joint = scene.joints.front();
  if (!joint.bearing.on_ground()) {
    refuse("joints[0].bearing.body is \"" + body.name + "\"; allowed is \"ground\"", joint.line);
  }
  if (!is_zero(joint.journal.point)) {
    refuse("joints[0].journal.point is not [0, 0]; allowed is a journal at the mass centre of its body", joint.line);
  }
  if (joint.contact) refuse("joints[0] has contact; allowed here is a film alone");
  if (joint.shear) {  // the law may be another than the file's
    with_film_law<NamedFilmLaws>(joint.film, [&]<class Law>() { return sheared_gap<Law>(*joint.shear); });
  }
  if (joint.shear && !body.spin_is_held) {
    refuse("joints[0].shear slows the journal down; allowed here is a spin that is held: spin = {held = ...}",
           joint.line);
  }
  if (!scene.springs.empty()) {
    refuse("springs has " + std::to_string(scene.springs.size()) + " entries; a free journal has none");
  }
  for (const SceneLoad& each : scene.loads) {
    if (!each.is_constant()) {
      refuse("loads has one that is not constant, inertial and through the mass centre; allowed here are such");
    }
    if (each.moment != 0) refuse("loads has a moment; allowed here are forces: the journal's spin is constant");
  }
  Vector2<double> load = body.mass * scene.gravity;
  for (const SceneLoad& each : scene.loads) load += each.force;
  if (body.mass == 0) {  // what the reader could not know: the law may be another than the file's
    const bool moves =
        with_film_law<NamedFilmLaws>(joint.film, []<class Law>() { return moves_massless_journal<Law>; });
    if (!moves) {
      refuse("bodies[0].mass is 0 on a film of " + joint.film +
                 ", which leaves the motion open: not every force has one velocity; allowed are " +
                 listed_massless_laws(),
             body.line);
    }
  }
  const Vector2<double> e = (body.position - joint.bearing.point) / joint.clearance;
  if (!(one_minus_squared_norm(e.x(), e.y()) > 0)) {
    std::ostringstream message;
    message << "bodies[0].position puts journal \"" << body.name << "\" at eccentricity ratio " << e.norm()
            << " in joint \"" << joint.name << "\"; allowed are eccentricity ratios in [0, 1)";
    refuse(message.str(), body.line);
  }
  const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
  with_film_law<NamedFilmLaws>(joint.film, [&]<class Law>() {
    if constexpr (ShapedFilmLaw<Law>) require_shape<Law>(length_to_diameter(bearing));
    if constexpr (CompiledLaw<Law>) require_compiled_shape(Law::name, length_to_diameter(bearing));
  });
  return {bearing,
          Lubricant<double>(joint.viscosity),
          {body.mass, load, 0.0, body.spin},
          {e.x(), e.y(), body.velocity.x() / joint.clearance, body.velocity.y() / joint.clearance},
          joint.film,
          joint.table};
}

}  // namespace lubjoint
