/// The spatial slider-crank with a lubricated gudgeon pin in minimal coordinates: crank angle, rod angle, slider
/// position. It shares the film laws with the library, and nothing else.
#pragma once

#include <array>
#include <cmath>

#include "lubjoint/film/law.hpp"
#include "oracle/mechanisms/lobatto.hpp"
#include "oracle/mechanisms/spatial_slider_crank.hpp"

namespace lubjoint::mechanisms {

/// The crank of SpatialSliderCrank, free under gravity. The slider moves along x and swivels about it; the pin's axis n
/// is fixed to it, normal to x; thrust faces keep rod and pin parallel to each other and level along n. The rod then
/// lies in the plane through the x axis normal to n, and so does its ball at B: that plane turns with B about x,
/// whatever the film does. In it, with b from the x axis to B, h the distance of B and ρ the angle of b from y about x:
///   u = x cosφ + b sinφ (the rod),   e = (x − l cosφ, −h − l sinφ),   n = x × b.
/// Spins: ρ̇ x of the slider, ρ̇ x + φ̇ n of the rod; so the pure-squeeze velocity is u c = ė − ½ φ̇ n × e, rates seen in
/// the plane. Bearing on the rod, journal on the slider.
///   T = ½ A θ̇² + C θ̇ φ̇ + ½ D φ̇² + ½ m_s ẋ²,
///   A = I_c + m(h'² + r² ρ'²) + ρ'²(J₁ cos²φ + J₃ sin²φ + J_s),  r = h + ½ l sinφ,  C = ½ m l cosφ h',  D = ¼ m l² +
///   J₂.
template <FilmLaw Law, class R>
class LubricatedSpatialSliderCrank {
 public:
  /// θ, φ, x and their rates.
  using State = ShortState<R, 6>;

  LubricatedSpatialSliderCrank(const SpatialSliderCrank<R>& mechanism, const Bearing<R>& bearing,
                               const Lubricant<R>& oil)
      : m_(mechanism), bearing_(bearing), scale_(lubjoint::force_scale(Law::limit, bearing, oil)) {}

  /// The ideal mechanism's position and velocity, e = 0.
  State start(const R& angle, const R& speed) const {
    using std::atan2;
    const PinPlace<R> b = place(angle);
    const AlongCrank<R> x = m_.slider(angle);
    const R phi = atan2(R(-b.h), x.value);
    // sinφ = −h/l: cosφ φ' = −h'/l
    return {angle, phi, x.value, speed, R(-b.slope * speed / x.value), R(x.slope * speed)};
  }

  /// The journal in its bearing.
  struct Pin {
    std::array<R, 3> eccentricity;  ///< e/c, inertial
    std::array<R, 3> force;         ///< of the film on the journal, inertial [N]
  };
  Pin pin(const State& y) const {
    const PinPlace<R> b = place(y[0]);
    const InPlane<R> film = film_at(y, b);
    const auto inertial = [&](const R& along_x, const R& along_b) {
      return std::array<R, 3>{along_x, R(along_b * b.y / b.h), R(along_b * b.z / b.h)};
    };
    return {inertial(film.e[0], film.e[1]), inertial(film.force[0], film.force[1])};
  }

  /// e/c along x and b; of any state.
  std::array<R, 2> eccentricity(const State& y) const {
    const Vector2<R> e = eccentricity_at(y, place(y[0]));
    return {e.x(), e.y()};
  }

  /// Kinetic and potential energy [J].
  R energy(const State& y) const {
    const Lagrangian<R> now = lagrangian(y, place(y[0]));
    return now.a * y[3] * y[3] / 2 + now.c * y[3] * y[4] + now.d * y[4] * y[4] / 2 + m_.slider_mass * y[5] * y[5] / 2 +
           now.potential;
  }
  /// Power of the film on the mechanism, F·(ė − φ̇ n × e) [W].
  R film_power(const State& y) const {
    const InPlane<R> film = film_at(y, place(y[0]));
    const R c = bearing_.clearance();
    return c * (film.force[0] * (film.rate[0] + y[4] * film.e[1]) + film.force[1] * (film.rate[1] - y[4] * film.e[0]));
  }

  // What Lobatto asks of a system.
  std::size_t states() const { return 6; }
  /// On any scalar. @throws FilmDomainError where ε ≥ 1
  template <class T>
  void rate(const R&, const ShortState<T, 6>& y, ShortState<T, 6>& dydt) const {
    const PinPlace<T> b = place(y[0]);
    const InPlane<T> film = film_at(y, b);
    const Lagrangian<T> now = lagrangian(y, b);
    const T w = y[3];
    const T f = y[4];
    // Of the forces F at the journal: on the slider along x, about B on the rod, and through h' on the crank.
    const T on_crank = -b.slope * film.force[1] - now.potential_theta - now.a_phi * f * w - now.a_theta * w * w / 2 -
                       now.c_phi * f * f;
    const T on_rod =
        -b.h * film.force[0] - y[2] * film.force[1] - now.potential_phi - now.c_theta * w * w + now.a_phi * w * w / 2;
    const T determinant = now.a * now.d - now.c * now.c;
    dydt = {w,
            f,
            y[5],
            T((on_crank * now.d - on_rod * now.c) / determinant),
            T((on_rod * now.a - on_crank * now.c) / determinant),
            T(film.force[0] / m_.slider_mass)};
  }
  void weights(const State& y, State& w) const {
    // A clearance at the end of the rod, and the speeds that cross it in a radian of the crank.
    const R c = bearing_.clearance();
    const R per_second = abs_of(y[3]) + 1;
    w = {R(c / m_.rod_length), R(c / m_.rod_length), c};
    for (std::size_t k = 0; k < 3; ++k) w[k + 3] = w[k] * per_second;
  }
  void increments(const State& y, State& d) const {
    using std::sqrt;
    weights(y, d);
    for (R& x : d) x *= sqrt(std::numeric_limits<R>::epsilon());
  }

