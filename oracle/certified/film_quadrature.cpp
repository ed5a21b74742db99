#include "oracle/certified/film_quadrature.hpp"

#include <acb_calc.h>

#include <stdexcept>
#include <string>

namespace lubjoint::certified {

namespace {

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

/// ∫ f(θ) dθ. f must be holomorphic wherever its value is finite: quotients of entire functions are.
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

/// P of the films whose pressure is known in closed form, from eqs. 3 and 5, over the force scale's units.
ComplexBall known_pressure(const LawEntry& law, const FilmBalls& film, const Place& at) {
  const auto& [epsilon, a, b] = film;
  if (law.is_short) {
    return (a * at.sine - (2 * b) * at.cosine) / (ComplexBall(Ball(2)) * at.h * at.h * at.h);
  }
  const ComplexBall one(Ball(1));
  const ComplexBall two(Ball(2));
  const Ball d = Ball(2) + epsilon * epsilon;
  const Ball widest = (Ball(1) + epsilon) * (Ball(1) + epsilon);
  const ComplexBall ec = epsilon * at.cosine;
  const ComplexBall wedge = (a / d) * (at.sine * (two + ec));
  const ComplexBall squeeze = (b / widest) * ((one - at.cosine) * (two + ComplexBall(epsilon) + ec));
  return Ball(6) * ((wedge + squeeze) / (at.h * at.h));
}

/// P'/6 = (g + C)/H³ of the long film with P = 0 at both ends.
class LongSlope {
 public:
  LongSlope(const FilmBalls& film, const ExtentBalls& extent) : film_(film) {
    const Ball weight = integral(
        [&](const ComplexBall& theta) {
          const Place at(theta, film_.epsilon);
          return ComplexBall(Ball(1)) / (at.h * at.h * at.h);
        },
        extent);
    const Ball flow = integral(
        [&](const ComplexBall& theta) {
          const Place at(theta, film_.epsilon);
          return source(at) / (at.h * at.h * at.h);
        },
        extent);
    constant_ = ComplexBall(-(flow / weight));
  }

  ComplexBall operator()(const Place& at) const { return (source(at) + constant_) / (at.h * at.h * at.h); }

 private:
  ComplexBall source(const Place& at) const { return film_.a * at.cosine + (2 * film_.b) * at.sine; }

  const FilmBalls& film_;
  ComplexBall constant_;
};

}  // namespace

PolarBalls force_ratio_by_quadrature(Law law, const FilmBalls& film) {
  const LawEntry& entry = laws[static_cast<std::size_t>(law)];
  if (!entry.has_pressure) throw std::invalid_argument(std::string(entry.name) + " is the integral of no pressure");
  if (film.at_rest()) return {};
  const ExtentBalls extent = film_extent(entry.extent, film);
  if (law == Law::long_half || law == Law::long_dynamic) {
    const LongSlope slope(film, extent);
    const Ball radial = integral(
        [&](const ComplexBall& theta) {
          const Place at(theta, film.epsilon);
          return slope(at) * at.sine;
        },
        extent);
    const Ball tangential = integral(
        [&](const ComplexBall& theta) {
          const Place at(theta, film.epsilon);
          return slope(at) * at.cosine;
        },
        extent);
    return {-6 * radial, 6 * tangential};
  }
  const Ball radial = integral(
      [&](const ComplexBall& theta) {
        const Place at(theta, film.epsilon);
        return known_pressure(entry, film, at) * at.cosine;
      },
      extent);
  const Ball tangential = integral(
      [&](const ComplexBall& theta) {
        const Place at(theta, film.epsilon);
        return known_pressure(entry, film, at) * at.sine;
      },
      extent);
  return {radial, tangential};
}

Ball long_pressure_by_quadrature(Extent extent, const FilmBalls& film, double theta) {
  const ExtentBalls whole = film_extent(extent, film);
  const LongSlope slope(film, whole);
  return integral([&](const ComplexBall& at) { return slope(Place(at, film.epsilon)); }, {whole.start, Ball(theta)});
}

}  // namespace lubjoint::certified
