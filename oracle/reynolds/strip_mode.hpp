/// One axial harmonic of a finite-length film whose bounds do not depend on z.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "lubjoint/film/extent.hpp"
#include "oracle/reynolds/lobatto.hpp"
#include "oracle/reynolds/scaled_film.hpp"

namespace lubjoint::oracle {

/// A film on start ≤ x ≤ end. The ends carry P = 0, or no flow where they are planes of symmetry.
/// The full film is two strips on half the circle: the wedge's pressure is odd about the minimum film and vanishes on
/// the line of centres, the squeeze's is even and does not flow across it.
struct Strip {
  ScaledFilm film;
  double start;
  double end;
  bool open_ends;                ///< P = 0 at both ends
  Eigen::Vector2d multiplicity;  ///< of the strip's moments in the film's force: radial, tangential

  /// ∫ s (cosθ, sinθ)/H³ dx and its like need breaks where the spike is; layer is the thickness of end layers.
  std::vector<double> breaks(double layer) const;
};

/// The strips of a film; a ≥ 0.
std::vector<Strip> strips_of(FilmExtent extent, const ScaledFilm& film);

/// Solves (H³ f')' − κ² H³ f = −s on a strip by spectral elements.
class StripMode {
 public:
  explicit StripMode(int degree) : rule_(lobatto_rule(degree)) {}

  void solve(const Strip& strip, double kappa);

  /// ∫ f (cosθ, sinθ) dθ
  Eigen::Vector2d moment() const { return moment_; }
  /// ∫ s/H³ (cosθ, sinθ) dθ with the same quadrature: what the moment times κ² tends to as κ grows.
  Eigen::Vector2d short_moment() const { return short_moment_; }
  /// ∫ H³ f dx
  double volume() const { return volume_; }
  /// ∫ s dx with the same quadrature: what κ² ∫ H³ f dx tends to.
  double short_volume() const { return short_volume_; }
  int unknowns() const { return static_cast<int>(matrix_.rows()); }
  /// f at a point of the strip.
  double at(double x) const;

 private:
  void place_nodes(const Strip& strip, double kappa);
  void assemble(const Strip& strip, double kappa);

  LobattoRule rule_;
  // The upper triangle, numbered along the strip: a chain of dense blocks, to which the factor adds nothing.
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>> cholesky_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::vector<double> breaks_;
  Eigen::VectorXd x_, weight_, cubed_, source_;  // a column of degree + 1 nodes for each element
  Eigen::VectorXd solution_;                     // at the distinct nodes
  Eigen::MatrixXd scaled_derivative_, stiffness_;
  Eigen::Vector2d moment_, short_moment_;
  double volume_ = 0, short_volume_ = 0;
};

}  // namespace lubjoint::oracle
