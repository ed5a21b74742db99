#include "oracle/certified/golden.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "oracle/certified/golden_table.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::certified {

namespace {

using Rows = std::vector<std::string>;

/// Rows of all tables, those that were asked for. Each is made on its own, so the threads decide nothing but the time.
/// @param whole  tables whose rows are all wanted, whatever run.every says
std::vector<Rows> make_rows(const std::vector<GoldenTable>& tables, const GoldenRun& run,
                            const std::set<std::string>& whole) {
  struct Job {
    std::size_t table, row;
  };
  std::vector<Job> jobs;
  std::vector<Rows> rows;
  for (std::size_t table = 0; table < tables.size(); ++table) {
    rows.emplace_back(tables[table].rows);
    const std::size_t every = whole.contains(tables[table].file) ? 1 : std::max<std::size_t>(run.every, 1);
    for (std::size_t row = 0; row < tables[table].rows; row += every) jobs.push_back({table, row});
  }
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    while (true) {
      const std::size_t number = next++;
      if (number >= jobs.size()) break;
      const auto [table, row] = jobs[number];
      try {
        rows[table][row] = tables[table].row(row);
        const std::lock_guard lock(mutex);
        run.progress(++done, jobs.size());
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = jobs.size();
      }
    }
    flint_cleanup();  // this thread's caches
  };
  const unsigned count = run.threads ? run.threads : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < count; ++i) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
  return rows;
}

std::string joined(const GoldenTable& table, const Rows& rows) {
  std::string text = table.header + "\n";
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

}  // namespace

void write_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  const std::vector<GoldenTable> tables = golden_tables();
  reports::prepare_folder(folder);
  GoldenRun whole = run;
  whole.every = 1;
  const std::vector<Rows> rows = make_rows(tables, whole, {});
  std::vector<reports::GoldenFile> files;
  for (std::size_t i = 0; i < tables.size(); ++i) files.push_back({tables[i].file, joined(tables[i], rows[i])});
  for (const reports::GoldenFile& file : files) reports::write_file(folder / file.name, file.text);
  reports::write_file(folder / reports::golden_manifest_name, reports::golden_manifest(files));
}

std::vector<reports::GoldenDifference> check_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  const std::vector<GoldenTable> tables = golden_tables();
  std::vector<std::string> names;
  for (const GoldenTable& table : tables) names.push_back(table.file);
  std::vector<reports::GoldenDifference> differences = reports::manifest_differences(folder, names);
  std::set<std::string> suspect;
  for (const reports::GoldenDifference& difference : differences) suspect.insert(difference.file);
  const std::vector<Rows> rows = make_rows(tables, run, suspect);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (!std::filesystem::exists(folder / tables[i].file)) continue;  // the manifest's check has named it
    const std::string found = reports::read_input((folder / tables[i].file).string());
    const auto more = reports::csv_differences(tables[i].file, tables[i].header, rows[i], found);
    differences.insert(differences.end(), more.begin(), more.end());
  }
  return differences;
}

}  // namespace lubjoint::certified
