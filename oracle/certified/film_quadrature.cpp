#include "oracle/certified/film_quadrature.hpp"

#include <stdexcept>
#include <string>

#include "oracle/certified/film_integrals.hpp"

namespace lubjoint::certified {

namespace {

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

PolarBalls force_ratio_by_quadrature(Law law, const FilmBalls& given) {
  const LawEntry& entry = laws[static_cast<std::size_t>(law)];
  const FilmBalls film = film_seen(entry, given);
  if (!entry.has_pressure) throw std::invalid_argument(std::string(entry.name) + " is the integral of no pressure");
  if (film.at_rest()) return {};
  const ExtentBalls extent = film_extent(entry.extent, film);
  if (law == Law::long_half || law == Law::long_dynamic || law == Law::squeeze_long) {
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
