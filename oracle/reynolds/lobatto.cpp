#include "oracle/reynolds/lobatto.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace lubjoint::oracle {

namespace {

struct LegendrePair {
  double last;    ///< P_n(x)
  double before;  ///< P_{n−1}(x)
};

LegendrePair legendre(int n, double x) {
  LegendrePair p{x, 1.0};
  for (int k = 2; k <= n; ++k) p = {((2 * k - 1) * x * p.last - (k - 1) * p.before) / k, p.last};
  return p;
}

/// Zero of (1 − x²)P_n', by Newton from the Chebyshev–Lobatto point; x P_n − P_{n−1} is (x² − 1)P_n'/n, and its
/// derivative (n + 1)P_n.
double lobatto_node(int n, double x) {
  const int enough = 100;  // Newton converges quadratically from there: six steps in practice
  for (int step = 0; step < enough; ++step) {
    const LegendrePair p = legendre(n, x);
    const double change = (x * p.last - p.before) / ((n + 1) * p.last);
    x -= change;
    if (std::abs(change) <= std::numeric_limits<double>::epsilon()) break;
  }
  return x;
}

}  // namespace

LobattoRule lobatto_rule(int degree) {
  const int n = degree;
  LobattoRule rule{n, Eigen::VectorXd(n + 1), Eigen::VectorXd(n + 1), Eigen::VectorXd(n + 1),
                   Eigen::MatrixXd::Zero(n + 1, n + 1)};
  Eigen::VectorXd end_value(n + 1);  // P_n at the nodes
  for (int i = 0; i <= n; ++i) {
    rule.node[i] = i == 0 ? -1.0 : i == n ? 1.0 : lobatto_node(n, -std::cos(std::numbers::pi * i / n));
    end_value[i] = legendre(n, rule.node[i]).last;
    rule.weight[i] = 2 / (n * (n + 1) * end_value[i] * end_value[i]);
    rule.barycentric[i] = 1 / end_value[i];
  }
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      if (i == j) continue;
      rule.derivative(i, j) = end_value[i] / (end_value[j] * (rule.node[i] - rule.node[j]));
      rule.derivative(i, i) -= rule.derivative(i, j);
    }
  }
  return rule;
}

}  // namespace lubjoint::oracle
