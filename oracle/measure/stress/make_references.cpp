#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>
#include <set>

#include "oracle/files/parallel.hpp"
#include "oracle/measure/stress/reference_crank.hpp"
#include "oracle/measure/stress/reference_journal.hpp"
#include "oracle/measure/stress/stress_references.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using namespace stress_reference;
using Long = long double;

/// Of a step, over its scale: the stored motion's, and that of the one that it is compared with.
template <class R>
struct ReferenceTolerance;
template <>
struct ReferenceTolerance<Long> {
  static constexpr double stored = 1e-14;
  static constexpr double compared = 1e-13;
};
/// For motions that 64 bits do not do: a motion that amplifies a million times is known to 1e-14 still.
template <>
struct ReferenceTolerance<Quad> {
  static constexpr double stored = 1e-20;
  static constexpr double compared = 1e-19;
};
/// Of disturbed motions, whose differences are read to 1e-4 of a disturbance of 1e-4.
constexpr double disturbed_tolerance = 1e-10;
/// Share of its scale by which a state is moved to see what becomes of it: its square is below what growth is read to.
constexpr double disturbance = 1e-4;

struct Sample {
  Eigen::Vector4d state;  ///< ê and its rate
  Eigen::Vector2d force;
};

/// A motion by one method, and where it could not go on.
struct Run {
  std::vector<Sample> samples;
  std::string why_ended;
};

std::vector<double> output_times(const Scene& scene) {
  std::vector<double> times;
  for (int k = 1; static_cast<double>(k) * scene.run.output_interval < scene.run.duration * (1 - 1e-12); ++k) {
    times.push_back(static_cast<double>(k) * scene.run.output_interval);
  }
  times.push_back(scene.run.duration);
  return times;
}

/// Growth of disturbances and the forces' sensitivity, from disturbed motions over each output interval.
/// @param on  on(i, component, share): the state at output i + 1 of the motion that is moved at output i, in the scales
template <class On>
void add_growth(StressReference& reference, const On& on) {
  // Growth to output i is that of the product of the intervals' matrices from any earlier output on.
  std::vector<Eigen::Matrix4d> since;
  for (std::size_t i = 0; i < reference.rows.size(); ++i) {
    if (i > 0) {
      const Eigen::Matrix4d step = on(i - 1);
      since.push_back(Eigen::Matrix4d::Identity());
      for (Eigen::Matrix4d& each : since) each = step * each;
    }
    double growth = 1;
    for (const Eigen::Matrix4d& each : since) {
      const double norm = each.cwiseAbs().rowwise().sum().maxCoeff();
      growth = std::max(growth, std::isfinite(norm) ? norm : 1e99);
    }
    reference.rows[i].growth = growth;
  }
}

/// Keeps what two methods have, and judges whether they agree.
void compare(StressReference& reference, const std::vector<double>& times, const Run& stored, const Run& compared,
             double least_rate, double load) {
  const std::size_t common = std::min(stored.samples.size(), compared.samples.size());
  reference.rate_unit = least_rate;
  reference.force_unit = load;
  for (std::size_t i = 0; i < common; ++i) {
    reference.rate_unit = std::max(reference.rate_unit, stored.samples[i].state.tail<2>().norm());
    reference.force_unit = std::max(reference.force_unit, stored.samples[i].force.norm());
  }
  const double force_unit = reference.force_unit > 0 ? reference.force_unit : 1;
  for (std::size_t i = 0; i < common; ++i) {
    const Sample& a = stored.samples[i];
    const Sample& b = compared.samples[i];
    const std::array<double, 3> apart = {(a.state - b.state).head<2>().norm(),
                                         (a.state - b.state).tail<2>().norm() / reference.rate_unit,
                                         (a.force - b.force).norm() / force_unit};
    if (!(apart[0] <= poor_agreement)) {
      reference.why_none = fmt::format("the two methods are {:.0e} clearances apart at {:.3g} s", apart[0], times[i]);
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) reference.apart[k] = std::max(reference.apart[k], apart[k]);
    reference.rows.push_back(
        {times[i], {a.state(0), a.state(1)}, {a.state(2), a.state(3)}, {a.force(0), a.force(1)}, 1, 0});
  }
  if (common < times.size()) {
    reference.why_none = stored.samples.size() == common ? stored.why_ended : compared.why_ended;
  }
}

// The journal.

