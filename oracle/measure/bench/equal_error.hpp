/// Who wins a race: run times at equal error.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/measure/bench/bench_rows.hpp"

namespace lubjoint::reports {

/// The errors at which integrators are compared.
inline constexpr double judged_errors[] = {1e-5, 1e-9};

/// Whose an integrator is.
enum class Camp { own, sundials, simbody };
Camp camp_of(std::string_view integrator);

/// One race: a scene in the coordinates that it is run in.
struct Race {
  std::string scene;
  std::string formulation;
  bool operator==(const Race&) const = default;
};

/// The coordinates of a mechanism of the plane that is turned out of it: its one integrator races against nobody.
inline constexpr std::string_view embedded_coordinates = "embedded";

/// The races in the order of the rows, without embedded coordinates. Simbody's runs, in joint coordinates, are in the
/// races of the scene in absolute and in independent coordinates, in whose place a user would run it. In independent
/// coordinates, which others don't have, CVODE and IDA race in absolute ones.
std::vector<Race> races(const std::vector<BenchRow>& rows);

/// Names of those that ran in a race, in the order of the rows.
std::vector<std::string> integrators_of(const std::vector<BenchRow>& rows, const Race& race);

/// Finished runs of an integrator in a race, the loosest tolerance first.
std::vector<const BenchRow*> finished_runs(const std::vector<BenchRow>& rows, const Race& race,
                                           const std::string& integrator);

/// An integrator that reaches an error.
struct Contender {
  std::string integrator;
  double seconds;  ///< least time in which it does, between its tolerances on a log-log line of error and time
  double spread;   ///< of the repeats behind it, see MethodRun
};

/// Least time of an integrator in a race; nothing if none of its tolerances reaches the error, or it was not run.
std::optional<Contender> time_at_error(const std::vector<BenchRow>& rows, const Race& race,
                                       const std::string& integrator, double error);

/// Least error that any tolerance reached.
std::optional<double> error_floor(const std::vector<BenchRow>& rows, const Race& race, const std::string& integrator);

/// How many times as long an integrator takes in one race as in another, at the same error; nothing unless it reaches
/// that in both.
std::optional<double> time_ratio(const std::vector<BenchRow>& rows, const Race& race, const Race& other,
                                 const std::string& integrator, double error);

/// What the rows say of one race at one error.
struct RaceVerdict {
  Race race;
  double error;
  std::vector<Contender> order;  ///< those that reach the error, the fastest first

  /// Those that can't be told from the first: their times differ by less than the larger spread of both.
  std::vector<Contender> winners() const;
  std::optional<Contender> fastest(Camp camp) const;
  std::optional<Contender> of(std::string_view integrator) const;
};

RaceVerdict judge_race(const std::vector<BenchRow>& rows, const Race& race, double error);

/// "radau_iia5"; "radau_iia5 or dopri5" if they tie; "cvode_adams; of lubjoint's own dopri5, 1.3 times as long"; "none
/// reaches it". An integrator of lubjoint's that ties with the fastest is named alone.
std::string recommendation(const RaceVerdict& verdict);

}  // namespace lubjoint::reports
