/// Numerical stability: extreme cases × laws × integrators.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "oracle/reports/stress/stress_cases.hpp"

namespace lubjoint::reports {

enum class StressStatus {
  finished,  ///< at the end of the duration, as accurate as asked for or nearly so
  coarse,  ///< at the end, further off than that, and the run itself warns that the tolerance does not resolve its film
  stopped,  ///< with a reason, the results so far kept
  wrong  ///< finished or stopped far from the reference, a number that is none, a stop without a reason, an exception
};

/// One run.
struct StressCell {
  std::string scenario;  ///< name of the case
  std::string law;
  std::string integrator;
  StressStatus status = StressStatus::finished;
  /// Largest |ê − ê_ref| over samples and end [clearances]; of a run that stopped, over what it kept. None without a
  /// reference.
  std::optional<double> error;
  double seconds = 0;
  std::size_t steps = 0;  ///< accepted and rejected
  std::string message;    ///< why it stopped, or what is wrong
};

struct StressSettings {
  std::vector<std::string> laws;
  std::vector<std::string> integrators;
  unsigned threads = 1;
  /// No limit of steps above this: what a quick look has time for.
  std::size_t most_steps = 200'000;
  /// Cells so far are kept here after every case and law, and taken up again if the settings are the same.
  /// Whoever has written the results removes it (discard_kept_rows).
  std::optional<std::filesystem::path> resume_file;
};

/// All laws and integrators, on all cores.
/// @param quick  two laws and few steps: less than a minute
StressSettings stress_settings(bool quick);

/// The error above which a run is wrong: a thousand times its tolerance and 1e-3 clearances, and ten times what two
/// references differ by (a motion that amplifies every rounding has no better reference); of a loose tolerance no more
/// than a tenth of a clearance.
double stress_error_limit(double tolerance, double reference_agreement);

/// Of a run whose numbers are all numbers. One that is further off than the limit is wrong, unless it has itself warned
/// of its tolerance: then it is coarse.
/// @param error  as far as it is known, up to where the run came
/// @param warned  has it said that its tolerance is too coarse for its film?
StressStatus stress_status(bool finished, std::optional<double> error, double limit, bool warned);

/// What the cells of a resume file depend on: cases, scenes, laws, integrators and limits.
std::string stress_key(const std::vector<StressCase>& cases, const StressSettings& settings);

/// Runs the matrix; cells by case, law and integrator, the same for any number of threads but for their seconds.
/// @throws OutputError, CsvError of the resume file
std::vector<StressCell> run_stress(const std::vector<StressCase>& cases, const StressSettings& settings);

const char* stress_status_name(StressStatus status);

/// case,law,integrator,status,error,seconds,steps,message
std::string stress_csv(const std::vector<StressCell>& cells);

}  // namespace lubjoint::reports
