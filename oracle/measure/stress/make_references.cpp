#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>
#include <set>

#include "lubjoint/film/law_list.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/measure/stress/reference_journal.hpp"
#include "oracle/measure/stress/stress_references.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using namespace stress_reference;
using Long = long double;

/// Of a step, over its scale. The stored motion's, and that of the one that it is compared with.
constexpr double stored_tolerance = 1e-14;
constexpr double compared_tolerance = 1e-13;
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
double drive_rate(const JournalNumbers& n, const JournalForces<Long>& forces, double duration) {
  const double load = static_cast<double>(forces.load.norm());
  const double spin = std::max(std::abs(n.spin), std::abs(n.spin + n.spin_rate * duration)) / 2;
  return std::max(
      spin, std::min(load / static_cast<double>(forces.scale), std::sqrt(load / static_cast<double>(forces.inertia))));
}

template <class Motion>
Sample sample_of(const Motion& motion, const Situation<Long>& s) {
  return {s.plane().template cast<double>(), motion.force(s).template cast<double>()};
}

template <template <class> class Method>
Run journal_run(const JournalNumbers& n, const JournalForces<Long>& forces, double rate, double tolerance,
                const std::vector<double>& times, std::vector<Situation<Long>>* kept) {
  JournalMotionBy<Long, Method> motion(forces, rate, tolerance, times.back());
  Run run;
  try {
    Situation<Long> now = motion.start(n);
    for (const double t : times) {
      motion.to(now, t);
      run.samples.push_back(sample_of(motion, now));
      if (kept) kept->push_back(now);
    }
  } catch (const std::exception& error) {
    run.why_ended =
        fmt::format("{} beyond {:.3g} s", error.what(), run.samples.empty() ? 0.0 : times[run.samples.size() - 1]);
  }
  return run;
}

StressReference journal_reference(const Scene& scene, StressReference reference) {
  const JournalNumbers n = numbers_of(scene);
  const JournalForces<Long> forces(n);
  const std::vector<double> times = output_times(scene);
  const double driven = drive_rate(n, forces, scene.run.duration);
  double rate = std::max(driven, std::hypot(n.velocity[0], n.velocity[1]) / n.clearance);
  if (rate == 0) rate = 1;
  std::vector<Situation<Long>> kept;
  const Run stored = journal_run<Collocation>(n, forces, rate, stored_tolerance, times, &kept);
  const Run compared = journal_run<Extrapolation>(n, forces, rate, compared_tolerance, times, nullptr);
  compare(reference, times, stored, compared, driven > 0 ? driven : 1, static_cast<double>(forces.load.norm()));
  JournalMotionBy<Long, Collocation> motion(forces, rate, stored_tolerance, times.back());
  const double unit = reference.rate_unit;
  const auto scaled = [unit](Eigen::Vector4d v) {
    v.tail<2>() /= unit;
    return v;
  };
  const auto both_ways = [&](std::size_t i, int component, const auto& what) {
    const Situation<Long> up = motion.moved(kept[i], component, disturbance);
    const Situation<Long> down = motion.moved(kept[i], component, -disturbance);
    return what(up, down);
  };
  // Columns: what a disturbance by its scale changes; divided by what the disturbance itself is in ê and ê̇/V.
  const auto directions = [&](std::size_t i) {
    Eigen::Matrix4d d;
    for (int k = 0; k < 4; ++k) {
      d.col(k) = both_ways(i, k, [&](const auto& up, const auto& down) {
        return scaled((up.plane() - down.plane()).template cast<double>());
      });
    }
    return d;
  };
  for (std::size_t i = 0; i < reference.rows.size(); ++i) {
    Eigen::Matrix<double, 2, 4> change;
    for (int k = 0; k < 4; ++k) {
      change.col(k) = both_ways(i, k, [&](const auto& up, const auto& down) {
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
        moved.col(k) = both_ways(i, k, [&](auto up, auto down) {
          JournalMotionBy<Long, Collocation> on(forces, rate, 1e-10, times.back());
          on.to(up, times[i + 1]);
          on.to(down, times[i + 1]);
          return scaled((up.plane() - down.plane()).template cast<double>());
        });
      }
    } catch (const std::exception&) {  // beyond where the motion is known, growth is without bound
      return moved;
    }
    return moved * directions(i).inverse();
  });
  return reference;
}

