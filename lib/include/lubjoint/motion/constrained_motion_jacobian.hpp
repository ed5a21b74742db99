/// The exact Jacobian of constrained equations of motion in a number of passes that does not depend on their size.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/ode/constrained_jacobian.hpp"

namespace lubjoint {

/// Fills a ConstrainedJacobian. Bodies get colours, so that none feels two others of the same colour: a pass on numbers
/// with derivatives serves all bodies of a colour at once, three passes a chain however long.
/// For systems without half films, whose journals may slide.
template <class R>
class ConstrainedMotionJacobian {
 public:
  /// @param ode  whose Jacobian it is, with what its joints remember; kept by reference
  explicit ConstrainedMotionJacobian(const MultibodyOde<R>& ode)
      : ode_(ode),
        system_(ode.system()),
        real_(system_.template workspace<R>()),
        dual_(system_.template workspace<Seeded>()),
        seeded_(2 * system_.coordinates()) {
    real_.table_pieces = dual_.table_pieces = &ode.table_pieces();
    find_neighbours();
    find_colours();
    find_pattern();
  }

  std::size_t passes() const { return colours_; }  ///< a Jacobian

  /// Of the equations at (t, y). @throws as PlanarSystem::evaluate
  void evaluate(const R& t, const std::vector<R>& y, ConstrainedJacobian<R>& out) {
    const std::size_t n = system_.coordinates();
    if (out.inner.size() != pattern_.inner.size()) out = pattern_;
    std::fill(out.constant.begin(), out.constant.end(), R(0));
    std::fill(out.over_shift.begin(), out.over_shift.end(), R(0));
    std::fill(out.over_square.begin(), out.over_square.end(), R(0));
    system_.evaluate(t, y.data(), ode_.memory(), real_);
    for (std::size_t i = 0; i < n; ++i) out.constant[place_of_mass_[i]] = 1 / system_.inverse_mass(i / 3)[i % 3];
    for (const RowSide& each : row_sides_) {
      const auto& columns = each.second ? real_.rows[each.row].second : real_.rows[each.row].first;
      for (std::size_t k = 0; k < 3; ++k) out.constant[each.below[k]] = out.constant[each.beside[k]] = columns[k];
    }
    for (std::size_t i = 0; i < 2 * n; ++i) seeded_[i] = Seeded(y[i]);
    for (std::size_t colour = 0; colour < colours_; ++colour) {
      seed(colour, y, true);
      system_.place(seeded_.data(), dual_);
      system_.apply_forces(ode_.memory(), dual_);
      if (system_.has_elements()) system_.apply_elements(t, dual_);
      system_.evaluate_constraints(t, dual_);
      take(colour, out);
      seed(colour, y, false);
    }
  }

 private:
  static constexpr int width = 2 * planar_coordinates;
  using Seeded = Dual<R, width>;
  using Slopes = typename Seeded::Derivatives;

  /// A body, or a row behind all bodies, and a body that it feels: 3 × 3 or 1 × 3 elements.
  struct Block {
    std::size_t of;    ///< number of the body, or of the row
    std::size_t body;  ///< that it feels
    std::array<std::array<std::size_t, 3>, 3> places;
  };
  /// One side of a row: where its three elements are, in the row and in the column of its multiplier.
  struct RowSide {
    std::size_t row;
    std::size_t body;
    bool second;
    std::array<std::size_t, 3> below, beside;
  };

