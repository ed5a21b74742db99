/// A number and what is known of its error.
#pragma once

namespace lubjoint::oracle {

/// A computed value; the exact one is expected within value ± error.
struct Estimate {
  double value = 0;
  double error = 0;  ///< absolute, not negative, in the unit of the value
};

/// How closely an integral is asked for: whichever of the two is larger decides.
struct Tolerance {
  double relative = 1e-10;
  double absolute = 0;
};

}  // namespace lubjoint::oracle