// The slider-crank.

/// Minimal coordinates as the methods want them.
template <FilmLaw Law>
struct CrankSystem {
  using Scalar = Long;
  static constexpr int size = 4;
  using State = Eigen::Matrix<Long, 4, 1>;
  mechanisms::LubricatedSliderCrank<Law, Long> mechanism;

  static mechanisms::DeviationState<Long> deviation(const State& y) { return {y(0), y(1), y(2), y(3)}; }
  State rate(const Long& t, const State& y) const {
    mechanisms::DeviationState<Long> d;
    mechanism.rate(deviation(y), d, t);
    return State(d[0], d[1], d[2], d[3]);
  }
  State scale(const State&) const { return State::Ones(); }
  static Long noise() { return 1000 * std::numeric_limits<Long>::epsilon(); }
  std::array<Long, 2> margins(const Long& t, const State& y) const {
    std::array<Long, 2> m = {1, 1};
    if (Law::name != std::string_view("pinkus_sternlicht")) return m;
    // Its kink: either of these two turns negative where ε̇ changes sign, and then the other counts.
    const auto pin = mechanism.pin(t, deviation(y));
    const Long squeeze = dot(pin.eccentricity, pin.velocity) / speed;
    m = {squeeze, -squeeze};
    return m;
  }
  Long speed;
};

template <FilmLaw Law, template <class> class Method>
Run crank_run(const CrankSystem<Law>& system, double tolerance, const std::vector<double>& times,
              std::vector<Eigen::Matrix<Long, 4, 1>>* kept) {
  Run run;
  Eigen::Matrix<Long, 4, 1> y = Eigen::Matrix<Long, 4, 1>::Zero();
  Long t = 0;
  Long step = times.back() * 1e-9L;
  try {
    for (const double goal : times) {
      while (t < goal) {
        Piece<CrankSystem<Law>, Method> piece(system, tolerance, step);
        piece.to(t, y, goal);
        step = piece.step();
      }
      const auto pin = system.mechanism.pin(t, system.deviation(y));
      Sample sample;
      sample.state << static_cast<double>(pin.eccentricity.x()), static_cast<double>(pin.eccentricity.y()),
          static_cast<double>(pin.velocity.x()), static_cast<double>(pin.velocity.y());
      sample.force << static_cast<double>(pin.force.x()), static_cast<double>(pin.force.y());
      run.samples.push_back(sample);
      if (kept) kept->push_back(y);
    }
  } catch (const std::exception& error) {
    run.why_ended =
        fmt::format("{} beyond {:.3g} s", error.what(), run.samples.empty() ? 0.0 : times[run.samples.size() - 1]);
  }
  return run;
}

