#include "oracle/measure/stress/stress_cases.hpp"

#include <functional>

#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint::reports {

namespace {

using Change = std::function<void(Scene&)>;

constexpr int samples = 50;

void set_duration(Scene& scene, double duration) {
  scene.run.duration = duration;
  scene.run.output_interval = duration / samples;
}

void set_tolerance(Scene& scene, double tolerance) {
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
}

/// Everything that moves, so many times faster, for so many times shorter.
void scale_speed(Scene& scene, double factor) {
  for (SceneBody& body : scene.bodies) {
    body.velocity *= factor;
    body.spin *= factor;
  }
  for (SceneConstraint& each : scene.constraints) {
    if (auto* driver = std::get_if<Driver<double>>(&each.constraint)) driver->speed *= factor;
  }
  set_duration(scene, scene.run.duration / factor);
}

/// Collects cases that differ from a base scene in what a change does to it.
class CaseList {
 public:
  explicit CaseList(std::vector<StressCase>& cases) : cases_(cases) {}

  void base(Scene scene, std::string prefix, double duration, std::size_t max_steps) {
    base_ = std::move(scene);
    prefix_ = std::move(prefix);
    set_duration(base_, duration);
    set_tolerance(base_, 1e-6);
    base_.run.max_steps = max_steps;
    base_.energy_ledger = false;
  }
  void add(const std::string& name, const std::string& what, const Change& change = {}) {
    StressCase made{prefix_ + "-" + name, what, base_};
    if (change) change(made.scene);
    made.scene.name = made.name;
    cases_.push_back(std::move(made));
  }

