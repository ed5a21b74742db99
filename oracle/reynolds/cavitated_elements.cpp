#include "oracle/reynolds/cavitated_elements.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace lubjoint::oracle {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// The film at ψ, seen from the maximum film: H and the functions of θ.
struct FilmAt {
  double thickness;
  double stretch;  ///< dθ/dψ = H/√q
  double cosine;   ///< cosθ
  double sine;     ///< sinθ

  FilmAt(const ScaledFilm& film, double psi) {
    const double q = film.thinnest * (1 + film.epsilon);
    const double root = std::sqrt(q);
    const double half = std::sin(psi / 2);
    const double gap = film.thinnest + 2 * film.epsilon * half * half;  // 1 − ε cosψ
    thickness = q / gap;
    stretch = thickness / root;
    cosine = (std::cos(psi) - film.epsilon) / gap;
    sine = root * std::sin(psi) / gap;
  }
};

/// An element's integrals around the film, over its two places on ψ.
struct AroundElement {
  Eigen::Matrix2d stiff = Eigen::Matrix2d::Zero();  ///< of ∂ψ ∂ψ
  Eigen::Matrix2d mass = Eigen::Matrix2d::Zero();   ///< of the axial part
  Eigen::Vector2d source = Eigen::Vector2d::Zero();

  /// Of nodes of the same place along the axis, or of neighbouring ones, rise apart.
  double entry(int a, int b, bool same, double rise) const {
    return stiff(a, b) * rise * (same ? 1.0 / 3 : 1.0 / 6) + mass(a, b) * (same ? 1.0 : -1.0) / rise;
  }
};

/// One grid: bilinear elements on 0 ≤ ψ < 2π, periodic, and 0 ≤ ζ ≤ Λ, P = 0 at the end.
class ElementGrid {
 public:
  ElementGrid(const ScaledFilm& film, int around)
      : around_(around), along_(around / 4), rise_(film.slenderness / along_) {
    const Eigen::Index unknowns = static_cast<Eigen::Index>(around_) * along_;
    source_ = Vector::Zero(unknowns);
    weight_ = Eigen::MatrixX2d::Zero(unknowns, 2);
    std::vector<Eigen::Triplet<double>> entries;
    const double step = 2 * std::numbers::pi / around_;
    for (int i = 0; i < around_; ++i) {
      // Around: two-point Gauss rule; along the axis the integrals are exact.
      AroundElement element;
      Eigen::Matrix2d weight = Eigen::Matrix2d::Zero();
      for (const double side : {-1.0, 1.0}) {
        const double place = 0.5 + side / (2 * std::numbers::sqrt3);
        const FilmAt at(film, (i + place) * step);
        const double cube = at.thickness * at.thickness * at.thickness;
        const Eigen::Vector2d shape(1 - place, place);
        const Eigen::Vector2d slope(-1 / step, 1 / step);
        const double length = step / 2;
        element.stiff += length * cube / at.stretch * slope * slope.transpose();
        element.mass += length * cube * at.stretch * shape * shape.transpose();
        element.source += length * at.stretch * (film.slip * at.sine - 2 * film.squeeze * at.cosine) * shape;
        weight.col(0) += length * at.stretch * at.cosine * shape;
        weight.col(1) += length * at.stretch * at.sine * shape;
      }
      for (int j = 0; j < along_; ++j) {
        for (int a = 0; a < 4; ++a) {
          const Eigen::Index row = node(i + a % 2, j + a / 2);
          if (row < 0) continue;
          source_[row] += element.source[a % 2] * rise_ / 2;
          weight_.row(row) += weight.row(a % 2) * rise_ / 2;
          for (int b = 0; b < 4; ++b) {
            const Eigen::Index column = node(i + b % 2, j + b / 2);
            if (column < 0) continue;
            const double value = element.entry(a % 2, b % 2, a / 2 == b / 2, rise_);
            entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
          }
        }
      }
      elements_.push_back(element);
    }
    matrix_.resize(unknowns, unknowns);
    matrix_.setFromTriplets(entries.begin(), entries.end());
  }

  /// @throws std::runtime_error if the active set does not settle
  void solve() {
    std::vector<char> carries(static_cast<std::size_t>(source_.size()), 1);
    constexpr int most = 200;  // a boundary moves by a node or more in each step
    for (int step = 0; step < most; ++step) {
      pressure_ = solved(carries);
      const Vector residual = matrix_ * pressure_ - source_;
      bool changed = false;
      for (Eigen::Index i = 0; i < source_.size(); ++i) {
        char& carrier = carries[static_cast<std::size_t>(i)];
        const char next = carrier ? pressure_[i] >= 0 : residual[i] < 0;
        changed = changed || next != carrier;
        carrier = next;
      }
      if (!changed) return;
    }
    throw std::runtime_error("the bounds of a cavitated film did not settle");
  }

  /// ∬ P (cosθ, sinθ) dθ dζ over the whole length.
  Eigen::Vector2d force() const { return 2 * weight_.transpose() * pressure_; }  // both halves of the length

  /// ∫ −H³ ∂ζP dθ at the end.
  double edge_flow() const {
    double sum = 0;
    for (const EndNode& end : end_nodes()) sum += std::max(end.source - end.fed, 0.0);
    return sum;
  }

