/// Odeint's rosenbrock4 behind plain functions: it needs uBLAS, which Boost 1.74 has for C++17 only.
#pragma once

#include <cstddef>
#include <memory>

namespace lubjoint::detail {

/// ż = f(z, t), J = ∂f/∂z by rows, and ∂f/∂t; they may throw.
struct RosenbrockProblem {
  void* context;
  void (*rate)(void* context, const double* z, double* dzdt, double t);
  void (*derivatives)(void* context, const double* z, double* jacobian, double* time_slope, double t);
};

/// Rosenbrock's method RODAS of order 4(3), L-stable, with the coefficient d₄ = −0.0362: Odeint's has the other sign,
/// which leaves order 1 where f depends on time.
class Rosenbrock4 {
 public:
  /// @param tolerance  of every z_i: absolute + relative |z_i|
  Rosenbrock4(std::size_t n, double absolute, double relative);
  ~Rosenbrock4();

  bool try_step(const RosenbrockProblem& problem, double* z, double& t, double& dt);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace lubjoint::detail
