/// A journal in a fixed bearing, from piece to piece of its motion: the film on one side or the other, sliding on a
/// half film's jump, the blend of film and contact, dry contact, and back. Written for this purpose from the published
/// polar forms; it shares no force law, contact or event logic with lib.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lubjoint/film/law_facts.hpp"
#include "oracle/laws/published_forms.hpp"
#include "oracle/measure/stress/reference_methods.hpp"

namespace lubjoint::reports::stress_reference {

template <class R>
using Pair = Eigen::Matrix<R, 2, 1>;

template <class R>
Pair<R> turned(const Pair<R>& v) {
  return {R(-v.y()), v.x()};
}
template <class R>
R wedge(const Pair<R>& a, const Pair<R>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Surfaces that may touch.
struct ContactNumbers {
  double bearing_modulus, bearing_poisson, journal_modulus, journal_poisson;
  double restitution, friction, slow_sliding, min_impact_speed;
  double blend;     ///< e₀ [m]
  double widening;  ///< e₁ [m]
};

/// A journal's problem in a scene's own numbers: doubles, read exactly.
struct JournalNumbers {
  std::string law;
  double length, journal_radius, clearance, viscosity;
  double mass, inertia;
  std::array<double, 2> load;     ///< [N]
  std::array<double, 2> gravity;  ///< [m/s²]
  std::array<double, 2> place;    ///< e at the start [m]
  std::array<double, 2> velocity;
  double spin;
  double spin_rate = 0;  ///< of a motor [rad/s²]
  std::optional<ContactNumbers> contact;
};

enum class Region { film, blend, dry };

/// The journal's constants and forces; places in clearances, rates in clearances a second.
template <class R>
class JournalForces {
 public:
  explicit JournalForces(const JournalNumbers& n)
      : law_(n.law), inertia(R(n.mass) * R(n.clearance)), turning_inertia(n.inertia), spin_rate(n.spin_rate) {
    const R c(n.clearance);
    clearance_ = c;
    radius_ = R(n.journal_radius);
    const R film_clearance = n.contact ? R(c + R(n.contact->widening)) : c;
    film_share_ = c / film_clearance;
    const R arm = law_facts(law_).is_short() ? R(n.length) : radius_;
    scale = R(n.viscosity) * R(n.length) * radius_ * arm * arm / (film_clearance * film_clearance);
    load = {R(n.load[0]) + R(n.mass) * R(n.gravity[0]), R(n.load[1]) + R(n.mass) * R(n.gravity[1])};
    has_contact = n.contact.has_value();
    if (!has_contact) return;
    const ContactNumbers& k = *n.contact;
    const auto compliance = [](double modulus, double poisson) {
      return R((1 - R(poisson)) * (1 + R(poisson)) / R(modulus));
    };
    using std::sqrt;
    stiffness_ = R(4) / 3 * sqrt(R((radius_ + c) * radius_ / c)) /
                 (compliance(k.bearing_modulus, k.bearing_poisson) + compliance(k.journal_modulus, k.journal_poisson));
    loss_ = R(3) / 4 * (1 - R(k.restitution)) * (1 + R(k.restitution));
    friction_ = R(k.friction);
    slow_ = R(k.slow_sliding);
    min_impact_speed = R(k.min_impact_speed);
    blend = R(k.blend) / c;
  }

  bool jumps() const { return law_.find("half") != std::string::npos; }
  /// Pinkus–Sternlicht: once differentiable where ε̇ changes sign.
  bool kinks() const { return law_ == "pinkus_sternlicht"; }
  bool sides() const { return jumps() || kinks(); }
  const R& clearance() const { return clearance_; }

  /// F_r and F_t of the film [N] at 1 − |e|/c = gap, from slip and squeeze rates of the eccentricity e/c.
  /// @param side  half films: +1 where a > 0; Pinkus–Sternlicht: the sign of ε̇, continued smoothly beyond its zero
  std::array<R, 2> film(const R& gap, const R& slip, const R& squeeze, int side) const {
    // ε = (1 − gap) c/(c + e₁)
    const R film_gap = (1 - film_share_) + gap * film_share_;
    if (!(film_gap > 0)) throw std::domain_error("beyond the wall");
    const R a = slip * film_share_;
    const R b = squeeze * film_share_;
    if (a == 0 && b == 0) return {R(0), R(0)};
    if (kinks()) return pinkus_sternlicht(film_gap, a, b, side);
    if (law_.ends_with("dynamic")) return quadruple(film_gap, a, b);
    return summed(published_terms_at<R>(law_, R(1 - film_gap), R(film_gap * (2 - film_gap)), a, b, side));
  }

  /// Normal and tangential force of the dry contact on the journal, along r and r turned; the couple of friction.
  std::array<R, 3> dry(const R& gap, const R& radial_rate, const R& across_rate, const R& spin,
                       const R& impact_speed) const {
    using std::sqrt;
    const R depth = -gap * clearance_;
    if (!(depth > 0)) return {R(0), R(0), R(0)};
    const R damping = 1 + loss_ * (radial_rate * clearance_) / impact_speed;
    if (!(damping > 0)) return {R(0), R(0), R(0)};
    const R normal = stiffness_ * depth * sqrt(depth) * damping;
    const R sliding = across_rate * clearance_ + spin * radius_;
    const R along = friction_ == 0 ? R(0) : R(-friction_ * normal * sliding / sqrt(sliding * sliding + slow_ * slow_));
    return {-normal, along, radius_ * along};
  }

 private:
  std::string law_;
  R clearance_{};
  R radius_{};
  R film_share_{};
  R stiffness_{};
  R loss_{};
  R friction_{};
  R slow_{};

  template <class T>
  std::array<R, 2> summed(const PublishedTerms<T>& terms) const {
    std::array<R, 2> sum = {R(0), R(0)};
    for (const T& each : terms.radial) sum[0] += R(each);
    for (const T& each : terms.tangential) sum[1] += R(each);
    return {scale * sum[0], scale * sum[1]};
  }
  /// The dynamic laws' integrals cancel in thin films: always in quadruple precision.
  std::array<R, 2> quadruple(const R& gap, const R& a, const R& b) const {
    const Quad g(gap);
    const auto terms = published_terms_at<Quad>(law_, Quad(1 - g), Quad(g * (2 - g)), Quad(a), Quad(b), 0);
    Quad radial = 0;
    Quad tangential = 0;
    for (const Quad& each : terms.radial) radial += each;
    for (const Quad& each : terms.tangential) tangential += each;
    return {scale * R(radial), scale * R(tangential)};
  }
  std::array<R, 2> pinkus_sternlicht(const R& gap, const R& a, const R& b, int side) const {
    using std::sqrt;
    const R& pi = boost::math::constants::pi<R>();
    const R epsilon = 1 - gap;
    const R q = gap * (2 - gap);
    const R d = 2 + epsilon * epsilon;
    const R root = sqrt(q);
    const R k = root * sqrt(R(a * a / 4 + b * b));
    const R opening = epsilon * b;
    const R phi = side < 0 ? R(k / (k - R(3) / 2 * opening)) : R((k + 3 * opening) / (k + R(3) / 2 * opening));
    const R q32 = q * root;
    return {scale * (-24 * epsilon * k / (d * q32) - 6 * pi * b * phi / q32), scale * (6 * pi * a * phi / (d * root))};
  }

 public:
  R scale{};
  R inertia{};  ///< m c
  R turning_inertia{};
  R spin_rate{};
  Pair<R> load;
  bool has_contact = false;
  R min_impact_speed{};
  R blend{};  ///< e₀/c
};

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
      s.y(component) += share * plane(s).scale(s.y)(component);
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
        move(s, plane(s), goal);
      }
    }
  }

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
    const auto d = plane(s).rate(s.t, s.y);
    return forces_.inertia * Pair<R>(d(2), d(3)) - forces_.load;
  }

 private:
  PieceOf<R> piece_of(const Situation<R>& s) const {
    return {forces_, velocity_scale_, s.region, s.side, s.impact_speed};
  }
  PlaneSystem<R> plane(const Situation<R>& s) const { return {piece_of(s)}; }
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
        const auto d = plane(s).rate(s.t, s.y);
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
