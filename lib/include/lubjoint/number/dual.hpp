/// Dual numbers: forward-mode automatic differentiation of the laws and the equations of motion.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>

#include "lubjoint/number/scalar.hpp"

namespace lubjoint {

/// x and its derivatives in N variables. Every operation gives a Dual at once, with derivatives in place: nothing is
/// allocated, and a compiler sees one type. Eigen's AutoDiffScalar gives a type of its own to every expression, which
/// takes it two to three times as long to compile. Comparisons are those of the numbers.
/// R: float, double, long double or a number of Boost.Multiprecision. Derivatives are exact but for rounding: a few
/// units in the last place of the larger of the terms that a rule adds.
template <class R, int N>
class Dual {
 public:
  using Scalar = R;                            ///< the number itself
  using Derivatives = Eigen::Matrix<R, N, 1>;  ///< ∂x/∂(variables)

  /// Zero, a constant.
  Dual() : Dual(0) {}
  /// A constant: its derivatives are zero.
  template <std::convertible_to<R> U>
  Dual(const U& value) : value_(static_cast<R>(value)), derivatives_(Derivatives::Zero()) {}
  /// A number and its derivatives.
  Dual(const R& value, const Derivatives& derivatives) : value_(value), derivatives_(derivatives) {}
  /// The variable of this index, 0 to N − 1: its derivative in itself is one.
  static Dual variable(const R& value, Eigen::Index index) { return {value, Derivatives::Unit(index)}; }

  const R& value() const { return value_; }                        ///< the number
  R& value() { return value_; }                                    ///< the number, to be set
  const Derivatives& derivatives() const { return derivatives_; }  ///< its derivatives
  Derivatives& derivatives() { return derivatives_; }              ///< its derivatives, to be set

  /// −a
  friend Dual operator-(const Dual& a) { return {-a.value_, -a.derivatives_}; }
  /// a + b
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value_ + b.value_, a.derivatives_ + b.derivatives_}; }
  /// a − b
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value_ - b.value_, a.derivatives_ - b.derivatives_}; }
  /// a b
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value_ * b.value_, a.derivatives_ * b.value_ + b.derivatives_ * a.value_};
  }
  /// a/b, (a′ − (a/b) b′)/b: no square of b, which could leave the range where the quotient does not.
  friend Dual operator/(const Dual& a, const Dual& b) {
    const R quotient = a.value_ / b.value_;
    return {quotient, (a.derivatives_ - b.derivatives_ * quotient) * R(1 / b.value_)};
  }

  /// a + b, b a number
  template <std::convertible_to<R> U>
  friend Dual operator+(const Dual& a, const U& b) {
    return {a.value_ + static_cast<R>(b), a.derivatives_};
  }
  /// a + b, a a number
  template <std::convertible_to<R> U>
  friend Dual operator+(const U& a, const Dual& b) {
    return b + a;
  }
  /// a − b, b a number
  template <std::convertible_to<R> U>
  friend Dual operator-(const Dual& a, const U& b) {
    return {a.value_ - static_cast<R>(b), a.derivatives_};
  }
  /// a − b, a a number
  template <std::convertible_to<R> U>
  friend Dual operator-(const U& a, const Dual& b) {
    return {static_cast<R>(a) - b.value_, -b.derivatives_};
  }
  /// a b, b a number
  template <std::convertible_to<R> U>
  friend Dual operator*(const Dual& a, const U& b) {
    const R factor(b);
    return {a.value_ * factor, a.derivatives_ * factor};
  }
  /// a b, a a number
  template <std::convertible_to<R> U>
  friend Dual operator*(const U& a, const Dual& b) {
    return b * a;
  }
  /// a/b, b a number
  template <std::convertible_to<R> U>
  friend Dual operator/(const Dual& a, const U& b) {
    const R divisor(b);
    return {a.value_ / divisor, a.derivatives_ * R(1 / divisor)};
  }
  /// a/b, a a number
  template <std::convertible_to<R> U>
  friend Dual operator/(const U& a, const Dual& b) {
    const R quotient = static_cast<R>(a) / b.value_;
    return {quotient, b.derivatives_ * R(-quotient) * R(1 / b.value_)};
  }

  Dual& operator+=(const Dual& b) { return *this = *this + b; }  ///< *this + b
  Dual& operator-=(const Dual& b) { return *this = *this - b; }  ///< *this − b
  Dual& operator*=(const Dual& b) { return *this = *this * b; }  ///< *this times b
  Dual& operator/=(const Dual& b) { return *this = *this / b; }  ///< *this over b

  /// a = b
  friend bool operator==(const Dual& a, const Dual& b) { return a.value_ == b.value_; }
  /// a < b
  friend bool operator<(const Dual& a, const Dual& b) { return a.value_ < b.value_; }
  /// a > b
  friend bool operator>(const Dual& a, const Dual& b) { return a.value_ > b.value_; }
  /// a ≤ b
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value_ <= b.value_; }
  /// a ≥ b
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value_ >= b.value_; }

  /// √a: derivatives a′/(2√a), infinite or no number at a = 0.
  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const R root = sqrt(a.value_);
    return {root, a.derivatives_ / R(2 * root)};
  }
  /// |a|: at a = 0 the derivatives of a.
  friend Dual abs(const Dual& a) { return a.value_ < 0 ? -a : a; }
  /// cos a
  friend Dual cos(const Dual& a) {
    using std::cos;
    using std::sin;
    return {cos(a.value_), a.derivatives_ * R(-sin(a.value_))};
  }
  /// sin a
  friend Dual sin(const Dual& a) {
    using std::cos;
    using std::sin;
    return {sin(a.value_), a.derivatives_ * R(cos(a.value_))};
  }
  /// aⁿ, n a constant, for a > 0, and for a = 0 if n ≥ 1.
  friend Dual pow(const Dual& a, const R& n) {
    using std::pow;
    return {pow(a.value_, n), a.derivatives_ * R(n * pow(a.value_, R(n - 1)))};
  }

 private:
  R value_;
  Derivatives derivatives_;
};

