/// Forces on a journal for reference motions: films by their published polar forms, and dry contact. Written for this
/// purpose; they share no force law and no contact with lib.
#pragma once

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
  double length = 0, journal_radius = 0, clearance = 0, viscosity = 0;
  double mass = 1;
  double inertia = 1;
  std::array<double, 2> load{};     ///< [N]
  std::array<double, 2> gravity{};  ///< [m/s²]
  std::array<double, 2> place{};    ///< e at the start [m]
  std::array<double, 2> velocity{};
  double spin = 0;
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
  bool kinks() const { return law_facts(law_).kinks; }
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

}  // namespace lubjoint::reports::stress_reference
