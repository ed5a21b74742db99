/// Trajectories as tables, and curves through their rows.
#pragma once

#include <boost/math/interpolators/makima.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/scene/trajectory_table.hpp"

namespace lubjoint::verify {

/// Numbers over increasing times [s].
struct Trajectory {
  std::string name;  ///< for messages
  std::vector<double> t;
  std::map<std::string, std::vector<double>> columns;  ///< without t
  std::vector<std::string> not_read;                   ///< columns that were there and not known, in their order

  bool has(const std::string& column) const { return columns.contains(column); }
};

/// Reads the column t and all others, or those that `known` has.
/// @throws UnjudgedError for no column t, a field that is no finite number, times that don't increase, under five rows
Trajectory read_trajectory(std::string_view csv, const std::string& name, const Trajectory* known = nullptr);

/// Of joints with contact: c − |e| of a program that counts on into contact is no film. Elsewhere it stays wrong.
void end_films_in_contact(const Scene& scene, Trajectory& trajectory);

/// A run's own table; what is not defined anywhere is no column.
Trajectory as_trajectory(const TrajectoryTable& table, const std::string& name);

/// A vector, or one number, over time.
struct Samples {
  std::vector<double> t;
  std::vector<std::vector<double>> x;  ///< one list a component

  std::size_t components() const { return x.size(); }
};

/// Every `stride`-th sample, and the last.
Samples thinned(const Samples& samples, std::size_t stride);

/// Piecewise cubics through samples (modified Akima): exact at the samples, no overshoot beside a jump.
class Curves {
 public:
  /// @param samples  at least four, at increasing times
  explicit Curves(const Samples& samples);

  double first() const { return first_; }
  double last() const { return last_; }
  /// Component k at a time from first() to last().
  double operator()(std::size_t k, double t) const { return curves_[k](t); }

 private:
  double first_;
  double last_;
  std::vector<boost::math::interpolators::makima<std::vector<double>>> curves_;
};

}  // namespace lubjoint::verify