template <FilmLaw Law>
StressReference crank_reference(const Scene& scene, StressReference reference) {
  const double speed = crank_speed_of(scene);
  const CrankSystem<Law> system{lubricated_slider_crank<Law, Long>(scene), speed};
  const std::vector<double> times = output_times(scene);
  std::vector<Eigen::Matrix<Long, 4, 1>> kept;
  // ê is a difference of lengths of the mechanism's size: what rounding leaves of it is no tolerance.
  const double rounding = 50 * static_cast<double>(std::numeric_limits<Long>::epsilon()) *
                          static_cast<double>(mechanism_of<Long>(scene).rod_length) / scene.joints.front().clearance;
  const Run stored = crank_run<Law, Collocation>(system, std::max(stored_tolerance, rounding), times, &kept);
  const Run compared = crank_run<Law, Extrapolation>(system, std::max(compared_tolerance, rounding), times, nullptr);
  compare(reference, times, stored, compared, speed, 0);
  const double unit = reference.rate_unit;
  const auto seen = [&](double t, const Eigen::Matrix<Long, 4, 1>& y) {
    const auto pin = system.mechanism.pin(t, system.deviation(y));
    Eigen::Matrix<Long, 6, 1> all;
    all << pin.eccentricity.x(), pin.eccentricity.y(), pin.velocity.x() / unit, pin.velocity.y() / unit,
        pin.force.x() / reference.force_unit, pin.force.y() / reference.force_unit;
    return all;
  };
  const auto moved = [&](std::size_t i, int k, double sign) {
    Eigen::Matrix<Long, 4, 1> y = kept[i];
    const Long gap = 1 - seen(times[i], y).template head<2>().norm();
    y(k) += sign * disturbance * gap;
    return y;
  };
  const auto directions = [&](std::size_t i) {
    Eigen::Matrix<double, 6, 4> d;
    for (int k = 0; k < 4; ++k) {
      d.col(k) = (seen(times[i], moved(i, k, 1)) - seen(times[i], moved(i, k, -1))).template cast<double>();
    }
    return d;
  };
  for (std::size_t i = 0; i < reference.rows.size(); ++i) {
    const Eigen::Matrix<double, 6, 4> d = directions(i);
    const double gain = (d.bottomRows<2>() * d.topRows<4>().inverse()).norm();
    reference.rows[i].force_gain = std::isfinite(gain) ? gain : 1e99;
  }
  add_growth(reference, [&](std::size_t i) -> Eigen::Matrix4d {
    Eigen::Matrix4d after = Eigen::Matrix4d::Constant(std::nan(""));
    try {
      for (int k = 0; k < 4; ++k) {
        std::array<Eigen::Matrix<Long, 6, 1>, 2> ends;
        for (const int way : {0, 1}) {
          Eigen::Matrix<Long, 4, 1> y = moved(i, k, way ? -1 : 1);
          Long t = times[i];
          Long step = (times[i + 1] - times[i]) * 1e-6L;
          while (t < times[i + 1]) {
            Piece<CrankSystem<Law>, Collocation> piece(system, 1e-10L, step);
            piece.to(t, y, times[i + 1]);
            step = piece.step();
          }
          ends[static_cast<std::size_t>(way)] = seen(times[i + 1], y);
        }
        after.col(k) = (ends[0] - ends[1]).template head<4>().template cast<double>();
      }
    } catch (const std::exception&) {
      return after;
    }
    const Eigen::Matrix<double, 6, 4> d = directions(i);
    return after * d.topRows<4>().inverse();
  });
  return reference;
}

}  // namespace

StressReference make_stress_reference(const Scene& scene) {
  StressReference reference;
  reference.scenario = scene.name;
  reference.law = scene.joints.front().film;
  reference.key = motion_key(scene);
  reference.methods =
      "collocation at 7 Radau points against extrapolated linearly implicit Euler steps, 64-bit significands; ";
  if (scene.bodies.size() == 1) {
    reference.methods += "the journal piece by piece, its published force law written anew, polar near the wall";
    return journal_reference(scene, std::move(reference));
  }
  reference.methods += "minimal coordinates";
  return with_film_law(reference.law, [&]<class Law>() -> StressReference {
    if constexpr (PolarLaw<Law>) {
      reference.why_none = "a half film between moving bodies slides on its jump: minimal coordinates do not have that";
      return reference;
    } else {
      return crank_reference<Law>(scene, reference);
    }
  });
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
      if (!references.find(key) && listed.insert(key).second) missing.push_back(scene);
    }
  }
  std::mutex mutex;
  run_parallel(missing.size(), threads, [&](std::size_t i) {
    const StressReference made = make_stress_reference(missing[i]);
    const std::lock_guard lock(mutex);
    std::cerr << fmt::format("{}, {}: {} rows, places {:.0e} apart, rates {:.0e}, forces {:.0e}{}{}\n", made.scenario,
                             made.law, made.rows.size(), made.apart[0], made.apart[1], made.apart[2],
                             made.why_none.empty() ? "" : "; ", made.why_none);
    references.add(made);
    references.write(folder);
  });
}

}  // namespace lubjoint::reports
