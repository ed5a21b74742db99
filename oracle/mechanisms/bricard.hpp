/// Bricard's mechanism from its closed curve of positions: one coordinate, no constraint.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

namespace lubjoint::mechanisms {

/// Problem A04 of the IFToMM library of computational benchmark problems: five rods of length, mass and square cross
/// section between two points of the ground that are one length apart, six pins, gravity along −y. At the start, at
/// rest, the pins lie at (0, 0, 0), (1, 0, 0), (1, −1, 0), (1, −1, 1), (0, −1, 1), (0, 0, 1), their axes along y, z, x,
/// y, z, x.
///
/// Each rod lies at right angles to the pins at its ends, and these to each other, so that it is d_k = ± n_k × n_{k+1}.
/// The pins' angles are then θ at the first, third and fifth and φ at the others, right angles at the start, with
///   (1 + cosθ)(1 + cosφ) = 1
/// (the closing condition of a threefold symmetric linkage whose neighbouring axes are at right angles). That is a
/// smooth closed curve, and (θ', φ') = (sinφ (1 + cosθ), −sinθ (1 + cosφ)) runs along it: never zero, as one of the
/// sines isn't. Source of the condition: Baker (1980), An analysis of the Bricard linkages; closing() checks it in
/// every position.
template <class R>
class Bricard {
 public:
  static constexpr std::size_t bodies = 5;
  static constexpr std::size_t published_point = 2;  ///< of pins(): the benchmark's P3
  using Vector = Eigen::Matrix<R, 3, 1>;
  /// θ, φ, and the speed s along the curve: (θ̇, φ̇) = s (θ', φ').
  using State = std::array<R, 3>;

  R length = R(1);          ///< of each rod [m]
  R mass = R(1);            ///< of each rod [kg]
  R thickness = R(1) / 10;  ///< side of the cross section [m]
  R gravity = R(981) / 100;

  static State start() {
    using std::acos;
    const R right_angle = acos(R(0));
    return {right_angle, right_angle, R(0)};
  }

  /// The pins, from the first, on the ground, to the sixth, on the ground again.
  std::array<Vector, 6> pins(const State& y) const {
    std::array<Vector, 6> result;
    const Chain chain(*this, y, R(0));
    for (std::size_t k = 0; k < 6; ++k) result[k] = chain.pin[k].position;
    return result;
  }

  /// The pins' axes, of the first to the sixth.
  std::array<Vector, 6> axes(const State& y) const { return Chain(*this, y, R(0)).axis; }

  /// How far the end of the fifth rod is from where the ground has it [m], and its pin's axis from the x axis.
  R open(const State& y) const {
    using std::max;
    const Chain chain(*this, y, R(0));
    return max<R>((chain.pin[5].position - Vector(R(0), R(0), length)).norm(),
                  length * (chain.axis[5] - Vector(R(1), R(0), R(0))).norm());
  }

  /// ẏ: the force of inertia and the weight do no work along the curve (d'Alembert).
  void operator()(const State& y, State& rate, const R&) const {
    const R s = y[2];
    const std::array<R, 2> slope = along(y);
    rate = {s * slope[0], s * slope[1], R(0)};
    const Chain chain(*this, y, s);
    R inertia(0);
    R force(0);
    for (std::size_t k = 0; k < bodies; ++k) {
      const Rod& rod = chain.rod[k];
      inertia += mass * rod.slope.squaredNorm() + rod.turning_slope.dot(moment(rod, rod.turning_slope));
      // J ω̇ + ω × J ω without ṡ.
      const Vector turning = moment(rod, rod.turning_left) + rod.spin.cross(moment(rod, rod.spin));
      force -= mass * rod.slope.dot(rod.left + Vector(R(0), gravity, R(0))) + rod.turning_slope.dot(turning);
    }
    rate[2] = force / inertia;
  }

