/// Geometry of a journal bearing and the lubricant in it.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "lubjoint/number/scalar.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

namespace detail {
template <class R>
void require_positive(const char* name, const R& given, const char* unit) {
  using std::isfinite;
  if (isfinite(given) && given > 0) return;
  Message message;
  message << name << " is " << given << " " << unit << "; allowed is a finite number above 0";
  throw std::invalid_argument(message.str());
}
}  // namespace detail

/// A plain cylindrical bearing of 360°: length L, journal radius R, radial clearance c, all in metres; c < R.
template <class R>
class Bearing {
 public:
  /// @throws std::invalid_argument that names the field, the value and what is allowed
  Bearing(const R& length, const R& radius, const R& clearance)
      : length_(length), radius_(radius), clearance_(clearance) {
    detail::require_positive("length", length, "m");
    detail::require_positive("radius", radius, "m");
    detail::require_positive("clearance", clearance, "m");
    if (clearance < radius) return;
    Message message;
    message << "clearance is " << clearance << " m; allowed is less than the journal radius, " << radius << " m";
    throw std::invalid_argument(message.str());
  }

  const R& length() const { return length_; }        ///< L [m]
  const R& radius() const { return radius_; }        ///< R, of the journal [m]
  const R& clearance() const { return clearance_; }  ///< c, radial [m]

 private:
  R length_;
  R radius_;
  R clearance_;
};

/// An isoviscous, incompressible oil of dynamic viscosity μ [Pa·s].
template <class R>
class Lubricant {
 public:
  /// @throws std::invalid_argument if the viscosity is not a positive finite number
  explicit Lubricant(const R& viscosity) : viscosity_(viscosity) {
    detail::require_positive("viscosity", viscosity, "Pa s");
  }
  const R& viscosity() const { return viscosity_; }  ///< μ [Pa s]

 private:
  R viscosity_;
};

/// Which term of Reynolds' equation is left out: the flow around (short) or the flow along the axis (long).
enum class BearingLimit { short_bearing, long_bearing };

/// Force scale S [N s]: μRL³/c² (short) or μLR³/c² (long), rounded once.
template <class R>
R force_scale(BearingLimit limit, const Bearing<R>& bearing, const Lubricant<R>& lubricant) {
  using Wide = typename ExtendedFor<R>::Type;
  const Wide length(bearing.length());
  const Wide radius(bearing.radius());
  const Wide clearance(bearing.clearance());
  const Wide product = Wide(lubricant.viscosity()) * length * radius;
  const Wide ratio = (limit == BearingLimit::short_bearing ? length : radius) / clearance;
  return static_cast<R>(product * ratio * ratio);
}

}  // namespace lubjoint
