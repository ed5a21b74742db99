#include "oracle/certified/film_pressure.hpp"

#include "oracle/certified/sommerfeld_moments.hpp"

namespace lubjoint::certified {

Ball short_pressure(const FilmBalls& film, double length, double theta, double z) {
  const Ball sine = sin(Ball(theta));
  const Ball cosine = cos(Ball(theta));
  const Ball h = Ball(1) + film.epsilon * cosine;
  const Ball l(length);
  const Ball axial = l * l / 4 - Ball(z) * Ball(z);
  return axial * (film.a * sine - 2 * film.b * cosine) / (h * h * h);
}

Ball long_pressure_eq5(const FilmBalls& film, double theta) {
  const auto& [epsilon, a, b] = film;
  const Ball sine = sin(Ball(theta));
  const Ball cosine = cos(Ball(theta));
  const Ball h = Ball(1) + epsilon * cosine;
  const Ball d = Ball(2) + epsilon * epsilon;
  const Ball widest = (Ball(1) + epsilon) * (Ball(1) + epsilon);
  const Ball wedge = a * sine * (Ball(2) + epsilon * cosine) / d;
  const Ball squeeze = b * (Ball(1) - cosine) * (Ball(2) + epsilon + epsilon * cosine) / widest;
  return (wedge + squeeze) / (h * h);
}

Ball long_pressure(Extent extent, const FilmBalls& film, double theta) {
  const auto& [epsilon, a, b] = film;
  const Ball root = sqrt(film.q());
  Ball sine(0);
  Ball cosine(film.side());
  Ball whole = ball_pi();  // of Sommerfeld's angle, which is θ at 0 and at π
  Ball start = film.side() > 0 ? Ball(0) : ball_pi();
  if (extent == Extent::dynamic) {
    const Ball w = sqrt(a * a + 4 * (b * b));
    sine = 2 * b / w;
    cosine = a / w;
    whole = 2 * atan2(root, -(epsilon * sine));
    start = atan2(root * sine, epsilon + cosine);
  }
  const Ball half(theta / 2);
  const Ball here = 2 * atan2(sqrt(Ball(1) - epsilon) * sin(half), sqrt(Ball(1) + epsilon) * cos(half));
  const SommerfeldMoments all(epsilon, sine, cosine, -sine, -cosine, whole);
  const SommerfeldMoments part(epsilon, sine, cosine, sin(Ball(theta)), cos(Ball(theta)), here - start);
  const Ball constant = -((a * all.j01 + 2 * b * all.j10) / all.j00);
  return a * part.j01 + 2 * b * part.j10 + constant * part.j00;
}

}  // namespace lubjoint::certified
