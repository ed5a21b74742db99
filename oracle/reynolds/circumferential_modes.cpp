#include "oracle/reynolds/circumferential_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace lubjoint::oracle {

namespace {

/// Gauss points of successive bases; a basis has two thirds as many functions, so that H⁴ is integrated, too.
constexpr std::array<std::size_t, 7> gauss_points{20, 32, 64, 96, 128, 256, 512};

/// Nodes and weights of a Gauss–Legendre rule on [−1, 1]. By Boost: the Python package compiles films, and loads no
/// library under the GPL, as GSL is.
struct GaussRule {
  std::vector<double> nodes, weights;

  /// @param points  an even number
  explicit GaussRule(std::size_t points) : nodes(points), weights(points) {
    const auto n = static_cast<int>(points);
    const std::vector<long double> zeros = boost::math::legendre_p_zeros<long double>(n);  // those above 0, ascending
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      const long double x = zeros[i];
      const long double slope = boost::math::legendre_p_prime(n, x);
      const std::size_t above = points / 2 + i;
      const std::size_t below = points / 2 - 1 - i;
      nodes[above] = static_cast<double>(x);
      nodes[below] = -nodes[above];
      weights[above] = weights[below] = static_cast<double>(2 / ((1 - x) * (1 + x) * slope * slope));
    }
  }
};

/// The rule of one of these sizes, made at its first use and shared by all threads.
const GaussRule& gauss_rule(std::size_t step) {
  static const auto rules = [] {
    std::vector<GaussRule> all;
    for (const std::size_t points : gauss_points) all.emplace_back(points);
    return all;
  }();
  return rules.at(step);
}

/// A stretch of film around the bearing.
struct Arc {
  ScaledFilm film;
  double start, end;        ///< x, from the minimum film
  bool cut;                 ///< P = 0 at its ends; else no flow across them
  double radial_share;      ///< how often its moment along e counts in the film's force
  double tangential_share;  ///< and that across
};

std::vector<Arc> arcs_of(FilmExtent extent, const ScaledFilm& film) {
  const double half_turn = std::numbers::pi;
  if (extent == FilmExtent::half) return {{film, -half_turn, 0.0, true, 1, 1}};
  if (extent == FilmExtent::dynamic) {
    // s = 2b cos x − a sin x is positive for π before its zero at atan2(2b, a)
    const double last = std::atan2(2 * film.squeeze, film.slip);
    return {{film, last - half_turn, last, true, 1, 1}};
  }
  ScaledFilm wedge = film;
  ScaledFilm squeeze = film;
  wedge.squeeze = 0;
  squeeze.slip = 0;
  std::vector<Arc> arcs;
  if (wedge.slip != 0) arcs.push_back({wedge, -half_turn, 0.0, true, 0, 2});
  if (squeeze.squeeze != 0) arcs.push_back({squeeze, -half_turn, 0.0, false, 2, 0});
  return arcs;
}

/// 1 − tanh(z)/z as a function of w = z² ≥ 0: the mean over the axis of what a mode carries, over what it would carry
/// in an endless film. tanh's continued fraction has positive terms: nothing cancels.
double axial_share(double w) {
  if (w > 4) {
    const double z = std::sqrt(w);
    return 1 - std::tanh(z) / z;
  }
  double below = 25;  // w/(2n + 1) falls below rounding long before n = 12 for w ≤ 4
  for (int odd = 23; odd >= 3; odd -= 2) below = odd + w / below;
  return w / (below + w);  // tanh z/z = 1/(1 + w/below)
}

/// Integrals of Legendre polynomials, orthonormal in their slopes, on the Gauss points: of P₁, P₂, …, which vanish at
/// both ends, and, unless the ends are cut, before them of P₀.
struct Basis {
  Eigen::MatrixXd value, slope;  ///< a row for each point, a column for each function

