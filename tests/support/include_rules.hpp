/// The rules about who may include whom, and a scanner that finds what breaks them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace lubjoint::test {

/// Files by the path that an #include names them by ("lubjoint/film/bearing.hpp", "oracle/reynolds/film_name.cpp"),
/// with the project's files that each includes.
using IncludeGraph = std::map<std::string, std::vector<std::string>>;

/// Paths in the #include lines of a text, in order; lines that are commented out do not count.
inline std::vector<std::string> included_paths(const std::string& text) {
  static const std::regex line(R"(^\s*#\s*include\s*[<"]([^">]+)[">])");
  std::vector<std::string> paths;
  std::istringstream lines(text);
  for (std::string row; std::getline(lines, row);) {
    std::smatch match;
    if (std::regex_search(row, match, line)) paths.push_back(match[1]);
  }
  return paths;
}

/// The includes of a project file; a path without a folder is one of the file's own folder.
inline std::vector<std::string> project_includes(const std::string& file, const std::string& text) {
  std::vector<std::string> includes;
  for (std::string path : included_paths(text)) {
    const bool rooted = path.starts_with("lubjoint/") || path.starts_with("oracle/");
    const bool of_a_source = path.ends_with(".hpp") || path.ends_with(".cpp");
    if (!rooted && of_a_source && path.find('/') == std::string::npos) {
      path = file.substr(0, file.rfind('/') + 1) + path;
    } else if (!rooted && path.starts_with("..")) {
      path = (std::filesystem::path(file).parent_path() / path).lexically_normal().generic_string();
    }
    if (path.starts_with("lubjoint/") || path.starts_with("oracle/")) includes.push_back(path);
  }
  return includes;
}

/// Reads lib/ and oracle/ of a source tree. The compiled part of the library counts as scene.
inline IncludeGraph scan_sources(const std::filesystem::path& root) {
  IncludeGraph graph;
  const auto scan = [&](const std::filesystem::path& folder, const std::string& prefix) {
    if (!std::filesystem::exists(folder)) return;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || (extension != ".hpp" && extension != ".cpp")) continue;
      std::ifstream stream(entry.path());
      std::stringstream text;
      text << stream.rdbuf();
      const std::string name = prefix + std::filesystem::relative(entry.path(), folder).generic_string();
      graph[name] = project_includes(name, text.str());
    }
  };
  scan(root / "lib/include/lubjoint", "lubjoint/");
  scan(root / "lib/src", "lubjoint/scene/src/");
  scan(root / "oracle", "oracle/");
  return graph;
}

/// Folder of a file: "film", "oracle/reynolds".
inline std::string folder_of(const std::string& file) {
  const bool of_oracle = file.starts_with("oracle/");
  const std::size_t begin = of_oracle ? 0 : std::string("lubjoint/").size();
  const std::size_t end = file.find('/', std::max(begin, std::string("oracle/").size() * (of_oracle ? 1 : 0)));
  return end == std::string::npos ? std::string() : file.substr(begin, end - begin);
}

/// Film state and geometry. Any other header of film/ counts as a force law until it is listed here.
inline bool is_film_geometry(const std::string& file) {
  static const std::set<std::string> geometry = {"bearing", "film_state", "extent", "pressure", "law_facts"};
  const std::string prefix = "lubjoint/film/";
  if (!file.starts_with(prefix)) return false;
  return geometry.contains(std::filesystem::path(file).stem().string());
}

/// Height of a folder, if it has one: arrows run down. ode knows no mechanics, files nothing at all.
inline std::optional<int> height_of(const std::string& folder) {
  static const std::map<std::string, int> heights = {
      {"text", -2},          {"oracle/files", -2},       {"number", -1},      {"film", 0},
      {"joint", 1},          {"multibody", 2},           {"run", 2},          {"motion", 3},
      {"scene", 4},          {"oracle/verify", 5},       {"oracle/plot", 5},  {"oracle/results", 6},
      {"oracle/laws", 7},    {"oracle/trajectories", 7}, {"oracle/sweep", 7}, {"oracle/paper", 8},
      {"oracle/measure", 8}, {"oracle/page", 9},         {"oracle/cli", 10}};
  const auto found = heights.find(folder);
  return found == heights.end() ? std::nullopt : std::optional<int>(found->second);
}

/// All files that a file sees, through whatever number of headers.
inline std::set<std::string> seen_from(const IncludeGraph& graph, const std::string& file) {
  std::set<std::string> seen;
  std::vector<std::string> open{file};
  while (!open.empty()) {
    const auto found = graph.find(open.back());
    open.pop_back();
    if (found == graph.end()) continue;
    for (const std::string& next : found->second) {
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  return seen;
}

/// What a rule has against a file seeing another; empty if nothing.
inline std::string objection(const std::string& from, const std::string& to) {
  static const std::set<std::string> independent = {"oracle/quadrature", "oracle/reynolds", "oracle/proofs",
                                                    "oracle/certified"};
  const std::string folder = folder_of(from);
  const std::string target = folder_of(to);
  if (independent.contains(folder)) {
    if (target == "film" && !is_film_geometry(to)) return "what checks the force laws may not see one";
    const bool of_library = !target.starts_with("oracle/");
    if (of_library && target != "film" && target != "number" && target != "text")
      return "it may see only film state and geometry";
  }
  static const std::set<std::string> machinery = {"joint", "multibody", "ode", "run", "motion", "scene"};
  if (folder == "oracle/mechanisms" && machinery.contains(target)) return "it is the check of " + target;
  if (!folder.starts_with("oracle/") && target.starts_with("oracle/")) return "the library may not see the oracles";
  if (folder == "ode" && !target.starts_with("oracle/") && target != "number" && target != "ode") {
    return "an integrator knows no mechanics";
  }
  static const std::set<std::string> below_run = {"number", "ode", "run"};
  if (folder == "run" && !target.starts_with("oracle/") && !below_run.contains(target)) {
    return "the engine of runs knows no mechanics";
  }
  static const std::set<std::string> reports = {"oracle/plot",         "oracle/results", "oracle/laws",
                                                "oracle/trajectories", "oracle/sweep",   "oracle/paper",
                                                "oracle/measure",      "oracle/page"};
  if ((folder == "oracle/certified" || folder == "oracle/verify") && reports.contains(target)) {
    return "what judges may not see a report";
  }
  const std::optional<int> height = height_of(folder);
  const std::optional<int> target_height = height_of(target);
  if (height && target_height && *target_height > *height) return "the arrows run the other way";
  return {};
}

/// One sentence for each file that sees, directly or through headers, what it may not.
inline std::vector<std::string> include_violations(const IncludeGraph& graph) {
  std::vector<std::string> violations;
  for (const auto& [file, includes] : graph) {
    for (const std::string& seen : seen_from(graph, file)) {
      const std::string reason = objection(file, seen);
      if (reason.empty()) continue;
      const bool direct = std::ranges::find(includes, seen) != includes.end();
      violations.push_back(file + (direct ? " includes " : " sees, through other headers, ") + seen + ": " + reason);
    }
  }
  return violations;
}

}  // namespace lubjoint::test
