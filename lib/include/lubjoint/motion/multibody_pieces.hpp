/// The pieces of a multibody system's equations: phases of contact, and the sides of half films.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "lubjoint/motion/contact_events.hpp"
#include "lubjoint/motion/film_sides.hpp"
#include "lubjoint/motion/planar_film_bodies.hpp"
#include "lubjoint/motion/watched_angles.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// How a run keeps its constraints: by the accelerations alone (Baumgarte's terms are part of the system), or by
/// projection of every accepted step.
enum class ConstraintUpkeep { by_accelerations, by_projection };

/// A joint's memory from a time on.
template <class R>
struct MemoryChange {
  R t;                    ///< [s]
  std::size_t joint;      ///< its number
  JointMemory<R> memory;  ///< from then on
};

/// A multibody system as a run sees it. Each joint that may touch, or whose half film jumps, has a piece of its own:
/// film, blend or dry, and the side of its film or sliding. Joints change one at a time, in the order of their events.
template <class R>
class MultibodyPieces {
 public:
  using Real = R;                                          ///< scalar
  using State = std::vector<R>;                            ///< (q, q̇, work)
  static constexpr std::size_t dimension = run_time_size;  ///< known when the program runs
  static constexpr bool has_events = true;                 ///< or a projection
  static constexpr std::size_t looks_each = 2;             ///< a journal may touch and leave within a short time

