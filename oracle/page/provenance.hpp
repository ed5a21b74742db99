/// What a page was made with and on.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lubjoint::reports::page {

using NamedWords = std::vector<std::pair<std::string, std::string>>;

struct Provenance {
  std::string version;  ///< of lubjoint
  NamedWords software;  ///< compiler, libraries, gnuplot, revision
  NamedWords machine;   ///< processor, system
};

/// What this program was built with, and the machine that it runs on; no names of hosts or users.
/// @param more  parts that the caller alone knows of
Provenance provenance(const std::string& version, const NamedWords& more = {});

}  // namespace lubjoint::reports::page
