/// The film seen from its narrowest place, where all its digits are needed.
///
/// φ = θ − π is measured from the minimum film. There H = (1 − ε) + 2ε sin²(φ/2) has a dip of width √(2(1 − ε)), and
/// θ itself, rounded near π, would no longer know where in the dip it is. All integrals run over φ.
#pragma once

#include <algorithm>
#include <cmath>

#include "lubjoint/film/film_state.hpp"

namespace lubjoint::oracle {

/// What the gap and the motion are at a place φ of the film.
struct GapPlace {
  double sin;           ///< sinφ = −sinθ
  double cos;           ///< cosφ = −cosθ
  double thickness;     ///< H = h/c [-]
  double wedge;         ///< a sinθ [1/s]
  double squeeze;       ///< −2b cosθ [1/s]
  double one_plus_cos;  ///< 1 + cosφ = 1 − cosθ

  /// a sinθ − 2b cosθ, the right-hand side of Reynolds' equation over −6μ/c² [1/s]
  double source() const { return wedge + squeeze; }
  double source_magnitude() const { return std::abs(wedge) + std::abs(squeeze); }
  double cubed_thickness() const { return thickness * thickness * thickness; }
};

/// Gap and motion of one state.
class NarrowGap {
 public:
  explicit NarrowGap(const PolarFilmState<double>& state)
      : epsilon_(state.eccentricity_ratio),
        slip_(state.slip_rate),
        squeeze_(state.squeeze_rate),
        thinnest_(state.q / (1 + epsilon_)),
        dip_ratio_(std::sqrt(state.q) / (1 + epsilon_)),
        dip_width_(std::min(4.0, 2 * std::atanh(std::min(dip_ratio_, 0.999)))) {}

  GapPlace at(double phi) const {
    const double s = std::sin(0.5 * phi);
    const double c = std::cos(0.5 * phi);
    const double sine = 2 * s * c;
    const double cosine = (c - s) * (c + s);
    return {sine, cosine, thinnest_ + 2 * epsilon_ * s * s, -slip_ * sine, 2 * squeeze_ * cosine, 2 * c * c};
  }

  double epsilon() const { return epsilon_; }
  double slip() const { return slip_; }
  double squeeze() const { return squeeze_; }
  double thinnest() const { return thinnest_; }    ///< 1 − ε = q/(1 + ε)
  double dip_ratio() const { return dip_ratio_; }  ///< √((1 − ε)/(1 + ε))

  /// Distance from the real axis at which H has its zeros, arcosh(1/ε) = 2 artanh √((1 − ε)/(1 + ε)): the width of the
  /// dip. Held at 4 as ε → 0, where there is no dip.
  double dip_width() const { return dip_width_; }

 private:
  double epsilon_;
  double slip_;
  double squeeze_;
  double thinnest_;
  double dip_ratio_;
  double dip_width_;
};

/// The part of the film that carries pressure, in φ [rad].
struct FilmWindow {
  double from;
  double to;

  /// The place of the window that is nearest to the minimum film.
  double narrowest() const { return std::clamp(0.0, from, to); }
};

/// The variable t in which integrals over the film are smooth: φ = φ₀ + w sinh t, with φ₀ the place of the window that
/// is nearest to the minimum film and w² = (width of the dip)² + φ₀². The zeros of H, where the pressure has its poles,
/// are then about 1 away from the path whatever ε, and the distance from φ₀ keeps all its digits.
class StretchedAngle {
 public:
  StretchedAngle(const NarrowGap& gap, const FilmWindow& window)
      : origin_(window.narrowest()), width_(std::hypot(gap.dip_width(), origin_)) {}

  double stretched(double phi) const { return std::asinh((phi - origin_) / width_); }
  double origin() const { return origin_; }

  struct Place {
    double phi;
    double rate;  ///< dφ/dt
  };
  Place at(double t) const {
    const double s = std::sinh(t);
    return {origin_ + width_ * s, width_ * std::sqrt(1 + s * s)};
  }

 private:
  double origin_;
  double width_;
};

}  // namespace lubjoint::oracle
