/// A system in units of its tolerances, for integrators that know one tolerance for all states.
#pragma once

#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// States z_i = y_i / s_i, s_i = absolute_i / nominal: an absolute tolerance `nominal` on every z_i is absolute_i on
/// y_i. Integrals that control no step are in units in which they are next to nothing.
template <class R, std::size_t N>
class ScaledSystem {
 public:
  using System = OdeSystem<R, N>;  ///< in its own units
  using State = StateOf<R, N>;     ///< of the system

  /// Takes the scales from the tolerances.
  explicit ScaledSystem(const StepTolerance<R, N>& tolerance) : scale_(tolerance.absolute), y_(scale_), rate_(scale_) {
    for (R& s : scale_) s /= tolerance.nominal;
    for (std::size_t i = tolerance.controlled(); i < scale_.size(); ++i) scale_[i] *= R(beyond_control);
  }

  /// z of a state.
  /// @tparam Scaled  the state type of z
  template <class Scaled>
  void scale(const State& y, Scaled& z) const {
    for (std::size_t i = 0; i < y.size(); ++i) z[i] = y[i] / scale_[i];
  }
  /// The state of z.
  template <class Scaled>
  void unscale(const Scaled& z, State& y) const {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = z[i] * scale_[i];
  }

  /// dz/dt of the system at z.
  template <class Scaled>
  void rate(System& system, const Scaled& z, Scaled& dzdt, const R& t) {
    unscale(z, y_);
    system.rate(y_, rate_, t);
    scale(rate_, dzdt);
  }
  const State& scales() const { return scale_; }  ///< s

 private:
  /// In units so large no error of an integral counts.
  static constexpr double beyond_control = 1e30;

  State scale_;
  State y_, rate_;
};

}  // namespace lubjoint
