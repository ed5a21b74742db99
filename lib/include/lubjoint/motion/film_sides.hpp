/// Half films of a system's joints: on which side of the jump each is, and when its journal slides on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lubjoint/motion/jump_side.hpp"
#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/multibody/joint_element.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// The sides of half films as a run sees them. On a = 0 Filippov's rule says which way a film goes: where the
/// tangential force that keeps a = 0 lies inside the jump, the journal slides; else the film goes to the side to which
/// all other forces drive it.
/// @tparam Bodies  of the plane or of space, with R and State:
///   memory(), memory_of(j) to be changed, joints(), joint(j) as an element of its plane;
///   evaluate(t, y) and its workspace last(); place(t, y) of the bodies and, of these, motion(j) of a journal and
///   sizes(j), its numbers of place and speed;
///   of an evaluated state eccentricity_acceleration(j), where motion(j) is seen from, and force_size();
///   moved(y, a moment); line_angle(t, y, j) of the frame in which lines keep theirs
template <class Bodies>
class FilmSides {
 public:
  using R = typename Bodies::R;          ///< the number
  using State = typename Bodies::State;  ///< y
  static constexpr std::size_t margins_each = 2;  ///< of a joint, that add_margins adds

  /// Of all joints; those without a half film have no side.
  explicit FilmSides(Bodies bodies)
      : bodies_(std::move(bodies)), slides_since_(bodies_.joints(), R(0)), unparted_(bodies_.joints(), false) {}

  /// The sides that a start is on. One on the jump is decided with every joint that is off it on its side.
  void start(const R& t, const State& y) {
    for (const bool on_jump : {false, true}) {
      for (std::size_t j = 0; j < bodies_.joints(); ++j) {
        if (has_side(j) && slip_of(t, y, j).is_on_jump() == on_jump) find(t, y, j);
      }
    }
  }
  /// Slides that last to the end of the run end with it.
  void finish(const R& t) {
    for (std::size_t j = 0; j < bodies_.joints(); ++j) end_slide(t, j);
  }
  const std::vector<JointSlide>& slides() const { return slides_; }  ///< as they ended

  /// Has the joint's film a side now?
  bool has_side(std::size_t j) const {
    return bodies_.joint(j).has_half_film() && bodies_.memory()[j].phase != ContactPhase::dry;
  }
  /// Does any journal slide?
  bool any_slides() const {
    const auto& memory = bodies_.memory();
    return std::any_of(memory.begin(), memory.end(), [](const auto& m) { return m.side == FilmSide::sliding; });
  }

  /// What ends the side of a joint's film: a = 0, or, of one that slides, both ends of the jump. From the bodies'
  /// places, or, where any journal slides, from an evaluated state.
  /// @param far  where there is no such end
  void add_margins(std::size_t j, const Margin<R>& far, std::vector<Margin<R>>& list) const {
    if (!has_side(j)) {
      list.insert(list.end(), margins_each, far);
    } else if (bodies_.memory()[j].side == FilmSide::sliding) {
      const Hold hold = hold_of(j);
      const R size = abs_of(hold.reach) + abs_of(hold.needed);
      const R rounding = size > 0 ? R(hold.rounding / size) : R(1);
      list.push_back({size > 0 ? R((hold.reach - hold.needed) / size) : R(0), rounding});
      list.push_back({size > 0 ? R((hold.reach + hold.needed) / size) : R(0), rounding});
    } else {
      const Slip slip = slip_of_placed(j);
      const R rounding = unparted_[j] ? std::max<R>(slip.rounding, slip.wrong_side) : slip.rounding;
      list.push_back({part_of(j, slip), rounding});
      list.push_back(far);
    }
  }
  /// A joint's margin is crossed: the first or the second of the two.
  void cross(bool second, const R& t, const State& y, std::size_t j) {
    if (bodies_.memory()[j].side != FilmSide::sliding) {
      leave_side(t, y, j);
    } else {
      leave(t, j, second ? FilmSide::mirrored : FilmSide::converging);
    }
  }

