/// Random films, motions and joints. What is random is here; what must hold is in the tests.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/joint/lubricated_joint.hpp"

namespace lubjoint::generate {

using Vec = Vector2<double>;

/// Uniform on [lower, upper], in steps of a billionth of the range.
inline rc::Gen<double> uniform(double lower, double upper) {
  return rc::gen::map(rc::gen::inRange(0, 1'000'000'001),
                      [=](int k) { return lower + (upper - lower) * (static_cast<double>(k) * 1e-9); });
}

/// 10^x with x uniform.
inline rc::Gen<double> log_uniform(double lowest_exponent, double highest_exponent) {
  return rc::gen::map(uniform(lowest_exponent, highest_exponent), [](double x) { return std::pow(10.0, x); });
}

inline rc::Gen<double> angle() { return uniform(-std::numbers::pi, std::numbers::pi); }

/// ε: uniform to 0.99, or 1 − ε down to 1e-6, or ε down to 1e-12, uniform in their logarithms.
inline rc::Gen<double> eccentricity_ratio() {
  return rc::gen::oneOf(uniform(0.0, 0.99), rc::gen::map(log_uniform(-6, -1), [](double gap) { return 1 - gap; }),
                        log_uniform(-12, -1));
}

/// ε to 0.95, where no law is ill-conditioned.
inline rc::Gen<double> moderate_ratio() { return uniform(0.01, 0.95); }

inline Vec direction_at(double turn) { return Vec(std::cos(turn), std::sin(turn)); }

inline Vec turned(const Vec& v, double turn) {
  const Vec d = direction_at(turn);
  return Vec(d.x() * v.x() - d.y() * v.y(), d.y() * v.x() + d.x() * v.y());
}

/// (a, b) of unit |u|, every direction, axes included.
inline rc::Gen<std::pair<double, double>> rates() {
  const auto of = [](double turn) { return std::make_pair(2 * std::cos(turn), std::sin(turn)); };
  const auto on_axis = [](int quarter) {
    constexpr double cosine[] = {2, 0, -2, 0};
    constexpr double sine[] = {0, 1, 0, -1};
    return std::make_pair(cosine[quarter], sine[quarter]);
  };
  return rc::gen::weightedOneOf<std::pair<double, double>>(
      {{9, rc::gen::map(angle(), of)}, {1, rc::gen::map(rc::gen::inRange(0, 4), on_axis)}});
}

inline PolarFilmState<double> polar_state(double epsilon, const std::pair<double, double>& rate) {
  return {epsilon, rate.first, rate.second};
}

inline rc::Gen<PolarFilmState<double>> film() {
  return rc::gen::map(rc::gen::pair(eccentricity_ratio(), rates()),
                      [](const auto& x) { return polar_state(x.first, x.second); });
}

inline rc::Gen<PolarFilmState<double>> moderate_film() {
  return rc::gen::map(rc::gen::pair(moderate_ratio(), rates()),
                      [](const auto& x) { return polar_state(x.first, x.second); });
}

/// Clearance from a hundredth to a ten-thousandth of the radius, L/D from 0.05 to 5.
inline rc::Gen<Bearing<double>> bearing() {
  return rc::gen::map(rc::gen::tuple(log_uniform(-3, 0), log_uniform(-4, -2), log_uniform(-1, 1)), [](const auto& x) {
    const double radius = std::get<0>(x);
    return Bearing<double>(radius * std::get<2>(x), radius, radius * std::get<1>(x));
  });
}

inline rc::Gen<Lubricant<double>> oil() {
  return rc::gen::map(log_uniform(-4, 2), [](double viscosity) { return Lubricant<double>(viscosity); });
}

/// A body anywhere in a machine of a metre, at speeds of machines.
inline rc::Gen<PlanarMotion<double>> body() {
  return rc::gen::map(
      rc::gen::tuple(uniform(-1, 1), uniform(-1, 1), angle(), uniform(-5, 5), uniform(-5, 5), uniform(-500, 500)),
      [](const auto& x) {
        return PlanarMotion<double>{Vec(std::get<0>(x), std::get<1>(x)), std::get<2>(x),
                                    Vec(std::get<3>(x), std::get<4>(x)), std::get<5>(x)};
      });
}

inline rc::Gen<Vec> body_point() {
  return rc::gen::map(rc::gen::pair(uniform(-0.2, 0.2), uniform(-0.2, 0.2)),
                      [](const auto& x) { return Vec(x.first, x.second); });
}

/// Two bodies and a joint between them whose journal is inside its bearing, e = εc in any direction.
struct JointedPair {
  PlanarMotion<double> bearing_body;
  Vec bearing_centre;
  PlanarMotion<double> journal_body;
  Vec journal_centre;

  JointKinematics<double> kinematics() const {
    return joint_kinematics(bearing_body, bearing_centre, journal_body, journal_centre);
  }
};

inline constexpr double joint_clearance = 2e-4;

inline rc::Gen<JointedPair> jointed_pair() {
  return rc::gen::map(rc::gen::tuple(body(), body_point(), body(), body_point(), moderate_ratio(), angle()),
                      [](const auto& x) {
                        JointedPair pair{std::get<0>(x), std::get<1>(x), std::get<2>(x), std::get<3>(x)};
                        const Vec e = joint_clearance * std::get<4>(x) * direction_at(std::get<5>(x));
                        const Vec& bearing_arm = inertial_vector(pair.bearing_body, pair.bearing_centre);
                        const Vec& journal_arm = inertial_vector(pair.journal_body, pair.journal_centre);
                        pair.journal_body.position = pair.bearing_body.position + bearing_arm + e - journal_arm;
                        return pair;
                      });
}

/// The same pair after the whole system was turned about a pole, and given a spin about it.
struct Rotation {
  double turn;  ///< [rad]
  double spin;  ///< [rad/s]
  Vec pole;     ///< [m]
};

inline rc::Gen<Rotation> rotation() {
  return rc::gen::map(rc::gen::tuple(angle(), uniform(-300, 300), uniform(-1, 1), uniform(-1, 1)), [](const auto& x) {
    return Rotation{std::get<0>(x), std::get<1>(x), Vec(std::get<2>(x), std::get<3>(x))};
  });
}

inline PlanarMotion<double> rotated(const PlanarMotion<double>& body, const Rotation& by) {
  const Vec arm = turned(body.position - by.pole, by.turn);
  return {Vec(by.pole + arm), body.angle + by.turn, Vec(turned(body.velocity, by.turn) + by.spin * perpendicular(arm)),
          body.spin + by.spin};
}

inline JointedPair rotated(const JointedPair& pair, const Rotation& by) {
  return {rotated(pair.bearing_body, by), pair.bearing_centre, rotated(pair.journal_body, by), pair.journal_centre};
}

}  // namespace lubjoint::generate
