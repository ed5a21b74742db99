/// Coefficients of the three-stage Radau IIA method, in any precision.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <complex>

namespace lubjoint {

/// Three-stage Radau IIA (order 5): abscissae c, the real and the complex eigenvalue of A⁻¹, and the real matrix T
/// whose columns are the eigenvectors v, Re w, Im w, so that T⁻¹A⁻¹T = [γ; α −β; β α]. Nothing is typed in but the
/// definition: A⁻¹ comes from the collocation conditions, its eigenvalues from the roots of the cubic.
/// Source: Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.8.
template <class R>
struct RadauTableau {
  using Matrix3 = Eigen::Matrix<R, 3, 3>;  ///< of the stages
  using Vector3 = Eigen::Matrix<R, 3, 1>;  ///< of the stages

  Vector3 c;              ///< abscissae, as shares of the step
  R gamma;                ///< real eigenvalue of A⁻¹
  R alpha;                ///< real part of the complex pair
  R beta;                 ///< its imaginary part, positive
  Matrix3 t;              ///< T
  Matrix3 t_inverse;      ///< T⁻¹
  Vector3 error_weights;  ///< of the stage increments in the embedded formula of order 3

  RadauTableau() {
    using std::pow;
    using std::sqrt;
    const R root6 = sqrt(R(6));
    c << (4 - root6) / 10, (4 + root6) / 10, R(1);
    // Characteristic polynomial of A: stability function's denominator 1 − 3z/5 + 3z²/20 − z³/60.
    const R nine = pow(R(9), R(1) / 3);
    const R real_root = (6 + nine * (nine - 1)) / 30;
    const R pair_real = (12 - nine * (nine - 1)) / 60;
    const R pair_imaginary = nine * (nine + 1) * sqrt(R(3)) / 60;
    const R square = pair_real * pair_real + pair_imaginary * pair_imaginary;
    gamma = 1 / real_root;
    alpha = pair_real / square;
    beta = pair_imaginary / square;

    // Collocation: Σ_j a_ij c_j^{k−1} = c_i^k/k, so A = C V⁻¹ and A⁻¹ = V C⁻¹.
    Matrix3 powers;
    Matrix3 integrals;
    for (int i = 0; i < 3; ++i) {
      powers.row(i) << R(1), c(i), c(i) * c(i);
      integrals.row(i) << c(i), c(i) * c(i) / 2, c(i) * c(i) * c(i) / 3;
    }
    const Matrix3 a_inverse = powers * integrals.inverse();

    const Vector3 v = null_vector(a_inverse, gamma);
    // Null vector of (A⁻¹ − (α − iβ)): the cross product of two of its rows, in real and imaginary parts.
    const Matrix3 shifted = a_inverse - alpha * Matrix3::Identity();
    const Vector3 p = shifted.row(0).transpose();
    const Vector3 q = shifted.row(1).transpose();
    const Vector3 i_p(beta, R(0), R(0));
    const Vector3 i_q(R(0), beta, R(0));
    const Vector3 real_part = p.cross(q) - i_p.cross(i_q);
    const Vector3 imaginary_part = p.cross(i_q) + i_p.cross(q);
    t.col(0) = v / v(2);
    const R size = real_part(2) * real_part(2) + imaginary_part(2) * imaginary_part(2);
    t.col(1) = (real_part * real_part(2) + imaginary_part * imaginary_part(2)) / size;
    t.col(2) = (imaginary_part * real_part(2) - real_part * imaginary_part(2)) / size;
    t_inverse = t.inverse();
    error_weights << -(13 + 7 * root6) / 3, (-13 + 7 * root6) / 3, R(-1) / 3;
  }

  /// Computed once for each scalar.
  static const RadauTableau& instance() {
    static const RadauTableau tableau;
    return tableau;
  }

 private:
  static Vector3 null_vector(const Matrix3& matrix, const R& eigenvalue) {
    const Matrix3 shifted = matrix - eigenvalue * Matrix3::Identity();
    const Vector3 p = shifted.row(0).transpose();
    const Vector3 q = shifted.row(1).transpose();
    return p.cross(q);
  }
};

}  // namespace lubjoint
