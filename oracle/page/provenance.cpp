#include "oracle/page/provenance.hpp"

#include <fmt/core.h>
#include <gsl/gsl_version.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <array>
#include <boost/version.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "oracle/page/resources.hpp"

namespace lubjoint::reports::page {

namespace {

/// First value of "name : value" or name="value" in a file of the system; empty if there is none.
std::string value_in(const char* file, const std::string& name, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t at = line.find(separator);
    if (at == std::string::npos || line.compare(0, name.size(), name) != 0) continue;
    const std::size_t begin = line.find_first_not_of(" \t\"", at + 1);
    const std::size_t end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return {};
}

std::string first_line_of(const char* command) {
  std::FILE* pipe = ::popen(command, "r");
  if (!pipe) return {};
  std::array<char, 256> line{};
  const bool read = std::fgets(line.data(), line.size(), pipe) != nullptr;
  ::pclose(pipe);
  std::string text = read ? line.data() : "";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

std::string kernel() {
  utsname names{};
  if (::uname(&names) != 0) return "unknown";
  return fmt::format("{} {} {}", names.sysname, names.release, names.machine);
}

std::string or_unknown(std::string text) { return text.empty() ? "unknown" : std::move(text); }

}  // namespace

Provenance provenance(const std::string& version, const NamedWords& more) {
  Provenance result{version, {}, {}};
  result.software = {
      {"lubjoint", version},
      {"revision of the checkout when it was built", or_unknown(std::string(revision()))},
      {"compiler", compiler()},
      {"build type and flags", LUBJOINT_BUILD_WORDS},
      {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"GSL", gsl_version},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann-json",
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
  };
  result.software.insert(result.software.end(), more.begin(), more.end());
  result.software.emplace_back("gnuplot", or_unknown(first_line_of("LC_ALL=C gnuplot --version 2>/dev/null")));
  result.machine = {
      {"processor", or_unknown(value_in("/proc/cpuinfo", "model name", ':'))},
      {"logical processors", fmt::format("{}", std::thread::hardware_concurrency())},
      {"system", or_unknown(value_in("/etc/os-release", "PRETTY_NAME", '='))},
      {"kernel", kernel()},
  };
  return result;
}

}  // namespace lubjoint::reports::page
