#include "oracle/certified/golden_table.hpp"

#include "oracle/files/files.hpp"

namespace lubjoint::certified {

RowText& RowText::add(std::string_view text) {
  if (!text_.empty()) text_ += ',';
  text_ += text;
  return *this;
}

RowText& RowText::add(double value) { return add(reports::number(value)); }

RowText& RowText::add(const std::vector<CertifiedNumber>& numbers) {
  for (const CertifiedNumber& number : numbers) add(number.value).add(number.uncertainty);
  return *this;
}

std::string golden_header(std::string_view inputs, const std::vector<std::string_view>& outputs) {
  std::string header(inputs);
  for (const std::string_view output : outputs) {
    header += "," + std::string(output) + "," + std::string(output) + "_uncertainty";
  }
  return header;
}

std::vector<GoldenTable> golden_tables() {
  return {film_force_table(),  film_extent_table(), film_pressure_table(),     joint_wrench_table(),
          transition_table(),  dry_contact_table(), contact_stiffness_table(), exit_speed_table(),
          equilibrium_table(), film_losses_table(), coefficients_table(),      loaded_coefficients_table()};
}

}  // namespace lubjoint::certified
