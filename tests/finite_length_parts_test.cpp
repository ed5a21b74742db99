// The parts that the finite-length solvers are made of.
#include <Eigen/Cholesky>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "oracle/reynolds/envelope_cholesky.hpp"
#include "oracle/reynolds/lobatto.hpp"

namespace finite_length_parts_test {

using namespace lubjoint::oracle;

namespace {
constexpr double rounding = std::numeric_limits<double>::epsilon();
}

TEST_CASE("Gauss-Lobatto points: the quadrature is exact up to degree 2n - 1, the derivative up to n") {
  for (const int degree : {2, 3, 8, 22}) {
    const LobattoRule rule = lobatto_rule(degree);
    INFO("degree " << degree);
    for (int power = 0; power <= 2 * degree - 1; ++power) {
      const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
      CHECK(rule.weight.dot(rule.node.array().pow(power).matrix()) == Approx(exact).margin(20 * rounding));  // rounding
    }
    const Eigen::VectorXd slope = rule.derivative * rule.node.array().pow(degree).matrix();
    const Eigen::VectorXd exact = degree * rule.node.array().pow(degree - 1).matrix();
    CHECK((slope - exact).norm() < 10 * rounding * rule.derivative.norm());  // rounding of the product
  }
}

TEST_CASE("envelope Cholesky: solves a ring of nodes, whose last rows reach back to the first") {
  const int count = 40;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(count, count);
  EnvelopeCholesky matrix;
  for (int row = 0; row < count; ++row) {
    const int first = row == count - 1 ? 0 : std::max(0, row - 3);
    matrix.add_row(first);
    for (int column = first; column < row; ++column) {
      if (row == count - 1 && column > 0 && column < row - 3) continue;
      const double value = -1.0 / (1 + row - column) - 0.01 * column;
      matrix.at(row, column) = dense(row, column) = dense(column, row) = value;
    }
    matrix.at(row, row) = dense(row, row) = 10;
  }
  const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(count, -1, 2);
  Eigen::VectorXd solution = load;
  matrix.factor();
  matrix.solve(solution);
  CHECK((dense * solution - load).norm() < 10 * rounding * dense.norm() * solution.norm());  // backward stability
}

TEST_CASE("envelope Cholesky: an indefinite matrix is refused") {
  EnvelopeCholesky matrix;
  matrix.add_row(0);
  matrix.add_row(0);
  matrix.at(0, 0) = 1;
  matrix.at(1, 0) = 2;
  matrix.at(1, 1) = 1;
  CHECK_THROWS_WITH(matrix.factor(), Catch::Contains("not positive definite"));
}

}  // namespace finite_length_parts_test
