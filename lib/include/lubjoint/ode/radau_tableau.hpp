/// Coefficients of the Radau IIA methods, in any precision.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>

namespace lubjoint {

/// Radau IIA of s stages (order 2s − 1), s odd: abscissae c, the eigenvalues of A⁻¹, one real and (s − 1)/2 complex
/// pairs, and the real matrix T whose columns are the eigenvectors v, Re w₁, Im w₁, …, so that
/// T⁻¹A⁻¹T = [γ; α₁ −β₁; β₁ α₁; …]. Nothing is typed in but the definition: the abscissae are the zeros of
///   M(x) = d^{s−1}/dx^{s−1} x^{s−1} (x − 1)^s, scaled so that its first coefficient is 1.
/// A takes the derivatives at c of a polynomial p of degree s with p(0) = 0 to its values. A p′ = μ p′ therefore says
/// p − μp′ = M: p's coefficients follow from the last to the first, and that of x⁰ vanishes for the eigenvalues μ.
/// Source: Hairer and Wanner, Solving Ordinary Differential Equations II, sections IV.5 and IV.8.
template <class R, int Stages>
class RadauTableau {
 public:
  static_assert(Stages >= 3 && Stages % 2 == 1, "an odd number of stages has one real eigenvalue");
  static constexpr int pairs = (Stages - 1) / 2;                 ///< of complex eigenvalues
  using Matrix = Eigen::Matrix<R, Stages, Stages>;               ///< of the stages
  using Vector = Eigen::Matrix<R, Stages, 1>;                    ///< of the stages
  using Pairs = std::array<R, static_cast<std::size_t>(pairs)>;  ///< a number for each complex pair

  Vector c;              ///< abscissae, as shares of the step
  R gamma;               ///< real eigenvalue of A⁻¹
  Pairs alpha;           ///< real parts of the complex pairs
  Pairs beta;            ///< their imaginary parts, positive
  Matrix t;              ///< T
  Matrix t_inverse;      ///< T⁻¹
  Matrix a;              ///< A: integrals of the polynomials through the stages
  Matrix a_inverse;      ///< A⁻¹
  Vector end_slopes;     ///< slopes at 1 of the polynomials of interpolating()
  Vector error_weights;  ///< of the stage increments z: −p′(0) of the polynomial through (0, 0) and (c, z)

  RadauTableau() {
    if constexpr (std::is_same_v<R, double>) {
      take(RadauTableau<long double, Stages>::instance());
    } else {
      derive();
    }
  }

  /// Values at x of the polynomials of degree s that are 0 at x = 0 and at each abscissa but one, where they are 1.
  Vector interpolating(const R& x) const {
    Vector values;
    for (int i = 0; i < Stages; ++i) {
      values(i) = x * scale_(i);
      for (int k = 0; k < Stages; ++k) {
        if (k != i) values(i) *= x - c(k);
      }
    }
    return values;
  }

  /// Computed once for each scalar.
  static const RadauTableau& instance() {
    static const RadauTableau tableau;
    return tableau;
  }

 private:
  /// Each number rounded once: the zeros of M lose two digits in its powers.
  void take(const RadauTableau<long double, Stages>& longer) {
    c = longer.c.template cast<R>();
    gamma = static_cast<R>(longer.gamma);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      alpha[i] = static_cast<R>(longer.alpha[i]);
      beta[i] = static_cast<R>(longer.beta[i]);
    }
    t = longer.t.template cast<R>();
    t_inverse = longer.t_inverse.template cast<R>();
    a = longer.a.template cast<R>();
    a_inverse = longer.a_inverse.template cast<R>();
    end_slopes = longer.end_slopes.template cast<R>();
    error_weights = longer.error_weights.template cast<R>();
    scale();
  }

