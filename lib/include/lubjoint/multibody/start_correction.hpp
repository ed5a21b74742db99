#pragma once

namespace lubjoint {

/// What bringing the start onto the constraints has changed.
template <class R>
struct StartCorrection {
  R position = R(0);  ///< largest displacement of a mass centre [m]
  R angle = R(0);     ///< largest turn of a body [rad]
  R velocity = R(0);  ///< largest change of a mass centre's velocity [m/s]
  R spin = R(0);      ///< [rad/s]
};

}  // namespace lubjoint
