#include "oracle/sweep/sweep.hpp"

#include <charconv>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "oracle/cli/programs.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/files/program_identity.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/sweep/sweep_store.hpp"

namespace lubjoint::cli {

namespace {

using reports::Shard;
using reports::Sweep;
using reports::SweepGrid;
using reports::SweepStore;
using reports::SweptKey;

struct SweepOptions : SceneOptions, LateOptions {
  std::vector<std::string> vary;
  std::optional<std::string> shard;
  std::optional<std::string> out;
  unsigned jobs = 0;
  bool merge = false;
  bool accept_stopped = false;
  bool json = false;
};

Shard read_shard(const std::string& text) {
  Shard shard{0, 0};
  const std::size_t slash = text.find('/');
  const auto read = [&](std::size_t begin, std::size_t end, std::size_t& number) {
    const auto result = std::from_chars(text.data() + begin, text.data() + end, number);
    return result.ec == std::errc() && result.ptr == text.data() + end;
  };
  const bool fits = slash != std::string::npos && read(0, slash, shard.number) &&
                    read(slash + 1, text.size(), shard.count) && shard.number >= 1 && shard.number <= shard.count;
  if (!fits) throw std::invalid_argument("--shard is \"" + text + "\"; allowed is i/n with 1 <= i <= n, such as 2/8");
  return shard;
}

/// SweepOptions and keys that set the same thing.
void require_apart(const SweepOptions& options, const SweptKey& swept) {
  const std::string& key = swept.key;
  const auto refuse = [&](bool given, const char* option, bool same) {
    if (given && same) {
      throw std::invalid_argument("--vary " + key + " and " + option + " set the same; allowed is one of them");
    }
  };
  refuse(options.law.has_value(), "--law", key.starts_with("joints[") && key.ends_with("].film"));
  refuse(options.integrator.has_value(), "--integrator", key == "integrator.name");
  refuse(options.rtol.has_value(), "--rtol",
         key == "integrator.relative_tolerance" || key == "integrator.absolute_tolerance");
  refuse(options.duration.has_value(), "--duration", key == "duration");
}

Sweep make_sweep(const SweepOptions& options) {
  options.SceneOptions::require();
  options.LateOptions::require();
  SceneFile file(options.file);
  std::vector<SweptKey> keys;
  for (const std::string& text : options.vary) {
    SweptKey swept = reports::parse_swept_key(text);
    swept.key = file.numbered_key(swept.key);
    require_apart(options, swept);
    keys.push_back(std::move(swept));
  }
  Sweep::LateStart late;
  if (options.after || options.last_revolution) late = [options](const Scene& scene) { return *options.start(scene); };
  return Sweep(
      std::move(file), SweepGrid(std::move(keys)), [options](Scene& scene) { options.change(scene); }, std::move(late));
}

reports::SweepIdentity identity(const SweepOptions& options, const Sweep& sweep) {
  std::string grid;
  for (const SweptKey& swept : sweep.grid().keys()) {
    grid += swept.key + "=";
    for (const SceneValue& value : swept.values) grid += reports::shown(value) + ",";
    grid += '\n';
  }
  std::string changes;
  if (options.law) changes += "law " + *options.law + " ";
  if (options.integrator) changes += "integrator " + *options.integrator + " ";
  if (options.rtol) changes += "rtol " + reports::number(*options.rtol) + " ";
  if (options.duration) changes += "duration " + reports::number(*options.duration);
  if (options.after) changes += " after " + reports::number(*options.after);
  if (options.last_revolution) changes += " last revolution";
  return {{"format", "lubjoint sweep 1"},
          {"program", reports::program_identity()},
          {"scene", reports::sha256(sweep.file().text())},
          {"options", changes},
          {"grid", reports::sha256(grid)}};
}

using Rows = std::map<std::size_t, std::string>;

/// Runs the points of a list, and hands over their rows as they come.
template <class Done>
void run_points(const Sweep& sweep, const std::vector<std::size_t>& points, unsigned threads, const Done& done) {
  reports::ProgressBar progress("sweep", points.size());
  std::mutex mutex;
  reports::run_parallel(points.size(), threads, [&](std::size_t i) {
    const std::string row = sweep.row(points[i]);
    done(points[i], row);
    const std::lock_guard lock(mutex);
    progress.advance();
  });
}

/// What rows of compiled laws are beyond, once a joint: of the points of this shard, whose tables are at hand.
void warn_beyond_tables(const Sweep& sweep, const Shard& shard, const Rows& rows) {
  Rows own;
  for (const auto& [point, row] : rows) {
    if (shard.holds(point)) own.emplace(point, row);
  }
  for (const std::string& warning : sweep.beyond_table_warnings(own)) std::cerr << warning << '\n';
}

struct Result {
  Rows rows;            ///< of all points if they are merged; else of the shard
  std::size_t run = 0;  ///< points that ran now
  bool merged = false;
  std::string csv;  ///< file
};

Result run_in_memory(const Sweep& sweep, unsigned threads) {
  Result result;
  const std::vector<std::size_t> points = Shard{}.points(sweep.grid().size());
  sweep.require_valid(points, threads);
  std::mutex mutex;
  run_points(sweep, points, threads, [&](std::size_t point, const std::string& row) {
    const std::lock_guard lock(mutex);
    result.rows.emplace(point, row);
  });
  result.run = points.size();
  result.merged = true;
  warn_beyond_tables(sweep, Shard{}, result.rows);
  return result;
}

/// The result of a sweep that has been merged before: nothing is run.
Result already_merged(const Sweep& sweep, const std::filesystem::path& csv) {
  std::cerr << "lubjoint: all points were run and merged before; nothing is done. To run them anew, delete \""
            << csv.string() << "\" or name another --out\n";
  Result result;
  result.merged = true;
  result.csv = csv.string();
  std::istringstream lines(reports::read_input(csv.string()));
  std::string row;
  std::getline(lines, row);  // the header
  for (std::size_t point = 0; point < sweep.grid().size() && std::getline(lines, row); ++point) {
    result.rows.emplace(point, row);
  }
  return result;
}

Result run_in_folder(const SweepOptions& options, const Sweep& sweep, const Shard& shard, unsigned threads) {
  const std::string stem = sweep.scene_name() + "-sweep";
  const std::filesystem::path folder = *options.out;
  const std::filesystem::path csv = folder / (stem + ".csv");
  if (reports::is_merged(folder, stem, identity(options, sweep))) return already_merged(sweep, csv);
  if (!options.merge) {
    sweep.require_valid(shard.points(sweep.grid().size()), threads);  // before there is a folder
    reports::prepare_folder(folder);
  }
  SweepStore store(folder, stem, identity(options, sweep), options.merge ? std::nullopt : std::optional<Shard>(shard));
  for (const std::string& note : store.notes()) std::cerr << "lubjoint: " << note << '\n';
  std::vector<std::size_t> missing;
  for (const std::size_t point : shard.points(sweep.grid().size())) {
    if (!store.rows().contains(point)) missing.push_back(point);
  }
  Result result;
  if (!options.merge) {
    run_points(sweep, missing, threads, [&](std::size_t point, const std::string& row) { store.add(point, row); });
    result.run = missing.size();
    warn_beyond_tables(sweep, shard, store.rows());
  }
  result.merged = store.merge(sweep.header(), sweep.grid().size());
  if (result.merged) result.csv = csv.string();
  if (options.merge && !result.merged) {
    throw std::invalid_argument("--merge: \"" + folder.string() + "\" has " + std::to_string(store.rows().size()) +
                                " of " + std::to_string(sweep.grid().size()) +
                                " points; allowed is a merge of all, after every shard has run");
  }
  for (const auto& [point, row] : store.rows()) {
    if (result.merged || shard.holds(point)) result.rows.emplace(point, row);
  }
  return result;
}

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = app.add_subcommand("sweep", words_of("sweep"));
  options->add_file(*command);
  command
      ->add_option("--vary", options->vary,
                   "KEY=LO:HI:N, KEY=log:LO:HI:N or KEY=A,B,...; once for each key. Keys as error messages name "
                   "them: joints[0].clearance, bodies[1].mass, joints.NAME.film; the last in alphabetical order "
                   "varies fastest")
      ->required()
      ->take_all()
      ->allow_extra_args(false);
  options->add_law(*command);
  options->add_run(*command);
  options->add_late(*command);
  CLI::Option* jobs =
      command->add_option("--jobs", options->jobs, "Threads (default: all cores); no result depends on it");
  command->add_option("--shard", options->shard, "i/n: every n-th point, from the i-th; the last shard merges");
  command->add_option("--out", options->out, "Folder for SCENE-sweep.csv; an interrupted sweep continues there");
  command->add_flag("--merge", options->merge, "Run nothing: merge what all shards have left in --out");
  command->add_flag("--accept-stopped", options->accept_stopped,
                    "Exit status 0 although some points stopped, for schedulers that go on after success alone");
  command->footer(
      "Exit status: 0 all points finished; 1 all points ran, and some stopped: their rows say why; 2 the sweep "
      "failed:\n"
      "bad usage or input, or a file that can't be written.\n"
      "\n"
      "Laws of finite length are tables for one L/D, and nothing is interpolated between two of them: each L/D of\n"
      "the grid that has none is compiled once, before the first point runs, on all cores, and kept in the user's\n"
      "cache. On one core an L/D of 1/4 to 2 takes 0.3 s for finite_full, 0.6 s for finite_half, 2 s for\n"
      "finite_dynamic and 15 to 30 s for finite_reynolds; very short and very long bearings take longer.");
  command->add_flag("--json", options->json, "Rows and counts as one JSON object");
  command->callback([options, jobs, &action] {
    action = [options, jobs] {
      using Clock = std::chrono::steady_clock;
      const auto begin = Clock::now();
      const Shard shard = options->shard ? read_shard(*options->shard) : Shard{};
      if ((options->shard || options->merge) && !options->out) {
        throw std::invalid_argument("--out is missing; --shard and --merge need a folder");
      }
      if (options->shard && options->merge) {
        throw std::invalid_argument("--shard and --merge are given; allowed is one of them");
      }
      if (options->merge && jobs->count() > 0) {
        throw std::invalid_argument("--jobs has no effect with --merge, which runs nothing; allowed is one of them");
      }
      if (options->jobs > 1024) {
        throw std::invalid_argument("--jobs is " + std::to_string(options->jobs) +
                                    "; allowed is a whole number from 1 to 1024, or 0 for all cores");
      }
      const unsigned threads = options->jobs ? options->jobs : reports::available_cores();
      const Sweep sweep = make_sweep(*options);
      const Result result =
          options->out ? run_in_folder(*options, sweep, shard, threads) : run_in_memory(sweep, threads);
      std::size_t stopped = 0;
      for (const auto& [point, row] : result.rows) stopped += Sweep::is_stopped(row, sweep.grid()) ? 1 : 0;
      if (options->json) {
        nlohmann::ordered_json keys;
        for (const SweptKey& swept : sweep.grid().keys()) keys[swept.key] = swept.values.size();
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const auto& [point, row] : result.rows) rows.push_back(sweep.row_json(row));
        const nlohmann::ordered_json summary{
            {"scene", sweep.scene_name()},
            {"keys", keys},
            {"points", sweep.grid().size()},
            {"shard", options->shard ? nlohmann::ordered_json(*options->shard) : nlohmann::ordered_json(nullptr)},
            {"run_now", result.run},
            {"finished", result.rows.size() - stopped},
            {"stopped", stopped},
            {"merged", result.merged},
            {"csv", result.csv.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(result.csv)},
            {"wall_s", std::chrono::duration<double>(Clock::now() - begin).count()},
            {"rows", rows}};
        std::cout << summary.dump(2) << '\n';
      } else if (!options->out) {
        std::cout << sweep.header() << '\n';
        for (const auto& [point, row] : result.rows) std::cout << row << '\n';
      } else {
        std::cout << "scene    " << sweep.scene_name() << '\n';
        for (const SweptKey& swept : sweep.grid().keys()) {
          std::cout << "key      " << swept.key << ": " << swept.values.size() << " values\n";
        }
        std::cout << "points   " << result.rows.size() << " of " << sweep.grid().size() << ": "
                  << result.rows.size() - stopped << " finished, " << stopped << " stopped; " << result.run
                  << " ran now\n"
                  << "file     " << (result.merged ? result.csv : "not yet: other shards are missing") << '\n';
      }
      return stopped == 0 || options->accept_stopped ? 0 : 1;
    };
  });
}

}  // namespace lubjoint::cli