  void find_neighbours() {
    const std::size_t bodies = system_.bodies().size();
    neighbours_.resize(bodies);
    const auto join = [&](std::size_t one, std::size_t other) {
      if (one == ground_body || other == ground_body) return;
      neighbours_[one].push_back(other);
      neighbours_[other].push_back(one);
    };
    for (std::size_t b = 0; b < bodies; ++b) neighbours_[b].push_back(b);
    for (const auto& each : system_.constraints()) join(each.first_body(), each.second_body());
    for (const auto& each : system_.joints()) join(each.bearing_at.body, each.journal_at.body);
    for (const auto& each : system_.elements().springs) join(each.first_body(), each.second_body());
    for (const auto& each : system_.elements().loads) {
      if (const auto* load = std::get_if<TableLoad<R>>(&each); load && load->of_angle)
        join(load->body(), load->against);
    }
    for (auto& list : neighbours_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }

  /// Greedily: another one than all that share a neighbour.
  void find_colours() {
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    colour_.assign(neighbours_.size(), none);
    for (std::size_t b = 0; b < neighbours_.size(); ++b) {
      std::vector<bool> taken(colours_ + 1, false);
      for (const std::size_t near : neighbours_[b]) {
        for (const std::size_t far : neighbours_[near]) {
          if (colour_[far] != none) taken[colour_[far]] = true;
        }
      }
      colour_[b] = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
      colours_ = std::max(colours_, colour_[b] + 1);
    }
  }

  void find_pattern() {
    const std::size_t bodies = system_.bodies().size();
    const std::size_t n = system_.coordinates();
    const std::size_t m = system_.constraint_rows();
    std::vector<std::vector<int>> columns(n + m);
    const auto add = [&](std::size_t row, std::size_t column) { columns[column].push_back(static_cast<int>(row)); };
    const auto for_each_side = [&](const auto& act) {
      for (std::size_t row = 0; row < m; ++row) {
        if (system_.first_body_of_row(row) != ground_body) act(row, system_.first_body_of_row(row), false);
        if (system_.second_body_of_row(row) != ground_body) act(row, system_.second_body_of_row(row), true);
      }
    };
    for (std::size_t b = 0; b < bodies; ++b) {
      for (const std::size_t near : neighbours_[b]) {
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j) add(3 * near + i, 3 * b + j);
        }
      }
    }
    for_each_side([&](std::size_t row, std::size_t body, bool) {
      for (std::size_t k = 0; k < 3; ++k) {
        add(n + row, 3 * body + k);
        add(3 * body + k, n + row);
      }
    });
    pattern_.coordinates = static_cast<Eigen::Index>(n);
    pattern_.multipliers = static_cast<Eigen::Index>(m);
    pattern_.outer.push_back(0);
    for (auto& column : columns) {
      std::sort(column.begin(), column.end());
      pattern_.inner.insert(pattern_.inner.end(), column.begin(), column.end());
      pattern_.outer.push_back(static_cast<int>(pattern_.inner.size()));
    }
    for (auto* numbers : {&pattern_.constant, &pattern_.over_shift, &pattern_.over_square})
      numbers->assign(pattern_.inner.size(), R(0));
    const auto place = [&](std::size_t row, std::size_t column) {
      const auto begin = pattern_.inner.begin() + pattern_.outer[column];
      const auto end = pattern_.inner.begin() + pattern_.outer[column + 1];
      return static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<int>(row)) - pattern_.inner.begin());
    };
    for (std::size_t i = 0; i < n; ++i) place_of_mass_.push_back(place(i, i));
    blocks_.resize(colours_);
    row_blocks_.resize(colours_);
    for (std::size_t b = 0; b < bodies; ++b) {
      for (const std::size_t near : neighbours_[b]) {
        Block block{near, b, {}};
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j) block.places[i][j] = place(3 * near + i, 3 * b + j);
        }
        blocks_[colour_[b]].push_back(block);
      }
    }
    for_each_side([&](std::size_t row, std::size_t body, bool second) {
      RowSide side{row, body, second, {}, {}};
      Block block{row, body, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        side.below[k] = block.places[0][k] = place(n + row, 3 * body + k);
        side.beside[k] = place(3 * body + k, n + row);
      }
      row_sides_.push_back(side);
      row_blocks_[colour_[body]].push_back(block);
    });
  }

  void seed(std::size_t colour, const std::vector<R>& y, bool on) {
    const std::size_t n = system_.coordinates();
    for (std::size_t b = 0; b < colour_.size(); ++b) {
      if (colour_[b] != colour) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto index = static_cast<Eigen::Index>(k);
        for (const std::size_t half : {std::size_t(0), std::size_t(1)}) {
          const std::size_t i = half * n + 3 * b + k;
          seeded_[i] = on ? Seeded::variable(y[i], index + static_cast<Eigen::Index>(3 * half)) : Seeded(y[i]);
        }
      }
    }
  }

  /// g − Φqᵀλ at fixed λ, and w − Φq a at fixed a, of the bodies and rows that feel a colour.
  void take(std::size_t colour, ConstrainedJacobian<R>& out) {
    const std::size_t n = system_.coordinates();
    slopes_.resize(n);
    for (std::size_t i = 0; i < n; ++i) slopes_[i] = dual_.forces[i].derivatives();
    for (const RowSide& each : row_sides_) {
      const auto& columns = each.second ? dual_.rows[each.row].second : dual_.rows[each.row].first;
      for (std::size_t k = 0; k < 3; ++k)
        slopes_[3 * each.body + k] -= real_.multipliers[each.row] * columns[k].derivatives();
    }
    const auto put = [&](const std::array<std::size_t, 3>& places, const Slopes& slopes) {
      for (std::size_t k = 0; k < 3; ++k) {
        out.over_square[places[k]] = -slopes(static_cast<Eigen::Index>(k));
        out.over_shift[places[k]] = -slopes(static_cast<Eigen::Index>(k + 3));
      }
    };
    for (const Block& each : blocks_[colour]) {
      for (std::size_t i = 0; i < 3; ++i) put(each.places[i], slopes_[3 * each.of + i]);
    }
    row_slopes_.resize(system_.constraint_rows());
    for (std::size_t row = 0; row < row_slopes_.size(); ++row)
      row_slopes_[row] = system_.wanted_acceleration(row, dual_).derivatives();
    for (const RowSide& each : row_sides_) {
      const auto& columns = each.second ? dual_.rows[each.row].second : dual_.rows[each.row].first;
      for (std::size_t k = 0; k < 3; ++k)
        row_slopes_[each.row] -= real_.accelerations[3 * each.body + k] * columns[k].derivatives();
    }
    for (const Block& each : row_blocks_[colour]) put(each.places[0], row_slopes_[each.of]);
  }

  const MultibodyOde<R>& ode_;
  const PlanarSystem<R>& system_;
  SystemWorkspace<R> real_;
  SystemWorkspace<Seeded> dual_;
  std::vector<Seeded> seeded_;
  std::vector<Slopes> slopes_, row_slopes_;
  std::vector<std::vector<std::size_t>> neighbours_;  ///< of each body, itself among them
  std::vector<std::size_t> colour_;
  std::size_t colours_ = 0;
  ConstrainedJacobian<R> pattern_;
  std::vector<std::size_t> place_of_mass_;
  std::vector<std::vector<Block>> blocks_, row_blocks_;  ///< by the colour of the body that is felt
  std::vector<RowSide> row_sides_;
};

}  // namespace lubjoint
