#include "oracle/reports/trajectories/journal_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "oracle/reports/files.hpp"
#include "oracle/reports/trajectories/journal_pass.hpp"

namespace lubjoint::reports {

namespace {

using journal_reference::ExplicitMethod;
using journal_reference::ImplicitMethod;
using journal_reference::Journal;
using journal_reference::Pass;
using journal_reference::Real;

std::string digits_of(const Real& value, int digits) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(digits) << std::scientific << value;
  return text.str();
}

}  // namespace

ReferenceTrajectory reference_trajectory(const std::string& law, const JournalCase& c, double tolerance) {
  const Journal journal(law, c);
  const Pass<ImplicitMethod> implicit_pass(journal, c.times, Real(tolerance));
  const Pass<ExplicitMethod> explicit_pass(journal, c.times, Real(tolerance));
  ReferenceTrajectory result;
  double worst = 0;
  for (std::size_t i = 0; i < c.times.size(); ++i) {
    const auto& one = implicit_pass.samples[i];
    const auto& other = explicit_pass.samples[i];
    const std::array<Real, 6> a = {one.state[0], one.state[1], one.state[2], one.state[3], one.force[0], one.force[1]};
    const std::array<Real, 6> b = {other.state[0], other.state[1], other.state[2],
                                   other.state[3], other.force[0], other.force[1]};
    TrajectoryRow row{c.times[i], {}, 0};
    for (std::size_t k = 0; k < 6; k += 2) {
      const Real size = sqrt(b[k] * b[k] + b[k + 1] * b[k + 1]);
      const Real apart = sqrt((a[k] - b[k]) * (a[k] - b[k]) + (a[k + 1] - b[k + 1]) * (a[k + 1] - b[k + 1]));
      row.disagreement = std::max(row.disagreement, static_cast<double>(apart / size));
      row.value[k] = digits_of(b[k], 15);
      row.value[k + 1] = digits_of(b[k + 1], 15);
    }
    worst = std::max(worst, row.disagreement);
    result.rows.push_back(row);
  }
  for (const auto& change : explicit_pass.changes) result.modes.push_back({digits_of(change.t, 16), change.mode});
  result.agreed_digits = -std::log10(std::max(worst, 1e-34));
  return result;
}

std::string trajectory_reference_csv(const ReferenceTrajectory& trajectory) {
  std::string csv = "t,ex_over_c,ey_over_c,wx,wy,fx,fy,disagreement\n";
  for (const TrajectoryRow& row : trajectory.rows) {
    csv += number(row.t);
    for (const std::string& value : row.value) csv += "," + value;
    // One digit: the difference itself is rounding and truncation.
    csv += fmt::format(",{:.0e}\n", row.disagreement);
  }
  return csv;
}

std::vector<double> reference_times(double duration) {
  std::vector<double> times;
  for (const double share : {1e-5, 1e-4, 1e-3, 2e-3, 5e-3, 1e-2}) times.push_back(share * duration);
  for (int i = 1; i <= 50; ++i) times.push_back(duration * i / 50);
  return times;
}

}  // namespace lubjoint::reports
