/// A free journal's equations of motion in quadruple precision, from the published polar forms: in the plane, and on
/// the line of centres along which a half film lets it slide.
#pragma once

#include <array>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "lubjoint/film/law_facts.hpp"
#include "oracle/laws/published_forms.hpp"
#include "oracle/trajectories/journal_trajectory.hpp"

namespace lubjoint::reports::journal_reference {

using Real = boost::multiprecision::float128;
template <std::size_t N>
using State = std::array<Real, N>;

/// All constants of a case, and the law.
class Journal {
 public:
  Journal(const std::string& law, const JournalCase& c) : law_(law) {
    const Real l(c.length);
    const Real r(c.journal_radius);
    const Real gap(c.clearance);
    const Real product = Real(c.viscosity) * l * r;
    scale = product * (law_facts(law).is_short() ? Real(l * l) : Real(r * r)) / (gap * gap);
    inertia = Real(c.mass) * gap;
    for (std::size_t i = 0; i < 2; ++i) load[i] = Real(c.load[i]) + Real(c.mass) * Real(c.gravity[i]);
    spin = Real(c.spin) / 2;
  }

  bool jumps() const { return law_.find("half") != std::string::npos; }
  /// Pinkus–Sternlicht is once differentiable where ε̇ changes sign: an integrator of high order must stop there.
  bool kinks() const { return law_facts(law_).kinks; }

  /// F_r/S, F_t/S with the half film on the side of the sign given.
  std::array<Real, 2> ratio(const Real& epsilon, const Real& a, const Real& b, int side) const {
    const auto terms = published_terms<Real>(law_, epsilon, a, b, side);
    std::array<Real, 2> sum = {Real(0), Real(0)};
    for (const Real& term : terms.radial) sum[0] += term;
    for (const Real& term : terms.tangential) sum[1] += term;
    return sum;
  }

  /// Force at ê, w; side 0 reads it off the sign of a.
  std::array<Real, 2> force(const State<4>& y, int side) const {
    const Real ux = y[2] + spin * y[1];
    const Real uy = y[3] - spin * y[0];
    const Real epsilon = sqrt(y[0] * y[0] + y[1] * y[1]);
    const Real speed = sqrt(ux * ux + uy * uy);
    if (speed == 0) return {Real(0), Real(0)};
    if (epsilon >= 1) throw std::domain_error("journal beyond the wall");
    const Real rx = epsilon == 0 ? ux / speed : y[0] / epsilon;
    const Real ry = epsilon == 0 ? uy / speed : y[1] / epsilon;
    const Real b = ux * rx + uy * ry;
    const Real a = -2 * (uy * rx - ux * ry);
    const auto f = ratio(epsilon, a, b, side);
    return {scale * (f[0] * rx - f[1] * ry), scale * (f[0] * ry + f[1] * rx)};
  }

  Real scale;
  Real inertia;  ///< m c
  std::array<Real, 2> load;
  Real spin;  ///< mean

 private:
  std::string law_;
};

/// ê, w with the film on one side, or (side 0) wherever the sign of a says.
struct PlaneMotion {
  static constexpr std::size_t dimension = 4;
  const Journal& journal;
  int side;

  void operator()(const State<4>& y, State<4>& dydt, const Real&) const {
    const auto f = journal.force(y, side);
    dydt = {y[2], y[3], (f[0] + journal.load[0]) / journal.inertia, (f[1] + journal.load[1]) / journal.inertia};
  }
};

/// ρ, ρ̇ on the line of centres, which turns with the mean spin while a = 0 (Filippov's sliding).
struct LineMotion {
  static constexpr std::size_t dimension = 2;
  const Journal& journal;
  Real t0;
  Real angle0;

  std::array<Real, 2> line(const Real& t) const {
    const Real angle = angle0 + journal.spin * (t - t0);
    return {cos(angle), sin(angle)};
  }
  Real needed(const State<2>& y, const Real& t) const {
    const auto n = line(t);
    return 2 * journal.inertia * journal.spin * y[1] - (journal.load[1] * n[0] - journal.load[0] * n[1]);
  }
  /// Radial force along the line and the tangential reach; ρ < 0 is the journal beyond the centre.
  std::array<Real, 2> film(const State<2>& y) const {
    const Real sign = y[0] < 0 ? -1 : 1;
    if (sign * y[0] >= 1) throw std::domain_error("sliding journal beyond the wall");
    const auto f = journal.ratio(Real(sign * y[0]), Real(0), Real(sign * y[1]), 1);
    return {journal.scale * sign * f[0], journal.scale * f[1]};
  }
  Real reach(const State<2>& y) const { return film(y)[1]; }
  State<4> plane(const State<2>& y, const Real& t) const {
    const auto n = line(t);
    const Real across = journal.spin * y[0];
    return {y[0] * n[0], y[0] * n[1], y[1] * n[0] - across * n[1], y[1] * n[1] + across * n[0]};
  }
  std::array<Real, 2> force(const State<2>& y, const Real& t) const {
    const auto n = line(t);
    const Real radial = film(y)[0];
    const Real tangential = needed(y, t);
    return {radial * n[0] - tangential * n[1], radial * n[1] + tangential * n[0]};
  }
  void operator()(const State<2>& y, State<2>& dydt, const Real& t) const {
    const auto n = line(t);
    const Real radial = film(y)[0];
    const Real weight = journal.load[0] * n[0] + journal.load[1] * n[1];
    dydt = {y[1], journal.spin * journal.spin * y[0] + (radial + weight) / journal.inertia};
  }
};

}  // namespace lubjoint::reports::journal_reference
