/// The free rigid body: its spin by Jacobi's elliptic functions, its orientation by one quadrature.
#pragma once

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace lubjoint::mechanisms {

/// Euler's equations J ω̇ = Jω × ω in principal axes. With L² = |Jω|² and 2T = ω·Jω, the spin about the axis d (that of
/// the largest moment where L² > 2T J_m, of the smallest otherwise; m is the middle one, c the third) never changes
/// sign:
///   ω_d = D dn τ,  ω_m = M sn τ,  ω_c = C cn τ,  τ = p t + τ₀,
///   C² = ω_c² + J_m|J_d − J_m|/(J_c|J_d − J_c|) ω_m²,   M² = C² J_c|J_d − J_c|/(J_m|J_d − J_m|),
///   D² = ω_d² + J_m|J_m − J_c|/(J_d|J_d − J_c|) ω_m²,   p² = D²|J_d − J_m||J_d − J_c|/(J_m J_c),
///   k² = C² J_c|J_m − J_c| / (D² J_d|J_d − J_m|);
/// sums of squares, that lose no digit. Source: Landau and Lifshitz, Mechanics, §37. On the separatrix, k = 1.
/// The frame of ℓ = Jω/L and of the body's axis c turns about the fixed direction of L at the rate
///   L (J_d ω_d² + J_m ω_m²)/(J_d² ω_d² + J_m² ω_m²).
/// Errors grow as the rounding of p t, and near the separatrix as that over 1 − k².
class FreeRigidBody {
 public:
  using Vector = Eigen::Vector3d;

  /// @param moments  principal moments [kg m²]
  /// @param spin     ω′ at t = 0, in principal axes [rad/s]
  FreeRigidBody(const Vector& moments, const Vector& spin) : j_(moments), start_(spin) {
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return j_[a] < j_[b]; });
    const double low = j_[order[0]];
    const double middle = j_[order[1]];
    const double high = j_[order[2]];
    const double wl = spin[order[0]];
    const double wh = spin[order[2]];
    const double excess = high * (high - middle) * wh * wh - low * (middle - low) * wl * wl;  // L² − 2T J_m
    const bool about_high = high > middle && excess >= 0;
    d_ = about_high ? order[2] : order[0];
    m_ = order[1];
    c_ = about_high ? order[0] : order[2];
    const double dm = std::abs(j_[d_] - j_[m_]);
    const double dc = std::abs(j_[d_] - j_[c_]);
    const double mc = std::abs(j_[m_] - j_[c_]);
    const double wd = spin[d_];
    const double wm = spin[m_];
    const double wc = spin[c_];
    const bool steady = dm == 0 || dc == 0 || (wc == 0 && wm == 0) || (wd == 0 && wc == 0) || (wd == 0 && mc == 0);
    if (steady) return;
    const double to_c = j_[m_] * dm / (j_[c_] * dc);
    amplitude_[c_] = std::sqrt(wc * wc + to_c * wm * wm);
    amplitude_[m_] = amplitude_[c_] / std::sqrt(to_c);
    amplitude_[d_] = std::copysign(std::sqrt(wd * wd + j_[m_] * mc / (j_[d_] * dc) * wm * wm), wd);
    rate_ = std::abs(amplitude_[d_]) * std::sqrt(dm * dc / (j_[m_] * j_[c_]));
    const double ratio = amplitude_[c_] / amplitude_[d_];
    parameter_ = std::min(1.0, ratio * ratio * j_[c_] * mc / (j_[d_] * dm));
    if (excess == 0) parameter_ = 1;
    if (parameter_ == 1) amplitude_[c_] = std::copysign(amplitude_[c_], wc);  // sech keeps its sign
    // J_m ω̇_m = ±(J_c − J_d) ω_c ω_d, + where (m, c, d) is a cyclic order.
    const double cyclic = (c_ - m_ + 3) % 3 == 1 ? 1 : -1;
    amplitude_[m_] *= cyclic * (j_[c_] - j_[d_]) * amplitude_[c_] * amplitude_[d_] > 0 ? 1 : -1;
    const double sine = wm / amplitude_[m_];
    const double cosine = wc / amplitude_[c_];
    if (parameter_ == 1) {
      phase_ = std::asinh(sine / cosine);
    } else {
      phase_ = gsl_sf_ellint_F(std::atan2(sine, cosine), std::sqrt(parameter_), GSL_PREC_DOUBLE);
      period_ = 2 * gsl_sf_ellint_Kcomp(std::sqrt(parameter_), GSL_PREC_DOUBLE) / rate_;
    }
  }

  /// ω′.
  Vector spin(double t) const {
    if (rate_ == 0) return start_;
    double sn = 0;
    double cn = 0;
    double dn = 0;
    gsl_sf_elljac_e(rate_ * t + phase_, parameter_, &sn, &cn, &dn);
    Vector w;
    dn = std::sqrt(cn * cn + (1 - parameter_) * sn * sn);  // a sum of squares, where dn's own quotient may be 0/0
    w[d_] = amplitude_[d_] * dn;
    w[m_] = amplitude_[m_] * sn;
    w[c_] = amplitude_[c_] * cn;
    return w;
  }

  /// A(t) with A(0) = I.
  Eigen::Matrix3d orientation(double t) const {
    const double size = start_.norm();
    if (size == 0) return Eigen::Matrix3d::Identity();
    if (rate_ == 0) return Eigen::AngleAxisd(size * t, start_ / size).toRotationMatrix();
    double angle = 0;
    double left = t;
    if (period_ > 0) {
      const double turns = std::floor(t / period_);
      left = t - turns * period_;
      angle = turns * turned(0, period_);
    }
    angle += turned(0, left);
    const Eigen::Matrix3d before = frame(start_);
    return before * Eigen::AngleAxisd(angle, Vector::UnitZ()).toRotationMatrix() * frame(spin(t)).transpose();
  }

  /// Time after which the squares of the spin's components are the same again; 0 if they never change or never return.
  double period() const { return period_; }
  /// 1 − k², by which rounding is divided: 0 on the separatrix.
  double from_separatrix() const { return 1 - parameter_; }

 private:
  /// Columns: across L in the plane of L and the axis c, across both, along L; body's frame.
  Eigen::Matrix3d frame(const Vector& w) const {
    const Vector along = j_.cwiseProduct(w).normalized();
    const Vector first = (Vector::Unit(c_) - along[c_] * along).normalized();
    Eigen::Matrix3d columns;
    columns << first, along.cross(first), along;
    return columns;
  }
  double turned(double from, double to) const {
    if (from == to) return 0;
    const double momentum = j_.cwiseProduct(start_).norm();
    const auto rate = [&](double t) {
      const Vector w = spin(t);
      const double first = j_[d_] * w[d_] * w[d_];
      const double second = j_[m_] * w[m_] * w[m_];
      return momentum * (first + second) / (j_[d_] * first + j_[m_] * second);
    };
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(rate, from, to, 8, 1e-12);
  }

  Vector j_;
  Vector start_;
  int d_ = 0;
  int m_ = 1;
  int c_ = 2;
  Vector amplitude_ = Vector::Zero();
  double rate_ = 0;       ///< p; 0: the spin is constant
  double parameter_ = 0;  ///< k²
  double phase_ = 0;
  double period_ = 0;
};

}  // namespace lubjoint::mechanisms
