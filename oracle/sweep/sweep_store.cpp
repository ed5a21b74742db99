#include "oracle/sweep/sweep_store.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>

#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"

namespace lubjoint::reports {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t checksum_digits = 16;
constexpr const char* what_else = "; allowed is to delete it, or to name another --out";

/// A lock of one process on a folder, for as long as this lives.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX) != 0) {
      if (descriptor_ >= 0) ::close(descriptor_);
      throw OutputError("folder \"" + folder.string() + "\" can't be locked: " + std::strerror(errno));
    }
  }
  ~FolderLock() { ::close(descriptor_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

std::optional<std::size_t> row_index(const std::string& row) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), index);
  if (error != std::errc() || end == row.data() + row.size() || *end != ',') return std::nullopt;
  return index;
}

nlohmann::ordered_json json_of(const SweepIdentity& identity) {
  nlohmann::ordered_json items;
  for (const auto& [name, value] : identity) items[name] = value;
  return items;
}

/// What a merge leaves beside its CSV.
std::string merge_manifest(const SweepIdentity& identity, const std::string& csv) {
  nlohmann::ordered_json manifest = json_of(identity);
  manifest["csv_sha256"] = sha256(csv);
  return manifest.dump(2) + "\n";
}

std::string file_text(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) ? read_input(file.string()) : std::string();
}

}  // namespace

std::vector<std::size_t> Shard::points(std::size_t all) const {
  std::vector<std::size_t> points;
  for (std::size_t i = number - 1; i < all; i += count) points.push_back(i);
  return points;
}

bool is_merged(const fs::path& folder, const std::string& stem, const SweepIdentity& identity) {
  const std::string csv = file_text(folder / (stem + ".csv"));
  return !csv.empty() && file_text(folder / (stem + ".json")) == merge_manifest(identity, csv);
}

std::string lock_refusal(const fs::path& part, int error) {
  if (error == EWOULDBLOCK) {
    return "another process is at work on \"" + part.string() + "\"; allowed is one for each shard";
  }
  return "\"" + part.string() + "\" can't be locked: " + std::strerror(error) +
         "; allowed is a folder whose file system has locks (flock)";
}

SweepStore::SweepStore(fs::path folder, std::string stem, const SweepIdentity& identity,
                       const std::optional<Shard>& shard)
    : folder_(std::move(folder)), stem_(std::move(stem)), identity_(identity) {
  header_ = json_of(identity_).dump();
  digest_ = sha256(header_);
  if (shard) own_ = part_of(*shard);
  read_all();  // what others have left is refused before there is a part of our own
  if (shard) open_own();
}

SweepStore::~SweepStore() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string SweepStore::checksum(const std::string& line) const {
  return sha256(digest_ + line).substr(0, checksum_digits);
}

std::vector<fs::path> SweepStore::parts() const {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(stem_ + ".") && name.ends_with(".part")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path SweepStore::part_of(const Shard& shard) const {
  return folder_ / (stem_ + "." + std::to_string(shard.number) + "-of-" + std::to_string(shard.count) + ".part");
}

void SweepStore::open_own() {
  descriptor_ = ::open(own_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw OutputError("\"" + own_.string() + "\" can't be written: " + std::strerror(errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    ::close(std::exchange(descriptor_, -1));
    throw std::invalid_argument(lock_refusal(own_, reason));
  }
  try {
    const std::size_t whole = read_part(own_, read_input(own_.string()));
    if (::ftruncate(descriptor_, static_cast<::off_t>(whole)) != 0) {
      throw OutputError("\"" + own_.string() + "\" can't be written: " + std::strerror(errno));
    }
    if (whole == 0) append(stamped(header_));
  } catch (...) {
    ::close(std::exchange(descriptor_, -1));
    throw;
  }
}

void SweepStore::read_all() {
  for (const fs::path& file : parts()) {
    if (file == own_) continue;
    read_part(file, read_input(file.string()));
  }
}

void SweepStore::require_own_identity(const fs::path& file, const std::string& line) const {
  const std::string text = line.size() > checksum_digits ? line.substr(checksum_digits + 1) : std::string();
  if (text == header_ && line == checksum(text) + " " + text) return;
  const auto found = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!found.is_object()) {
    throw std::invalid_argument("\"" + file.string() + "\" is no part of a sweep" + what_else);
  }
  std::string others;
  for (const auto& [name, value] : identity_) {
    if (found.contains(name) && found[name] == value) continue;
    others += (others.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument("\"" + file.string() + "\" belongs to another sweep (other " +
                              (others.empty() ? "format" : others) + ")" + what_else);
}

std::size_t SweepStore::read_part(const fs::path& file, const std::string& text) {
  std::size_t begin = 0;
  std::size_t number = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (number == 1) {
      require_own_identity(file, line);
      continue;
    }
    const std::string row = line.size() > checksum_digits ? line.substr(checksum_digits + 1) : std::string();
    const std::optional<std::size_t> index = row_index(row);
    if (!index || line != checksum(row) + " " + row) {
      notes_.push_back("\"" + file.string() + "\", line " + std::to_string(number) + ": damaged, and ignored");
      continue;
    }
    const auto [known, is_new] = rows_.emplace(*index, row);
    if (!is_new && known->second != row) {
      throw std::invalid_argument("\"" + file.string() + "\", line " + std::to_string(number) + ": point " +
                                  std::to_string(*index) + " has another row in another part" + what_else);
    }
  }
  if (begin < text.size() && begin > 0 && file == own_) {  // another part may be being written
    notes_.push_back("\"" + file.string() + "\": the last row is cut off, and ignored");
  }
  return begin;
}

void SweepStore::append(const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ::ssize_t count = ::write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw OutputError("\"" + own_.string() + "\" can't be written: " + std::strerror(errno));
    written += static_cast<std::size_t>(count);
  }
}

void SweepStore::add(std::size_t index, const std::string& row) {
  const std::string line = stamped(row);
  const std::lock_guard lock(mutex_);
  append(line);
  rows_.emplace(index, row);
}

bool SweepStore::merge(const std::string& header, std::size_t points) {
  const FolderLock lock(folder_);
  struct stat own {};
  if (descriptor_ >= 0 && ::fstat(descriptor_, &own) == 0 && own.st_nlink == 0) return true;
  read_all();
  if (rows_.size() != points) return false;
  std::string text = header + "\n";
  for (const auto& [index, row] : rows_) text += row + "\n";
  write_file(folder_ / (stem_ + ".csv"), text);
  write_file(folder_ / (stem_ + ".json"), merge_manifest(identity_, text));
  for (const fs::path& part : parts()) fs::remove(part);
  return true;
}

}  // namespace lubjoint::reports