 private:
  static R abs_of(const R& x) {
    using std::abs;
    return abs(x);
  }
  /// B, in the plane and about the x axis, with derivatives after θ.
  template <class T>
  struct PinPlace {
    T y, z, h, slope, curvature;   ///< B_y, B_z, h, h', h''
    T z_slope;                     ///< B_z'
    T turn_slope, turn_curvature;  ///< ρ', ρ''
  };
  template <class T>
  PinPlace<T> place(const T& theta) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T ddy = m_.crank_length * sin(theta);  // the crank's arm turns: its second derivative is its opposite
    const T dy = -m_.crank_length * cos(theta);
    const T y = m_.offset_y - ddy;
    const T z = m_.offset_z - dy;
    const T dz = -ddy;
    const T ddz = dy;
    const T h = sqrt(T(y * y + z * z));
    const T slope = (y * dy + z * dz) / h;
    const T turn = (y * dz - z * dy) / (h * h);
    return {y,
            z,
            h,
            slope,
            T((dy * dy + y * ddy + dz * dz + z * ddz - slope * slope) / h),
            dz,
            turn,
            T((y * ddz - z * ddy) / (h * h) - 2 * slope * turn / h)};
  }

  /// In the plane, along x and b, over the clearance but for the force.
  template <class T>
  struct InPlane {
    std::array<T, 2> e, rate, force;
  };
  template <class T>
  Vector2<T> eccentricity_at(const ShortState<T, 6>& y, const PinPlace<T>& b) const {
    using std::cos;
    using std::sin;
    const R c = bearing_.clearance();
    return Vector2<T>(T((y[2] - m_.rod_length * cos(y[1])) / c), T((-b.h - m_.rod_length * sin(y[1])) / c));
  }
  template <class T>
  InPlane<T> film_at(const ShortState<T, 6>& y, const PinPlace<T>& b) const {
    using std::cos;
    using std::sin;
    const R c = bearing_.clearance();
    const R l = m_.rod_length;
    const T cosine = cos(y[1]);
    const T sine = sin(y[1]);
    const Vector2<T> e = eccentricity_at(y, b);
    const Vector2<T> rate(T((y[5] + l * sine * y[4]) / c), T((-b.slope * y[3] - l * cosine * y[4]) / c));
    // n × e = (−e_b, e_x)
    const Vector2<T> u(T(rate.x() + y[4] * e.y() / 2), T(rate.y() - y[4] * e.x() / 2));
    const Vector2<T> ratio = force_ratio<Law>(FilmState<T>(e, u));
    return {{e.x(), e.y()}, {rate.x(), rate.y()}, {T(scale_ * ratio.x()), T(scale_ * ratio.y())}};
  }

  template <class T>
  struct Lagrangian {
    T a, a_theta, a_phi, c, c_theta, c_phi, d, potential, potential_theta, potential_phi;
  };
  template <class T>
  Lagrangian<T> lagrangian(const ShortState<T, 6>& state, const PinPlace<T>& b) const {
    using std::cos;
    using std::sin;
    const R m = m_.rod_mass;
    const R half = m_.rod_length / 2;
    const T c = cos(state[1]);
    const T s = sin(state[1]);
    const T r = b.h + half * s;
    const T turning = m_.rod_inertia_along * c * c + m_.rod_inertia_third * s * s + m_.slider_inertia;
    const T squared = b.turn_slope * b.turn_slope;
    const T product = 2 * b.turn_slope * b.turn_curvature;
    const T rise = b.z / b.h;  // of b along z
    const T rise_slope = (b.z_slope - rise * b.slope) / b.h;
    const R g = m_.gravity;
    const R crank = m_.crank_mass * m_.crank_centre;
    return {m_.crank_inertia + crank * m_.crank_centre + m * (b.slope * b.slope + r * r * squared) + squared * turning,
            m * (2 * b.slope * b.curvature + 2 * r * b.slope * squared + r * r * product) + product * turning,
            2 * squared * c * (m * r * half + s * (m_.rod_inertia_third - m_.rod_inertia_along)),
            m * half * c * b.slope,
            m * half * c * b.curvature,
            -m * half * s * b.slope,
            m * half * half + m_.rod_inertia_cross,
            g * (m_.crank_mass * m_.offset_z + crank * cos(state[0]) + m * r * rise),
            g * (-crank * sin(state[0]) + m * (b.slope * rise + r * rise_slope)),
            g * m * half * c * rise};
  }

  SpatialSliderCrank<R> m_;
  Bearing<R> bearing_;
  R scale_;
};

}  // namespace lubjoint::mechanisms
