// C++17: see rosenbrock4.hpp.
#include "rosenbrock4.hpp"

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <utility>

namespace lubjoint::detail {

namespace {

namespace odeint = boost::numeric::odeint;
using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;

struct CorrectedCoefficients : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.3620000000000023e-01;  // hides the base's
};

}  // namespace

struct Rosenbrock4::Implementation {
  using Stepper = odeint::rosenbrock4<double, CorrectedCoefficients>;

  Implementation(std::size_t n, double absolute, double relative) : controller(absolute, relative), state(n) {}

  odeint::rosenbrock4_controller<Stepper> controller;
  Vector state;
};

Rosenbrock4::Rosenbrock4(std::size_t n, double absolute, double relative)
    : implementation_(std::make_unique<Implementation>(n, absolute, relative)) {}

Rosenbrock4::~Rosenbrock4() = default;

bool Rosenbrock4::try_step(const RosenbrockProblem& problem, double* z, double& t, double& dt) {
  Vector& state = implementation_->state;
  std::copy(z, z + state.size(), state.begin());
  const auto rate = [&](const Vector& x, Vector& dxdt, double s) { problem.rate(problem.context, &x[0], &dxdt[0], s); };
  const auto derivatives = [&](const Vector& x, Matrix& j, double s, Vector& slope) {
    problem.derivatives(problem.context, &x[0], &j.data()[0], &slope[0], s);
  };
  const bool accepted =
      implementation_->controller.try_step(std::make_pair(rate, derivatives), state, t, dt) == odeint::success;
  if (accepted) std::copy(state.begin(), state.end(), z);
  return accepted;
}

}  // namespace lubjoint::detail
