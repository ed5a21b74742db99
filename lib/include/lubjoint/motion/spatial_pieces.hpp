/// The pieces of the equations of a system in space: phases of contact, sides of half films, and the edges of films.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "lubjoint/motion/contact_events.hpp"
#include "lubjoint/motion/film_sides.hpp"
#include "lubjoint/motion/multibody_pieces.hpp"
#include "lubjoint/motion/spatial_film_bodies.hpp"
#include "lubjoint/motion/spatial_watched_angles.hpp"
#include "lubjoint/multibody/spatial/assembly.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// A system in space as a run sees it. Each joint that may touch, or whose half film jumps, has a piece of its own. A
/// film whose edge meets its wall, |e| + ψL/2 = c, is outside the model where the joint has no contact: the run ends
/// there, by handing over to nothing.
template <class R>
class SpatialPieces {
 public:
  using Real = R;                                          ///< scalar
  using State = std::vector<R>;                            ///< (r, p; ṙ, ω′; work)
  static constexpr std::size_t dimension = run_time_size;  ///< known when the program runs
  static constexpr bool has_events = true;                 ///< or a projection
  static constexpr std::size_t looks_each = 2;             ///< a journal may touch and leave within a short time

  /// @param norm_error  of Euler parameters, ||p| − 1|, that may stay
  /// @param tolerance  within which a journal that slides is kept on its line, in clearances
  SpatialPieces(SpatialOde<R>& ode, ConstraintUpkeep upkeep, double norm_error, const R& tolerance)
      : ode_(ode),
        upkeep_(upkeep),
        norm_error_(norm_error),
        tolerance_(tolerance),
        sides_(SpatialFilmBodies<R>(ode)),
        knots_(SpatialAngles<R>(ode), ode.table_pieces()),
        rooms_(ode.system().joints().size()) {
    for (const SpatialJointElement<R>& joint : ode.system().joints()) {
      has_pieces_ = has_pieces_ || joint.plane.has_contact() || joint.plane.has_half_film();
    }
  }

  /// The pieces that a start is in.
  void start(const R& t, const State& y) {
    knots_.start(t, y);
    ode_.forget();
    if (ode_.memory().empty()) return;
    for (std::size_t j = 0; j < ode_.memory().size(); ++j) {
      const SpatialJointElement<R>& joint = ode_.system().joints()[j];
      ode_.memory()[j] = detail::starting_memory(joint.plane, motion_of(y, j));
    }
    sides_.start(t, y);
    for (std::size_t j = 0; j < ode_.memory().size(); ++j) changes_.push_back({t, j, ode_.memory()[j]});
    starts_ = changes_.size();
  }

  /// Slides that last to the end of the run end with it.
  void finish(const R& t) { sides_.finish(t); }

  const std::vector<JointSlide>& slides() const { return sides_.slides(); }      ///< of half films, as they ended
  const std::vector<ContactEvent>& events() const { return events_; }            ///< of contact, in order
  const std::vector<MemoryChange<R>>& changes() const { return changes_; }       ///< of any memory, the start first
  std::size_t changes_after_start() const { return changes_.size() - starts_; }  ///< events of any kind
  double norm_drift() const { return norm_drift_; }  ///< largest ||p| − 1| at the end of a step, before it was mended

  /// What a margin is of.
  enum class Kind { contact, side, edge, knot };
  /// Of a margin.
  Kind kind_of(std::size_t margin) const {
    if (margin >= first_knot()) return Kind::knot;
    const std::size_t of_joint = margin % margins_each;
    return of_joint < 2 ? Kind::contact : of_joint < 4 ? Kind::side : Kind::edge;
  }
  /// The joint of a margin.
  const SpatialJointElement<R>& joint_of(std::size_t margin) const {
    return ode_.system().joints()[margin / margins_each];
  }

  // What a run asks for (EventSystem).

