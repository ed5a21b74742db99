#include "oracle/verify/trajectory/scene_mistakes.hpp"

#include <utility>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::verify {

namespace {

using Scale = std::function<void(Scene&, double)>;

void add_joint_numbers(std::vector<SceneNumber>& list, const SceneJoint& joint, std::size_t j) {
  const auto add = [&](const char* what, double SceneJoint::*number) {
    if (joint.*number == 0) return;
    list.push_back({std::string("the ") + what + " of " + joint.name,
                    [=](Scene& scene, double factor) { scene.joints[j].*number *= factor; }});
  };
  add("clearance", &SceneJoint::clearance);
  if (joint.film != no_film) {
    add("viscosity", &SceneJoint::viscosity);
    add("length", &SceneJoint::length);
  }
  add("journal radius", &SceneJoint::journal_radius);
  if (!joint.contact) return;
  list.push_back({"the moduli of " + joint.name, [j](Scene& scene, double factor) {
                    scene.joints[j].contact->bearing_modulus *= factor;
                    scene.joints[j].contact->journal_modulus *= factor;
                  }});
  list.push_back({"the restitution of " + joint.name,
                  [j](Scene& scene, double factor) { scene.joints[j].contact->restitution *= factor; }});
}

void add_body_numbers(std::vector<SceneNumber>& list, const SceneBody& body, std::size_t b) {
  list.push_back({"the mass of " + body.name, [b](Scene& scene, double factor) { scene.bodies[b].mass *= factor; }});
  list.push_back(
      {"the inertia of " + body.name, [b](Scene& scene, double factor) { scene.bodies[b].inertia *= factor; }});
  if (body.spin != 0) {
    list.push_back(
        {"the first spin of " + body.name, [b](Scene& scene, double factor) { scene.bodies[b].spin *= factor; }});
  }
}

void add_joint_changes(std::vector<SceneVariant>& list, const Scene& whole, std::size_t j) {
  const SceneJoint& joint = whole.joints[j];
  list.push_back({"bearing and journal of " + joint.name + " were exchanged",
                  [j](Scene& scene) { std::swap(scene.joints[j].bearing, scene.joints[j].journal); }});
  list.push_back({"the journal's diameter of " + joint.name + " were its radius",
                  [j](Scene& scene) { scene.joints[j].journal_radius *= 2; }});
  list.push_back({"the clearance of " + joint.name + " were diametral, and had been halved",
                  [j](Scene& scene) { scene.joints[j].clearance /= 2; }});
  list.push_back(
      {"the clearance of " + joint.name + " had been doubled", [j](Scene& scene) { scene.joints[j].clearance *= 2; }});
  if (joint.film == no_film) return;
  for (const std::string_view law : names_of_laws<StateFilmLaws>) {
    if (law == joint.film) continue;
    list.push_back({"the law of " + joint.name + " were " + std::string(law),
                    [j, law](Scene& scene) { scene.joints[j].film = law; }});
  }
}

bool is_driver(const SceneConstraint& constraint) {
  return std::holds_alternative<Driver<double>>(constraint.constraint);
}

}  // namespace

std::vector<SceneNumber> numbers_of(const Scene& scene) {
  std::vector<SceneNumber> list;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) add_joint_numbers(list, scene.joints[j], j);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) add_body_numbers(list, scene.bodies[b], b);
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
    if (!is_driver(scene.constraints[c])) continue;
    if (std::get<Driver<double>>(scene.constraints[c].constraint).speed == 0) continue;  // a factor would do nothing
    list.push_back({"the speed of " + scene.constraints[c].name, [c](Scene& changed, double factor) {
                      std::get<Driver<double>>(changed.constraints[c].constraint).speed *= factor;
                    }});
  }
  if (!is_zero(scene.gravity)) {
    list.push_back({"gravity", [](Scene& changed, double factor) { changed.gravity *= factor; }});
  }
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    list.push_back({"the load on " + scene.bodies[scene.loads[l].body].name, [l](Scene& changed, double factor) {
                      SceneLoad& load = changed.loads[l];
                      load.force *= factor;
                      load.moment *= factor;
                      if (load.unbalance) load.unbalance->mass_radius *= factor;
                      if (load.table) {
                        load.table->curves = std::make_shared<const TableCurves<3>>(load.table->curves->scaled(factor));
                      }
                    }});
  }
  return list;
}

std::vector<SceneVariant> changes_of(const Scene& scene) {
  std::vector<SceneVariant> list;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) add_joint_changes(list, scene, j);
  if (!is_zero(scene.gravity)) {
    list.push_back({"there were no gravity", [](Scene& changed) { changed.gravity = {0, 0}; }});
    list.push_back({"gravity acted the other way", [](Scene& changed) { changed.gravity = -changed.gravity; }});
  }
  if (!scene.loads.empty()) list.push_back({"there were no load", [](Scene& changed) { changed.loads.clear(); }});
  list.push_back({"the start were at rest", [](Scene& changed) {
                    for (SceneBody& body : changed.bodies) {
                      body.velocity = {0, 0};
                      body.spin = 0;
                    }
                  }});
  list.push_back({"everything turned the other way", [](Scene& changed) {
                    for (SceneBody& body : changed.bodies) body.spin = -body.spin;
                    for (SceneConstraint& constraint : changed.constraints) {
                      if (!is_driver(constraint)) continue;
                      auto& driver = std::get<Driver<double>>(constraint.constraint);
                      driver.speed = -driver.speed;
                      driver.acceleration = -driver.acceleration;
                    }
                  }});
  return list;
}

}  // namespace lubjoint::verify
