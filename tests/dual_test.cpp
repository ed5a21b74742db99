#include "lubjoint/number/dual.hpp"

#include <catch2/catch.hpp>
#include <unsupported/Eigen/AutoDiff>

#include "lubjoint/film/long_dynamic.hpp"
#include "support/film_jacobian.hpp"
#include "support/film_reference.hpp"

namespace dual_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

using Two = Dual<double, 2>;
using EigensTwo = Eigen::AutoDiffScalar<Eigen::Vector2d>;

Two ours(const EigensTwo& x) { return {x.value(), x.derivatives()}; }

constexpr double rounding = 4 * 0x1p-52;  // a rule adds two products

bool same(const Two& a, const EigensTwo& b) {
  const Two difference = a - ours(b);
  return std::abs(difference.value()) <= rounding * std::abs(b.value()) &&
         difference.derivatives().norm() <= rounding * b.derivatives().norm();
}

/// A function of two variables that uses every rule, numbers and integers among its terms.
struct EveryRule {
  template <class T>
  T operator()(const T& x, const T& y) const {
    using std::abs, std::cos, std::pow, std::sin, std::sqrt;
    T z = -x * y + x / y - 3 * T(cos(x)) + T(sin(y)) * 2 - T(sqrt(x)) / 7;
    z += 1 - T(abs(T(-y))) + 5;
    z -= 2 / T(x + y);
    z *= T(pow(x, 1.5)) - 1;
    z /= y - x;
    return z;
  }
};

}  // namespace

TEST_CASE("dual numbers: each rule gives the derivatives that Eigen's AutoDiffScalar gives") {
  for (const auto& [x, y] : {std::pair(0.7, -1.3), std::pair(3.5, 2.25), std::pair(1e-3, 40.0)}) {
    INFO("x " << x << ", y " << y);
    const Two a(x, {1.5, -0.25}), b(y, {-2, 0.75});
    const EigensTwo c(x, Eigen::Vector2d(1.5, -0.25)), d(y, Eigen::Vector2d(-2, 0.75));
    CHECK(same(-a, -c));
    CHECK(same(a + b, c + d));
    CHECK(same(a - b, c - d));
    CHECK(same(a * b, c * d));
    CHECK(same(a / b, c / d));
    CHECK(same(a + 3, c + 3));
    CHECK(same(3 + a, 3 + c));
    CHECK(same(a - 3, c - 3));
    CHECK(same(3 - a, 3 - c));
    CHECK(same(a * 3, c * 3));
    CHECK(same(3 * a, 3 * c));
    CHECK(same(a / 3, c / 3));
    CHECK(same(3 / a, 3 / c));
    CHECK(same(sqrt(a), sqrt(c)));
    CHECK(same(abs(b), abs(d)));
    CHECK(same(sin(b), sin(d)));
    CHECK(same(cos(b), cos(d)));
    CHECK(same(pow(a, 1.5), pow(c, 1.5)));
  }
}

TEST_CASE("dual numbers: derivatives of a composition equal central differences in 50 digits") {
  const FiftyDigits x(0.7), y(2.1), h("1e-16");
  const EveryRule f;
  using T = Dual<FiftyDigits, 2>;
  const T exact = f(T::variable(x, 0), T::variable(y, 1));
  const FiftyDigits in_x = (f(FiftyDigits(x + h), y) - f(FiftyDigits(x - h), y)) / (2 * h);
  const FiftyDigits in_y = (f(x, FiftyDigits(y + h)) - f(x, FiftyDigits(y - h))) / (2 * h);
  CHECK(exact.value() == f(x, y));
  CHECK(abs(FiftyDigits(exact.derivatives().x() / in_x - 1)) < 1e-28);  // h² times third derivatives
  CHECK(abs(FiftyDigits(exact.derivatives().y() / in_y - 1)) < 1e-28);
  const Two in_double = f(Two::variable(0.7, 0), Two::variable(2.1, 1));
  CHECK(in_double.derivatives().x() == Approx(static_cast<double>(in_x)).epsilon(1e-14));  // a dozen roundings
  CHECK(in_double.derivatives().y() == Approx(static_cast<double>(in_y)).epsilon(1e-14));
}

TEST_CASE("dual numbers: a quotient is in range where squares of its terms are not") {
  const Two small(2e-200, {1e-200, 0}), smaller(1e-200, {0, 3e-200});
  const Two quotient = small / smaller;
  CHECK(quotient.value() == 2);
  CHECK(quotient.derivatives() == Eigen::Vector2d(1, -6));
  CHECK((1 / Two(1e200, {1e200, 0})).derivatives().x() == Approx(-1e-200));
}

TEST_CASE("dual numbers compare as their numbers, and start as constants") {
  const Two a(1, {5, 5}), b(2, {-5, -5});
  CHECK((a < b && a <= b && b > a && b >= a && a != b && a == 1 && 1 < b && b >= 2));
  CHECK(Two().value() == 0);
  CHECK(Two(3).derivatives() == Eigen::Vector2d(0, 0));
  CHECK(Two::variable(3, 1).derivatives() == Eigen::Vector2d(0, 1));
}

TEST_CASE("dual numbers: at zero a power above one is flat, and an absolute value has the slope of its argument") {
  const Two zero = Two::variable(0, 0);
  CHECK(pow(zero, 1.5).derivatives() == Eigen::Vector2d(0, 0));
  CHECK(abs(zero).derivatives() == Eigen::Vector2d(1, 0));
}

TEMPLATE_TEST_CASE("laws differentiate Eigen's AutoDiffScalar as they do dual numbers", "", ShortFull, LongDynamic) {
  using T = Eigen::AutoDiffScalar<Eigen::Vector4d>;
  const Vector2<double> e_hat(0.5, 0.625), u(-0.25, -1);
  const auto expected = exact_force_jacobian<TestType>(e_hat, u);
  const Vector2<T> e_seeded(T(e_hat.x(), 4, 0), T(e_hat.y(), 4, 1)), u_seeded(T(u.x(), 4, 2), T(u.y(), 4, 3));
  const Vector2<T> ratio = force_ratio<TestType>(FilmState<T>(e_seeded, u_seeded));
  for (int i = 0; i < 2; ++i) {
    CHECK(ratio(i).value() == Approx(expected.force(i)).epsilon(1e-14));  // quotients are rounded otherwise
    CHECK((ratio(i).derivatives().transpose() - expected.jacobian.row(i)).norm() <= 1e-12 * expected.jacobian.norm());
  }
}

}  // namespace dual_test
