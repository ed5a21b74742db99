/// Functions given by a table: a cubic between each two of its knots.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lubjoint/number/scalar.hpp"

namespace lubjoint {

/// An interval of a table in a certain period. Its cubic goes on smoothly beyond its ends.
struct TablePiece {
  std::size_t interval = 0;  ///< number of the interval
  double turns = 0;          ///< periods of the table before it
  bool is_held = false;      ///< does it hold wherever it is read? Else the place says which
};

/// N functions of one variable x with the same knots x_0 < … < x_n: between x_k and x_{k+1}, with u = x − x_k,
///   f(x) = c₀ + u (c₁ + u (c₂ + u c₃)).
/// Periodic ones repeat with the period x_n − x_0; others go on beyond their ends by the cubic there, which nobody asks
/// for but an integrator whose last stage is late by rounding. A derivative may jump at a knot: the one to its right
/// holds there.
template <std::size_t N>
class TableCurves {
 public:
  using Cubic = std::array<double, 4>;  ///< c₀ … c₃

  /// @param knots  x_k, finite, each above the one before;  @param pieces  the N cubics of each interval, one fewer
  /// @throws std::invalid_argument  if they are not
  TableCurves(std::vector<double> knots, std::vector<std::array<Cubic, N>> pieces, bool periodic)
      : knots_(std::move(knots)), pieces_(std::move(pieces)), periodic_(periodic) {
    const auto not_below = [](double a, double b) { return !(a < b); };
    if (knots_.size() < 2 || pieces_.size() + 1 != knots_.size() || !std::isfinite(knots_.front()) ||
        !std::isfinite(knots_.back()) || std::adjacent_find(knots_.begin(), knots_.end(), not_below) != knots_.end()) {
      throw std::invalid_argument(
          "a table needs two knots or more, finite and each above the one before, and a piece between each two");
    }
  }

  const std::vector<double>& knots() const { return knots_; }       ///< x_k
  bool is_periodic() const { return periodic_; }                    ///< does it repeat?
  double length() const { return knots_.back() - knots_.front(); }  ///< x_n − x_0, the period of a periodic table
  const std::vector<std::array<Cubic, N>>& pieces() const { return pieces_; }  ///< between the knots

  /// The largest |f| at a knot.
  double largest() const {
    double largest = 0;
    for (const std::array<Cubic, N>& piece : pieces_) {
      for (const Cubic& cubic : piece) largest = std::max(largest, std::abs(cubic[0]));
    }
    for (const double value : at(knots_.back())) largest = std::max(largest, std::abs(value));
    return largest;
  }

  /// How many periods lie between x and the table's own; 0 of one that is not periodic.
  double periods(double x) const { return periodic_ ? std::floor((x - knots_.front()) / length()) : 0; }

  /// Number of the interval that holds x, a place within the table; the first or the last one beyond its ends.
  std::size_t interval(double x) const {
    const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, x);
    return static_cast<std::size_t>(above - knots_.begin()) - 1;
  }

  /// f, f′ and f″.
  template <class T>
  struct Values {
    std::array<T, N> value;      ///< f
    std::array<T, N> slope;      ///< f′
    std::array<T, N> curvature;  ///< f″
  };

  /// f at x, which may carry derivatives.
  template <class T>
  std::array<T, N> at(const T& x) const {
    std::size_t k = 0;
    const T u = within(x, k);
    return of_piece(k, u);
  }

  /// f at x of a piece, also beyond its ends.
  template <class T>
  std::array<T, N> at(const T& x, const TablePiece& piece) const {
    using R = typename ScalarTraits<T>::Real;
    return of_piece(piece.interval, T(x - R(knots_[piece.interval] + piece.turns * length())));
  }

  /// f, f′ and f″ at x, which may carry derivatives.
  template <class T>
  Values<T> with_derivatives(const T& x) const {
    std::size_t k = 0;
    const T u = within(x, k);
    Values<T> result;
    for (std::size_t i = 0; i < N; ++i) {
      const Cubic& c = pieces_[k][i];
      result.value[i] = T(c[0] + u * (c[1] + u * (c[2] + u * c[3])));
      result.slope[i] = T(c[1] + u * (2 * c[2] + u * (3 * c[3])));
      result.curvature[i] = T(2 * c[2] + u * (6 * c[3]));
    }
    return result;
  }

  /// The same functions times a factor.
  TableCurves scaled(double factor) const {
    TableCurves result = *this;
    for (std::array<Cubic, N>& piece : result.pieces_) {
      for (Cubic& cubic : piece) {
        for (double& c : cubic) c *= factor;
      }
    }
    return result;
  }

 private:
  template <class T>
  std::array<T, N> of_piece(std::size_t k, const T& u) const {
    std::array<T, N> result;
    for (std::size_t i = 0; i < N; ++i) {
      const Cubic& c = pieces_[k][i];
      result[i] = T(c[0] + u * (c[1] + u * (c[2] + u * c[3])));
    }
    return result;
  }
  /// x from its knot, and the number of the interval.
  template <class T>
  T within(const T& x, std::size_t& k) const {
    using R = typename ScalarTraits<T>::Real;
    const double place = static_cast<double>(value_of(x));
    const double shift = periods(place) * length();
    k = interval(place - shift);
    return T(x - R(knots_[k] + shift));
  }

  std::vector<double> knots_;
  std::vector<std::array<Cubic, N>> pieces_;
  bool periodic_;
};

}  // namespace lubjoint
