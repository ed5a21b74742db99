/// Gauss–Lobatto–Legendre points: the nodes and the quadrature of a spectral element.
#pragma once

#include <Eigen/Core>

namespace lubjoint::oracle {

/// The degree + 1 Gauss–Lobatto–Legendre points on [−1, 1], exact for polynomials of degree 2·degree − 1.
struct LobattoRule {
  int degree;
  Eigen::VectorXd node;
  Eigen::VectorXd weight;
  Eigen::VectorXd barycentric;  ///< weights of the interpolation through the nodes, up to a common factor
  Eigen::MatrixXd derivative;   ///< (i, j): derivative of the j-th Lagrange polynomial at node i
};

/// @param degree  2 or more
LobattoRule lobatto_rule(int degree);

}  // namespace lubjoint::oracle
