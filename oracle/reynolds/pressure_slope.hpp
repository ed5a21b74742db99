/// Long film with p = 0 at both ends: its differential equation, integrated once.
#pragma once

#include <cmath>
#include <cstddef>

#include "oracle/reynolds/film_rule.hpp"
#include "oracle/reynolds/narrow_gap.hpp"

namespace lubjoint::oracle {

/// H³ dp/dφ = −k (G + C). G and the moments are written in X = sin d and Y = 1 − cos d, d = φ − φ₀ with φ₀ the place of
/// the film nearest to the minimum film. There the weight 1/H³ sits, and there X and Y are small and exact:
///   G − G(φ₀) = g₀ X + g₀' Y,   g = a sinθ − 2b cosθ,   g₀ = 0 where φ₀ is an edge of the dynamic film.
class PressureSlope {
 public:
  /// Coordinates and weight of one place.
  struct Place {
    double x;       ///< sin d
    double y;       ///< 1 − cos d
    double weight;  ///< 1/H³
  };

  PressureSlope(const NarrowGap& gap, const FilmWindow& window, bool edges_are_zeros)
      : gap_(gap), origin_(window.narrowest()) {
    const GapPlace place = gap.at(origin_);
    const bool at_a_zero = edges_are_zeros && (origin_ == window.from || origin_ == window.to);
    source_ = at_a_zero ? 0 : place.source();
    source_slope_ = -gap.slip() * place.cos - 2 * gap.squeeze() * place.sin;
    sin_origin_ = place.sin;
    cos_origin_ = place.cos;
  }

  Place at(double phi) const {
    const double d = phi - origin_;
    const double s = std::sin(0.5 * d);
    return {2 * s * std::cos(0.5 * d), 2 * s * s, 1 / gap_.at(phi).cubed_thickness()};
  }

  double g(const Place& p) const { return source_ * p.x + source_slope_ * p.y; }
  double g_magnitude(const Place& p) const { return std::abs(source_ * p.x) + std::abs(source_slope_ * p.y); }

  double sin_origin() const { return sin_origin_; }
  double cos_origin() const { return cos_origin_; }

 private:
  NarrowGap gap_;
  double origin_;
  double source_;
  double source_slope_;
  double sin_origin_;
  double cos_origin_;
};

/// Means with weight 1/H³; C = −mean of G.
struct WeightedMeans {
  double x = 0;
  double y = 0;
};

}  // namespace lubjoint::oracle
