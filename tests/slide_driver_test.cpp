// The row of a driver along an axis of a body that moves itself, against differences of its Φ along a motion.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>

#include "lubjoint/multibody/driver.hpp"

namespace slide_driver_test {

using namespace lubjoint;

namespace {

using Long = boost::multiprecision::cpp_bin_float_50;

/// Coordinates of two bodies, each a parabola in time: both turn and move.
struct Parabola {
  std::array<double, 6> start{0.1, -0.4, 0.3, 1.2, 0.5, -0.7};
  std::array<double, 6> speed{0.5, 1.1, -2.0, -0.3, 0.8, 3.0};
  std::array<double, 6> acceleration{-1.0, 0.2, 4.0, 2.0, -0.6, 1.5};

  PlanarFrame<Long> body(std::size_t which, const Long& t) const {
    const auto q = [&](std::size_t i) { return Long(start[i] + t * (speed[i] + t * Long(acceleration[i]) / 2)); };
    const auto v = [&](std::size_t i) { return Long(speed[i] + t * acceleration[i]); };
    const std::size_t i = 3 * which;
    return PlanarFrame<Long>(
        PlanarMotion<Long>{Vector2<Long>(q(i), q(i + 1)), q(i + 2), Vector2<Long>(v(i), v(i + 1)), v(i + 2)});
  }
};

}  // namespace

TEST_CASE("slide driver: its rate, its columns and its gamma are those of its constraint, on a guide that turns") {
  MotionShape<Long> shape{Long(0.2), Long(5), Long(0.7)};
  const SlideDriver<Long> driver{{0, {0.3, -0.1}},
                                 {Long(0.6), Long(0.8)},
                                 {1, {-0.2, 0.4}},
                                 Long(0.1),
                                 Long(2),
                                 Long(-3),
                                 std::make_shared<const MotionShape<Long>>(shape)};
  Parabola motion;
  const auto row_at = [&](const Parabola& m, const Long& t) {
    ConstraintRow<Long> row;
    driver.evaluate(m.body(0, t), m.body(1, t), t, &row);
    return row;
  };
  const Long t(0.4);
  const Long h("1e-12");
  const ConstraintRow<Long> row = row_at(motion, t);
  // Differences leave h² and 1e-50/h²: 1e-23 or less.
  const auto close = [](const Long& a, const Long& b) { return abs(a - b) < Long("1e-20"); };
  Long rate = row.time_rate;
  Long along_acceleration(0);
  for (std::size_t i = 0; i < 6; ++i) {
    const Long& column = i < 3 ? row.first[i] : row.second[i - 3];
    const Long speed = motion.speed[i] + t * motion.acceleration[i];
    rate += column * speed;
    along_acceleration += column * motion.acceleration[i];
    // ∂Φ/∂q_i: the motion displaced.
    const auto displaced = [&](const Long& by) {
      PlanarFrame<Long> bodies[2] = {motion.body(0, t), motion.body(1, t)};
      PlanarMotion<Long> moved = bodies[i / 3];
      if (i % 3 == 0) moved.position.x() += by;
      if (i % 3 == 1) moved.position.y() += by;
      if (i % 3 == 2) moved.angle += by;
      bodies[i / 3] = PlanarFrame<Long>(moved);
      ConstraintRow<Long> other;
      driver.evaluate(bodies[0], bodies[1], t, &other);
      return other.value;
    };
    CHECK(close(column, Long((displaced(h) - displaced(-h)) / (2 * h))));
  }
  const Long before = row_at(motion, Long(t - h)).value;
  const Long after = row_at(motion, Long(t + h)).value;
  CHECK(close(rate, Long((after - before) / (2 * h))));
  CHECK(close(along_acceleration - row.gamma, Long((after - 2 * row.value + before) / (h * h))));
}

TEST_CASE("slide driver: a motion that starts later is the same motion") {
  MotionShape<double> shape{0.2, 5, 0.7};
  std::shared_ptr<const MotionShape<double>> moved = std::make_shared<const MotionShape<double>>(shape);
  const std::shared_ptr<const MotionShape<double>> given = moved;
  double start = 1;
  double speed = 2;
  move_start(start, speed, -3.0, moved, 0.25);
  for (const double t : {0.0, 0.3, 1.0}) {
    const DrivenMotion<double> whole = driven_motion(1.0, 2.0, -3.0, given, t + 0.25);
    const DrivenMotion<double> rest = driven_motion(start, speed, -3.0, moved, t);
    CHECK(rest.value == Approx(whole.value).epsilon(1e-14));  // rounding
    CHECK(rest.rate == Approx(whole.rate).epsilon(1e-14));
    CHECK(rest.acceleration == Approx(whole.acceleration).epsilon(1e-14));
  }
}

}  // namespace slide_driver_test