  void derive() {
    Coefficients monic;  // m_k = (−1)^{s−k} binomial(s, k) (k + s − 1)!/k! · s!/(2s − 1)!
    R sized(1);
    for (int k = Stages; k >= 0; --k) {
      monic[at(k)] = sized;
      if (k > 0) sized *= -R(k) * R(k) / (R(Stages - k + 1) * R(k + Stages - 1));
    }
    // An abscissa is a root of M, an eigenvalue of A one of Σ k! m_k μᵏ.
    Coefficients characteristic = monic;
    for (int k = 0; k <= Stages; ++k) {
      for (int j = 2; j <= k; ++j) characteristic[at(k)] *= R(j);
    }
    const Roots abscissae = roots_of(monic);
    for (int i = 0; i < Stages; ++i) c(i) = abscissae[at(i)].real;
    std::sort(c.data(), c.data() + Stages);
    c(Stages - 1) = R(1);
    int column = 1;
    for (const Number& mu : roots_of(characteristic)) {
      const R square = mu.real * mu.real + mu.imaginary * mu.imaginary;
      if (mu.imaginary < 0) continue;
      const bool is_real = mu.imaginary == 0;
      const int first = is_real ? 0 : column;
      for (int i = 0; i < Stages; ++i) {
        const Number value = quotient(eigenpolynomial(monic, mu, c(i)), eigenpolynomial(monic, mu, R(1)));
        t(i, first) = value.real;
        if (!is_real) t(i, first + 1) = value.imaginary;
      }
      if (is_real) {
        gamma = 1 / mu.real;
      } else {
        alpha[at((column - 1) / 2)] = mu.real / square;
        beta[at((column - 1) / 2)] = mu.imaginary / square;
        column += 2;
      }
    }
    t_inverse = t.inverse();
    Matrix eigenvalues = Matrix::Zero();
    eigenvalues(0, 0) = gamma;
    for (int pair = 0; pair < pairs; ++pair) {
      const int first = 2 * pair + 1;
      eigenvalues(first, first) = eigenvalues(first + 1, first + 1) = alpha[at(pair)];
      eigenvalues(first + 1, first) = beta[at(pair)];
      eigenvalues(first, first + 1) = -beta[at(pair)];
    }
    a_inverse = t * eigenvalues * t_inverse;
    a = a_inverse.inverse();
    scale();
    constexpr int end = Stages - 1;
    end_slopes(end) = R(1);
    for (int i = 0; i < Stages; ++i) {
      error_weights(i) = -scale_(i);
      for (int k = 0; k < Stages; ++k) {
        if (k != i) error_weights(i) *= -c(k);
      }
      if (i == end) continue;
      end_slopes(i) = scale_(i);
      for (int k = 0; k < end; ++k) {
        if (k != i) end_slopes(i) *= 1 - c(k);
      }
      end_slopes(end) += 1 / (1 - c(i));
    }
  }

  void scale() {
    for (int i = 0; i < Stages; ++i) {
      scale_(i) = c(i);
      for (int k = 0; k < Stages; ++k) {
        if (k != i) scale_(i) *= c(i) - c(k);
      }
      scale_(i) = 1 / scale_(i);
    }
  }

  /// std::complex means nothing for numbers that are not built in.
  struct Number {
    R real, imaginary;
  };
  using Coefficients = std::array<R, static_cast<std::size_t>(Stages) + 1>;  ///< of x⁰ to xˢ
  using Roots = std::array<Number, static_cast<std::size_t>(Stages)>;

  Vector scale_;  ///< of the polynomials of interpolating()

  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
  static Number product(const Number& a, const Number& b) {
    return {R(a.real * b.real - a.imaginary * b.imaginary), R(a.real * b.imaginary + a.imaginary * b.real)};
  }
  static Number quotient(const Number& a, const Number& b) {
    const R square = b.real * b.real + b.imaginary * b.imaginary;
    const Number product_with_conjugate = product(a, {b.real, R(-b.imaginary)});
    return {R(product_with_conjugate.real / square), R(product_with_conjugate.imaginary / square)};
  }

  /// p at x.
  static Number eigenpolynomial(const Coefficients& monic, const Number& mu, const R& x) {
    Number coefficient{R(1), R(0)};
    Number value = coefficient;
    for (int k = Stages - 1; k >= 1; --k) {
      coefficient = product(coefficient, {R(mu.real * (k + 1)), R(mu.imaginary * (k + 1))});
      coefficient.real += monic[at(k)];
      value = {R(value.real * x + coefficient.real), R(value.imaginary * x + coefficient.imaginary)};
    }
    return {R(value.real * x), R(value.imaginary * x)};
  }

  /// All roots, each of which is a simple one: all at once in double precision (Durand and Kerner), then each by
  /// Newton's iterations. A root that is real to double precision is real.
  static Roots roots_of(const Coefficients& polynomial) {
    using Complex = std::complex<double>;
    std::array<Complex, static_cast<std::size_t>(Stages)> near;
    for (int i = 0; i < Stages; ++i) near[at(i)] = std::pow(Complex(0.4, 0.9), i);
    for (int sweep = 0; sweep < 200; ++sweep) {
      for (int i = 0; i < Stages; ++i) {
        Complex value = 0;
        for (int k = Stages; k >= 0; --k) value = value * near[at(i)] + static_cast<double>(polynomial[at(k)]);
        value /= static_cast<double>(polynomial[at(Stages)]);
        for (int k = 0; k < Stages; ++k) {
          if (k != i) value /= near[at(i)] - near[at(k)];
        }
        near[at(i)] -= value;
      }
    }
    Roots roots;
    for (int i = 0; i < Stages; ++i) {
      const Complex start = near[at(i)];
      const bool is_real = std::abs(start.imag()) < 1e-9 * std::abs(start);
      Number& root = roots[at(i)] = {R(start.real()), R(is_real ? 0 : start.imag())};
      for (int iteration = 0; iteration < 6; ++iteration) {  // each doubles the digits
        Number value{R(0), R(0)};
        Number slope = value;
        for (int k = Stages; k >= 0; --k) {
          slope = product(slope, root);
          slope = {R(slope.real + value.real), R(slope.imaginary + value.imaginary)};
          value = product(value, root);
          value.real += polynomial[at(k)];
        }
        const Number step = quotient(value, slope);
        root = {R(root.real - step.real), R(root.imaginary - step.imaginary)};
      }
    }
    return roots;
  }
};

}  // namespace lubjoint
