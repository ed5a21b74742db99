/// Numerical stability: extreme cases × laws × integrators.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "oracle/files/csv_table.hpp"
#include "oracle/measure/stress/stress_cases.hpp"
#include "oracle/measure/stress/stress_judgement.hpp"

namespace lubjoint::reports {

/// One run.
struct StressCell {
  std::string scenario;  ///< name of the case
  std::string law;
  std::string integrator;
  StressStatus status = StressStatus::finished;
  StressDeviation deviation;  ///< from the reference
  double seconds = 0;
  std::size_t steps = 0;  ///< accepted and rejected
  std::string program;    ///< that ran it: measuring_sources() then
  std::string message;    ///< why it stopped, what it warned of, or what is wrong
};

struct StressSettings {
  std::vector<std::string> laws;
  std::vector<std::string> integrators;
  StressReferences references;  ///< of every case with every law
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

/// The scene with this law in all its joints.
Scene with_law(Scene scene, const std::string& law);

/// What the cells of a resume file depend on: cases, scenes, laws, integrators, limits, references and sources.
std::string stress_key(const std::vector<StressCase>& cases, const StressSettings& settings);

/// Runs the matrix; cells by case, law and integrator, the same for any number of threads but for their seconds.
/// @throws OutputError, CsvError of the resume file
std::vector<StressCell> run_stress(const std::vector<StressCase>& cases, const StressSettings& settings);

/// The cells of a CSV that stress_csv wrote. In one of before rates and forces were compared (without the column
/// program) what finished was not judged as now, and counts as unreferenced.
/// @throws CsvError
std::vector<StressCell> read_stress_cells(const CsvTable& table);

/// case,law,integrator,status,error,rate_error,force_error,over_expected,compared,seconds,steps,program,message
std::string stress_csv(const std::vector<StressCell>& cells);

}  // namespace lubjoint::reports
