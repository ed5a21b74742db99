/// What motion in coordinates that the constraints leave free asks of bodies in the plane.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/prescribed_motion.hpp"
#include "lubjoint/multibody/coordinate_chart.hpp"

namespace lubjoint {

/// Turns a frame by a small angle from a cosine and a sine, to (x, y, φ) of q, by series whose next terms are below
/// rounding. @returns false, and changes nothing, if the angle isn't below 1e-3
template <class R>
bool turn_frame(PlanarFrame<R>& frame, const R* q, const R& angle, const R c, const R s) {
  if (!(angle < R(1e-3) && angle > R(-1e-3))) return false;
  const R square = angle * angle;
  const R sine = angle * (1 - square / 6 * (1 - square / 20));
  const R versed = square / 2 * (1 - square / 12);
  frame.position = Vector2<R>(q[0], q[1]);
  frame.angle = q[2];
  frame.cosine = c - (c * versed + s * sine);
  frame.sine = s - (s * versed - c * sine);
  return true;
}

/// Bodies in the plane: places are q = (x, y, φ) of each, velocities q̇.
template <class Real>
struct InPlane {
  using R = Real;                            ///< the number
  using System = PlanarSystem<R>;            ///< the bodies
  using Equations = MultibodyOde<R>;         ///< in all coordinates
  using Chart = CoordinateChart<R>;          ///< functions that are free
  using Part = typename Chart::Parts::Part;  ///< of the velocities
  template <class T>
  using Frame = PlanarFrame<T>;  ///< of a body
  template <class T>
  using Workspace = SystemWorkspace<T>;  ///< of the bodies
  template <class T>
  using Row = ConstraintRow<T>;                  ///< of Φ or C
  using Memory = std::vector<JointMemory<R>>;    ///< of the joints
  static constexpr std::size_t coordinates = 3;  ///< of a body's place
  static constexpr std::size_t velocities = 3;   ///< of a body

  /// What a place is found again with.
  struct Orientation {
    R cosine;  ///< cos φ
    R sine;    ///< sin φ
  };
  static Orientation orientation(const Frame<R>& frame) { return {frame.cosine, frame.sine}; }  ///< of a frame
  static Frame<R> ground() { return Frame<R>(ground_motion<R>()); }                             ///< a frame at rest

  /// Displacements are counted along the inertial axes.
  struct Directions {
    /// A row as it is.
    template <class Row>
    const Row& of(const Row& row, std::size_t, std::size_t) const {
      return row;
    }
    /// Nothing is to do.
    template <class V>
    void to_inertial(V*) const {}
    /// Nothing is to do.
    template <class V>
    void from_inertial(V*) const {}
    /// x(i), along direction i.
    template <class X>
    auto component(std::size_t i, const X& x) const {
      return x(i);
    }
    /// Calls add_to(component of a body's velocity, value) for what a value along direction i adds.
    template <class V, class Add>
    void add(std::size_t i, const V& value, const Add& add_to) const {
      add_to(i % velocities, value);
    }
    /// Bodies whose directions are others than the inertial ones: none.
    template <class Visit>
    void for_each_turned(const Visit&) const {}
  };
  static Directions directions(const Chart&) { return {}; }  ///< of a chart

  // Rows of Φ in A.

  static std::size_t constraint_rows(const System& system) { return system.constraint_rows(); }  ///< of A
  /// The system's number of a row of A.
  static std::size_t system_row(const System&, std::size_t row) { return row; }

