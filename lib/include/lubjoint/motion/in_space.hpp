/// What motion in coordinates that the constraints leave free asks of bodies in space.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/motion/spatial_prescribed_motion.hpp"
#include "lubjoint/multibody/spatial/coordinate_chart.hpp"

namespace lubjoint {

/// p of a body that is turned further by θ′, a rotation vector in its frame, and |p| = 1: exact to the seventh power of
/// |θ′|, without trigonometry, up to 1 rad; exact beyond.
///   p ∝ p + ½Lᵀθ′ τ,   τ = tan(½|θ′|)/(½|θ′|) = 1 + |θ′|²/12 + |θ′|⁴/120 + …
template <class R>
EulerParameters<R> turned(const EulerParameters<R>& p, const Vector3<R>& by) {
  using std::abs;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const R square = dot(by, by);
  if (square > 1) {
    const R half = sqrt(square) / 2;
    const EulerParameters<R> rate = euler_rate(p, by);
    return normalised(EulerParameters<R>(R(cos(half)) * p + R(sin(half) / half) * rate));
  }
  const EulerParameters<R> next = p + euler_rate(p, scaled(R(1 + square / 12 * (1 + square / 10)), by));
  const R size = next(0) * next(0) + next(1) * next(1) + next(2) * next(2) + next(3) * next(3);
  // Nearly 1 at the end of a search: there the series of 1/√size, whose next term is below rounding.
  const R off = size - 1;
  const R inverse = off * off * abs(off) < std::numeric_limits<R>::epsilon() ? R(1 - off / 2 * (1 - R(0.75) * off))
                                                                             : R(1 / sqrt(size));
  return EulerParameters<R>(R(next(0) * inverse), R(next(1) * inverse), R(next(2) * inverse), R(next(3) * inverse));
}

/// Bodies in space: places are (r, p) of each, velocities (ṙ, ω′), displacements those of r and rotation vectors in the
/// body's frame.
template <class Real>
struct InSpace {
  using R = Real;                            ///< the number
  using System = SpatialSystem<R>;           ///< the bodies
  using Equations = SpatialOde<R>;           ///< in all coordinates
  using Chart = SpatialCoordinateChart<R>;   ///< functions that are free
  using Part = typename Chart::Parts::Part;  ///< of the velocities
  template <class T>
  using Frame = SpatialFrame<T>;  ///< of a body
  template <class T>
  using Workspace = SpatialWorkspace<T>;  ///< of the bodies
  template <class T>
  using Row = SpatialRow<T>;                     ///< of Φ or C
  using Memory = std::vector<JointMemory<R>>;    ///< of the joints
  static constexpr std::size_t coordinates = 7;  ///< of a body's place
  static constexpr std::size_t velocities = 6;   ///< of a body

  /// What a place is found again with: nothing that its coordinates don't say at once.
  struct Orientation {};
  static Orientation orientation(const Frame<R>&) { return {}; }  ///< of a frame
  static Frame<R> ground() { return spatial_ground_frame<R>(); }  ///< a frame at rest

  static const BodyDirections<R>& directions(const Chart& chart) { return chart.directions(); }  ///< of a chart

  // Rows of Φ in A.

  static std::size_t constraint_rows(const System& system) { return system.kept().size(); }  ///< of A
  /// The system's number of a row of A.
  static std::size_t system_row(const System& system, std::size_t row) { return system.kept()[row]; }

  /// Evaluates a constraint at the frames and hands each of its rows that is kept to keep(its number in A, row).
  template <class T, class Time, class Keep>
  static void for_each_row(const System& system, std::size_t c, const Time& t, const Workspace<T>& w,
                           const Keep& keep) {
    const std::size_t row = system.first_row(c);
    const Frame<T>& first = system.frame(system.first_body_of_row(row), w);
    const Frame<T>& second = system.frame(system.second_body_of_row(row), w);
    std::visit(
        [&]<class Constraint>(const Constraint& constraint) {
          std::array<Row<T>, Constraint::rows> from;
          constraint.evaluate(first, second, t, from.data());
          for (std::size_t i = 0; i < Constraint::rows; ++i) {
            const std::size_t number = system.place_among_kept(row + i);
            if (number != System::not_kept) keep(number, from[i]);
          }
        },
        system.constraints()[c].constraint);
  }

  // Places.

