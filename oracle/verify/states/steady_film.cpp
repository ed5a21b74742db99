#include "oracle/verify/states/steady_film.hpp"

#include <cmath>

namespace lubjoint::verify {

using Real = long double;

Real SteadySlopes::size() const { return std::hypot(radial, tangential); }

Real SteadySlopes::size_by_ratio() const {
  return (radial * (radial_by_ratio + radial_by_slip) + tangential * (tangential_by_ratio + tangential_by_slip)) /
         size();
}

PolarCoefficients polar_coefficients(const SteadySlopes& f, Real ratio, int spin_sign) {
  const auto sign = static_cast<Real>(spin_sign);
  return {
      {-(f.radial_by_ratio + f.radial_by_slip), sign * f.tangential / ratio,
       -sign * (f.tangential_by_ratio + f.tangential_by_slip), -f.radial / ratio},
      {-f.radial_by_squeeze, sign * 2 * f.radial_by_slip, -sign * f.tangential_by_squeeze, 2 * f.tangential_by_slip}};
}

Entries in_inertial_axes(const Entries& polar, Real sine, Real cosine) {
  // r = (sine, −cosine), t = (cosine, sine), the columns of a matrix Q: Q M Qᵀ.
  const Real q[2][2] = {{sine, cosine}, {-cosine, sine}};
  Entries m{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int k = 0; k < 2; ++k) {
        for (int l = 0; l < 2; ++l) {
          m[static_cast<std::size_t>(2 * i + j)] += q[i][k] * polar[static_cast<std::size_t>(2 * k + l)] * q[j][l];
        }
      }
    }
  }
  return m;
}

}  // namespace lubjoint::verify
