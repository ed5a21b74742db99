#include "oracle/measure/bench/bench_manifest.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "oracle/files/golden_files.hpp"
#include "oracle/files/program_identity.hpp"

namespace lubjoint::reports {

namespace {

nlohmann::ordered_json object(const WordPairs& words) {
  nlohmann::ordered_json pairs = nlohmann::ordered_json::object();
  for (const auto& [name, value] : words) pairs[name] = value;
  return pairs;
}

}  // namespace

std::string bench_manifest(std::string_view csv, const SceneBenchSettings& settings, const WordPairs& opponents,
                           const WordPairs& software, const WordPairs& machine) {
  nlohmann::ordered_json manifest;
  manifest["file"] = "bench-scenes.csv";
  manifest["sha256"] = sha256(csv);
  manifest["program"] = program_identity();
  manifest["repeats"] = settings.limits.repeats;
  manifest["seconds_a_run"] = settings.limits.seconds;
  for (const auto& [name, version] : opponents) manifest[name] = version;
  manifest["software"] = object(software);
  manifest["machine"] = object(machine);
  return manifest.dump(2) + "\n";
}

std::string measured_by(const std::string& manifest, std::string_view csv, const std::string& name) {
  const auto json = nlohmann::json::parse(manifest, nullptr, false);
  const auto text = [&](const nlohmann::json& from, const char* key) {
    if (!from.is_object() || !from.contains(key) || !from[key].is_string()) {
      throw std::invalid_argument(name + ": \"" + key + "\" is missing; allowed is what bench scenes --out writes");
    }
    return from[key].get<std::string>();
  };
  if (text(json, "sha256") != sha256(csv)) {
    throw std::invalid_argument(name + " is not of the bench-scenes.csv beside it; allowed are both from one run");
  }
  if (!json.contains("repeats") || !json["repeats"].is_number_integer() || !json.contains("machine")) {
    throw std::invalid_argument(name + ": repeats or machine are missing; allowed is what bench scenes --out writes");
  }
  const auto version = [&](const char* what, const char* key) {
    const std::string found = text(json, key);
    return found.empty() ? "without " + std::string(what) : what + (" " + found);
  };
  return fmt::format("lubjoint {}, {}, {}; {}; medians of up to {} runs", text(json, "program"),
                     version("SUNDIALS", "sundials"), version("Simbody", "simbody"), text(json["machine"], "processor"),
                     json["repeats"].get<int>());
}

}  // namespace lubjoint::reports