  Basis(const GaussRule& rule, Eigen::Index count, bool cut)
      : value(static_cast<Eigen::Index>(rule.nodes.size()), count), slope(value.rows(), count) {
    Eigen::VectorXd p(count + 2);
    for (Eigen::Index i = 0; i < value.rows(); ++i) {
      const double x = rule.nodes[static_cast<std::size_t>(i)];
      p[0] = 1;
      p[1] = x;
      for (Eigen::Index n = 2; n < p.size(); ++n) {
        const auto k = static_cast<double>(n);
        p[n] = ((2 * k - 1) * x * p[n - 1] - (k - 1) * p[n - 2]) / k;
      }
      for (Eigen::Index column = 0; column < count; ++column) {
        const Eigen::Index n = column + (cut ? 1 : 0);
        const double scale = std::sqrt(static_cast<double>(n) + 0.5);
        value(i, column) = scale * (n == 0 ? x : (p[n + 1] - p[n - 1]) / static_cast<double>(2 * n + 1));
        slope(i, column) = scale * p[n];
      }
    }
  }
};

/// What an arc is integrated to by one basis.
struct ArcSums {
  Eigen::Vector2d moments = Eigen::Vector2d::Zero();  ///< its part of ∬ P (cosθ, sinθ) dθ dζ
  double flow = 0;                                    ///< ∫ −H³ ∂ζP dθ at ζ = Λ
};

ArcSums arc_sums(const Arc& arc, std::size_t step) {
  const GaussRule& rule = gauss_rule(step);
  const auto count = static_cast<Eigen::Index>(2 * gauss_points[step] / 3);
  Basis basis(rule, count, arc.cut);
  const double epsilon = arc.film.epsilon;
  const double root_q = std::sqrt(arc.film.thinnest * (1 + epsilon));
  const double squeezed = std::sqrt(arc.film.thinnest / (1 + epsilon));
  const auto sommerfeld = [squeezed](double x) { return 2 * std::atan2(std::sin(x / 2), squeezed * std::cos(x / 2)); };
  const double start = sommerfeld(arc.start);
  const double half = (sommerfeld(arc.end) - start) / 2;

  // With dx = (H/√q) dχ and ∂x = (√q/H) ∂χ: ∫ H³u′v′ dx = √q ∫ H² ∂χu ∂χv dχ, ∫ H³uv dx = (1/√q) ∫ H⁴ uv dχ.
  const Eigen::Index rows = basis.value.rows();
  Eigen::VectorXd stiffness(rows), mass(rows), load(rows);
  Eigen::MatrixX2d direction(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double chi = start + half * (1 + rule.nodes[n]);
    const double cosine = std::cos(chi / 2);
    const double spread = arc.film.thinnest + 2 * epsilon * cosine * cosine;  // 1 + ε cosχ
    const double h = root_q * root_q / spread;
    const double weight = half * rule.weights[n];
    const double cos_x = (std::cos(chi) + epsilon) / spread;
    const double sin_x = root_q * std::sin(chi) / spread;
    const double dx = weight * h / root_q;
    stiffness[i] = root_q * weight * h * h / (half * half);
    mass[i] = dx * h * h * h;
    load[i] = dx * (2 * arc.film.squeeze * cos_x - arc.film.slip * sin_x);
    direction(i, 0) = -dx * cos_x;
    direction(i, 1) = -dx * sin_x;
  }
  // Nothing flows out of an arc with uncut ends, and nothing is squeezed out of it on the whole (∫ s dx = 0): so the
  // mean of P over the circumference, weighted with H³, is harmonic along the axis, that is zero. Functions without
  // that mean are the whole of what is needed, and leave no constant, on which the stiffness would be singular.
  if (!arc.cut) basis.value.rowwise() -= (mass.transpose() * basis.value / mass.sum()).eval();
  // The eigenvalues of the mass in the metric of the stiffness, 1/λ: the largest carry the force, and are right to
  // rounding.
  const Eigen::MatrixXd m = basis.value.transpose() * mass.asDiagonal() * basis.value;
  const Eigen::MatrixXd k = basis.slope.transpose() * stiffness.asDiagonal() * basis.slope;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m, k);
  if (eigen.info() != Eigen::Success) {
    throw std::runtime_error("the eigenfunctions of the finite-length film could not be had");
  }
  const Eigen::VectorXd loads = eigen.eigenvectors().transpose() * (basis.value.transpose() * load);
  const Eigen::MatrixX2d directions = eigen.eigenvectors().transpose() * (basis.value.transpose() * direction);
  const Eigen::VectorXd volumes = eigen.eigenvectors().transpose() * (basis.value.transpose() * mass);  // ∫ H³ v
  const double span = arc.film.slenderness;
  ArcSums sums;
  for (Eigen::Index j = 0; j < count; ++j) {
    const double mu =
        eigen.eigenvalues()[j];  // an eigenvalue of zero is rounding, of a mode that ends within no length
    const double share = mu > 0 ? axial_share(span * span / mu) : 1.0;
    sums.moments += 2 * span * share * loads[j] * directions.row(j).transpose();
    // The functions are of unit stiffness: (s_j/√λ_j) ∫ H³ v_j of functions of unit mass is √λ_j times that of these.
    if (mu > 0) sums.flow += std::tanh(span / std::sqrt(mu)) / std::sqrt(mu) * loads[j] * volumes[j];
  }
  sums.moments = sums.moments.cwiseProduct(Eigen::Vector2d(arc.radial_share, arc.tangential_share)).eval();
  return sums;
}