JournalNumbers numbers_of(const Scene& scene) {
  const SceneBody& body = scene.bodies.front();
  const SceneJoint& joint = scene.joints.front();
  JournalNumbers n{joint.film,
                   joint.length,
                   joint.journal_radius,
                   joint.clearance,
                   joint.viscosity,
                   body.mass,
                   body.inertia,
                   {0, 0},
                   {scene.gravity.x(), scene.gravity.y()},
                   {body.position.x() - joint.bearing.point.x(), body.position.y() - joint.bearing.point.y()},
                   {body.velocity.x(), body.velocity.y()},
                   body.spin,
                   0,
                   {}};
  for (const SceneLoad& load : scene.loads) {
    n.load[0] += load.force.x();
    n.load[1] += load.force.y();
  }
  for (const SceneConstraint& each : scene.constraints) {
    const auto* motor = std::get_if<Driver<double>>(&each.constraint);
    if (!motor) throw std::invalid_argument(scene.name + ": a journal's reference has no constraint but a motor");
    n.spin = motor->speed;
    n.spin_rate = motor->acceleration;
  }
  if (joint.contact) {
    if (!joint.transition) throw std::invalid_argument(scene.name + ": a reference's contact has a transition");
    const SceneContact& c = *joint.contact;
    n.contact = ContactNumbers{c.bearing_modulus,    c.bearing_poisson,   c.journal_modulus, c.journal_poisson,
                               c.restitution,        c.friction,          c.slow_sliding,    c.min_impact_speed,
                               joint.transition->e0, joint.transition->e1};
  }
  return n;
}

/// Rates that the journal's drive makes [1/s]: the mean spin, or that at which the load moves it, be it the film or
/// inertia that holds it back.
template <class R>
double drive_rate(const JournalNumbers& n, const JournalForces<R>& forces, double duration) {
  const double load = static_cast<double>(forces.load.norm());
  const double spin = std::max(std::abs(n.spin), std::abs(n.spin + n.spin_rate * duration)) / 2;
  return std::max(
      spin, std::min(load / static_cast<double>(forces.scale), std::sqrt(load / static_cast<double>(forces.inertia))));
}

/// A motion at its output times, or to where it can't go on.
template <class Motion, class At>
Run run_of(Motion& motion, At now, const std::vector<double>& times, std::vector<At>* kept) {
  Run run;
  try {
    for (const double t : times) {
      motion.to(now, t);
      run.samples.push_back({motion.plane(now).template cast<double>(), motion.force(now).template cast<double>()});
      if (kept) kept->push_back(now);
    }
  } catch (const std::exception& error) {
    run.why_ended =
        fmt::format("{} beyond {:.3g} s", error.what(), run.samples.empty() ? 0.0 : times[run.samples.size() - 1]);
  }
  return run;
}

/// Growth of disturbances and the forces' sensitivity, of a motion whose states at the output times are kept.
/// @param another  another() makes a motion for a disturbed one
template <class At, class Motion, class Another>
void add_sensitivity(StressReference& reference, const std::vector<double>& times, const std::vector<At>& kept,
                     const Motion& motion, const Another& another) {
  const double unit = reference.rate_unit;
  const auto scaled = [unit](Eigen::Vector4d v) {
    v.tail<2>() /= unit;
    return v;
  };
  const auto both_ways = [&](std::size_t i, int component, const auto& what) {
    return what(motion.moved(kept[i], component, disturbance), motion.moved(kept[i], component, -disturbance));
  };
  // Columns: what a disturbance by its scale changes; divided by what the disturbance itself is in ê and ê̇/V.
  const auto directions = [&](std::size_t i) {
    Eigen::Matrix4d d;
    for (int k = 0; k < 4; ++k) {
      d.col(k) = both_ways(i, k, [&](const At& up, const At& down) {
        return scaled((motion.plane(up) - motion.plane(down)).template cast<double>());
      });
    }
    return d;
  };
  for (std::size_t i = 0; i < reference.rows.size(); ++i) {
    Eigen::Matrix<double, 2, 4> change;
    for (int k = 0; k < 4; ++k) {
      change.col(k) = both_ways(i, k, [&](const At& up, const At& down) {
        return Eigen::Vector2d((motion.force(up) - motion.force(down)).template cast<double>());
      });
    }
    const double gain =
        (change * directions(i).inverse()).norm() / (reference.force_unit > 0 ? reference.force_unit : 1);
    reference.rows[i].force_gain = std::isfinite(gain) ? gain : 1e99;
  }
  add_growth(reference, [&](std::size_t i) -> Eigen::Matrix4d {
    Eigen::Matrix4d moved = Eigen::Matrix4d::Constant(std::nan(""));
    try {
      for (int k = 0; k < 4; ++k) {
        moved.col(k) = both_ways(i, k, [&](At up, At down) {
          auto on = another();
          on.to(up, times[i + 1]);
          on.to(down, times[i + 1]);
          return scaled((on.plane(up) - on.plane(down)).template cast<double>());
        });
      }
    } catch (const std::exception&) {  // beyond where the motion is known, growth is without bound
      return moved;
    }
    return moved * directions(i).inverse();
  });
}

template <class R, template <class> class Method>
Run journal_run(const JournalNumbers& n, const JournalForces<R>& forces, double rate, double tolerance,
                const std::vector<double>& times, std::vector<Situation<R>>* kept) {
  JournalMotionBy<R, Method> motion(forces, R(rate), R(tolerance), R(times.back()));
  return run_of(motion, motion.start(n), times, kept);
}