  /// A side begins on a = 0 and may part from it slowly, by less than the errors of the run. It ends at a = 0 once it
  /// has parted; before that, where it is wrong beyond any error.
  void note_parted(const R& t, const State& y) {
    for (std::size_t j = 0; j < bodies_.joints(); ++j) {
      if (!unparted_[j]) continue;
      const bool sided = has_side(j) && bodies_.memory()[j].side != FilmSide::sliding;
      if (!sided) {
        unparted_[j] = false;
        continue;
      }
      const Slip slip = slip_of(t, y, j);
      unparted_[j] = !(part_of(j, slip) > slip.rounding);
    }
  }

  /// The side of a film that begins.
  void find(const R& t, const State& y, std::size_t j) {
    const Slip slip = slip_of(t, y, j);
    Vector2<R> line = slip.line;
    const bool on_jump = slip.is_on_jump();
    const FilmSide side = on_jump ? side_from_jump(t, y, j, line, FilmSide::converging) : slip.side();
    enter_side(t, y, j, side, line);
    unparted_[j] = on_jump;
  }
  /// The film leaves its jump, or its side, for a side that is known.
  void leave(const R& t, std::size_t j, FilmSide side) {
    end_slide(t, j);
    bodies_.memory_of(j).side = side;
    unparted_[j] = true;
  }

 private:
  static R abs_of(const R& x) {
    using std::abs;
    return abs(x);
  }
  static R epsilon() { return std::numeric_limits<R>::epsilon(); }

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

