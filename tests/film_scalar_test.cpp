#include <catch2/catch.hpp>
#include <vector>

#include "support/film_jacobian.hpp"
#include "support/film_reference.hpp"

namespace film_scalar_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

struct PlaneState {
  double ex, ey, ux, uy;
};

/// Closing and opening, both signs of a, small and large ε; none on a = 0, where half films jump.
const std::vector<PlaneState> states = {{0.25, -0.125, 1.5, 0.75}, {0.5, 0.625, -0.25, -1.0}, {-0.75, 0.25, 2.0, 1.25},
                                        {1e-9, 2e-9, 0.5, 3.0},    {-0.6, -0.7, 0.3, -0.2},   {0.0, 0.9375, 1.0, -0.5}};

template <class R>
Vector2<R> plane(double x, double y) {
  return Vector2<R>(R(x), R(y));
}

template <FilmLaw Law, class R>
Vector2<R> ratio_in(const PlaneState& s) {
  return force_ratio<Law>(FilmState<R>(plane<R>(s.ex, s.ey), plane<R>(s.ux, s.uy)));
}

/// |x − y|/|y|, both taken to 50 digits.
template <class R>
double difference(const Vector2<R>& x, const Vector2<FiftyDigits>& y) {
  const FiftyDigits dx = FiftyDigits(x.x()) - y.x();
  const FiftyDigits dy = FiftyDigits(x.y()) - y.y();
  return static_cast<double>(sqrt(FiftyDigits((dx * dx + dy * dy) / (y.x() * y.x() + y.y() * y.y()))));
}

}  // namespace

TEST_CASE("every law gives the same force in double, long double and 50 digits, to the lower precision") {
  for_each_film_law([]<class Law>() {
    for (const PlaneState& s : states) {
      INFO(Law::name << " at (" << s.ex << ", " << s.ey << "), (" << s.ux << ", " << s.uy << ")");
      const Vector2<FiftyDigits> exact = ratio_in<Law, FiftyDigits>(s);
      CHECK(difference(ratio_in<Law, double>(s), exact) < 60 * 0x1p-52);       // a few dozen roundings at ε ≤ 0.94
      CHECK(difference(ratio_in<Law, long double>(s), exact) < 60 * 0x1p-63);  // the same in 64 bits
    }
  });
}

TEST_CASE("what rounding leaves out of a square is exact, in double and in long double") {
  const auto is_exact = []<class R>(R x) {
    const R square = x * x;
    const FiftyDigits left_out = FiftyDigits(x) * FiftyDigits(x) - FiftyDigits(square);  // 128 bits of 168
    return left_out == FiftyDigits(detail::left_out_of_square(x, square));
  };
  for (const double x : {0.7, 1 - 0x1p-53, 0x1.00000113p-1, 1e-9}) CHECK(is_exact(x));
  // Halves are longest just above a power of two.
  for (const long double x : {0.7L, 1 - 0x1p-64L, 0x8.0000000448b7abfp-4L, 0x8.00000007382d1e7p-4L, 1e-9L}) {
    CHECK(is_exact(x));
  }
}

TEST_CASE("automatic differentiation leaves the value of every law as it is without derivatives") {
  for_each_film_law([]<class Law>() {
    for (const PlaneState& s : states) {
      INFO(Law::name << " at (" << s.ex << ", " << s.ey << "), (" << s.ux << ", " << s.uy << ")");
      const Vector2<double> plain = ratio_in<Law, double>(s);
      const auto dual = exact_force_jacobian<Law>(plane<double>(s.ex, s.ey), plane<double>(s.ux, s.uy));
      CHECK((dual.force - plain).norm() <= 4 * 0x1p-52 * plain.norm());  // dual quotients round once more
    }
  });
}

TEST_CASE("the Jacobian of every law by automatic differentiation equals central differences in 50 digits") {
  const FiftyDigits h("1e-16");
  for_each_film_law([&]<class Law>() {
    for (const PlaneState& s : states) {
      INFO(Law::name << " at (" << s.ex << ", " << s.ey << "), (" << s.ux << ", " << s.uy << ")");
      const Vector2<FiftyDigits> e = plane<FiftyDigits>(s.ex, s.ey);
      const Vector2<FiftyDigits> u = plane<FiftyDigits>(s.ux, s.uy);
      const bool at_pole = Law::extent == FilmExtent::half && s.ex * s.ex + s.ey * s.ey < 1e-16;
      // h over ε is 5e-8 there, and a half film turns with the direction of ê: the truncation is 1/ε³ times h².
      const double truncation = at_pole ? 1e-5 : 1e-20;  // h² times third derivatives of order 1e5 at ε = 0.94
      const auto differences = difference_jacobian<Law, FiftyDigits>(e, u, h);
      const FiftyDigits size = differences.norm();
      const auto exact = exact_force_jacobian<Law>(e, u);
      CHECK(static_cast<double>((exact.jacobian - differences).norm() / size) < truncation);
      const auto in_double = exact_force_jacobian<Law>(plane<double>(s.ex, s.ey), plane<double>(s.ux, s.uy));
      const Eigen::Matrix<FiftyDigits, 2, 4> widened = in_double.jacobian.template cast<FiftyDigits>();
      // Derivatives of the moments cancel a digit or two more than the force does. A half film is written in r and t,
      // whose derivatives 1/ε cancel for the isotropic part of its damping.
      const double epsilon = std::hypot(s.ex, s.ey);
      const double cancelled = Law::extent == FilmExtent::half ? 1 / epsilon : 0;
      CHECK(static_cast<double>((widened - exact.jacobian).norm() / size) < (1000 + cancelled) * 0x1p-52);
    }
  });
}

}  // namespace film_scalar_test