  /// @param tolerance  within which a journal that slides is kept on its line, in clearances
  MultibodyPieces(MultibodyOde<R>& ode, ConstraintUpkeep upkeep, const R& tolerance)
      : ode_(ode),
        upkeep_(upkeep),
        tolerance_(tolerance),
        sides_(PlanarFilmBodies<R>(ode)),
        knots_(PlanarAngles<R>(ode.system()), ode.table_pieces()) {
    const std::vector<JointElement<R>>& joints = ode.system().joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (joints[j].has_contact() || joints[j].has_half_film()) watched_.push_back(j);
    }
  }

  /// The pieces that a start is in.
  void start(const R& t, const State& y) {
    for (const std::size_t j : watched_) {
      const JointElement<R>& joint = ode_.system().joints()[j];
      const JournalMotion<R> motion = motion_of(t, y, j);
      ode_.memory()[j] = detail::starting_memory(joint, motion);
    }
    sides_.start(t, y);
    for (const std::size_t j : watched_) changes_.push_back({t, j, ode_.memory()[j]});
    knots_.start(t, y);
  }

  /// Slides that last to the end of the run end with it.
  void finish(const R& t) { sides_.finish(t); }

  const std::vector<ContactEvent>& events() const { return events_; }        ///< of contact, in order
  const std::vector<JointSlide>& slides() const { return sides_.slides(); }  ///< of half films, as they ended
  const std::vector<MemoryChange<R>>& changes() const { return changes_; }   ///< of any memory, the start first
  std::size_t changes_after_start() const { return changes_.size() - watched_.size(); }  ///< events of any kind

  /// The joint of a margin.
  const JointElement<R>& joint_of(std::size_t margin) const {
    return ode_.system().joints()[watched_[margin / margins_each]];
  }
  /// Is a margin the distance to a knot of a table?
  bool is_of_knot(std::size_t margin) const { return margin >= margins_each * watched_.size(); }
  /// Is a margin one of contact, and not of a half film?
  static bool is_of_contact(std::size_t margin) { return margin % margins_each < 2; }

  // What a run asks for (EventSystem).

  bool watches() const { return !watched_.empty() || !knots_.empty(); }    ///< has any joint or table pieces?
  OdeSystem<R, run_time_size>& equations() { return ode_; }                ///< of the present pieces
  std::size_t coordinates() const { return ode_.system().coordinates(); }  ///< number of q
  /// Every number is finite; films are looked at where forces are asked for.
  bool admissible(const R&, const State& y) const {
    return std::all_of(y.begin(), y.end(), [](const R& v) { return std::isfinite(static_cast<double>(v)); });
  }

  /// Of each joint with pieces: the inner and the outer seam of its contact, and what ends the side of its film: a = 0,
  /// or, of one that slides, both ends of the jump. Then the distances to the knots of tables over angles.
  void margins(const R& t, const State& y, std::vector<Margin<R>>& list) {
    list.clear();
    if (!watched_.empty()) add_joint_margins(t, y, list);
    knots_.add_margins(t, y, list);
  }

  /// Those of joints.
  void add_joint_margins(const R& t, const State& y, std::vector<Margin<R>>& list) {
    if (sides_.any_slides()) {
      ode_.at(t, y);
    } else {
      ode_.system().evaluate_kinematics(t, y.data(), ode_.workspace());
    }
    for (const std::size_t j : watched_) {
      const JointElement<R>& joint = ode_.system().joints()[j];
      const JournalMotion<R> motion = ode_.system().journal_motion(j, ode_.workspace());
      const Margin<R> far{R(1), R(0)};
      if (joint.has_contact()) {
        const detail::SeamMargins<R> m = detail::seam_margins(joint, ode_.memory()[j].phase, motion.eccentricity);
        list.push_back({m.inner, seam_rounding()});
        list.push_back({m.outer, seam_rounding()});
      } else {
        list.insert(list.end(), 2, far);
      }
      sides_.add_margins(j, far, list);
    }
  }

  /// Constraints by projection, where that is their upkeep; journals that slide onto their lines.
  bool hold(const R& t, State& y, bool exactly) {
    if (!exactly) sides_.note_parted(t, y);
    const bool projects = upkeep_ == ConstraintUpkeep::by_projection && project(t, y);
    if (!sides_.any_slides()) return projects;
    const R allowed = exactly ? R(0) : tolerance_;
    const bool moved = project_onto_slides(ode_.system(), t, y, ode_.memory(), allowed, ode_.workspace());
    return projects || moved;
  }

  /// The joint of that margin changes its piece, or a table goes on to its next interval.
  AfterEvent cross(std::size_t margin, const R& t, const State& y) {
    if (is_of_knot(margin)) {
      knots_.cross(margin - margins_each * watched_.size());
      return AfterEvent::keep_pace;
    }
    const std::size_t j = watched_[margin / margins_each];
    switch (margin % margins_each) {
      case 0:
        change_phase(t, y, j, false);
        break;
      case 1:
        change_phase(t, y, j, true);
        break;
      default:
        sides_.cross(margin % margins_each == 3, t, y, j);
    }
    changes_.push_back({t, j, ode_.memory()[j]});
    return AfterEvent::go_on;
  }

 private:
  /// Onto the constraints, but where they are not independent: the next step ends elsewhere.
  bool project(const R& t, State& y) {
    projected_ = y;
    try {
      project_onto_constraints(ode_.system(), t, projected_, ode_.workspace());
    } catch (const SingularConstraints&) {
      return false;
    }
    y.swap(projected_);
    return true;
  }

  static constexpr std::size_t margins_each = 4;

  static R epsilon() { return std::numeric_limits<R>::epsilon(); }

  /// Seams are places in clearances; coordinates may be a thousand clearances long.
  static R seam_rounding() { return R(1e-12) * (epsilon() / R(std::numeric_limits<double>::epsilon())); }

  JournalMotion<R> motion_of(const R& t, const State& y, std::size_t j) {
    ode_.system().evaluate_kinematics(t, y.data(), ode_.workspace());
    return ode_.system().journal_motion(j, ode_.workspace());
  }

  void change_phase(const R& t, const State& y, std::size_t j, bool outwards) {
    const JointElement<R>& joint = ode_.system().joints()[j];
    JointMemory<R>& memory = ode_.memory()[j];
    const Vector2<R> before = ode_.at(t, y).joints[j].total();
    const R speed = detail::normal_speed(ode_.system().journal_motion(j, ode_.workspace()));
    ContactEvent event{static_cast<double>(t),
                       j,
                       memory.phase,
                       detail::next_phase(joint, memory.phase, outwards),
                       static_cast<double>(speed),
                       0,
                       0};
    detail::enter_phase(joint, memory, event.to, speed);
    if (joint.has_half_film()) {
      if (event.to == ContactPhase::dry) sides_.leave(t, j, FilmSide::of_slip);
      if (event.from == ContactPhase::dry) sides_.find(t, y, j);
    }
    const Vector2<R> after = ode_.at(t, y).joints[j].total();
    event.force_before = static_cast<double>(before.norm());
    event.force_jump = static_cast<double>((after - before).norm());
    events_.push_back(event);
  }

  MultibodyOde<R>& ode_;
  ConstraintUpkeep upkeep_;
  State projected_;  ///< a copy: a projection that fails leaves nothing behind
  R tolerance_;
  FilmSides<PlanarFilmBodies<R>> sides_;
  TableKnots<R, PlanarAngles<R>> knots_;
  std::vector<std::size_t> watched_;  ///< joints with pieces
  std::vector<ContactEvent> events_;
  std::vector<MemoryChange<R>> changes_;
};

}  // namespace lubjoint
