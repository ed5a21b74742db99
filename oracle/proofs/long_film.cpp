#include "oracle/proofs/long_film.hpp"

namespace lubjoint::proofs {

ex long_slope(const ex& constant) {
  const auto& [a, b, theta] = std::tie(sym().a, sym().b, sym().theta);
  return (a * cos(theta) + 2 * b * sin(theta) + constant) / pow(film_at(cos(theta)), 3);
}

ex moment_antiderivative(int l, int m) {
  const symbol& theta = sym().theta;
  return antiderivative(pow(sin(theta), l) * pow(cos(theta), m) / pow(film_at(cos(theta)), 3));
}

ex moment(int l, int m, const FilmEnd& from, const FilmEnd& to) {
  return between(moment_antiderivative(l, m), from, to);
}

LongFilm long_film_between(const FilmEnd& from, const FilmEnd& to) {
  const auto& [a, b] = std::tie(sym().a, sym().b);
  LongFilm film;
  film.constant = -(a * moment(0, 1, from, to) + 2 * b * moment(1, 0, from, to)) / moment(0, 0, from, to);
  const auto rise = [&](int l, int m) {
    const ex primitive = moment_antiderivative(l, m);
    return primitive - value_at(primitive, from);
  };
  film.pressure = a * rise(0, 1) + 2 * b * rise(1, 0) + film.constant * rise(0, 0);
  return film;
}

}  // namespace lubjoint::proofs