 private:
  std::vector<StressCase>& cases_;
  Scene base_;
  std::string prefix_;
};

/// Puts the journal at ε along x.
Change start_at(double epsilon) {
  return [epsilon](Scene& s) { s.bodies[0].position = {epsilon * s.joints[0].clearance, 0}; };
}

Change clearance(double c) {
  return [c](Scene& s) { s.joints[0].clearance = c; };
}

Change viscosity(double mu) {
  return [mu](Scene& s) { s.joints[0].viscosity = mu; };
}

Change tolerance(double tau) {
  return [tau](Scene& s) { set_tolerance(s, tau); };
}

Change load(double newtons) {
  return [newtons](Scene& s) { s.loads[0].force = {0, -newtons}; };
}

Change masses(double factor) {
  return [factor](Scene& s) {
    for (SceneBody& body : s.bodies) {
      body.mass *= factor;
      body.inertia *= factor;
    }
  };
}

Change impact_speed(double factor, double duration) {
  return [=](Scene& s) {
    s.bodies[0].velocity *= factor;
    set_duration(s, duration);
  };
}

void without_load(Scene& s) {
  s.loads.clear();
  s.gravity = {0, 0};
}

void add_journal_cases(CaseList& list) {
  list.add("start-centred", "e = 0, at rest: the direction of e is not defined");
  list.add("start-1e-300", "e = 1e-300 c: squares underflow", start_at(1e-300));
  list.add("start-1e-160", "e = 1e-160 c: squares are subnormal", start_at(1e-160));
  list.add("start-near-wall-1e-6", "1 - e/c = 1e-6", start_at(1 - 1e-6));
  list.add("start-near-wall-1e-12", "1 - e/c = 1e-12: four digits of the gap are left", start_at(1 - 1e-12));
  list.add("start-near-wall-outward", "1 - e/c = 1e-6, 1 m/s towards the wall", [](Scene& s) {
    start_at(1 - 1e-6)(s);
    s.bodies[0].velocity = {1, 0};
  });
  list.add("at-rest", "nothing moves: a = b = 0 at e = 0.3 c, for ever", [](Scene& s) {
    without_load(s);
    start_at(0.3)(s);
    s.bodies[0].spin = 0;
  });
  list.add("at-rest-centred", "nothing moves: a = b = 0 at e = 0, for ever", [](Scene& s) {
    without_load(s);
    s.bodies[0].spin = 0;
  });
  list.add("spin-without-load", "e = 0 is a rest, stable or not", without_load);
  list.add("pure-squeeze", "no spin, load along e: a = 0 throughout", [](Scene& s) {
    s.bodies[0].spin = 0;
    s.bodies[0].position = {0, -0.5 * s.joints[0].clearance};
  });
  list.add("pure-squeeze-from-centre", "no spin, e = 0: the load alone gives a direction",
           [](Scene& s) { s.bodies[0].spin = 0; });
  list.add("whirl-reversal", "whirl at twice the spin: a changes sign, and a half film its side", [](Scene& s) {
    start_at(0.5)(s);
    s.bodies[0].velocity = {0, 0.5 * s.joints[0].clearance * 2 * s.bodies[0].spin};
  });
  list.add("spin-negative", "the journal turns clockwise: half films on their other side", [](Scene& s) {
    start_at(0.5)(s);
    s.bodies[0].spin *= -1;
  });
  list.add("spin-reversal", "a motor turns the journal one way, then the other", [](Scene& s) {
    const double spin = s.bodies[0].spin;
    s.constraints.push_back({"motor", Driver<double>{ground_body, 0, 0, spin, -2 * spin / s.run.duration}});
    s.run.max_steps /= 4;
  });
  list.add("clearance-1um", "c = 1 um", clearance(1e-6));
  list.add("clearance-10um", "c = 10 um", clearance(1e-5));
  list.add("clearance-2mm", "c = 2 mm", clearance(2e-3));
  list.add("viscosity-1e-4", "0.1 mPa s: thin film under the load", viscosity(1e-4));
  list.add("viscosity-10", "10 Pa s", viscosity(10));
  list.add("speed-1rpm", "1 rpm: hardly a wedge", [](Scene& s) { s.bodies[0].spin /= 500; });
  list.add("speed-1e5rpm", "1e5 rpm", [](Scene& s) {
    s.bodies[0].spin *= 200;
    set_duration(s, 0.005);
  });
  list.add("mass-1e-6kg", "1 mg: velocity follows the film at once", [](Scene& s) { s.bodies[0].mass = 1e-6; });
  list.add("mass-1e3kg", "1 t: weight and inertia press on the film", [](Scene& s) { s.bodies[0].mass = 1e3; });
  list.add("load-1e4N", "thin film held by a large load: 10 kN", load(1e4));
  list.add("load-1e6N", "thin film held by a large load: 1 MN", load(1e6));
  list.add("load-1e9N", "1 GN: 1 - e/c at the rounding of e for some laws", load(1e9));
  list.add("load-1e13N", "10 TN: no film carries this in double precision", load(1e13));
  list.add("load-1e25N", "1e25 N: nor this", load(1e25));
  list.add("thrown-at-wall", "20 m/s in thin oil, steps of loose tolerance: trial steps beyond the wall", [](Scene& s) {
    s.bodies[0].velocity = {20, 1};
    s.joints[0].viscosity = 0.01;
    set_tolerance(s, 1e-3);
    set_duration(s, 0.01);
  });
  list.add("tolerance-1e-1", "tolerance far too loose", tolerance(1e-1));
  list.add("tolerance-1e-14", "tolerance far too tight", tolerance(1e-14));
  list.add("long-run", "100 s: an explicit method's steps are bound by stability",
           [](Scene& s) { set_duration(s, 100); });
  list.add("step-limit", "10 steps are allowed", [](Scene& s) { s.run.max_steps = 10; });
}

void add_impact_cases(CaseList& list) {
  list.add("as-shipped", "0.95 m/s against the wall: transition, contact, and back");
  list.add("fast", "19 m/s against the wall", impact_speed(20, 5e-4));
  list.add("slow", "10 mm/s: the film hardly yields", impact_speed(0.01, 0.02));
  list.add("inelastic", "restitution 0, friction 0.3", [](Scene& s) {
    s.joints[0].contact->restitution = 0;
    s.joints[0].contact->friction = 0.3;
    s.bodies[0].spin = 50;
  });
  list.add("viscosity-10", "10 Pa s: no contact is reached", viscosity(10));
  list.add("tolerance-1e-1", "tolerance far too loose", tolerance(1e-1));
  list.add("tolerance-1e-14", "tolerance far too tight", tolerance(1e-14));
  list.add("step-limit", "10 steps are allowed", [](Scene& s) { s.run.max_steps = 10; });
}

void add_slider_crank_cases(CaseList& list) {
  list.add("as-shipped", "half a revolution at 5000 rpm");
  list.add("clearance-1um", "c = 1 um", clearance(1e-6));
  list.add("clearance-2mm", "c = 2 mm", clearance(2e-3));
  list.add("viscosity-1e-4", "0.1 mPa s: the film collapses under the slider", viscosity(1e-4));
  list.add("viscosity-10", "10 Pa s", viscosity(10));
  list.add("speed-1e5rpm", "1e5 rpm: inertia forces 400 times larger", [](Scene& s) { scale_speed(s, 20); });
  list.add("masses-1e-5", "bodies of milligrams", masses(1e-5));
  list.add("masses-1e3", "bodies of hundreds of kilograms", masses(1e3));
  list.add("projection", "every step is projected onto the constraints",
           [](Scene& s) { s.stabilisation.projection = true; });
  list.add("tolerance-1e-1", "tolerance far too loose", tolerance(1e-1));
  list.add("tolerance-1e-14", "tolerance far too tight", tolerance(1e-14));
  list.add("step-limit", "10 steps are allowed", [](Scene& s) { s.run.max_steps = 10; });
}

}  // namespace

std::vector<StressCase> stress_cases(const std::filesystem::path& scenes) {
  std::vector<StressCase> cases;
  CaseList list(cases);
  // Step limits bound the time of a cell: stiff cases would keep an explicit method busy for days.
  list.base(load_scene(scenes / "journal.toml"), "journal", 0.1, 200'000);
  add_journal_cases(list);
  list.base(load_scene(scenes / "impact.toml"), "impact", 0.005, 50'000);
  add_impact_cases(list);
  list.base(load_scene(scenes / "slider-crank.toml"), "slider-crank", 0.006, 50'000);
  add_slider_crank_cases(list);
  return cases;
}

}  // namespace lubjoint::reports
