/// A journal in a fixed bearing, from piece to piece of its motion: the film on one side or the other, sliding on a
/// half film's jump, the blend of film and contact, dry contact, and back. It shares no event logic with lib.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "oracle/measure/stress/reference_methods.hpp"
#include "oracle/measure/stress/reference_pieces.hpp"

namespace lubjoint::reports::stress_reference {

/// The journal's motion by one of the methods.
template <class R, template <class> class Method>
class JournalMotionBy {
 public:
  JournalMotionBy(const JournalForces<R>& forces, const R& velocity_scale, const R& tolerance, const R& duration)
      : forces_(forces), velocity_scale_(velocity_scale), tolerance_(tolerance), step_(R(1e-9) * duration) {}

  Situation<R> start(const JournalNumbers& n) const {
    using std::sqrt;
    Situation<R> s;
    const Quad c(n.clearance);
    const Quad x = Quad(n.place[0]) / c;
    const Quad y = Quad(n.place[1]) / c;
    const Quad u = Quad(n.velocity[0]) / c;
    const Quad v = Quad(n.velocity[1]) / c;
    const Quad distance = sqrt(x * x + y * y);
    s.y << R(x), R(y), R(u), R(v), R(n.spin);
    s.wall = distance > chart_in;
    if (s.wall) {
      s.y << R(1 - distance), R(atan2(y, x)), R(-(x * u + y * v) / distance),
          R((x * v - y * u) / (distance * distance)), R(n.spin);
    }
    s.impact_speed = forces_.min_impact_speed;
    choose_side(s);
    return s;
  }

  /// Moved by a share of the scales in one of ê's or w's directions, or near the wall of g, γ and their rates.
  Situation<R> moved(Situation<R> s, int component, const R& share) const {
    if (s.wall) {
      s.y(component) += share * wall(s).scale(s.y)(component);
    } else {
      s.y(component) += share * in_plane(s).scale(s.y)(component);
    }
    return s;
  }

  /// On to a time, through all pieces between.
  void to(Situation<R>& s, const R& goal) {
    for (std::size_t pieces = 0; s.t < goal; ++pieces) {
      if (pieces > 5000) throw std::runtime_error("the reference has too many pieces");
      if (s.sliding) {
        slide(s, goal);
      } else if (s.wall) {
        move(s, wall(s), goal);
      } else {
        move(s, in_plane(s), goal);
      }
    }
  }

  /// ê and its rate.
  Eigen::Matrix<R, 4, 1> plane(const Situation<R>& s) const { return s.plane(); }

  /// On the journal [N].
  Pair<R> force(const Situation<R>& s) const {
    using std::cos;
    using std::sin;
    if (s.sliding) {
      const LineSystem<R> line = line_of(s);
      const auto here = line.at(on_line(s));
      return here.radial * here.n + (here.needed + here.dry_across) * turned(here.n);
    }
    if (s.wall) {
      const RadialForce<R> f = wall(s).force(s.y(0), R(-s.y(2)), R((1 - s.y(0)) * s.y(3)), s.y(4));
      const Pair<R> r(cos(s.y(1)), sin(s.y(1)));
      return f.radial * r + f.across * turned(r);
    }
    const auto d = in_plane(s).rate(s.t, s.y);
    return forces_.inertia * Pair<R>(d(2), d(3)) - forces_.load;
  }

 private:
  PieceOf<R> piece_of(const Situation<R>& s) const {
    return {forces_, velocity_scale_, s.region, s.side, s.impact_speed};
  }
  PlaneSystem<R> in_plane(const Situation<R>& s) const { return {piece_of(s)}; }
  WallSystem<R> wall(const Situation<R>& s) const { return {piece_of(s)}; }
  LineSystem<R> line_of(const Situation<R>& s) const { return {piece_of(s), s.wall}; }

  static Pair<R> squeeze(const Situation<R>& s) {
    const R mean = s.y(4) / 2;
    return {R(s.y(2) + mean * s.y(1)), R(s.y(3) - mean * s.y(0))};
  }

  /// x, ẋ, γ, spin on the line of centres; of a journal in the middle along its motion, or along the load that will
  /// move it.
  typename LineSystem<R>::State on_line(const Situation<R>& s) const {
    using std::atan2;
    typename LineSystem<R>::State y;
    if (s.wall) {
      y << s.y(0), s.y(2), s.y(1), s.y(4);
      return y;
    }
    Pair<R> along(R(1), R(0));
    for (const Pair<R>& v : {Pair<R>(s.y(0), s.y(1)), squeeze(s), Pair<R>(forces_.load)}) {
      const R size = v.norm();
      if (!(size > 0)) continue;
      along = v / size;
      break;
    }
    y << s.y(0) * along.x() + s.y(1) * along.y(), s.y(2) * along.x() + s.y(3) * along.y(),
        R(atan2(along.y(), along.x())), s.y(4);
    return y;
  }

