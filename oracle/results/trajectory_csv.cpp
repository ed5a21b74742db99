#include "oracle/results/trajectory_csv.hpp"

#include <fmt/format.h>

namespace lubjoint::reports {

std::string trajectory_csv(const TrajectoryTable& table) {
  std::string csv;
  for (const std::string& column : table.columns) csv += (csv.empty() ? "" : ",") + column;
  csv += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) csv += ',';
      if (row[i]) fmt::format_to(std::back_inserter(csv), "{}", *row[i]);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace lubjoint::reports
