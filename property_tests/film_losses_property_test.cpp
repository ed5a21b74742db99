#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "generators.hpp"
#include "lubjoint/film/losses.hpp"
#include "support/law_property.hpp"

namespace film_losses_property_test {

using namespace lubjoint;
using generate::Vec;

namespace {

const Bearing<double> bearing(0.04, 0.0098, 2e-4);
const Lubricant<double> oil(0.4);
const double clearance = 2e-4;

/// A motion of the size that a film has in a machine, in a frame of its own.
struct Motion {
  FilmState<double> film;
  double bearing_spin, journal_spin;

  double relative_spin() const { return journal_spin - bearing_spin; }
  Vec velocity() const {
    return clearance * (film.velocity + (bearing_spin + journal_spin) / 2 * perpendicular(film.eccentricity));
  }
};

Motion any_motion() {
  const PolarFilmState<double> state = *generate::film();
  const FilmState<double> film = state.in_own_frame();
  return {film, *generate::uniform(-300, 300), *generate::uniform(-300, 300)};
}

template <FilmLaw Law>
FilmLosses<double> losses_of_motion(const Motion& m) {
  return film_losses<Law>(bearing, oil, m.film, m.relative_spin());
}

/// Σ|terms| of a torque [N m], which its rounding is measured in.
double torque_terms(const FilmLosses<double>& losses, const Motion& m) {
  return std::abs(losses.torque_bearing - losses.torque_journal) +
         clearance * m.film.eccentricity.norm() * losses.force.norm();
}

}  // namespace

TEST_CASE("both torques and the moment of the pair of forces balance, and the power is what the bodies lose") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("T_J + T_B + e x F = 0, P = -(F.v + T_J omega_J + T_B omega_B)"), [] {
      const Motion m = any_motion();
      const FilmLosses<double> losses = losses_of_motion<Law>(m);
      const double moment = clearance * cross(m.film.eccentricity, losses.force);
      const double terms = torque_terms(losses, m);
      RC_ASSERT(std::abs(losses.torque_journal + losses.torque_bearing + moment) <= 4e-16 * terms);  // two roundings
      const double work = dot(losses.force, m.velocity()) + losses.torque_journal * m.journal_spin +
                          losses.torque_bearing * m.bearing_spin;
      const double size =
          losses.force.norm() * m.velocity().norm() + terms * (std::abs(m.journal_spin) + std::abs(m.bearing_spin));
      RC_ASSERT(std::abs(losses.power() + work) <= 1e-14 * (size + losses.power()));  // a dozen roundings
    });
  });
}

TEST_CASE("the film never gives power: its Couette part and its pressure's part are each not negative") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("omega T_C >= 0 and -c F.u >= 0"), [] {
      const Motion m = any_motion();
      const FilmLosses<double> losses = losses_of_motion<Law>(m);
      RC_ASSERT(losses.couette_power >= 0);
      RC_ASSERT(losses.pressure_power >= 0);
    });
  });
}

TEST_CASE("losses are the same for an observer who turns, and mirrored in a mirror") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("a turned frame turns the force alone"), [] {
      // Spins with few binary digits: their sums are exact, and so is what the torques see, the bodies' difference.
      const auto short_number = [](double x) { return std::round(0x1p20 * x) / 0x1p20; };
      Motion m = any_motion();
      m.bearing_spin = short_number(m.bearing_spin);
      m.journal_spin = short_number(m.journal_spin);
      const FilmLosses<double> here = losses_of_motion<Law>(m);
      const double turn = *generate::angle();
      const double spin = short_number(*generate::uniform(-100, 100));  // of the observer: u does not see it
      const Motion there{FilmState<double>(generate::turned(m.film.eccentricity, turn),
                                           generate::turned(m.film.velocity, turn), m.film.q),
                         m.bearing_spin + spin, m.journal_spin + spin};
      const FilmLosses<double> seen = losses_of_motion<Law>(there);
      // Turning rounds e and u: relative to the distance from a jump or the wall that is 1e-16/q.
      const double allowed = 1e-13 / m.film.q;
      RC_PRE(m.film.q > 1e-3 && std::abs(cross(m.film.eccentricity, m.film.velocity)) > 1e-9);
      RC_ASSERT(std::abs(seen.torque_journal - here.torque_journal) <= allowed * torque_terms(here, m));
      RC_ASSERT(std::abs(seen.power() - here.power()) <= allowed * here.power());
    });
    rc::prop(of_law<Law>("mirrored torques"), [] {
      const Motion m = any_motion();
      RC_PRE(m.film.eccentricity.x() * m.film.velocity.y() != 0);  // on the jump of a half film there is no mirror
      const Motion other{
          FilmState<double>(m.film.eccentricity, Vec(m.film.velocity.x(), -m.film.velocity.y()), m.film.q),
          -m.bearing_spin, -m.journal_spin};
      const FilmLosses<double> here = losses_of_motion<Law>(m);
      const FilmLosses<double> there = losses_of_motion<Law>(other);
      RC_ASSERT(std::abs(there.torque_journal + here.torque_journal) <= 1e-14 * torque_terms(here, m));
      RC_ASSERT(std::abs(there.power() - here.power()) <= 1e-14 * here.power());
    });
  });
}

TEST_CASE("twice as fast costs twice the torque and four times the power; thicker oil costs in proportion") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("homogeneous of degree one and two, linear in viscosity"), [] {
      const Motion m = any_motion();
      const FilmLosses<double> once = losses_of_motion<Law>(m);
      const FilmState<double> fast(m.film.eccentricity, Vec(2 * m.film.velocity), m.film.q);
      const FilmLosses<double> twice = film_losses<Law>(bearing, oil, fast, 2 * m.relative_spin());
      const double terms = torque_terms(once, m);
      RC_ASSERT(std::abs(twice.torque_journal - 2 * once.torque_journal) <= 1e-14 * terms);
      RC_ASSERT(std::abs(twice.power() - 4 * once.power()) <= 1e-14 * once.power());
      const FilmLosses<double> thick = film_losses<Law>(bearing, Lubricant<double>(1.2), m.film, m.relative_spin());
      RC_ASSERT(std::abs(thick.power() - 3 * once.power()) <= 1e-14 * thick.power());
    });
  });
}

}  // namespace film_losses_property_test