template <class R>
StressReference journal_reference(const Scene& scene, StressReference reference) {
  const JournalNumbers n = numbers_of(scene);
  const JournalForces<R> forces(n);
  const std::vector<double> times = output_times(scene);
  const double driven = drive_rate(n, forces, scene.run.duration);
  double rate = std::max(driven, std::hypot(n.velocity[0], n.velocity[1]) / n.clearance);
  if (rate == 0) rate = 1;
  std::vector<Situation<R>> kept;
  const Run stored = journal_run<R, Collocation>(n, forces, rate, ReferenceTolerance<R>::stored, times, &kept);
  const Run compared = journal_run<R, Extrapolation>(n, forces, rate, ReferenceTolerance<R>::compared, times, nullptr);
  compare(reference, times, stored, compared, driven > 0 ? driven : 1, static_cast<double>(forces.load.norm()));
  add_sensitivity(reference, times, kept,
                  JournalMotionBy<R, Collocation>(forces, rate, ReferenceTolerance<R>::stored, times.back()),
                  [&] { return JournalMotionBy<R, Collocation>(forces, rate, disturbed_tolerance, times.back()); });
  return reference;
}

// The slider-crank.

template <class R, template <class> class Method>
Run crank_run(const CrankMechanics<R>& mechanics, const JournalForces<R>& forces, double tolerance,
              const std::vector<double>& times, std::vector<CrankSituation<R>>* kept) {
  CrankMotionBy<R, Method> motion(mechanics, forces, R(tolerance), R(times.back()));
  return run_of(motion, motion.start(), times, kept);
}

template <class R>
StressReference crank_reference(const Scene& scene, StressReference reference) {
  const SceneJoint& joint = scene.joints.front();
  const bool on_rod = !joint.bearing.on_ground() && scene.bodies[joint.bearing.body].name == "rod";
  const double speed = crank_speed_of(scene);
  const CrankMechanics<R> mechanics({mechanism_of<R>(scene), R(speed), R(joint.clearance), on_rod});
  JournalNumbers film;
  film.law = joint.film;
  film.length = joint.length;
  film.journal_radius = joint.journal_radius;
  film.clearance = joint.clearance;
  film.viscosity = joint.viscosity;
  const JournalForces<R> forces(film);
  const std::vector<double> times = output_times(scene);
  std::vector<CrankSituation<R>> kept;
  const Run stored = crank_run<R, Collocation>(mechanics, forces, ReferenceTolerance<R>::stored, times, &kept);
  const Run compared = crank_run<R, Extrapolation>(mechanics, forces, ReferenceTolerance<R>::compared, times, nullptr);
  compare(reference, times, stored, compared, speed, 0);
  add_sensitivity(reference, times, kept,
                  CrankMotionBy<R, Collocation>(mechanics, forces, ReferenceTolerance<R>::stored, times.back()),
                  [&] { return CrankMotionBy<R, Collocation>(mechanics, forces, disturbed_tolerance, times.back()); });
  return reference;
}

}  // namespace

namespace {

template <class R>
StressReference reference_in(const Scene& scene) {
  StressReference reference;
  reference.scenario = scene.name;
  reference.law = scene.joints.front().film;
  reference.key = motion_key(scene);
  reference.methods = fmt::format(
      "collocation at 7 Radau points against extrapolated linearly implicit Euler steps, {}-bit significands; ",
      std::numeric_limits<R>::digits);
  if (scene.bodies.size() == 1) {
    reference.methods += "the journal piece by piece, its published force law written anew, polar near the wall";
    return journal_reference<R>(scene, std::move(reference));
  }
  reference.methods += "minimal coordinates piece by piece, published force law written anew";
  return crank_reference<R>(scene, std::move(reference));
}

}  // namespace

StressReference make_stress_reference(const Scene& scene) {
  StressReference made = reference_in<Long>(scene);
  if (made.whole()) return made;
  // A thin film's force is the difference of large terms, and some motions amplify a million times.
  StressReference longer = reference_in<Quad>(scene);
  return longer.whole() || longer.rows.size() > made.rows.size() ? longer : made;
}

void make_stress_references(const std::vector<StressCase>& cases, const std::vector<std::string>& laws,
                            const std::filesystem::path& folder, unsigned threads) {
  StressReferences references;
  if (std::filesystem::exists(folder / reference_table_name)) references = StressReferences::read(folder);
  std::vector<Scene> missing;
  std::set<std::string> listed;
  for (const StressCase& each : cases) {
    for (const std::string& law : laws) {
      Scene scene = each.scene;
      scene.joints.front().film = law;
      const std::string key = motion_key(scene);
      const StressReference* known = references.find(key);
      if ((!known || !known->whole()) && listed.insert(key).second) missing.push_back(scene);
    }
  }
  std::mutex mutex;
  run_parallel(missing.size(), threads, [&](std::size_t i) {
    const StressReference made = make_stress_reference(missing[i]);
    const std::lock_guard lock(mutex);
    std::cerr << fmt::format("{}, {}: {} rows, places {:.0e} apart, rates {:.0e}, forces {:.0e}{}{}\n", made.scenario,
                             made.law, made.rows.size(), made.apart[0], made.apart[1], made.apart[2],
                             made.why_none.empty() ? "" : "; ", made.why_none);
    const StressReference* known = references.find(made.key);
    if (known && !made.whole() && made.rows.size() <= known->rows.size()) return;
    references.add(made);
    references.write(folder);
  });
}

}  // namespace lubjoint::reports
