/// A system in units of its tolerances, for integrators that know one tolerance for all states.
#pragma once

#include "lubjoint/dynamics/integrator.hpp"

namespace lubjoint {

/// States z_i = y_i / s_i, s_i = absolute_i / nominal: an absolute tolerance `nominal` on every z_i is absolute_i on y_i.
template <class R, std::size_t N>
class ScaledSystem {
 public:
  using System = OdeSystem<R, N>;
  using State = StateOf<R, N>;

  explicit ScaledSystem(const StepTolerance<R, N>& tolerance) : scale_(tolerance.absolute), y_(scale_) {
    for (R& s : scale_) s /= tolerance.nominal;
  }

  void scale(const State& y, State& z) const {
    z = y;
    for (std::size_t i = 0; i < z.size(); ++i) z[i] /= scale_[i];
  }
  void unscale(const State& z, State& y) const {
    y = z;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] *= scale_[i];
  }

  /// dz/dt of the system at z.
  void rate(System& system, const State& z, State& dzdt, const R& t) {
    unscale(z, y_);
    system.rate(y_, dzdt, t);
    for (std::size_t i = 0; i < dzdt.size(); ++i) dzdt[i] /= scale_[i];
  }
  const State& scales() const { return scale_; }

 private:
  State scale_;
  State y_;
};

}  // namespace lubjoint
