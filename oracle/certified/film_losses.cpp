#include "oracle/certified/film_losses.hpp"

#include <stdexcept>
#include <string>

#include "oracle/certified/film_integrals.hpp"
#include "oracle/certified/film_quadrature.hpp"

namespace lubjoint::certified {

namespace {

/// The state's film and the scales of its losses.
struct Scene {
  FilmBalls film;
  Ball clearance, spin;
  Ball couette;   ///< μωR³L/c [N m]
  Ball pressure;  ///< cS [N m s]
  Ball flow;      ///< cRL [m³]

  Scene(const LawEntry& law, const JointState& state)
      : film(film_seen(law, film_frame(state, Ball(state.clearance)).film)),
        clearance(state.clearance),
        spin(Ball(state.omega_journal) - Ball(state.omega_bearing)),
        couette(Ball(state.viscosity) * spin * Ball(state.radius) * Ball(state.radius) * Ball(state.radius) *
                Ball(state.length) / clearance),
        pressure(clearance * force_scale(law, state.viscosity, state.length, state.radius, clearance)),
        flow(clearance * Ball(state.radius) * Ball(state.length)) {}

  LossBalls losses(const Ball& couette_integral, const Ball& wall, const Ball& power) const {
    const Ball torque = couette * couette_integral;
    return {wall - torque, wall + torque, power, std::nullopt};
  }
};

Ball couette_integral(const LawEntry& law, const FilmBalls& film) {
  const Ball root = sqrt(film.q());
  if (law.extent == Extent::full) return 2 * ball_pi() / root;
  if (law.extent == Extent::half || film.at_rest()) return ball_pi() / root;
  const Ball w = sqrt(film.a * film.a + 4 * (film.b * film.b));
  return 2 * atan2(root, -(film.epsilon * (2 * film.b / w))) / root;
}

Ball side_flow_ratio(const LawEntry& law, const FilmBalls& film) {
  if (law.extent == Extent::full) return Ball(0);
  if (law.extent == Extent::half) return abs(film.a);
  return sqrt(film.a * film.a + 4 * (film.b * film.b));
}

template <class Function>
Ball over(const FilmBalls& film, const ExtentBalls& extent, const Function& f) {
  return integral([&](const ComplexBall& theta) { return f(Place(theta, film.epsilon)); }, extent);
}

ComplexBall cubed(const ComplexBall& h) { return h * h * h; }

/// ∫H dP and the dissipation of the pressure, over the units of the force scale.
struct FilmIntegrals {
  Ball shear, dissipation;
};

FilmIntegrals short_integrals(const FilmBalls& film, const ExtentBalls& extent, bool whole) {
  const ComplexBall two{Ball(2)};
  const auto source = [&](const Place& at) { return film.a * at.sine - (2 * film.b) * at.cosine; };
  Ball shear = over(film, extent, [&](const Place& at) {
    const ComplexBall rise = film.a * at.cosine + (2 * film.b) * at.sine;  // dg/dθ; dH/dθ = −ε sinθ
    return (rise * at.h + Ball(3) * (source(at) * (film.epsilon * at.sine))) / (two * cubed(at.h));
  });
  if (!whole) {  // at both ends sinθ = 0 or, for the dynamic film, the source is
    const auto step = [&](const Ball& theta) {
      const Ball h = Ball(1) + film.epsilon * cos(theta);
      return (film.a * sin(theta) - 2 * film.b * cos(theta)) / (2 * h * h);
    };
    shear = shear + step(extent.start) - step(extent.end);
  }
  const Ball dissipation =
      over(film, extent, [&](const Place& at) { return source(at) * source(at) / (Ball(4) * cubed(at.h)); });
  return {shear, dissipation};
}

FilmIntegrals long_integrals(const LawEntry& law, const FilmBalls& film, const ExtentBalls& extent) {
  const bool of_whole = law.extent == Extent::full || law.law == Law::long_half_eq5;
  const ExtentBalls window = of_whole ? ExtentBalls{Ball(0), 2 * ball_pi()} : extent;
  const auto wave = [&](const Place& at) { return film.a * at.cosine + (2 * film.b) * at.sine; };
  const Ball weight = over(film, window, [&](const Place& at) { return ComplexBall(Ball(1)) / cubed(at.h); });
  const Ball moment = over(film, window, [&](const Place& at) { return wave(at) / cubed(at.h); });
  const ComplexBall constant(-(moment / weight));
  const auto flow = [&](const Place& at) { return wave(at) + constant; };
  Ball shear = over(film, extent, [&](const Place& at) { return flow(at) / (at.h * at.h); });
  if (law.law == Law::long_half_eq5) {  // p is 0 at the maximum film and has its step at the minimum
    const Ball rise = over(film, extent, [&](const Place& at) { return flow(at) / cubed(at.h); });
    shear = shear - (Ball(1) - film.epsilon) * rise;
  }
  const Ball dissipation = over(film, extent, [&](const Place& at) { return flow(at) * flow(at) / cubed(at.h); });
  return {6 * shear, 3 * dissipation};
}

}  // namespace

LossBalls film_losses(const LawEntry& law, const JointState& state) {
  const Scene scene(law, state);
  const FilmBalls& film = scene.film;
  const PolarBalls ratio = force_ratio(law.law, film);
  const Ball integral_1 = couette_integral(law, film);
  const Ball power = scene.spin * scene.couette * integral_1 -
                     scene.pressure * (ratio.radial * film.b - ratio.tangential * film.a / 2);
  LossBalls losses = scene.losses(integral_1, -(scene.pressure * film.epsilon * ratio.tangential / 2), power);
  if (law.is_short) losses.side_flow = scene.flow * side_flow_ratio(law, film);
  return losses;
}

LossBalls film_losses_by_quadrature(const LawEntry& law, const JointState& state) {
  if (!law.has_pressure) throw std::invalid_argument(std::string(law.name) + " is the integral of no pressure");
  const Scene scene(law, state);
  const FilmBalls& film = scene.film;
  const ExtentBalls extent = film_extent(law.extent, film);
  const Ball integral_1 = over(film, extent, [](const Place& at) { return ComplexBall(Ball(1)) / at.h; });
  FilmIntegrals integrals{Ball(0), Ball(0)};
  if (!film.at_rest()) {
    integrals =
        law.is_short ? short_integrals(film, extent, law.extent == Extent::full) : long_integrals(law, film, extent);
  }
  const Ball wall = -(scene.pressure * integrals.shear / 2);
  const Ball couette_power = scene.spin * scene.couette * integral_1;
  Ball pressure_power = scene.pressure * integrals.dissipation;
  if (law.law == Law::long_half_eq5) {
    const PolarBalls ratio = force_ratio_by_quadrature(law.law, film);
    pressure_power = -(scene.pressure * (ratio.radial * film.b - ratio.tangential * film.a / 2));
  }
  LossBalls losses = scene.losses(integral_1, wall, couette_power + pressure_power);
  if (law.is_short) {
    const Ball flow = film.at_rest() ? Ball(0) : over(film, extent, [&](const Place& at) {
      return film.a * at.sine - (2 * film.b) * at.cosine;
    });
    losses.side_flow = scene.flow * flow / 2;
  }
  return losses;
}

}  // namespace lubjoint::certified