  /// |p| = 1
  static void normalise(std::size_t bodies, R* q) {
    for (std::size_t b = 0; b < bodies; ++b) turn(zero_vector<R>(), q + coordinates * b);
  }
  /// Gives each p of a step's end y the sign with which it goes on from the step's start: a search for places may turn
  /// a body by whole revolutions more or less. Between its ends a step's p is near the cubic that both ends say, whose
  /// middle has |p| near 1 with that sign alone. @param h  of the step [s]
  static void go_on_from(const std::vector<R>& start, const R& h, std::size_t bodies, std::vector<R>& y) {
    using std::abs;
    struct End {
      EulerParameters<R> p, rate;
    };
    const auto end = [bodies](const std::vector<R>& of, std::size_t b) {
      const SpatialMotion<R> motion = spatial_motion_in(of.data(), bodies, b);
      return End{motion.parameters, euler_rate(motion.parameters, motion.body_spin)};
    };
    for (std::size_t b = 0; b < bodies; ++b) {
      const End from = end(start, b);
      const End to = end(y, b);
      const auto miss = [&](int sign) {  // of |p|² in the middle
        R square(0);
        for (Eigen::Index k = 0; k < 4; ++k) {
          const R middle = (from.p(k) + sign * to.p(k)) / 2 + h / 8 * (from.rate(k) - sign * to.rate(k));
          square += middle * middle;
        }
        return R(abs(square - 1));
      };
      if (!(miss(-1) < miss(1))) continue;
      for (std::size_t k = 3; k < coordinates; ++k) y[coordinates * b + k] = -y[coordinates * b + k];
    }
  }
  /// Moves the places of a part by its displacements by(i).
  template <class By>
  static void displace(const Chart& chart, const Part& part, const By& by, R* q) {
    std::size_t i = 0;
    for (const std::size_t b : part.bodies) {
      R* place = q + coordinates * b;
      for (; i < part.size() && part.columns[i] < velocities * b + 3; ++i)
        chart.directions().add(part.columns[i], R(by(i)), [place](std::size_t k, const R& more) { place[k] += more; });
      if (i == part.size() || part.columns[i] >= velocities * (b + 1)) continue;
      turn(Vector3<R>(by(i), by(i + 1), by(i + 2)), place);
      i += 3;
    }
  }
  /// A displacement of the i-th velocity of a part in the size of its coordinate.
  static R relative_size(const Part& part, std::size_t i, const R& displacement, const R*, const R& inverse_length) {
    using std::abs;
    const R size = abs(displacement);
    return part.components[i] < 3 ? R(size * inverse_length) : size;
  }

  /// The frame of a body at its place q.
  static void place(Frame<R>& frame, const R* q) {
    frame.moves = true;
    frame.position = Vector3<R>(q[0], q[1], q[2]);
    frame.parameters = EulerParameters<R>(q[3], q[4], q[5], q[6]);
    frame.rotation = rotation_matrix(frame.parameters);
  }
  /// The same from where the frame is: no way is shorter.
  static void move(Frame<R>& frame, const R* q) { place(frame, q); }
  /// The same from another place of the body.
  static bool move_from(const R*, const Orientation&, Frame<R>& frame, const R* q) {
    place(frame, q);
    return true;
  }
  /// Gives a frame the velocities v.
  template <class T>
  static void give_velocities(Frame<T>& frame, const T* v) {
    frame.velocity = Vector3<T>(v[0], v[1], v[2]);
    frame.body_spin = Vector3<T>(v[3], v[4], v[5]);
    frame.spin = product(frame.rotation, frame.body_spin);
  }
  /// Place and frame of a body with the derivatives of its displacements, at rest: dp = ½Lᵀθ′, dA = A θ̃′.
  template <class Seeded, class Slopes>
  static void seed(const Frame<R>& at, const R* q, const Slopes* d, Seeded*, Frame<Seeded>& frame) {
    const R half(0.5);
    frame.moves = true;
    frame.position = Vector3<Seeded>(Seeded(q[0], d[0]), Seeded(q[1], d[1]), Seeded(q[2], d[2]));
    frame.parameters = EulerParameters<Seeded>(Seeded(q[3], Slopes(-half * (q[4] * d[3] + q[5] * d[4] + q[6] * d[5]))),
                                               Seeded(q[4], Slopes(half * (q[3] * d[3] + q[5] * d[5] - q[6] * d[4]))),
                                               Seeded(q[5], Slopes(half * (q[3] * d[4] + q[6] * d[3] - q[4] * d[5]))),
                                               Seeded(q[6], Slopes(half * (q[3] * d[5] + q[4] * d[4] - q[5] * d[3]))));
    const Matrix3<R>& a = at.rotation;
    for (Eigen::Index i = 0; i < 3; ++i) {
      frame.rotation(i, 0) = Seeded(a(i, 0), Slopes(a(i, 1) * d[5] - a(i, 2) * d[4]));
      frame.rotation(i, 1) = Seeded(a(i, 1), Slopes(a(i, 2) * d[3] - a(i, 0) * d[5]));
      frame.rotation(i, 2) = Seeded(a(i, 2), Slopes(a(i, 0) * d[4] - a(i, 1) * d[3]));
    }
  }

