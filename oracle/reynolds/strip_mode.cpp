#include "oracle/reynolds/strip_mode.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lubjoint::oracle {

std::vector<Strip> strips_of(FilmExtent extent, const ScaledFilm& film) {
  const double half_turn = std::numbers::pi;
  switch (extent) {
    case FilmExtent::full: {
      ScaledFilm wedge = film;
      ScaledFilm squeeze = film;
      wedge.squeeze = 0;
      squeeze.slip = 0;
      std::vector<Strip> strips;
      if (wedge.slip != 0) strips.push_back({wedge, -half_turn, 0.0, true, {0.0, 2.0}});
      if (squeeze.squeeze != 0) strips.push_back({squeeze, -half_turn, 0.0, false, {2.0, 0.0}});
      return strips;
    }
    case FilmExtent::half:
      return {{film, -half_turn, 0.0, true, {1.0, 1.0}}};
    case FilmExtent::dynamic:
      break;
  }
  const double onset = std::atan2(2 * film.squeeze, film.slip);
  return {{film, onset - half_turn, onset, true, {1.0, 1.0}}};
}

std::vector<double> Strip::breaks(double layer) const {
  std::vector<double> points{start, end};
  const auto insert = [&](double point) {
    if (point > start && point < end) points.push_back(point);
  };
  insert(0.0);
  // H grows like 1 + (x/w)²: elements whose length is proportional to their distance from the spike resolve it evenly.
  const double width = film.epsilon > 0 ? film.spike_width() : end - start;
  double x = width;
  while (x < end - start) {
    insert(x);
    insert(-x);
    x *= 2;
  }
  if (open_ends) {
    // exp(−κx) on two elements of length proportional to degree/κ: their error falls exponentially with the degree at
    // any κ (Schwab and Suri, The p and hp versions of the finite element method for problems with boundary layers,
    // Math. Comp. 65, 1996).
    const double room = (end - start) / 4;
    for (const double distance : {layer / 2, layer * 3 / 2}) {
      if (distance > room) continue;
      insert(start + distance);
      insert(end - distance);
    }
  }
  std::sort(points.begin(), points.end());
  // The trigonometric functions themselves ask for elements of about a radian.
  std::vector<double> split{points.front()};
  for (std::size_t n = 1; n < points.size(); ++n) {
    const double length = points[n] - points[n - 1];
    if (length == 0) continue;
    const int parts = static_cast<int>(std::ceil(length));
    for (int part = 1; part < parts; ++part) split.push_back(points[n - 1] + length * part / parts);
    split.push_back(points[n]);
  }
  return split;
}

void StripMode::place_nodes(const Strip& strip, double kappa) {
  breaks_ = strip.breaks(rule_.degree / kappa);
  const auto elements = static_cast<Eigen::Index>(breaks_.size()) - 1;
  const Eigen::Index nodes = rule_.degree + 1;
  for (Eigen::VectorXd* field : {&x_, &weight_, &cubed_, &source_}) field->resize(elements * nodes);
  moment_.setZero();
  short_moment_.setZero();
  volume_ = short_volume_ = 0;
  for (Eigen::Index e = 0; e < elements; ++e) {
    const double left = breaks_[static_cast<std::size_t>(e)];
    const double half = (breaks_[static_cast<std::size_t>(e) + 1] - left) / 2;
    for (Eigen::Index i = 0; i < nodes; ++i) {
      const Eigen::Index n = e * nodes + i;
      x_[n] = left + half * (1 + rule_.node[i]);
      const double h = strip.film.thickness(x_[n]);
      weight_[n] = rule_.weight[i] * half;
      cubed_[n] = h * h * h;
      source_[n] = strip.film.source(x_[n]);
      const Eigen::Vector2d direction(-std::cos(x_[n]), -std::sin(x_[n]));
      short_moment_ += weight_[n] * source_[n] / cubed_[n] * direction;
      short_volume_ += weight_[n] * source_[n];
    }
  }
}

void StripMode::assemble(const Strip& strip, double kappa) {
  const Eigen::Index elements = static_cast<Eigen::Index>(breaks_.size()) - 1;
  const Eigen::Index degree = rule_.degree;
  const Eigen::Index nodes = degree + 1;
  const int offset = strip.open_ends ? 1 : 0;
  const int count = static_cast<int>(elements * degree) + 1 - 2 * offset;
  entries_.clear();
  solution_ = Eigen::VectorXd::Zero(count);
  for (Eigen::Index e = 0; e < elements; ++e) {
    const double half = (breaks_[static_cast<std::size_t>(e) + 1] - breaks_[static_cast<std::size_t>(e)]) / 2;
    const auto weight = weight_.segment(e * nodes, nodes).array();
    const auto cubed = cubed_.segment(e * nodes, nodes).array();
    scaled_derivative_ = (weight * cubed).matrix().asDiagonal() * rule_.derivative;
    stiffness_.noalias() = rule_.derivative.transpose() * scaled_derivative_;
    stiffness_ /= half * half;
    for (Eigen::Index i = 0; i < nodes; ++i) {
      const int row = static_cast<int>(e * degree + i) - offset;
      if (row < 0 || row >= count) continue;
      for (Eigen::Index j = 0; j <= i; ++j) {
        const int column = static_cast<int>(e * degree + j) - offset;
        if (column >= 0) entries_.emplace_back(column, row, stiffness_(i, j));
      }
      entries_.emplace_back(row, row, kappa * kappa * weight[i] * cubed[i]);
      solution_[row] += weight[i] * source_[e * nodes + i];
    }
  }
  matrix_.resize(count, count);
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
}

void StripMode::solve(const Strip& strip, double kappa) {
  place_nodes(strip, kappa);
  assemble(strip, kappa);
  cholesky_.compute(matrix_);
  if (cholesky_.info() != Eigen::Success) {
    throw std::runtime_error("the matrix of the finite-length film is not positive definite");
  }
  solution_ = cholesky_.solve(solution_).eval();
  if (strip.open_ends) {
    Eigen::VectorXd with_ends = Eigen::VectorXd::Zero(solution_.size() + 2);
    with_ends.segment(1, solution_.size()) = solution_;
    solution_ = with_ends;
  }
  const Eigen::Index nodes = rule_.degree + 1;
  for (Eigen::Index n = 0; n < x_.size(); ++n) {
    const double f = solution_[n / nodes * rule_.degree + n % nodes];
    moment_ -= weight_[n] * f * Eigen::Vector2d(std::cos(x_[n]), std::sin(x_[n]));
    volume_ += weight_[n] * cubed_[n] * f;
  }
}

double StripMode::at(double x) const {
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
  const auto element = static_cast<Eigen::Index>(above - breaks_.begin()) - 1;
  const Eigen::Index nodes = rule_.degree + 1;
  double sum = 0;
  double total = 0;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const double distance = x - x_[element * nodes + i];
    const double f = solution_[element * rule_.degree + i];
    if (distance == 0) return f;
    sum += rule_.barycentric[i] / distance * f;
    total += rule_.barycentric[i] / distance;
  }
  return sum / total;
}

}  // namespace lubjoint::oracle
