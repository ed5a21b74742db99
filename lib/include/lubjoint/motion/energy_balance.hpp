/// Energy of a system in motion, and what a run's ledger leaves unexplained of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lubjoint {

/// Kinetic energy, and potential energy of weights and springs [J].
template <class R>
struct MechanicalEnergy {
  R kinetic;    ///< of all bodies
  R potential;  ///< of all weights and springs
};

/// E − E₀ − work along a run.
template <class R>
class EnergyBalance {
 public:
  /// Of E₀.
  void start(const MechanicalEnergy<R>& energy) { start_ = energy.kinetic + energy.potential; }

  /// At the end of a step.
  /// @param y  the state, whose numbers from first_work on are the work of each term
  void note(const MechanicalEnergy<R>& energy, const std::vector<R>& y, std::size_t first_work) {
    R residual = energy.kinetic + energy.potential - start_;
    scale_ = std::max(scale_, static_cast<double>(energy.kinetic));
    for (std::size_t i = first_work; i < y.size(); ++i) {
      residual -= y[i];
      scale_ = std::max(scale_, std::abs(static_cast<double>(y[i])));
    }
    residual_ = std::max(residual_, std::abs(static_cast<double>(residual)));
  }

  double residual() const { return residual_; }  ///< largest |E − E₀ − work| [J]
  double scale() const { return scale_; }        ///< largest kinetic energy or work [J]

 private:
  R start_{};
  double residual_ = 0;
  double scale_ = 0;
};

}  // namespace lubjoint
