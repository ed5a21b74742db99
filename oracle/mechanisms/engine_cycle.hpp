/// A four-stroke engine of one cylinder in closed form: what its gas does over two revolutions, and what the ideal
/// mechanism's big end carries.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "lubjoint/number/vector.hpp"

namespace lubjoint::mechanisms {

/// Crank at the origin, the cylinder along x; angles of the crank from the outer dead centre at which the intake
/// begins: intake to π, compression to 2π, expansion to 3π, exhaust to 4π. The piston's own outer side is at ambient
/// pressure.
struct EngineCycle {
  double crank = 0.043;            ///< throw [m]
  double rod = 0.143;              ///< length between the pins [m]
  double bore = 0.086;             ///< [m]
  double compression_ratio = 10;   ///< largest over smallest volume
  double ambient = 1.0e5;          ///< [Pa]
  double intake = 0.6e5;           ///< pressure of the intake [Pa]
  double exhaust = 1.1e5;          ///< pressure of the exhaust [Pa]
  double isentropic = 1.33;        ///< κ of compression, combustion and expansion
  double heat = 500;               ///< Q, put in by combustion [J]
  double ignition_degrees = 345;   ///< crank angle at which combustion begins
  double combustion_degrees = 55;  ///< its length
  double wiebe_shape = 2;          ///< m of x_b = 1 − exp(−a s^{m+1})
  double wiebe_end = 5;            ///< a
  double blowdown_degrees = 50;    ///< after 540°: the pressure falls to the exhaust's as half a cosine
  double overlap_degrees = 20;     ///< before 720°: it falls to the intake's, likewise

  static double radians(double degrees) { return degrees * boost::math::constants::pi<double>() / 180; }

  /// x of the piston's pin.
  double piston(double angle) const {
    const double across = crank * std::sin(angle);
    return crank * std::cos(angle) + std::sqrt((rod - across) * (rod + across));
  }
  double area() const { return boost::math::constants::pi<double>() * bore * bore / 4; }  ///< [m²]
  /// Volume above the piston [m³].
  double volume(double angle) const {
    const double swept = area() * 2 * crank;
    return swept / (compression_ratio - 1) + area() * (crank + rod - piston(angle));
  }
  /// dx_b/dθ, the share of the heat that is put in per radian.
  double burning(double angle) const {
    const double length = radians(combustion_degrees);
    const double s = (angle - radians(ignition_degrees)) / length;
    if (s <= 0 || s >= 1) return 0;
    return wiebe_end * (wiebe_shape + 1) * std::pow(s, wiebe_shape) *
           std::exp(-wiebe_end * std::pow(s, wiebe_shape + 1)) / length;
  }
  /// Pressure between 180° and 540°: d(p V^κ) = (κ − 1) V^{κ−1} Q dx_b of a gas that loses no heat.
  double closed_pressure(double angle) const {
    const double begin = radians(ignition_degrees);
    const double end = std::min(angle, begin + radians(combustion_degrees));
    double added = 0;
    if (end > begin) {
      const auto rate = [&](double x) { return std::pow(volume(x), isentropic - 1) * burning(x); };
      added = (isentropic - 1) * heat * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(rate, begin, end);
    }
    const double start = intake * std::pow(volume(boost::math::constants::pi<double>()), isentropic);
    return (start + added) / std::pow(volume(angle), isentropic);
  }
  /// Pressure in the cylinder at 0 ≤ θ ≤ 4π [Pa].
  double pressure(double angle) const {
    const double pi = boost::math::constants::pi<double>();
    const auto half_cosine = [&](double from, double to, double share) {
      return to + (from - to) * (1 + std::cos(pi * share)) / 2;
    };
    if (angle <= pi) return intake;
    if (angle <= 3 * pi) return closed_pressure(angle);
    const double after = (angle - 3 * pi) / radians(blowdown_degrees);
    if (after < 1) return half_cosine(closed_pressure(3 * pi), exhaust, after);
    const double late = 1 - (4 * pi - angle) / radians(overlap_degrees);
    return late > 0 ? half_cosine(exhaust, intake, late) : exhaust;
  }
  /// Force of the gas on the piston along x [N].
  double gas_force(double angle) const { return -(pressure(angle) - ambient) * area(); }
};

/// Masses of the moving parts. The crank is balanced and turns evenly.
struct EngineMasses {
  double rod = 0.55;            ///< [kg]
  double rod_inertia = 2.1e-3;  ///< about its mass centre [kg m²]
  double rod_centre = 0.045;    ///< its mass centre from the big end [m]
  double piston = 0.45;         ///< with its pin [kg]
};

/// Force of the rod on the crank pin of the ideal mechanism at a steady speed, inertial [N]. Newton and Euler: the
/// piston gives the gudgeon pin's force along x, the rod's moments about the crank pin the one along y.
inline Vector2<double> big_end_load(const EngineCycle& engine, const EngineMasses& masses, double speed, double angle) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const double sine = -engine.crank / engine.rod * s;  // of the rod's angle
  const double cosine = std::sqrt((1 - sine) * (1 + sine));
  const double rate = -engine.crank / engine.rod * c * speed / cosine;
  const double turning = (engine.crank / engine.rod * s * speed * speed + sine * rate * rate) / cosine;
  const auto at = [&](double along) {  // acceleration of a point of the rod, from the crank pin
    return Vector2<double>(-engine.crank * c * speed * speed - along * (sine * turning + cosine * rate * rate),
                           -engine.crank * s * speed * speed + along * (cosine * turning - sine * rate * rate));
  };
  const double piston_force = masses.piston * at(engine.rod).x() - engine.gas_force(angle);  // of the rod on it
  const Vector2<double> centre = at(masses.rod_centre);
  const double moment =
      masses.rod_inertia * turning + masses.rod * masses.rod_centre * (cosine * centre.y() - sine * centre.x());
  // The pin's force on the rod at the small end is −(piston_force, f_y): l (cos(−f_y) − sin(−piston_force)) = moment.
  const double across = (engine.rod * sine * piston_force - moment) / (engine.rod * cosine);
  const Vector2<double> crank_on_rod(masses.rod * centre.x() + piston_force, masses.rod * centre.y() + across);
  return -crank_on_rod;
}

}  // namespace lubjoint::mechanisms