  /// Places of frames that are seeded, into a state.
  template <class Seeded>
  static void take_places(const std::vector<Frame<Seeded>>& frames, Seeded* q) {
    for (const Frame<Seeded>& frame : frames) {
      for (Eigen::Index k = 0; k < 3; ++k) *q++ = frame.position(k);
      for (Eigen::Index k = 0; k < 4; ++k) *q++ = frame.parameters(k);
    }
  }

  // Forces and masses.

  /// Tables over angles are read by the pieces that the equations hold, and angles by the revolutions they count.
  template <class T>
  static void hold_tables(Equations& ode, Workspace<T>& w) {
    if (!ode.table_pieces().empty()) w.table_pieces = &ode.table_pieces();
    if (!ode.turns().empty()) w.turns = &ode.turns();
    if constexpr (ScalarTraits<T>::carries_derivatives) hold_tables(ode, w.implicit.at);
  }
  /// Kinematics of the joints, for functions and forces.
  template <class T>
  static void place_joints(const System& system, Workspace<T>& w) {
    system.place_joints(w);
  }
  /// The chart's functions at the frames. @param keep  as of SpatialCoordinateChart::for_each_function
  template <class T, class Keep>
  static void for_each_function(const Chart& chart, const Workspace<T>& w, bool joints_are_placed, const Keep& keep) {
    chart.for_each_function(w, keep, joints_are_placed);
  }
  /// All forces at the frames, of joints that are placed. @param correct  as of SpatialSystem::apply_forces
  template <class T, class Time, class Correct>
  static void apply_forces(const System& system, const Time& t, const Memory& memory, Workspace<T>& w,
                           const Correct& correct) {
    system.apply_forces(t, memory, w, System::every_body, correct, true);
  }
  /// Do forces hold journals on lines, so that only the whole equations know them?
  template <class T>
  static bool slides(const Workspace<T>& w) {
    return !w.slides.empty();
  }
  /// All constraint rows of the frames.
  template <class T, class Time>
  static void evaluate_constraints(const System& system, const Time& t, Workspace<T>& w) {
    system.evaluate_constraints(t, w, System::every_body);
  }
  /// Powers of a ledger.
  template <class T, class Time>
  static void fill_powers(const Equations& ode, const Time& t, const std::vector<T>&, const Workspace<T>& w,
                          T* powers) {
    ode.fill_powers(t, w, powers);
  }

  /// M
  class Mass {
   public:
    /// Of the bodies of a system, kept by reference.
    explicit Mass(const System& system) : bodies_(&system.bodies()) {}
    /// Row i of M x, x(k) that of velocity k.
    template <class V, class At>
    V row(std::size_t i, const At& x) const {
      const SpatialBody<R>& body = (*bodies_)[i / velocities];
      const std::size_t k = i % velocities;
      if (k < 3) return V(body.mass * x(i));
      const auto row = static_cast<Eigen::Index>(k - 3);
      const std::size_t first = i - (k - 3);
      return V(body.inertia(row, 0) * x(first) + body.inertia(row, 1) * x(first + 1) +
               body.inertia(row, 2) * x(first + 2));
    }

   private:
    const std::vector<SpatialBody<R>>* bodies_;
  };

  // Tolerances: those of turns are those of angles, which Euler parameters follow by half.

  /// In which displacements and small turns are comparable. @param tolerance  of all states
  static std::vector<R> units(const Equations& ode, const std::vector<R>& tolerance) {
    std::vector<R> units;
    for (std::size_t i = 0; i < ode.system().velocities(); ++i) units.push_back(of_velocity(ode, i, false, tolerance));
    return units;
  }
  /// Tolerance of a function that is no eccentricity, or of its rate.
  static R tolerance(const Equations& ode, const Chart& chart, std::size_t k, bool of_rate,
                     const std::vector<R>& of_all) {
    return of_velocity(ode, chart.velocity_of(k), of_rate, of_all);
  }

 private:
  static void turn(const Vector3<R>& by, R* place) {
    const EulerParameters<R> p = turned(EulerParameters<R>(place[3], place[4], place[5], place[6]), by);
    std::copy_n(p.data(), 4, place + 3);
  }
  static R of_velocity(const Equations& ode, std::size_t i, bool of_rate, const std::vector<R>& tolerance) {
    if (of_rate) return tolerance[ode.system().places() + i];
    const std::size_t first = coordinates * (i / velocities);
    return i % velocities < 3 ? tolerance[first + i % velocities] : R(2 * tolerance[first + 3]);
  }
};

}  // namespace lubjoint