/// The values of growing bases until their last change is within the tolerance: a share of them, or of a size below
/// which they matter less.
template <int N, class Value>
ScaledResult<N> refined(double relative_tolerance, double least_size, const Value& value_of) {
  using Values = typename ScaledResult<N>::Values;
  ScaledResult<N> result;
  double last_change = std::numeric_limits<double>::infinity();
  for (std::size_t level = 0; level < gauss_points.size(); ++level) {
    const Values value = value_of(level);
    const Values change = (value - result.value).cwiseAbs();
    // Where a finer basis changes more than the one before, rounding is all that is left to see.
    if (level > 2 && change.norm() > last_change) {
      result.error = result.error.cwiseMax(change);
      break;
    }
    result.unknowns = static_cast<int>(2 * gauss_points[level] / 3);
    const double rounding =
        result.unknowns * std::numeric_limits<double>::epsilon() * std::max(value.norm(), least_size);
    result.value = value;
    result.error = change + Values::Constant(rounding);
    if (level > 1) {
      const double ratio = static_cast<double>(gauss_points[level]) / static_cast<double>(gauss_points[level - 1]);
      result.observed_order = std::log(last_change / change.norm()) / std::log(ratio);
      if (result.error.norm() <= relative_tolerance * std::max(result.value.norm(), least_size)) break;
    }
    last_change = change.norm();
  }
  return result;
}

}  // namespace

ScaledForce circumferential_film_force(FilmExtent extent, const ScaledFilm& film, double relative_tolerance) {
  const std::vector<Arc> arcs = arcs_of(extent, film);
  return refined<2>(relative_tolerance, 0, [&arcs](std::size_t level) {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    for (const Arc& arc : arcs) value += arc_sums(arc, level).moments;
    return value;
  });
}

ScaledFlow circumferential_film_flow(FilmExtent extent, const ScaledFilm& film, double relative_tolerance) {
  if (extent == FilmExtent::full) return {};  // what flows out on one side of the circle is drawn in on the other
  const std::vector<Arc> arcs = arcs_of(extent, film);
  return refined<1>(relative_tolerance, film.displacement(), [&arcs](std::size_t level) {
    ScaledFlow::Values value = ScaledFlow::Values::Zero();
    for (const Arc& arc : arcs) value[0] += arc_sums(arc, level).flow;
    return value;
  });
}

}  // namespace lubjoint::oracle
