/// What a film force depends on: where the journal is in its clearance circle, and how it moves there.
#pragma once

#include <stdexcept>

#include "lubjoint/number/vector.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

/// Thrown where a film does not exist: ε outside [0, 1), or a motion that is not finite.
class FilmDomainError : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// For states that are known to be sound, or looked at elsewhere: nothing is checked where they are made.
struct Unchecked {};

/// State of the film in any inertial frame.
///   ê = e/c, the eccentricity in clearances [-];
///   u = (v − ½(ω_J + ω_B) e⊥)/c, the pure-squeeze velocity [1/s] (Booker 1965; Childs, Moes and van Leeuwen 1977): in
///   the frame that turns with the mean spin only squeeze is left;
///   q = 1 − ê·ê.
template <class T>
struct FilmState {
  Vector2<T> eccentricity;  ///< ê
  Vector2<T> velocity;      ///< u
  T q;                      ///< 1 − ε², formed without cancellation

  /// @throws FilmDomainError if ε ≥ 1 or a number is not finite
  FilmState(const Vector2<T>& e_hat, const Vector2<T>& u)
      : eccentricity(e_hat), velocity(u), q(one_minus_squared_norm<T>(e_hat.x(), e_hat.y())) {
    check();
  }

  /// For a caller that knows q = 1 − ê·ê better than ê can say.
  FilmState(const Vector2<T>& e_hat, const Vector2<T>& u, const T& known_q)
      : eccentricity(e_hat), velocity(u), q(known_q) {
    check();
  }

  /// For a caller that has checked them.
  FilmState(const Vector2<T>& e_hat, const Vector2<T>& u, const T& known_q, Unchecked)
      : eccentricity(e_hat), velocity(u), q(known_q) {}

 private:
  void check() const {
    using std::isfinite;
    if (value_of(q) > 0 && isfinite(value_of(velocity.x())) && isfinite(value_of(velocity.y()))) return;
    Message message;
    message << "no film at eccentricity (" << value_of(eccentricity.x()) << ", " << value_of(eccentricity.y())
            << ") clearances and pure-squeeze velocity (" << value_of(velocity.x()) << ", " << value_of(velocity.y())
            << ") 1/s; allowed are eccentricity ratios in [0, 1) and finite velocities";
    throw FilmDomainError(message.str());
  }
};

/// The same state in polar components, as papers print it: ε, a = ε(ω − 2γ̇), b = ε̇, and q = 1 − ε².
template <class T>
struct PolarFilmState {
  T eccentricity_ratio;  ///< ε [-]
  T slip_rate;           ///< a [1/s]
  T squeeze_rate;        ///< b [1/s]
  T q;                   ///< 1 − ε²

  /// @throws FilmDomainError if ε is outside [0, 1) or a rate is not finite
  PolarFilmState(const T& epsilon, const T& a, const T& b) : PolarFilmState(epsilon, a, b, one_minus_square(epsilon)) {}

  /// For a caller that knows q = 1 − ε² better than ε can say.
  /// @throws FilmDomainError as above
  PolarFilmState(const T& epsilon, const T& a, const T& b, const T& known_q)
      : eccentricity_ratio(epsilon), slip_rate(a), squeeze_rate(b), q(known_q) {
    using std::isfinite;
    const bool inside = value_of(epsilon) >= 0 && value_of(epsilon) <= 1 && value_of(q) > 0;
    if (inside && isfinite(value_of(a)) && isfinite(value_of(b))) return;
    Message message;
    message << "no film at eccentricity_ratio " << value_of(epsilon) << ", slip_rate " << value_of(a)
            << " 1/s, squeeze_rate " << value_of(b)
            << " 1/s; allowed are eccentricity ratios in [0, 1) and finite rates";
    throw FilmDomainError(message.str());
  }

  /// For a caller that has checked them.
  PolarFilmState(const T& epsilon, const T& a, const T& b, const T& known_q, Unchecked)
      : eccentricity_ratio(epsilon), slip_rate(a), squeeze_rate(b), q(known_q) {}

  /// The state in the frame of its own radial and tangential directions: u = (b, −a/2).
  FilmState<T> in_own_frame() const {
    return FilmState<T>(Vector2<T>(eccentricity_ratio, T(0)), Vector2<T>(squeeze_rate, T(-slip_rate / 2)), q,
                        Unchecked());
  }
};

/// A state seen along its eccentricity: polar components, and the radial direction r that they refer to.
template <class T>
struct PolarView {
  PolarFilmState<T> state;  ///< ε, a, b
  Vector2<T> radial;        ///< r, a unit vector; the tangential direction is perpendicular(r)
};

/// Polar view of a state along a unit vector r: that of ê, or of u where ê = 0.
template <class T>
PolarView<T> polar_view_along(const Vector2<T>& r, const FilmState<T>& film) {
  const T epsilon = dot(r, film.eccentricity);
  const T b = dot(film.velocity, r);
  const T u_t = is_zero(film.eccentricity) ? T(0) : dot(film.velocity, perpendicular(r));
  const T a = -2 * u_t;
  return {PolarFilmState<T>(epsilon, a, b, film.q, Unchecked()), r};
}

/// Polar view of a state. At ê = 0 the radial direction is that of u, the limit of a journal that leaves the centre
/// along its velocity; there dε = r·dê. Needs ê ≠ 0 or u ≠ 0.
template <class T>
PolarView<T> polar_view(const FilmState<T>& film) {
  return polar_view_along(direction(is_zero(film.eccentricity) ? film.velocity : film.eccentricity), film);
}

/// Motion of a journal in its bearing, in one inertial frame.
template <class T>
struct JournalMotion {
  Vector2<T> eccentricity;  ///< e = P_journal − P_bearing [m]
  Vector2<T> velocity;      ///< v, inertial rate of e [m/s]
  T bearing_spin;           ///< ω_B, absolute [rad/s]
  T journal_spin;           ///< ω_J, absolute [rad/s]
};

/// ê of a motion.
template <class T>
Vector2<T> eccentricity_in_clearances(const JournalMotion<T>& motion, const RealOf<T>& clearance) {
  return Vector2<T>(T(motion.eccentricity.x() / clearance), T(motion.eccentricity.y() / clearance));
}

/// u of a motion with this ê [1/s].
template <class T>
Vector2<T> pure_squeeze_velocity(const JournalMotion<T>& motion, const RealOf<T>& clearance, const Vector2<T>& e_hat) {
  const T half_sum = (motion.bearing_spin + motion.journal_spin) / 2;
  return Vector2<T>(T(motion.velocity.x() / clearance + half_sum * e_hat.y()),
                    T(motion.velocity.y() / clearance - half_sum * e_hat.x()));
}

/// Film state of a motion. No angle, no division by e; both spins are absolute, so the answer does not depend on the
/// rotation of the observer.
/// @throws FilmDomainError if |e| ≥ c
template <class T>
FilmState<T> film_state(const JournalMotion<T>& motion, const RealOf<T>& clearance) {
  const Vector2<T> e_hat = eccentricity_in_clearances(motion, clearance);
  return FilmState<T>(e_hat, pure_squeeze_velocity(motion, clearance, e_hat));
}

}  // namespace lubjoint