  /// Share of ψ and ζ that carries pressure; nodes at the end count by half of their neighbours' area.
  double carried_share() const {
    const Vector fed = matrix_ * pressure_;
    const auto share = [](double feeds, double source) {
      return source >= 0 ? 1.0 : std::clamp(feeds / source, 0.0, 1.0);
    };
    double sum = 0;
    for (int i = 0; i < around_; ++i) {
      for (int j = 0; j < along_; ++j) {
        const Eigen::Index n = node(i, j);
        sum += (j == 0 ? 0.5 : 1.0) * (pressure_[n] > 0 ? 1.0 : share(fed[n], source_[n]));
      }
    }
    const std::vector<EndNode> ends = end_nodes();
    for (const EndNode& end : ends) sum += 0.5 * share(end.fed, end.source);
    return sum / (around_ * along_);
  }

  int unknowns() const { return static_cast<int>(source_.size()); }

 private:
  /// A node at the end of the bearing, where P = 0 is given: its source, and the equation's other side.
  struct EndNode {
    double source = 0;
    double fed = 0;
  };

  std::vector<EndNode> end_nodes() const {
    std::vector<EndNode> ends(static_cast<std::size_t>(around_));
    for (int i = 0; i < around_; ++i) {
      const AroundElement& element = elements_[static_cast<std::size_t>(i)];
      for (int a = 0; a < 2; ++a) {
        EndNode& end = ends[static_cast<std::size_t>((i + a) % around_)];
        end.source += element.source[a] * rise_ / 2;
        for (int b = 0; b < 2; ++b) {
          end.fed += element.entry(a, b, false, rise_) * pressure_[node(i + b, along_ - 1)];
        }
      }
    }
    return ends;
  }

  /// Number of a node; −1 at the end of the bearing, where P = 0.
  Eigen::Index node(int i, int j) const {
    if (j == along_) return -1;
    return static_cast<Eigen::Index>(i % around_) * along_ + j;
  }

  /// The pressure where it is carried by these nodes and zero at the others.
  Vector solved(const std::vector<char>& carries) const {
    std::vector<int> place(carries.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < carries.size(); ++i) {
      if (carries[i]) place[i] = count++;
    }
    Vector all = Vector::Zero(source_.size());
    if (count == 0) return all;
    std::vector<Eigen::Triplet<double>> entries;
    Vector right(count);
    for (int column = 0; column < matrix_.outerSize(); ++column) {
      const int c = place[static_cast<std::size_t>(column)];
      if (c < 0) continue;
      right[c] = source_[column];
      for (Sparse::InnerIterator entry(matrix_, column); entry; ++entry) {
        const int r = place[static_cast<std::size_t>(entry.row())];
        if (r >= 0) entries.emplace_back(r, c, entry.value());
      }
    }
    Sparse matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLLT<Sparse> factor(matrix);
    if (factor.info() != Eigen::Success) throw std::runtime_error("the matrix of a cavitated film is not definite");
    const Vector pressure = factor.solve(right);
    for (std::size_t i = 0; i < carries.size(); ++i) {
      if (place[i] >= 0) all[static_cast<Eigen::Index>(i)] = pressure[place[i]];
    }
    return all;
  }

  int around_;
  int along_;
  double rise_;  ///< of an element along ζ
  std::vector<AroundElement> elements_;
  Vector pressure_;
  Sparse matrix_;
  Vector source_;
  Eigen::MatrixX2d weight_;
};

/// What three grids give, extrapolated.
/// @param at_least  of the change from the second grid to the third: what the error estimate is no smaller than
template <int N, class Value>
ScaledResult<N> extrapolated(const ScaledFilm& film, int around, double at_least, const Value& value_of) {
  if (around < 8) throw std::invalid_argument("elements around a film: allowed are 8 or more");
  using Values = typename ScaledResult<N>::Values;
  std::array<Values, 3> values;
  ScaledResult<N> result;
  for (std::size_t level = 0; level < values.size(); ++level) {
    ElementGrid grid(film, around << level);
    grid.solve();
    values[level] = value_of(grid);
    result.unknowns = grid.unknowns();
  }
  const Values coarse = values[1] + (values[1] - values[0]) / 3;
  result.value = values[2] + (values[2] - values[1]) / 3;
  result.error = (result.value - coarse).cwiseAbs().cwiseMax(at_least * (values[2] - values[1]).cwiseAbs());
  result.observed_order = std::log2((values[1] - values[0]).norm() / (values[2] - values[1]).norm());
  return result;
}

}  // namespace

ScaledForce cavitated_force_by_elements(const ScaledFilm& film, int around) {
  return extrapolated<2>(film, around, 0, [](const ElementGrid& grid) { return grid.force(); });
}

ScaledFlow cavitated_flow_by_elements(const ScaledFilm& film, int around) {
  return extrapolated<1>(film, around, 1, [](const ElementGrid& grid) { return ScaledFlow::Values(grid.edge_flow()); });
}

ScaledCouette cavitated_couette_by_elements(const ScaledFilm& film, int around) {
  const double whole = 2 * std::numbers::pi / std::sqrt(film.thinnest * (1 + film.epsilon));
  return extrapolated<1>(film, around, 1, [whole](const ElementGrid& grid) {
    return ScaledCouette::Values(whole * grid.carried_share());
  });
}

}  // namespace lubjoint::oracle
