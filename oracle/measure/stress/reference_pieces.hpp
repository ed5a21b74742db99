/// The equations of a journal in a fixed bearing, piece by piece of its motion: in the plane, near the wall, and
/// sliding on a half film's jump; film, blend of film and contact, dry contact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "oracle/measure/stress/reference_forces.hpp"

namespace lubjoint::reports::stress_reference {

/// Where in its motion a journal is. Near the wall its state is polar, with the gap as a number of its own: what
/// Cartesian coordinates leave of a gap of 1e-12 are a few digits.
template <class R>
struct Situation {
  R t{};
  /// Away from the wall ê, w, spin; near it the gap g = 1 − |ê|, the angle γ of e, their rates, spin.
  Eigen::Matrix<R, 5, 1> y;
  bool wall = false;
  Region region = Region::film;
  int side = 0;
  bool sliding = false;
  R impact_speed{};

  /// ê, w.
  Eigen::Matrix<R, 4, 1> plane() const {
    if (!wall) return y.template head<4>();
    using std::cos;
    using std::sin;
    const R c = cos(y(1));
    const R s = sin(y(1));
    const R across = (1 - y(0)) * y(3);
    Eigen::Matrix<R, 4, 1> state;
    state << (1 - y(0)) * c, (1 - y(0)) * s, -y(2) * c - across * s, -y(2) * s + across * c;
    return state;
  }
};

/// Force on the journal along r and r turned [N], and the couple of friction [N m].
template <class R>
struct RadialForce {
  R radial;
  R across;
  R couple;
};

/// What a piece of a motion knows of its journal.
template <class R>
struct PieceOf {
  const JournalForces<R>& forces;
  R velocity_scale;  ///< [clearances/s]
  Region region;
  int side;
  R impact_speed;

  /// At gap, with the rates of e/c along r and across, and the spin.
  RadialForce<R> force(const R& gap, const R& radial_rate, const R& across_rate, const R& spin) const {
    RadialForce<R> sum{R(0), R(0), R(0)};
    const R weight = region == Region::film ? R(0) : region == Region::dry ? R(1) : R(-gap / forces.blend);
    if (region != Region::dry) {
      const R slip = -2 * (across_rate - spin / 2 * (1 - gap));
      const auto film = forces.film(gap, slip, radial_rate, side);
      sum.radial += (1 - weight) * film[0];
      sum.across += (1 - weight) * film[1];
    }
    if (region != Region::film) {
      const auto dry = forces.dry(gap, radial_rate, across_rate, spin, impact_speed);
      sum.radial += weight * dry[0];
      sum.across += weight * dry[1];
      sum.couple += weight * dry[2];
    }
    return sum;
  }

  static R noise() { return 1000 * std::numeric_limits<R>::epsilon(); }

  /// Seams of the contact outwards and inwards, as margins.
  void seams(const R& gap, R& outwards, R& inwards) const {
    if (!forces.has_contact) return;
    if (region == Region::film) outwards = gap;
    if (region == Region::blend) outwards = gap + forces.blend;
    if (region == Region::blend) inwards = -gap;
    if (region == Region::dry) inwards = -gap - forces.blend;
  }
};

/// Into the polar coordinates at this distance, and back out of them.
inline constexpr double chart_in = 0.6;
inline constexpr double chart_out = 0.4;

/// Away from the wall: ê, w, spin.
template <class R>
struct PlaneSystem : PieceOf<R> {
  using PieceOf<R>::forces;
  using Scalar = R;
  static constexpr int size = 5;
  using State = Eigen::Matrix<R, 5, 1>;