  /// Kinetic and potential energy, the latter zero at y = 0 [J].
  R energy(const State& y) const {
    const Chain chain(*this, y, y[2]);
    R sum(0);
    for (const Rod& rod : chain.rod) {
      const Vector v = y[2] * rod.slope;
      sum += mass * (v.squaredNorm() / 2 + gravity * rod.centre.y()) + rod.spin.dot(moment(rod, rod.spin)) / 2;
    }
    return sum;
  }

  /// (1 + cosθ)(1 + cosφ) − 1.
  static R closing(const State& y) {
    using std::cos;
    return (1 + cos(y[0])) * (1 + cos(y[1])) - 1;
  }

 private:
  struct Point {
    Vector position, slope, left;  ///< its derivative along the curve, and its acceleration without ṡ
  };
  struct Rod {
    Vector centre, slope, left;
    Vector direction;                          ///< a unit vector
    Vector spin, turning_slope, turning_left;  ///< ω, ω over s, and ω̇ without ṡ
  };

  static std::array<R, 2> along(const State& y) {
    using std::cos;
    using std::sin;
    return {sin(y[1]) * (1 + cos(y[0])), -sin(y[0]) * (1 + cos(y[1]))};
  }

  /// J v of a rod.
  Vector moment(const Rod& rod, const Vector& v) const {
    const R along_it = mass * thickness * thickness / 6;
    const R across = mass * (length * length + thickness * thickness) / 12;
    return across * v + (along_it - across) * rod.direction.dot(v) * rod.direction;
  }

  /// Rod after rod, each turned against the one before about the pin between them.
  struct Chain {
    std::array<Vector, 6> axis;
    std::array<Point, 6> pin;
    std::array<Rod, bodies> rod;

    Chain(const Bricard& m, const State& y, const R& s) {
      using std::cos;
      using std::sin;
      const std::array<R, 2> slope = along(y);
      const std::array<R, 2> cosine{cos(y[0]), cos(y[1])};
      const std::array<R, 2> sine{sin(y[0]), sin(y[1])};
      // d/dt of the slope over s: (θ', φ')' along the curve.
      const std::array<R, 2> curving{cosine[1] * slope[1] * (1 + cosine[0]) - sine[1] * sine[0] * slope[0],
                                     -cosine[0] * slope[0] * (1 + cosine[1]) + sine[0] * sine[1] * slope[1]};
      const Vector zero = Vector::Zero();
      axis[0] = Vector(R(0), R(1), R(0));
      pin[0] = {zero, zero, zero};
      Vector before(R(0), R(0), R(-1));  // the ground from the sixth pin to the first
      Vector turning = zero;
      Vector left = zero;
      for (std::size_t k = 0; k < bodies; ++k) {
        const std::size_t kind = k % 2;
        // A rod turns against the one before by −q about their pin.
        Rod& now = rod[k];
        now.direction = cosine[kind] * before - sine[kind] * axis[k].cross(before);
        const Vector own = -slope[kind] * axis[k];
        left += -curving[kind] * s * s * axis[k] + (s * turning).cross(s * own);
        turning += own;
        now.turning_slope = turning;
        now.spin = s * turning;
        now.turning_left = left;
        const auto at = [&](const R& distance) {
          const Vector arm = distance * now.direction;
          return Point{pin[k].position + arm, pin[k].slope + turning.cross(arm),
                       pin[k].left + left.cross(arm) + now.spin.cross(now.spin.cross(arm))};
        };
        const Point centre = at(m.length / 2);
        now.centre = centre.position;
        now.slope = centre.slope;
        now.left = centre.left;
        pin[k + 1] = at(m.length);
        // d_k = ± n_k × n_{k+1}, + for the first, third and fifth rod.
        axis[k + 1] = kind == 0 ? Vector(now.direction.cross(axis[k])) : Vector(axis[k].cross(now.direction));
        before = now.direction;
      }
    }
  };
};

}  // namespace lubjoint::mechanisms
