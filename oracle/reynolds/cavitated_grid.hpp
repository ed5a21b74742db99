/// One grid of the finite-length film that ruptures where its pressure would become negative.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/reynolds/envelope_cholesky.hpp"
#include "oracle/reynolds/scaled_film.hpp"

namespace lubjoint::oracle {

/// Finite volumes of second order for the complementarity problem
///   P ≥ 0,   −∂x(H³ ∂xP) − H³ ∂ζζP ≥ s,   one of the two an equality at each node,
/// on half the length, since P is even in ζ. The nodes are images of uniform ones under smooth maps, so that the error
/// is a series in even powers of the step but for the rounding of the free boundary to the nodes:
///   around: tan(x/2) = m tan(y/2), which lies between uniform steps (m = 1) and Sommerfeld's angle,
///   along:  ζ/Λ = η + β sin(πη)/π, finer towards the edge.
class CavitatedGrid {
 public:
  /// @param pinned  P = 0 along the maximum film
  /// @param around  nodes around the film;  @param along  steps from the middle to the edge
  CavitatedGrid(const ScaledFilm& film, bool pinned, int around, int along);

  /// Wets the nodes that another grid of the same film found wet.
  void start_from(const CavitatedGrid& solved);
  /// Active-set iteration. The matrix is an M-matrix, so the iteration is monotone after its first step and ends.
  /// @throws std::runtime_error if it has not ended after many more steps than there are layers of nodes
  void solve();

  Eigen::Vector2d force() const;  ///< ∬ P (cosθ, sinθ) dθ dζ over |ζ| ≤ Λ
  /// ∫ −H³ ∂ζP dθ at ζ = Λ, from the balance of the half volumes along the edge: what flows into them from the last
  /// nodes, and what the motion drives out of them. So it is of second order, and with P ≥ 0 no oil comes in by the
  /// edge: volumes that would draw it in are of a film that has ruptured.
  double edge_flow() const;
  /// ∬ dθ dζ/H over the part of |ζ| ≤ Λ that carries pressure, over 2Λ. The film ends inside of the volumes along its
  /// bounds: each holds as large a part of it as what flows in is of what the whole volume would draw in.
  double couette_integral() const;
  int unknowns() const { return matrix_.size(); }
  int along() const { return along_; }
  /// P at an angle θ from the maximum film and at ζ, |ζ| ≤ Λ, by linear interpolation.
  double pressure(double theta, double zeta) const;
  /// The largest P of a node.
  double largest_pressure() const;

 private:
  std::size_t node(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(along_) + static_cast<std::size_t>(j);
  }
  int next(int i) const { return i + 1 == around_ ? 0 : i + 1; }
  int previous(int i) const { return i == 0 ? around_ - 1 : i - 1; }
  /// Conductance from node (i, j) to (i + 1, j) and to (i, j + 1).
  double around_link(int i, int j) const {
    return link_[static_cast<std::size_t>(i)] * depth_[static_cast<std::size_t>(j)];
  }
  double axial_link(int i, int j) const {
    return j < 0 ? 0.0 : volume_[static_cast<std::size_t>(i)] * axial_link_[static_cast<std::size_t>(j)];
  }
  double load(int i, int j) const { return source_[static_cast<std::size_t>(i)] * depth_[static_cast<std::size_t>(j)]; }

  void place_nodes_around(const ScaledFilm& film);
  void place_nodes_along(double slenderness);
  int driest_column() const;
  void solve_on_wet_nodes();
  double inflow(int i, int j) const;
  double excess(int i, int j) const { return load(i, j) + inflow(i, j); }
  bool update_wet_nodes();

  int around_;
  int along_;
  bool pinned_;
  std::vector<double> x_, width_, volume_, link_, source_;  // around: x, dx, H³dx, H³/dx at faces, s dx
  std::vector<double> sheared_;                             // dx/H
  std::vector<double> zeta_, depth_, axial_link_;           // along: ζ, dζ, 1/dζ at faces
  double smallest_load_ = 0;
  double edge_depth_ = 0;  ///< of the half volumes at the edge
  std::vector<double> pressure_;
  std::vector<char> wet_;
  std::vector<int> number_;
  EnvelopeCholesky matrix_;
  Eigen::VectorXd solution_;
};

}  // namespace lubjoint::oracle
