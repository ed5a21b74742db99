#include "oracle/files/kept_rows.hpp"

#include "oracle/files/files.hpp"
#include "oracle/files/program_identity.hpp"

namespace lubjoint::reports {

std::string KeptRows::first_line(const std::string& campaign) {
  return "# " + campaign + "; program " + program_identity() + "\n";
}

KeptRows::KeptRows(std::optional<std::filesystem::path> file, const std::string& campaign, const std::string& header)
    : file_(std::move(file)) {
  if (!file_) return;
  const std::string first = first_line(campaign);
  text_ = first + header;
  std::error_code unreadable;  // then there is nothing to be taken up
  if (!std::filesystem::is_regular_file(*file_, unreadable)) return;
  std::string text = read_input(file_->string());
  if (!text.starts_with(first)) return;
  earlier_.emplace(std::string_view(text).substr(first.size()), file_->string());
  text_ = std::move(text);
}

void KeptRows::add(std::string_view rows) {
  if (!file_) return;
  text_ += rows;
  write_file(*file_, text_);
}

void discard_kept_rows(const std::optional<std::filesystem::path>& file) {
  if (file) std::filesystem::remove(*file);
}

}  // namespace lubjoint::reports
