/// A golden file as rows that can be made one by one, in any order.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/certified/digits.hpp"

namespace lubjoint::certified {

struct GoldenTable {
  std::string file;
  std::string header;
  std::size_t rows;
  std::function<std::string(std::size_t)> row;  ///< without its line end; safe to call from several threads
};

/// Fields of a row, separated by commas; doubles in the shortest form that reads back as the same double.
class RowText {
 public:
  RowText& add(std::string_view text);
  RowText& add(double value);
  /// Each value followed by its uncertainty.
  RowText& add(const std::vector<CertifiedNumber>& numbers);
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// Header of inputs and of outputs, each output followed by OUTPUT_uncertainty.
std::string golden_header(std::string_view inputs, const std::vector<std::string_view>& outputs);

/// All golden files.
std::vector<GoldenTable> golden_tables();

// Parts of it.
GoldenTable film_force_table();
GoldenTable film_extent_table();
GoldenTable film_pressure_table();
GoldenTable joint_wrench_table();
GoldenTable transition_table();
GoldenTable dry_contact_table();
GoldenTable contact_stiffness_table();
GoldenTable exit_speed_table();
GoldenTable equilibrium_table();
GoldenTable film_losses_table();
GoldenTable coefficients_table();
GoldenTable loaded_coefficients_table();

}  // namespace lubjoint::certified