/// What is asked of a scalar: a Dual's number.
template <class R, int N>
struct ScalarTraits<Dual<R, N>> {
  using Real = R;                                                      ///< the number itself, without derivatives
  static constexpr bool carries_derivatives = true;                    ///< it is differentiated forward
  static const Real& value(const Dual<R, N>& x) { return x.value(); }  ///< the number
};

}  // namespace lubjoint

namespace Eigen {

/// Of Eigen's unsupported module AutoDiff, which is not included here.
template <class Derivatives>
class AutoDiffScalar;

/// Vectors of Duals.
template <class R, int N>
struct NumTraits<lubjoint::Dual<R, N>> : NumTraits<R> {
  using Real = lubjoint::Dual<R, N>;   ///< it is real
  using NonInteger = Real;             ///< and no integer
  using Nested = Real;                 ///< expressions hold it by value
  enum { RequireInitialization = 1 };  ///< memory is not enough
};
/// Vectors of Duals times numbers.
template <class R, int N, class Operation>
struct ScalarBinaryOpTraits<lubjoint::Dual<R, N>, R, Operation> {
  using ReturnType = lubjoint::Dual<R, N>;  ///< a Dual
};
/// Numbers times vectors of Duals.
template <class R, int N, class Operation>
struct ScalarBinaryOpTraits<R, lubjoint::Dual<R, N>, Operation> {
  using ReturnType = lubjoint::Dual<R, N>;  ///< a Dual
};

}  // namespace Eigen

namespace lubjoint {

/// The same of an AutoDiffScalar: the laws differentiate it, too, for those who have it in their code.
template <class Derivatives>
struct ScalarTraits<Eigen::AutoDiffScalar<Derivatives>> {
  using Real = typename Eigen::AutoDiffScalar<Derivatives>::Scalar;  ///< the number itself, without derivatives
  static constexpr bool carries_derivatives = true;                  ///< it is differentiated forward
  /// The number.
  static const Real& value(const Eigen::AutoDiffScalar<Derivatives>& x) { return x.value(); }
};

}  // namespace lubjoint