  /// The side of the film at a state, and whether it slides on its jump.
  void choose_side(Situation<R>& s) const {
    s.sliding = false;
    s.side = 0;
    if (s.region == Region::dry || !forces_.sides()) return;
    const Pair<R> e(s.y(0), s.y(1));
    if (forces_.kinks()) {
      R squeezed = s.wall ? R(-s.y(2)) : e.dot(squeeze(s));
      // Where it is about to go: g̈, or the rate of e·w.
      if (squeezed == 0 && s.wall) squeezed = -wall(s).rate(s.t, s.y)(2);
      if (squeezed == 0 && !s.wall) {
        const auto d = in_plane(s).rate(s.t, s.y);
        squeezed = s.y(2) * s.y(2) + s.y(3) * s.y(3) + s.y(0) * d(2) + s.y(1) * d(3);
      }
      s.side = squeezed < 0 ? -1 : 1;
      return;
    }
    const R turning = s.wall ? R(s.y(3) - s.y(4) / 2) : wedge<R>(e, squeeze(s));
    if (turning != 0) {
      s.side = turning < 0 ? 1 : -1;
      return;
    }
    decide(s, 0);
  }

  /// On a = 0: sliding if a half film on either side pushes back by more than what the motion needs; else on to the
  /// other side, or from the start to where it is driven. A journal at rest is looked at a moment later.
  void decide(Situation<R>& s, int from) const {
    using std::abs;
    const LineSystem<R> line = line_of(s);
    auto y = on_line(s);
    const bool at_rest = s.wall ? s.y(2) == 0 && s.y(3) == s.y(4) / 2 : squeeze(s).norm() == 0;
    if (at_rest) {
      const R moment(1e-12);
      const auto rate = line.rate(s.t, y);
      y += moment * rate;
      y(0) += rate(1) * moment * moment / 2;
    }
    const auto here = line.at(y);
    // From the centre the reach grows from 0, and what is needed is 0 to the rounding of the load's share across.
    s.sliding = here.reach > 0 && abs(here.needed) <= here.reach + PieceOf<R>::noise() * forces_.load.norm();
    s.side = from != 0 ? -from : here.needed > 0 ? 1 : -1;
  }

  void cross_seam(Situation<R>& s, bool outwards) const {
    if (s.region == Region::film) {
      s.impact_speed = std::max(R(-s.y(2) * forces_.clearance()), forces_.min_impact_speed);
      s.region = Region::blend;
    } else if (s.region == Region::dry) {
      s.region = Region::blend;
      choose_side(s);
    } else {
      s.region = outwards ? Region::dry : Region::film;
      if (outwards) s.sliding = false;
    }
  }

  static void change_chart(Situation<R>& s) {
    using std::atan2;
    using std::sqrt;
    if (s.wall) {
      s.y.template head<4>() = s.plane();
      s.wall = false;
      return;
    }
    const Pair<R> e(s.y(0), s.y(1));
    const Pair<R> w(s.y(2), s.y(3));
    const R distance = sqrt(e.dot(e));
    s.y.template head<4>() << 1 - distance, R(atan2(e.y(), e.x())), R(-e.dot(w) / distance),
        R(wedge<R>(e, w) / (distance * distance));
    s.wall = true;
  }

  template <class System>
  void move(Situation<R>& s, const System& system, const R& goal) {
    Piece<System, Method> piece(system, tolerance_, step_);
    const PieceEnd end = piece.to(s.t, s.y, goal);
    step_ = piece.step();
    if (end.margin == 3) change_chart(s);
    if (end.margin == 1 || end.margin == 2) cross_seam(s, end.margin == 1);
    if (end.margin != 0) return;
    if (forces_.kinks()) {
      s.side = -s.side;
    } else {
      decide(s, s.side);
    }
  }

  void slide(Situation<R>& s, const R& goal) {
    const LineSystem<R> line = line_of(s);
    auto y = on_line(s);
    Piece<LineSystem<R>, Method> piece(line, tolerance_, step_);
    const PieceEnd end = piece.to(s.t, y, goal);
    step_ = piece.step();
    const auto here = line.at(y);
    const R mean = y(3) / 2;
    if (s.wall) {
      s.y << y(0), y(2), y(1), mean, y(3);
    } else {
      const Pair<R> e = here.place * here.n;
      const Pair<R> w = here.rate * here.n + R(mean * here.place) * turned(here.n);
      s.y << e.x(), e.y(), w.x(), w.y(), y(3);
    }
    if (end.margin == 3) change_chart(s);
    if (end.margin == 1 || end.margin == 2) cross_seam(s, end.margin == 1);
    if (end.margin != 0) return;
    s.sliding = false;
    s.side = (here.needed > 0) != (here.place < 0) ? 1 : -1;
  }

  const JournalForces<R>& forces_;
  R velocity_scale_;
  R tolerance_;
  R step_;
};

}  // namespace lubjoint::reports::stress_reference