  State rate(const R&, const State& y) const {
    using std::sqrt;
    const Pair<R> e(y(0), y(1));
    const Pair<R> w(y(2), y(3));
    const R mean = y(4) / 2;
    const Pair<R> u(R(w.x() + mean * e.y()), R(w.y() - mean * e.x()));
    const R distance = sqrt(e.dot(e));
    const R speed = sqrt(u.dot(u));
    Pair<R> r(R(1), R(0));
    if (distance > 0) {
      r = e / distance;
    } else if (speed > 0) {
      r = u / speed;
    }
    const RadialForce<R> f = this->force(R(1 - distance), w.dot(r), w.dot(turned(r)), y(4));
    const Pair<R> force = f.radial * r + f.across * turned(r);
    State d;
    d << y(2), y(3), (force.x() + forces.load.x()) / forces.inertia, (force.y() + forces.load.y()) / forces.inertia,
        forces.spin_rate + f.couple / forces.turning_inertia;
    return d;
  }

  State scale(const State& y) const {
    using std::abs;
    State s;
    s << R(1), R(1), this->velocity_scale, this->velocity_scale, std::max(R(1), R(abs(y(4))));
    return s;
  }

  std::array<R, 4> margins(const R&, const State& y) const {
    using std::sqrt;
    std::array<R, 4> m = {R(1), R(1), R(1), R(1)};
    const R mean = y(4) / 2;
    const R ux = y(2) + mean * y(1);
    const R uy = y(3) - mean * y(0);
    // Sine and cosine of the angle from e to u.
    const R sizes = sqrt(R(y(0) * y(0) + y(1) * y(1))) * sqrt(R(ux * ux + uy * uy));
    if (this->forces.jumps()) m[0] = sizes > 0 ? R(-this->side * (y(0) * uy - y(1) * ux) / sizes) : R(0);
    if (this->forces.kinks()) m[0] = sizes > 0 ? R(this->side * (y(0) * ux + y(1) * uy) / sizes) : R(0);
    m[3] = R(chart_in) - sqrt(R(y(0) * y(0) + y(1) * y(1)));
    return m;
  }
};

/// Near the wall: g, γ, their rates, spin.
///   g̈ = −(1 − g) γ̇² − (F_r + W·r)/(m c),   (1 − g) γ̈ = 2 ġ γ̇ + (F_t + W·t)/(m c)
template <class R>
struct WallSystem : PieceOf<R> {
  using PieceOf<R>::forces;
  using Scalar = R;
  static constexpr int size = 5;
  using State = Eigen::Matrix<R, 5, 1>;

  State rate(const R&, const State& y) const {
    using std::cos;
    using std::sin;
    const R distance = 1 - y(0);
    const RadialForce<R> f = this->force(y(0), R(-y(2)), R(distance * y(3)), y(4));
    const R c = cos(y(1));
    const R s = sin(y(1));
    const R radial = f.radial + forces.load.x() * c + forces.load.y() * s;
    const R across = f.across - forces.load.x() * s + forces.load.y() * c;
    State d;
    d << y(2), y(3), -distance * y(3) * y(3) - radial / forces.inertia,
        (2 * y(2) * y(3) + across / forces.inertia) / distance, forces.spin_rate + f.couple / forces.turning_inertia;
    return d;
  }

  State scale(const State& y) const {
    using std::abs;
    const R gap = this->forces.has_contact ? R(1) : y(0);
    State s;
    s << gap, R(1), rate_of_gap(y, gap), this->velocity_scale, std::max(R(1), R(abs(y(4))));
    return s;
  }

  /// What ġ is measured by: the rate at which a motion as fast as this one closes such a gap.
  R rate_of_gap(const State& y, const R& gap) const {
    using std::abs;
    return std::max(R(this->velocity_scale * gap), R(abs(y(2))));
  }