  /// Evaluates a constraint at the frames and hands each of its rows to keep(its number in A, row).
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
          for (std::size_t i = 0; i < Constraint::rows; ++i) keep(row + i, from[i]);
        },
        system.constraints()[c].constraint);
  }

  // Places.

  /// Makes places what they must be apart from constraints: any are.
  static void normalise(std::size_t, R*) {}
  /// Makes a step's end go on from its start: angles in the plane do.
  static void go_on_from(const std::vector<R>&, const R&, std::size_t, std::vector<R>&) {}
  /// Moves the places of a part by its displacements by(i).
  template <class By>
  static void displace(const Chart&, const Part& part, const By& by, R* q) {
    for (std::size_t i = 0; i < part.size(); ++i) q[part.columns[i]] += by(i);
  }
  /// A displacement of the i-th velocity of a part in the size of its coordinate.
  static R relative_size(const Part& part, std::size_t i, const R& displacement, const R* q, const R& inverse_length) {
    const R size = size_of(displacement);
    if (part.components[i] < 2) return size * inverse_length;
    const R angle = size_of(q[part.columns[i]]);
    return angle > 1 ? R(size / angle) : size;
  }

  /// The frame of a body at its place q.
  static void place(Frame<R>& frame, const R* q) {
    frame = Frame<R>(PlanarMotion<R>{Vector2<R>(q[0], q[1]), q[2], Vector2<R>(R(0), R(0)), R(0)});
  }
  /// The same from where the frame is, which may be near.
  static void move(Frame<R>& frame, const R* q) {
    if (!turn_frame(frame, q, R(q[2] - frame.angle), frame.cosine, frame.sine)) place(frame, q);
  }
  /// The same from another place of the body. @returns false if that isn't near
  static bool move_from(const R* q_from, const Orientation& from, Frame<R>& frame, const R* q) {
    return turn_frame(frame, q, R(q[2] - q_from[2]), from.cosine, from.sine);
  }
  /// Gives a frame the velocities v.
  template <class T>
  static void give_velocities(Frame<T>& frame, const T* v) {
    frame.velocity = Vector2<T>(v[0], v[1]);
    frame.spin = v[2];
  }
  /// Place and frame of a body with the derivatives of its displacements, at rest.
  template <class Seeded, class Slopes>
  static void seed(const Frame<R>& at, const R* q, const Slopes* slopes, Seeded* seeded, Frame<Seeded>& frame) {
    for (std::size_t k = 0; k < 3; ++k) seeded[k] = Seeded(q[k], slopes[k]);
    frame.position = Vector2<Seeded>(seeded[0], seeded[1]);
    frame.angle = seeded[2];
    frame.cosine = Seeded(at.cosine, Slopes(-at.sine * slopes[2]));
    frame.sine = Seeded(at.sine, Slopes(at.cosine * slopes[2]));
  }

  /// Places of frames that are seeded, into a state: seed has put them there.
  template <class Seeded>
  static void take_places(const std::vector<Frame<Seeded>>&, Seeded*) {}

  // Forces and masses.

  /// Equations read the pieces of tables that a run holds.
  template <class T>
  static void hold_tables(const Equations& ode, Workspace<T>& w) {
    w.table_pieces = &ode.table_pieces();
  }
  /// Kinematics of the joints, for functions and forces: they are quicker found again than kept.
  template <class T>
  static void place_joints(const System&, Workspace<T>&) {}
  /// The chart's functions at the frames. @param keep  as of CoordinateChart::for_each_function
  template <class T, class Keep>
  static void for_each_function(const Chart& chart, const Workspace<T>& w, bool, const Keep& keep) {
    chart.for_each_function(w, keep);
  }
  /// All forces at the frames. @param correct  as of PlanarSystem::apply_forces
  template <class T, class Time, class Correct>
  static void apply_forces(const System& system, const Time& t, const Memory& memory, Workspace<T>& w,
                           const Correct& correct) {
    system.apply_forces(memory, w, correct);
    if (system.has_elements()) system.apply_elements(t, w);
  }
  /// Do forces hold journals on lines, so that only the whole equations know them?
  template <class T>
  static bool slides(const Workspace<T>& w) {
    return !w.slides.empty();
  }
  /// All constraint rows of the frames.
  template <class T, class Time>
  static void evaluate_constraints(const System& system, const Time& t, Workspace<T>& w) {
    system.evaluate_constraints(t, w);
  }
  /// Powers of a ledger. @param y  the state whose evaluation w is
  template <class T, class Time>
  static void fill_powers(const Equations& ode, const Time& t, const std::vector<T>& y, const Workspace<T>& w,
                          T* powers) {
    ode.fill_powers(t, y, w, powers);
  }

  /// M
  class Mass {
   public:
    /// Of the bodies of a system.
    explicit Mass(const System& system) {
      for (const PlanarBody<R>& body : system.bodies())
        masses_.insert(masses_.end(), {body.mass, body.mass, body.inertia});
    }
    /// Row i of M x, x(k) that of velocity k.
    template <class V, class At>
    V row(std::size_t i, const At& x) const {
      return masses_[i] * x(i);
    }

   private:
    std::vector<R> masses_;
  };

  // Tolerances.

  /// In which velocities are comparable. @param tolerance  of all states
  static std::vector<R> units(const Equations& ode, const std::vector<R>& tolerance) {
    return {tolerance.begin(), tolerance.begin() + static_cast<std::ptrdiff_t>(ode.system().coordinates())};
  }
  /// Tolerance of a function that is no eccentricity, or of its rate.
  static R tolerance(const Equations& ode, const Chart& chart, std::size_t k, bool of_rate,
                     const std::vector<R>& of_all) {
    return of_all[(of_rate ? ode.system().coordinates() : 0) + chart.coordinate_of(k)];
  }

 private:
  static R size_of(const R& x) {
    using std::abs;
    return abs(x);
  }
};

}  // namespace lubjoint
