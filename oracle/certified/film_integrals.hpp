/// Rigorous integrals along the film.
#pragma once

#include <acb_calc.h>

#include "oracle/certified/film_laws.hpp"

namespace lubjoint::certified {

/// What integrands are made of at a complex θ. H = (1 − ε) + 2ε cos²(θ/2): on a ball around the minimum film its
/// enclosure is as wide as the square of the ball, where that of 1 + ε cosθ would be as wide as the ball.
struct Place {
  ComplexBall sine, cosine, h;

  Place(const ComplexBall& theta, const Ball& epsilon) {
    const auto [s, c] = sin_cos(theta / ComplexBall(Ball(2)));
    const ComplexBall square = c * c;
    sine = Ball(2) * (s * c);
    cosine = Ball(2) * square - ComplexBall(Ball(1));
    h = ComplexBall(Ball(1) - epsilon) + (2 * epsilon) * square;
  }
};

/// ∫ f(θ) dθ over a film, enclosed. f must be holomorphic wherever its value is finite: quotients of entire functions
/// are.
template <class Integrand>
Ball integral(const Integrand& f, const ExtentBalls& extent) {
  const auto call = [](acb_ptr out, const acb_t theta, void* parameter, slong, slong) {
    acb_set(out, (*static_cast<const Integrand*>(parameter))(ComplexBall(theta)).get());
    return 0;
  };
  const slong goal = working_bits();
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  // Largest error first: what a narrow peak contributes is known before places where the integrand vanishes are asked
  // for digits.
  options->use_heap = 1;
  options->depth_limit = 4 * goal;    // a film may be 1e-6 wide
  options->eval_limit = 1000 * goal;  // ends a search that no precision would help; the ball is then wide
  mag_t tolerance;
  mag_init(tolerance);  // zero: relative accuracy alone
  ComplexBall result;
  const ComplexBall from(extent.start);
  const ComplexBall to(extent.end);
  acb_calc_integrate(result.get(), call, const_cast<Integrand*>(&f), from.get(), to.get(), goal, tolerance, options,
                     goal);
  mag_clear(tolerance);
  Ball real;
  acb_get_real(real.get(), result.get());
  return real;
}

}  // namespace lubjoint::certified