  std::array<R, 4> margins(const R&, const State& y) const {
    std::array<R, 4> m = {R(1), R(1), R(1), R(1)};
    using std::sqrt;
    const R across = (1 - y(0)) * (y(3) - y(4) / 2);
    const R speed = sqrt(R(across * across + y(2) * y(2)));
    if (this->region != Region::dry && this->forces.jumps()) m[0] = speed > 0 ? R(-this->side * across / speed) : R(0);
    if (this->region != Region::dry && this->forces.kinks()) m[0] = -this->side * y(2) / scale(y)(2);
    this->seams(y(0), m[1], m[2]);
    m[3] = (1 - y(0)) - R(chart_out);
    return m;
  }
};

/// On a = 0, where the line of centres turns with the mean spin (Filippov's sliding): the film's tangential force is
/// whatever keeps the journal there, as long as a half film on either side could give it.
/// State: x, ẋ, γ, spin; x is the place ρ along n, below zero beyond the centre, or near the wall the gap 1 − ρ.
template <class R>
struct LineSystem : PieceOf<R> {
  using PieceOf<R>::forces;
  using Scalar = R;
  static constexpr int size = 4;
  using State = Eigen::Matrix<R, 4, 1>;
  bool wall;

  struct Here {
    Pair<R> n;
    R place;   ///< ρ
    R rate;    ///< ρ̇
    R radial;  ///< film and contact along n
    R dry_across;
    R couple;
    R needed;  ///< of the film along n turned, to keep a = 0
    R reach;   ///< what the film could give
  };

  Here at(const State& y) const {
    using std::abs;
    using std::cos;
    using std::sin;
    Here here;
    here.n = {cos(y(2)), sin(y(2))};
    here.place = wall ? R(1 - y(0)) : y(0);
    here.rate = wall ? R(-y(1)) : y(1);
    const R sign = here.place < 0 ? R(-1) : R(1);
    const R gap = wall ? y(0) : R(1 - abs(y(0)));
    const R mean = y(3) / 2;
    const R weight = this->region == Region::blend ? R(-gap / forces.blend) : R(0);
    const auto film = forces.film(gap, R(0), R(sign * here.rate), 1);
    std::array<R, 3> dry = {R(0), R(0), R(0)};
    if (weight > 0) {
      dry = forces.dry(gap, R(sign * here.rate), R(mean * abs(here.place)), y(3), this->impact_speed);
    }
    here.radial = sign * ((1 - weight) * film[0] + weight * dry[0]);
    here.dry_across = sign * weight * dry[1];
    here.couple = weight * dry[2];
    here.reach = (1 - weight) * film[1];
    const R spin_rate = forces.spin_rate + here.couple / forces.turning_inertia;
    here.needed = forces.inertia * (2 * mean * here.rate + spin_rate / 2 * here.place) -
                  forces.load.dot(turned(here.n)) - here.dry_across;
    return here;
  }

  State rate(const R&, const State& y) const {
    const Here here = at(y);
    const R mean = y(3) / 2;
    const R outwards = mean * mean * here.place + (here.radial + forces.load.dot(here.n)) / forces.inertia;
    State d;
    d << y(1), (wall ? R(-outwards) : outwards), mean, forces.spin_rate + here.couple / forces.turning_inertia;
    return d;
  }

  State scale(const State& y) const {
    using std::abs;
    const R place = wall && !this->forces.has_contact ? y(0) : R(1);
    State s;
    using std::sqrt;
    s << place, std::max(R(this->velocity_scale * place * place * sqrt(place)), R(abs(y(1)))), R(1),
        std::max(R(1), R(abs(y(3))));
    return s;
  }

  std::array<R, 4> margins(const R&, const State& y) const {
    using std::abs;
    const Here here = at(y);
    const R unit = abs(here.reach) + abs(here.needed) + std::numeric_limits<R>::min();
    std::array<R, 4> m = {R((here.reach - abs(here.needed)) / unit), R(1), R(1), R(1)};
    if (wall) this->seams(y(0), m[1], m[2]);
    m[3] = wall ? R(here.place - R(chart_out)) : R(R(chart_in) - abs(y(0)));
    return m;
  }
};

}  // namespace lubjoint::reports::stress_reference
