#include "oracle/reports/kept_rows.hpp"

#include <fstream>
#include <sstream>

#include "oracle/reports/files.hpp"

namespace lubjoint::reports {

KeptRows::KeptRows(std::optional<std::filesystem::path> file, const std::string& key, const std::string& header)
    : file_(std::move(file)), head_("# " + key + "\n" + header) {
  if (!file_) return;
  std::ifstream stream(*file_, std::ios::binary);
  std::string first;
  if (!std::getline(stream, first) || first != "# " + key) return;
  std::ostringstream rest;
  rest << stream.rdbuf();
  earlier_.emplace(rest.str(), file_->string());
}

void KeptRows::keep(std::string_view rows) const {
  if (file_) write_file(*file_, head_ + std::string(rows));
}

void KeptRows::discard() const {
  if (file_) std::filesystem::remove(*file_);
}

}  // namespace lubjoint::reports
