/// Real and complex balls: numbers that are enclosed, a midpoint and a radius, with FLINT/Arb's rigorous arithmetic.
#pragma once

#include <acb.h>
#include <arb.h>

#include <stdexcept>
#include <utility>

namespace lubjoint::certified {

/// Thrown where a decision would need a smaller ball, a sign for example: calls for more precision.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bits of all operations of this thread.
inline slong& working_bits() {
  thread_local slong bits = 128;
  return bits;
}

/// Sets the working precision for a scope.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(slong bits) : before_(std::exchange(working_bits(), bits)) {}
  ~WorkingPrecision() { working_bits() = before_; }
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

 private:
  slong before_;
};

/// An enclosed real number. Operations enclose the result for every number in the operands' balls.
class Ball {
 public:
  Ball() { arb_init(x_); }
  Ball(int value) : Ball() { arb_set_si(x_, value); }
  Ball(double value) : Ball() { arb_set_d(x_, value); }  ///< exactly this double
  Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(x_, other.x_); }
  Ball& operator=(Ball other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }

  bool is_exact_zero() const { return arb_is_zero(x_) != 0; }
  /// −1, 0 (exactly zero) or 1. @throws Undecided if the ball contains zero and another number
  int sign() const {
    if (is_exact_zero()) return 0;
    if (arb_contains_zero(x_)) throw Undecided("the sign of a ball that contains zero");
    return arb_is_positive(x_) ? 1 : -1;
  }
  bool overlaps(const Ball& other) const { return arb_overlaps(x_, other.x_) != 0; }

  Ball operator-() const {
    return made([&](arb_t r) { arb_neg(r, x_); });
  }
  friend Ball operator+(const Ball& a, const Ball& b) {
    return made([&](arb_t r) { arb_add(r, a.x_, b.x_, working_bits()); });
  }
  friend Ball operator-(const Ball& a, const Ball& b) {
    return made([&](arb_t r) { arb_sub(r, a.x_, b.x_, working_bits()); });
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    return made([&](arb_t r) { arb_mul(r, a.x_, b.x_, working_bits()); });
  }
  friend Ball operator/(const Ball& a, const Ball& b) {
    return made([&](arb_t r) { arb_div(r, a.x_, b.x_, working_bits()); });
  }
  friend Ball sqrt(const Ball& a) {
    return made([&](arb_t r) { arb_sqrt(r, a.x_, working_bits()); });
  }
  friend Ball sin(const Ball& a) {
    return made([&](arb_t r) { arb_sin(r, a.x_, working_bits()); });
  }
  friend Ball cos(const Ball& a) {
    return made([&](arb_t r) { arb_cos(r, a.x_, working_bits()); });
  }
  friend Ball log1p(const Ball& a) {
    return made([&](arb_t r) { arb_log1p(r, a.x_, working_bits()); });
  }
  friend Ball abs(const Ball& a) {
    return made([&](arb_t r) { arb_abs(r, a.x_); });
  }
  friend Ball atan2(const Ball& y, const Ball& x) {
    return made([&](arb_t r) { arb_atan2(r, y.x_, x.x_, working_bits()); });
  }

 private:
  template <class Operation>
  static Ball made(Operation&& operation) {
    Ball result;
    operation(result.x_);
    return result;
  }
  arb_t x_;
};

inline Ball ball_pi() {
  Ball result;
  arb_const_pi(result.get(), working_bits());
  return result;
}

/// An enclosed complex number, for integrands.
class ComplexBall {
 public:
  ComplexBall() { acb_init(z_); }
  explicit ComplexBall(acb_srcptr z) : ComplexBall() { acb_set(z_, z); }
  ComplexBall(const Ball& x) : ComplexBall() { acb_set_arb(z_, x.get()); }
  ComplexBall(const ComplexBall& other) : ComplexBall() { acb_set(z_, other.z_); }
  ComplexBall(ComplexBall&& other) noexcept : ComplexBall() { acb_swap(z_, other.z_); }
  ComplexBall& operator=(ComplexBall other) noexcept {
    acb_swap(z_, other.z_);
    return *this;
  }
  ~ComplexBall() { acb_clear(z_); }

  acb_ptr get() { return z_; }
  acb_srcptr get() const { return z_; }

  friend ComplexBall operator+(const ComplexBall& a, const ComplexBall& b) {
    return made([&](acb_t r) { acb_add(r, a.z_, b.z_, working_bits()); });
  }
  friend ComplexBall operator-(const ComplexBall& a, const ComplexBall& b) {
    return made([&](acb_t r) { acb_sub(r, a.z_, b.z_, working_bits()); });
  }
  friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
    return made([&](acb_t r) { acb_mul(r, a.z_, b.z_, working_bits()); });
  }
  friend ComplexBall operator*(const Ball& a, const ComplexBall& b) {
    return made([&](acb_t r) { acb_mul_arb(r, b.z_, a.get(), working_bits()); });
  }
  friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) {
    return made([&](acb_t r) { acb_div(r, a.z_, b.z_, working_bits()); });
  }
  friend std::pair<ComplexBall, ComplexBall> sin_cos(const ComplexBall& a) {
    std::pair<ComplexBall, ComplexBall> result;
    acb_sin_cos(result.first.z_, result.second.z_, a.z_, working_bits());
    return result;
  }

 private:
  template <class Operation>
  static ComplexBall made(Operation&& operation) {
    ComplexBall result;
    operation(result.z_);
    return result;
  }
  acb_t z_;
};

}  // namespace lubjoint::certified