  /// Asked after each step, whose end was evaluated last. Where no joint has pieces, the edges of the films alone may
  /// be crossed: they are looked at where the room that an edge has left may shrink inside the step, by the cubic
  /// through it and its rate at both ends, to a quarter of what it is at these. A step that brings an edge further and
  /// back inside, and is accepted, goes unnoticed, unless the journal itself leaves the film.
  bool watches() {
    if (has_pieces_) return true;
    bool may_cross = !knots_.empty();
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      const EdgeRoom before = rooms_[j];
      const EdgeRoom& now = rooms_[j] = room_at_end(j);
      const R least = std::min<R>(before.room, now.room);
      may_cross = may_cross || !(4 * (now.t - before.t) * (before.pace + now.pace) < R(0.75) * 27 * least);
    }
    return may_cross;
  }
  OdeSystem<R, run_time_size>& equations() { return ode_; }  ///< of the present pieces
  /// None that the plane's interpolant could take for q with q̇ = v: events are looked for on cubics, and then located
  /// by the method.
  std::size_t coordinates() const { return 0; }
  /// Every number is finite; films are looked at where forces are asked for.
  bool admissible(const R&, const State& y) const {
    return std::all_of(y.begin(), y.end(), [](const R& v) { return std::isfinite(static_cast<double>(v)); });
  }

  /// Of each joint: the inner and the outer seam of its contact, what ends the side of its half film (a = 0, or, of one
  /// that slides, both ends of the jump), and its film's edge. Then the distances to the knots of tables over angles.
  void margins(const R& t, const State& y, std::vector<Margin<R>>& list) {
    list.clear();
    if (sides_.any_slides()) {
      ode_.at(t, y);
    } else {
      ode_.system().place(y.data(), ode_.workspace());
    }
    const Margin<R> far{R(1), R(0)};
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      const JointElement<R>& joint = ode_.system().joints()[j].plane;
      const SpatialJointKinematics<R> k = ode_.system().joint_kinematics(j, ode_.last());
      if (joint.has_contact()) {
        const detail::SeamMargins<R> m =
            detail::seam_margins(joint, std::as_const(ode_).memory()[j].phase, k.motion.eccentricity);
        list.push_back({m.inner, seam_rounding()});
        list.push_back({m.outer, seam_rounding()});
      } else {
        list.insert(list.end(), 2, far);
      }
      sides_.add_margins(j, far, list);
      list.push_back(joint.has_contact() ? far : Margin<R>{edge_room(j, k), seam_rounding()});
    }
    knots_.add_margins(t, y, list);
  }

  /// Euler parameters of norm 1, to the error that may stay or, if exactly, to rounding; constraints by projection,
  /// where that is their upkeep; journals that slide onto their lines.
  bool hold(const R& t, State& y, bool exactly) {
    if (!exactly) sides_.note_parted(t, y);
    bool changed = false;
    for (std::size_t b = 0; b < ode_.system().bodies().size(); ++b)
      changed = normalise(&y[7 * b + 3], exactly) || changed;
    if (upkeep_ == ConstraintUpkeep::by_projection && ode_.system().constraint_rows() > 0) {
      projected_ = y;
      try {
        project_onto_constraints(ode_.system(), t, projected_, ode_.workspace());
        y.swap(projected_);
        changed = true;
      } catch (const SingularConstraints&) {  // the next step ends elsewhere
      }
    }
    if (sides_.any_slides()) {
      const R allowed = exactly ? R(0) : tolerance_;
      changed = project_onto_slides(ode_.system(), t, y, ode_.memory(), allowed, ode_.workspace()) || changed;
    }
    return changed;
  }

  /// The piece beyond a surface, or the next interval of a table.
  AfterEvent cross(std::size_t margin, const R& t, const State& y) {
    if (kind_of(margin) == Kind::knot) {
      knots_.cross(margin - first_knot());
      ode_.forget();
      return AfterEvent::keep_pace;
    }
    const std::size_t j = margin / margins_each;
    switch (margin % margins_each) {
      case 0:
        change_phase(t, y, j, false);
        break;
      case 1:
        change_phase(t, y, j, true);
        break;
      case 2:
      case 3:
        sides_.cross(margin % margins_each == 3, t, y, j);
        break;
      default:
        return AfterEvent::hand_over;
    }
    changes_.push_back({t, j, ode_.memory()[j]});
    return AfterEvent::go_on;
  }

  /// 1 − (|e| + ψL/2)/c of a joint: what is left between the film's edge and the wall.
  R edge_room(std::size_t j, const SpatialJointKinematics<R>& k) const {
    const SpatialJointElement<R>& joint = ode_.system().joints()[j];
    const R& c = joint.plane.bearing.clearance();
    return R(1 - (length(k.motion.eccentricity) + joint.edge_shift(k.tilt())) / c);
  }

 private:
  static constexpr std::size_t margins_each = 5;
  std::size_t first_knot() const { return margins_each * ode_.system().joints().size(); }

  static R epsilon() { return std::numeric_limits<R>::epsilon(); }
  /// Seams are places in clearances; coordinates may be a thousand clearances long.
  static R seam_rounding() { return R(1e-12) * (epsilon() / R(std::numeric_limits<double>::epsilon())); }
  static R length(const Vector2<R>& v) {
    using std::sqrt;
    return R(sqrt(R(v.x() * v.x() + v.y() * v.y())));
  }

  /// Room between a film's edge and the wall, and how quickly it changes at most [1/s].
  struct EdgeRoom {
    R t{0}, room{0}, pace{0};
  };
  EdgeRoom room_at_end(std::size_t j) const {
    const SpatialWorkspace<R>& w = ode_.last();
    const SpatialJointElement<R>& joint = ode_.system().joints()[j];
    const SpatialJointKinematics<R>& k = w.joints[j].kinematics;
    const Vector2<R>& e = k.motion.eccentricity;
    const Vector2<R>& v = k.motion.velocity;
    const R size = length(e);
    R pace = size > 0 ? R(dot(e, v) / size) : length(v);
    if (pace < 0) pace = -pace;
    const Vector3<R> relative = difference(ode_.system().frame(joint.journal_at.body, w).spin,
                                           ode_.system().frame(joint.bearing_at.body, w).spin);
    pace += joint.edge_shift(R(lubjoint::cross(relative, k.journal_axis).norm()));
    return {ode_.last_time(), edge_room(j, k), R(pace / joint.plane.bearing.clearance())};
  }

  JournalMotion<R> motion_of(const State& y, std::size_t j) {
    ode_.system().place(y.data(), ode_.workspace());
    return ode_.system().joint_kinematics(j, ode_.workspace()).motion;
  }

  bool normalise(R* p, bool exactly) {
    using std::abs;
    using std::sqrt;
    const R square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3];
    const R size = sqrt(square);
    norm_drift_ = std::max(norm_drift_, std::abs(static_cast<double>(size - 1)));
    const R rounding = 2 * epsilon();
    if (!(abs(R(size - 1)) > (exactly ? rounding : std::max<R>(rounding, R(norm_error_))))) return false;
    for (std::size_t k = 0; k < 4; ++k) p[k] /= size;
    return true;
  }

  void change_phase(const R& t, const State& y, std::size_t j, bool outwards) {
    const JointElement<R>& joint = ode_.system().joints()[j].plane;
    JointMemory<R>& memory = ode_.memory()[j];
    const SpatialJointForce<R> at_end = ode_.at(t, y).joints[j];
    const Vector2<R> before = at_end.plane.total();
    const R speed = detail::normal_speed(at_end.kinematics.motion);
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
    const Vector2<R> after = ode_.at(t, y).joints[j].plane.total();
    event.force_before = static_cast<double>(before.norm());
    event.force_jump = static_cast<double>((after - before).norm());
    events_.push_back(event);
  }

  SpatialOde<R>& ode_;
  ConstraintUpkeep upkeep_;
  double norm_error_;
  R tolerance_;
  bool has_pieces_ = false;  ///< may a joint touch, or its half film change its side?
  FilmSides<SpatialFilmBodies<R>> sides_;
  TableKnots<R, SpatialAngles<R>> knots_;
  std::vector<EdgeRoom> rooms_;  ///< of each film's edge, at the end of the last step
  State projected_;              ///< a copy: a projection that fails leaves nothing behind
  std::vector<ContactEvent> events_;
  std::vector<MemoryChange<R>> changes_;
  std::size_t starts_ = 0;
  double norm_drift_ = 0;
};

}  // namespace lubjoint
