#include "oracle/trajectories/journal_trajectory.hpp"

#include <fmt/format.h>

#include <iomanip>
#include <locale>
#include <sstream>

#include "oracle/files/files.hpp"
#include "oracle/trajectories/disagreement.hpp"
#include "oracle/trajectories/journal_pass.hpp"

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

/// ê, ė/c and the force at each time.
template <class OnePass>
TrajectoryValues<Real> values_of(const OnePass& pass) {
  TrajectoryValues<Real> rows;
  for (const auto& [state, force] : pass.samples) {
    rows.push_back({state[0], state[1], state[2], state[3], force[0], force[1]});
  }
  return rows;
}

}  // namespace

ReferenceTrajectory reference_trajectory(const std::string& law, const JournalCase& c, double tolerance) {
  const Journal journal(law, c);
  const Pass<ImplicitMethod> implicit_pass(journal, c.times, Real(tolerance));
  const Pass<ExplicitMethod> explicit_pass(journal, c.times, Real(tolerance));
  const TrajectoryValues<Real> values = values_of(explicit_pass);
  const std::vector<double> apart = disagreements(values, values_of(implicit_pass), {2, 2, 2});
  ReferenceTrajectory result;
  for (std::size_t i = 0; i < c.times.size(); ++i) {
    TrajectoryRow row{c.times[i], {}, apart[i]};
    for (std::size_t k = 0; k < row.value.size(); ++k) row.value[k] = digits_of(values[i][k], 15);
    result.rows.push_back(row);
  }
  for (const auto& change : explicit_pass.changes) result.modes.push_back({digits_of(change.t, 16), change.mode});
  result.agreed_digits = agreed_digits(apart);
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
