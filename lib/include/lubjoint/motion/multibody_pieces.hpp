/// The pieces of a multibody system's equations: phases of contact, and the sides of half films.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/motion/contact_events.hpp"
#include "lubjoint/motion/jump_side.hpp"
#include "lubjoint/motion/multibody_ode.hpp"
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
      : ode_(ode), upkeep_(upkeep), tolerance_(tolerance), knots_(PlanarAngles<R>(ode.system()), ode.table_pieces()) {
    const std::vector<JointElement<R>>& joints = ode.system().joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (joints[j].has_contact() || joints[j].has_half_film()) watched_.push_back(j);
    }
    slides_since_.resize(joints.size());
    unparted_.resize(joints.size(), false);
  }

  /// The pieces that a start is in.
  void start(const R& t, const State& y) {
    for (const std::size_t j : watched_) {
      const JointElement<R>& joint = ode_.system().joints()[j];
      const JournalMotion<R> motion = motion_of(t, y, j);
      ode_.memory()[j] = detail::starting_memory(joint, motion);
    }
    // A start on the jump is decided with every joint that is off it on its side.
    for (const bool on_jump : {false, true}) {
      for (const std::size_t j : watched_) {
        if (has_side(j) && slip_of(t, y, j).is_on_jump() == on_jump) find_side(t, y, j);
      }
    }
    for (const std::size_t j : watched_) changes_.push_back({t, j, ode_.memory()[j]});
    knots_.start(t, y);
  }

  /// Slides that last to the end of the run end with it.
  void finish(const R& t) {
    for (const std::size_t j : watched_) end_slide(t, j);
  }

  const std::vector<ContactEvent>& events() const { return events_; }       ///< of contact, in order
  const std::vector<JointSlide>& slides() const { return slides_; }         ///< of half films, as they ended
  const std::vector<MemoryChange<R>>& changes() const { return changes_; }  ///< of any memory, the start first
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
    bool slides = false;
    for (const std::size_t j : watched_) slides = slides || ode_.memory()[j].side == FilmSide::sliding;
    if (slides) {
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
      if (!has_side(j)) {
        list.insert(list.end(), 2, far);
      } else if (ode_.memory()[j].side == FilmSide::sliding) {
        const Hold hold = hold_of(j);
        const R size = abs_of(hold.reach) + abs_of(hold.needed);
        const R rounding = size > 0 ? R(hold.rounding / size) : R(1);
        list.push_back({size > 0 ? R((hold.reach - hold.needed) / size) : R(0), rounding});
        list.push_back({size > 0 ? R((hold.reach + hold.needed) / size) : R(0), rounding});
      } else {
        const Slip slip = slip_of_motion(motion, j);
        const R rounding = unparted_[j] ? std::max<R>(slip.rounding, slip.wrong_side) : slip.rounding;
        list.push_back({part_of(j, slip), rounding});
        list.push_back(far);
      }
    }
  }

  /// Constraints by projection, where that is their upkeep; journals that slide onto their lines.
  bool hold(const R& t, State& y, bool exactly) {
    if (!exactly) note_parted(t, y);
    const bool projects = upkeep_ == ConstraintUpkeep::by_projection && project(t, y);
    const bool slides = std::any_of(watched_.begin(), watched_.end(),
                                    [this](std::size_t j) { return ode_.memory()[j].side == FilmSide::sliding; });
    if (!slides) return projects;
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
      case 2:
        if (ode_.memory()[j].side == FilmSide::sliding) {
          leave_jump(t, j, FilmSide::converging);
        } else {
          leave_side(t, y, j);
        }
        break;
      default:
        leave_jump(t, j, FilmSide::mirrored);
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

  static R abs_of(const R& x) {
    using std::abs;
    return abs(x);
  }

  static R epsilon() { return std::numeric_limits<R>::epsilon(); }

  /// Seams are places in clearances; coordinates may be a thousand clearances long.
  static R seam_rounding() { return R(1e-12) * (epsilon() / R(std::numeric_limits<double>::epsilon())); }

  JournalMotion<R> motion_of(const R& t, const State& y, std::size_t j) {
    ode_.system().evaluate_kinematics(t, y.data(), ode_.workspace());
    return ode_.system().journal_motion(j, ode_.workspace());
  }

  /// Has the joint's film a side now?
  bool has_side(std::size_t j) const {
    return ode_.system().joints()[j].has_half_film() && ode_.memory()[j].phase != ContactPhase::dry;
  }

  // A journal near its jump.

  /// How e and u lie to each other.
  struct Slip {
    R sine;           ///< (e × u)/(|e||u|): above 0 where a < 0
    R rounding;       ///< what rounding of the bodies' places and velocities makes of it
    R wrong_side;     ///< sine beyond which it is on the other side, whatever the errors of a run
    Vector2<R> line;  ///< r; along u where e is nothing but rounding
    bool centred;     ///< is e nothing but rounding?
    bool at_rest;     ///< is u?

    bool is_on_jump() const { return at_rest || !(abs_of(sine) > rounding); }
    FilmSide side() const { return sine > 0 ? FilmSide::mirrored : FilmSide::converging; }
  };

  /// From the frames of the workspace.
  Slip slip_of_motion(const JournalMotion<R>& motion, std::size_t j) {
    using std::abs;
    const JointElement<R>& joint = ode_.system().joints()[j];
    const R mean_spin = (motion.bearing_spin + motion.journal_spin) / 2;
    const Vector2<R>& e = motion.eccentricity;
    const Vector2<R> u(R(motion.velocity.x() + mean_spin * e.y()), R(motion.velocity.y() - mean_spin * e.x()));
    // e and u are differences of numbers of the size of the mechanism.
    R place(0);
    R speed(0);
    for (const BodyPoint<R>* at : {&joint.bearing_at, &joint.journal_at}) {
      const R arm = at->point.norm();
      place += arm;
      if (at->body == ground_body) continue;
      const PlanarFrame<R>& frame = ode_.workspace().frames[at->body];
      place += frame.position.norm();
      speed += frame.velocity.norm() + abs(frame.spin) * arm;
    }
    const R few = 16 * epsilon();
    const R e_rounding = few * place;
    const R u_rounding = few * speed + abs(mean_spin) * e_rounding;
    const R distance = is_zero(e) ? R(0) : norm(e);
    const R pace = is_zero(u) ? R(0) : norm(u);
    Slip slip{R(0), R(1), R(1), Vector2<R>(R(1), R(0)), !(distance > e_rounding), !(pace > u_rounding)};
    if (!slip.centred) {
      slip.line = direction(e);
    } else if (!slip.at_rest) {
      slip.line = direction(u);
    }
    if (!slip.centred && !slip.at_rest) {
      slip.sine = lubjoint::cross(direction(e), direction(u));
      slip.rounding = few + e_rounding / distance + u_rounding / pace;
      slip.wrong_side = wrong_side(R(pace / joint.bearing.clearance()), R(abs(mean_spin)));
    }
    return slip;
  }

  Slip slip_of(const R& t, const State& y, std::size_t j) { return slip_of_motion(motion_of(t, y, j), j); }

  /// How far a journal is on its film's side.
  R part_of(std::size_t j, const Slip& slip) const {
    return ode_.memory()[j].side == FilmSide::mirrored ? slip.sine : R(-slip.sine);
  }

  /// A side begins on a = 0 and may part from it slowly, by less than the errors of the run. It ends at a = 0 once it
  /// has parted; before that, where it is wrong beyond any error.
  void note_parted(const R& t, const State& y) {
    for (const std::size_t j : watched_) {
      if (!unparted_[j]) continue;
      const bool sided = has_side(j) && ode_.memory()[j].side != FilmSide::sliding;
      if (!sided) {
        unparted_[j] = false;
        continue;
      }
      const Slip slip = slip_of(t, y, j);
      unparted_[j] = !(part_of(j, slip) > slip.rounding);
    }
  }

  /// Of a journal that slides.
  struct Hold {
    R needed;    ///< tangential force along t that keeps a = 0 [N]
    R reach;     ///< X, what the film has for it [N]
    R rounding;  ///< of the first [N]
  };

  /// From an evaluated workspace.
  Hold hold_of(std::size_t j) {
    using std::max;
    const SystemWorkspace<R>& w = ode_.workspace();
    const auto slide = std::find_if(w.slides.begin(), w.slides.end(), [j](const auto& s) { return s.joint == j; });
    const JointElement<R>& joint = ode_.system().joints()[j];
    const R share = joint.film_share(w.joints[j].kinematics.motion, ode_.memory()[j]);
    R size(0);
    for (std::size_t i = 0; i < w.forces.size(); i += 3) {
      const R inertial = w.accelerations[i] / ode_.system().inverse_mass(i / 3)[0];
      size = max(size, max(abs_of(w.forces[i]), abs_of(inertial)));
    }
    // Seen along its line a journal beyond the centre has its tangential direction reversed.
    const R needed = slide->place.along < 0 ? R(-slide->force) : slide->force;
    return {needed, share * joint.jump_force(slide->place).reach, 64 * epsilon() * size};
  }

  /// Filippov's rule at a = 0: where the tangential force that keeps it lies inside the jump, the journal slides; else
  /// the film goes to the side to which all other forces drive it. A journal at rest is looked at a moment later, when
  /// its acceleration has given it a direction.
  /// @param line  of the slide that is looked at: set
  /// @param repelled  the side where the jump pushes the journal away to both: either would do
  FilmSide side_from_jump(const R& t, const State& y, std::size_t j, Vector2<R>& line, FilmSide repelled) {
    const Slip slip = slip_of(t, y, j);
    line = slip.line;
    JointMemory<R>& memory = ode_.memory()[j];
    const JointMemory<R> before = memory;
    FilmSide side = repelled;
    try {
      R later = t;
      State ahead = y;
      if (slip.at_rest) {
        memory.side = FilmSide::of_slip;
        advance_from_rest(later, ahead, j, line);
      }
      begin_slide(y, j, line);
      ode_.at(later, ahead);
      const Hold hold = hold_of(j);
      if (hold.reach > 0 && abs_of(hold.needed) <= hold.reach) {
        side = FilmSide::sliding;
      } else if (abs_of(hold.needed) > abs_of(hold.reach)) {
        side = hold.needed > 0 ? FilmSide::converging : FilmSide::mirrored;
      }
    } catch (const std::domain_error&) {  // so near the wall that on its line the journal is at it, to rounding
    }
    memory = before;
    return side;
  }

  /// A moment on, in which the journal moves by next to nothing of its clearance. At the centre the line is that of the
  /// relative acceleration of journal and bearing.
  void advance_from_rest(R& t, State& y, std::size_t j, Vector2<R>& line) {
    using std::abs;
    using std::sqrt;
    const JointElement<R>& joint = ode_.system().joints()[j];
    const SystemWorkspace<R>& w = ode_.at(t, y);
    const JournalMotion<R>& motion = w.joints[j].kinematics.motion;
    const Vector2<R> acceleration = acceleration_of(joint.journal_at, w) - acceleration_of(joint.bearing_at, w);
    const R clearance = joint.bearing.clearance();
    const R pull = is_zero(acceleration) ? R(0) : norm(acceleration);
    const R fastest = std::max<R>(abs(motion.bearing_spin + motion.journal_spin) / 2, sqrt(R(pull / clearance)));
    if (!(fastest > 0)) return;  // nothing will ever move it
    const bool centred = slip_of_motion(motion, j).centred;
    if (centred && pull > 0) line = direction(acceleration);
    const R moment = R(1e-6) / fastest;
    const std::size_t n = coordinates();
    for (std::size_t i = 0; i < n; ++i) {
      y[i] += moment * (y[n + i] + moment * w.accelerations[i] / 2);
      y[n + i] += moment * w.accelerations[i];
    }
    t += moment;
  }

  /// r̈ + φ̈ s⊥ − φ̇² s of an evaluated workspace.
  Vector2<R> acceleration_of(const BodyPoint<R>& at, const SystemWorkspace<R>& w) const {
    if (at.body == ground_body) return Vector2<R>(R(0), R(0));
    const R* a = &w.accelerations[3 * at.body];
    const PlanarFrame<R>& frame = w.frames[at.body];
    const Vector2<R> s = inertial_vector(frame, at.point);
    const R square = frame.spin * frame.spin;
    return Vector2<R>(R(a[0] - a[2] * s.y() - square * s.x()), R(a[1] + a[2] * s.x() - square * s.y()));
  }

  // Changes of a joint's memory.

  void begin_slide(const State& y, std::size_t j, const Vector2<R>& line) {
    JointMemory<R>& memory = ode_.memory()[j];
    memory.side = FilmSide::sliding;
    memory.line = line;
    const JointElement<R>& joint = ode_.system().joints()[j];
    memory.line_angle = R(0);
    for (const std::size_t body : {joint.bearing_at.body, joint.journal_at.body}) {
      if (body != ground_body) memory.line_angle += y[3 * body + 2] / 2;
    }
  }

  void enter_side(const R& t, const State& y, std::size_t j, FilmSide side, const Vector2<R>& line) {
    if (side == FilmSide::sliding) {
      begin_slide(y, j, line);
      slides_since_[j] = t;
    } else {
      ode_.memory()[j].side = side;
    }
  }

  void end_slide(const R& t, std::size_t j) {
    if (ode_.memory()[j].side != FilmSide::sliding) return;
    slides_.push_back({j, static_cast<double>(slides_since_[j]), static_cast<double>(t)});
  }

  /// A side that ends at a = 0; or, of one that has not parted from it, where it is wrong beyond any error: a step of
  /// loose tolerance has brought the journal to the other side.
  void leave_side(const R& t, const State& y, std::size_t j) {
    const Slip slip = slip_of(t, y, j);
    if (abs_of(slip.sine) > std::max<R>(slip.rounding, slip.wrong_side)) {
      ode_.memory()[j].side = slip.side();
      unparted_[j] = false;
      return;
    }
    const FilmSide other = ode_.memory()[j].side == FilmSide::converging ? FilmSide::mirrored : FilmSide::converging;
    Vector2<R> line;
    enter_side(t, y, j, side_from_jump(t, y, j, line, other), line);
    unparted_[j] = true;
  }

  void leave_jump(const R& t, std::size_t j, FilmSide side) {
    end_slide(t, j);
    ode_.memory()[j].side = side;
    unparted_[j] = true;
  }

  void find_side(const R& t, const State& y, std::size_t j) {
    const Slip slip = slip_of(t, y, j);
    Vector2<R> line = slip.line;
    const bool on_jump = slip.is_on_jump();
    const FilmSide side = on_jump ? side_from_jump(t, y, j, line, FilmSide::converging) : slip.side();
    enter_side(t, y, j, side, line);
    unparted_[j] = on_jump;
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
      if (event.to == ContactPhase::dry) leave_jump(t, j, FilmSide::of_slip);
      if (event.from == ContactPhase::dry) find_side(t, y, j);
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
  TableKnots<R, PlanarAngles<R>> knots_;
  std::vector<std::size_t> watched_;  ///< joints with pieces
  std::vector<R> slides_since_;       ///< of each joint
  std::vector<bool> unparted_;        ///< of each joint: is it on a side that has not left a = 0 yet?
  std::vector<ContactEvent> events_;
  std::vector<JointSlide> slides_;
  std::vector<MemoryChange<R>> changes_;
};

}  // namespace lubjoint