  Slip slip_of_placed(std::size_t j) const {
    const JournalMotion<R> motion = bodies_.motion(j);
    const R mean_spin = (motion.bearing_spin + motion.journal_spin) / 2;
    const Vector2<R>& e = motion.eccentricity;
    const Vector2<R> u(R(motion.velocity.x() + mean_spin * e.y()), R(motion.velocity.y() - mean_spin * e.x()));
    // e and u are differences of numbers of the size of the mechanism.
    const auto [place, speed] = bodies_.sizes(j);
    const R few = 16 * epsilon();
    const R e_rounding = few * place;
    const R u_rounding = few * speed + abs_of(mean_spin) * e_rounding;
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
      slip.wrong_side = wrong_side(R(pace / bodies_.joint(j).bearing.clearance()), abs_of(mean_spin));
    }
    return slip;
  }
  Slip slip_of(const R& t, const State& y, std::size_t j) const {
    bodies_.place(t, y);
    return slip_of_placed(j);
  }

  /// How far a journal is on its film's side.
  R part_of(std::size_t j, const Slip& slip) const {
    return bodies_.memory()[j].side == FilmSide::mirrored ? slip.sine : R(-slip.sine);
  }

  /// Of a journal that slides.
  struct Hold {
    R needed;    ///< tangential force along t that keeps a = 0 [N]
    R reach;     ///< X, what the film has for it [N]
    R rounding;  ///< of the first [N]
  };

  /// From an evaluated state.
  Hold hold_of(std::size_t j) const {
    const auto& w = bodies_.last();
    const auto slide = std::find_if(w.slides.begin(), w.slides.end(), [j](const auto& s) { return s.joint == j; });
    const JointElement<R>& joint = bodies_.joint(j);
    const R share = joint.film_share(w.joints[j].kinematics.motion, bodies_.memory()[j]);
    // Seen along its line a journal beyond the centre has its tangential direction reversed.
    const R needed = slide->place.along < 0 ? R(-slide->force) : slide->force;
    return {needed, share * joint.jump_force(slide->place).reach, 64 * epsilon() * bodies_.force_size()};
  }

  /// Filippov's rule at a = 0. A journal at rest is looked at a moment later, when its acceleration has given it a
  /// direction.
  /// @param line  of the slide that is looked at: set
  /// @param repelled  the side where the jump pushes the journal away to both: either would do
  FilmSide side_from_jump(const R& t, const State& y, std::size_t j, Vector2<R>& line, FilmSide repelled) {
    const Slip slip = slip_of(t, y, j);
    line = slip.line;
    const JointMemory<R> before = bodies_.memory()[j];
    FilmSide side = repelled;
    try {
      R later = t;
      State ahead = y;
      if (slip.at_rest) {
        bodies_.memory_of(j).side = FilmSide::of_slip;
        advance_from_rest(later, ahead, j, line);
      }
      begin_slide(t, y, j, line);
      bodies_.evaluate(later, ahead);
      const Hold hold = hold_of(j);
      if (hold.reach > 0 && abs_of(hold.needed) <= hold.reach) {
        side = FilmSide::sliding;
      } else if (abs_of(hold.needed) > abs_of(hold.reach)) {
        side = hold.needed > 0 ? FilmSide::converging : FilmSide::mirrored;
      }
    } catch (const std::domain_error&) {  // so near the wall that on its line the journal is at it, to rounding
    }
    bodies_.memory_of(j) = before;
    return side;
  }

  /// A moment on, in which the journal moves by next to nothing of its clearance. At the centre the line is that of the
  /// relative acceleration of journal and bearing.
  void advance_from_rest(R& t, State& y, std::size_t j, Vector2<R>& line) {
    using std::sqrt;
    bodies_.evaluate(t, y);
    const JournalMotion<R> motion = bodies_.motion(j);
    const Vector2<R> acceleration = bodies_.eccentricity_acceleration(j);
    const R pull = is_zero(acceleration) ? R(0) : norm(acceleration);
    const R fastest = std::max<R>(abs_of(R(motion.bearing_spin + motion.journal_spin)) / 2,
                                  sqrt(R(pull / bodies_.joint(j).bearing.clearance())));
    if (!(fastest > 0)) return;  // nothing will ever move it
    if (slip_of_placed(j).centred && pull > 0) line = direction(acceleration);
    const R moment = R(1e-6) / fastest;
    y = bodies_.moved(y, moment);
    t += moment;
  }

  void begin_slide(const R& t, const State& y, std::size_t j, const Vector2<R>& line) {
    const R angle = bodies_.line_angle(t, y, j);
    JointMemory<R>& memory = bodies_.memory_of(j);
    memory.side = FilmSide::sliding;
    memory.line = line;
    memory.line_angle = angle;
  }
  void enter_side(const R& t, const State& y, std::size_t j, FilmSide side, const Vector2<R>& line) {
    if (side == FilmSide::sliding) {
      begin_slide(t, y, j, line);
      slides_since_[j] = t;
    } else {
      bodies_.memory_of(j).side = side;
    }
  }
  void end_slide(const R& t, std::size_t j) {
    if (bodies_.memory().empty() || bodies_.memory()[j].side != FilmSide::sliding) return;
    slides_.push_back({j, static_cast<double>(slides_since_[j]), static_cast<double>(t)});
  }

  /// A side that ends at a = 0; or, of one that has not parted from it, where it is wrong beyond any error: a step of
  /// loose tolerance has brought the journal to the other side.
  void leave_side(const R& t, const State& y, std::size_t j) {
    const Slip slip = slip_of(t, y, j);
    if (abs_of(slip.sine) > std::max<R>(slip.rounding, slip.wrong_side)) {
      bodies_.memory_of(j).side = slip.side();
      unparted_[j] = false;
      return;
    }
    const FilmSide other = bodies_.memory()[j].side == FilmSide::converging ? FilmSide::mirrored : FilmSide::converging;
    Vector2<R> line;
    enter_side(t, y, j, side_from_jump(t, y, j, line, other), line);
    unparted_[j] = true;
  }

  Bodies bodies_;
  std::vector<R> slides_since_;  ///< of each joint
  std::vector<bool> unparted_;   ///< of each joint: is it on a side that has not left a = 0 yet?
  std::vector<JointSlide> slides_;
};

}  // namespace lubjoint
