#include "oracle/trajectories/golden_trajectories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/trajectories/journal_trajectory.hpp"

namespace lubjoint::reports {

namespace {

namespace fs = std::filesystem;

JournalCase journal_case(const Scene& scene) {
  const SceneBody& body = scene.bodies.front();
  const SceneJoint& joint = scene.joints.front();
  Vector2<double> load(0, 0);
  if (!scene.loads.empty()) load = scene.loads.front().force;
  return {joint.length,
          joint.journal_radius,
          joint.clearance,
          joint.viscosity,
          body.mass,
          {load.x(), load.y()},
          {scene.gravity.x(), scene.gravity.y()},
          body.spin,
          reference_times(scene.run.duration)};
}

ReferenceCsv journal_reference(const std::string& law, const JournalCase& journal) {
  constexpr double tolerance = 1e-17;  // of a step; the integrators then agree to some 15 digits
  const ReferenceTrajectory trajectory = reference_trajectory(law, journal, tolerance);
  return {trajectory_reference_csv(trajectory), trajectory.agreed_digits};
}

/// Calls work(i, report) for all i < count, on some threads.
template <class Work>
void for_all(std::size_t count, const TrajectoryRun& run, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto report = [&](const std::string& line) {
    const std::lock_guard lock(mutex);
    if (run.report) run.report(line);
  };
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i, report);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    const unsigned workers = run.threads > 0 ? run.threads : std::max(1U, std::thread::hardware_concurrency());
    for (unsigned i = 0; i < workers; ++i) threads.emplace_back(loop);
  }
  if (failure) std::rethrow_exception(failure);
}

std::string agreement(const std::string& file, const ReferenceCsv& made, const SecondAgreement& second) {
  return fmt::format("{}: the methods agree to {:.1f} digits, the second derivation ({}) to {:.1f}", file,
                     made.agreed_digits, second.how, second.digits);
}

/// The first row that disagrees with the second derivation.
std::vector<GoldenDifference> second_differences(const std::string& file, const SecondAgreement& second) {
  const std::size_t row = second.first_wrong();
  if (row == second.apart.size()) return {};
  return {{file, row + 2, "",
           fmt::format("{:.1e} of the vectors' largest sizes from the second derivation ({}), allowed is {:.1e}",
                       second.apart[row], second.how, second.allowed[row])}};
}

/// Accepts a file that an earlier run has left, if it goes to the end.
void require_whole(const fs::path& file, double duration) {
  const std::string text = read_input(file.string());
  const std::size_t last = text.size() < 2 ? std::string::npos : text.rfind('\n', text.size() - 2);
  if (text.ends_with('\n') && last != std::string::npos && text.substr(last + 1).starts_with(number(duration) + ",")) {
    return;
  }
  throw std::invalid_argument("\"" + file.string() + "\" is cut off before its end at " + number(duration) +
                              " s; allowed is to delete it, or --fresh");
}

}  // namespace

std::vector<GoldenTrajectory> golden_trajectories(const fs::path& scenes) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(scenes)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<GoldenTrajectory> trajectories;
  for (const fs::path& file : files) {
    const Scene scene = load_scene(file);
    const std::string name = file.stem().string();
    if (!is_free_journal(scene)) {
      trajectories.push_back({name + ".csv", scene.run.duration, [scene] { return multibody_reference(scene); },
                              [scene](const CsvTable& table) { return second_agreement(scene, "", table); }});
      continue;
    }
    for (const std::string_view law : film_law_names) {
      trajectories.push_back(
          {name + "-" + std::string(law) + ".csv", scene.run.duration,
           [law, journal = journal_case(scene)] { return journal_reference(std::string(law), journal); },
           [law, scene](const CsvTable& table) { return second_agreement(scene, std::string(law), table); }});
    }
  }
  return trajectories;
}

void write_golden_trajectories(const fs::path& folder, const std::vector<GoldenTrajectory>& trajectories,
                               const TrajectoryRun& run) {
  prepare_folder(folder);
  for (const GoldenTrajectory& each : trajectories) {
    if (!run.fresh && fs::exists(folder / each.file)) require_whole(folder / each.file, each.duration);
  }
  for_all(trajectories.size(), run, [&](std::size_t i, const auto& report) {
    const GoldenTrajectory& each = trajectories[i];
    if (!run.fresh && fs::exists(folder / each.file)) {
      report(each.file + ": there already (--fresh makes it anew)");
      return;
    }
    const ReferenceCsv made = each.make();
    const SecondAgreement second = each.second(CsvTable(made.csv, each.file));
    const std::vector<GoldenDifference> wrong = second_differences(each.file, second);
    if (!wrong.empty()) throw std::runtime_error(wrong.front().text() + "; it is not written");
    write_file(folder / each.file, made.csv);
    report(agreement(each.file, made, second));
  });
  std::vector<GoldenFile> files;
  files.reserve(trajectories.size());
  for (const GoldenTrajectory& each : trajectories) {
    files.push_back({each.file, read_input((folder / each.file).string())});
  }
  write_file(folder / golden_manifest_name, golden_manifest(files));
}

std::vector<GoldenDifference> check_golden_trajectories(const fs::path& folder,
                                                        const std::vector<GoldenTrajectory>& trajectories,
                                                        const TrajectoryRun& run) {
  std::vector<std::vector<GoldenDifference>> found(trajectories.size());
  for_all(trajectories.size(), run, [&](std::size_t i, const auto& report) {
    const GoldenTrajectory& each = trajectories[i];
    if (!fs::exists(folder / each.file)) return;  // the comparison with the manifest says so
    const ReferenceCsv made = each.make();
    const CsvTable expected(made.csv, "regenerated");
    std::vector<std::string> rows;
    rows.reserve(expected.rows());
    for (std::size_t row = 0; row < expected.rows(); ++row) rows.push_back(expected.line(row));
    const std::string stored = read_input((folder / each.file).string());
    found[i] = csv_differences(each.file, expected.header(), rows, stored);
    const SecondAgreement second = each.second(CsvTable(stored, each.file));
    for (const GoldenDifference& each_wrong : second_differences(each.file, second)) found[i].push_back(each_wrong);
    report(agreement(each.file, made, second) + (found[i].empty() ? "; every byte as regenerated" : "; DIFFERENT"));
  });
  std::vector<GoldenDifference> differences;
  for (const auto& each : found) differences.insert(differences.end(), each.begin(), each.end());
  std::vector<std::string> names;
  names.reserve(trajectories.size());
  for (const GoldenTrajectory& each : trajectories) names.push_back(each.file);
  for (const GoldenDifference& each : manifest_differences(folder, names)) differences.push_back(each);
  return differences;
}

}  // namespace lubjoint::reports
