#include "oracle/files/temporary_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>
#include <vector>

namespace lubjoint::reports {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view mark = ".unfinished-";

/// Paths for a signal handler, which may call unlink and nothing that allocates.
constexpr std::size_t slots = 16;
constexpr std::size_t longest_path = 4096;
char pending[slots][longest_path];
std::atomic<bool> used[slots];

void remove_pending_and_end(int signal) {
  for (std::size_t i = 0; i < slots; ++i) {
    if (used[i]) ::unlink(pending[i]);
  }
  // Ends by the signal itself, when this returns: a shell that waits then knows that its user wants to stop.
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

/// @returns the slot, or `slots` if all are taken: the file is then left to remove_unfinished_files
std::size_t take_slot(const std::string& name) {
  if (name.size() >= longest_path) return slots;
  for (std::size_t i = 0; i < slots; ++i) {
    bool free = false;
    if (!used[i].compare_exchange_strong(free, true)) continue;
    name.copy(pending[i], name.size());
    pending[i][name.size()] = '\0';
    return i;
  }
  return slots;
}

bool is_unfinished(const std::string& name) {
  const std::size_t at = name.rfind(mark);
  return at != std::string::npos && name.find_first_not_of("0123456789-", at + mark.size()) == std::string::npos;
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : target_(target), slot_(slots) {
  std::error_code error;
  if (fs::is_symlink(target, error)) target_ = fs::weakly_canonical(target, error);
  static std::atomic<unsigned> number = 0;
  do {
    path_ = target_;
    path_ += std::string(mark) + std::to_string(::getpid()) + "-" + std::to_string(number++);
  } while (!make(path_));
}

/// @returns false if one of that name is there, or was swept away before it could be locked
bool TemporaryFile::make(const fs::path& path) {
  slot_ = take_slot(path.string());
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const int error = errno;
  struct stat status {};
  // Where locks are not to be had nothing is swept, either.
  if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  if (descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return true;
  if (slot_ < slots) used[slot_] = false;
  slot_ = slots;
  if (descriptor_ < 0 && error != EEXIST) refuse(error);
  if (descriptor_ >= 0) ::close(descriptor_);
  return false;
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
  if (slot_ < slots) used[slot_] = false;
}

void TemporaryFile::write(std::string_view content) {
  while (!content.empty()) {
    const ::ssize_t count = ::write(descriptor_, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(errno);
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  // Some file systems say only now that the disk is full; others know no fsync.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOSYS) refuse(errno);
}

void TemporaryFile::keep() {
  if (::rename(path_.c_str(), target_.c_str()) != 0) refuse(errno);
  path_.clear();
}

void TemporaryFile::refuse(int error) const { throw OutputError(target_, std::generic_category().message(error)); }

void remove_unfinished_files(const fs::path& folder) noexcept try {
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_unfinished(entry.path().filename().string())) left.push_back(entry.path());
  }
  for (const fs::path& path : left) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
    ::close(descriptor);
  }
} catch (const std::exception&) {
  // A folder that can't be read: then nothing is removed from it.
}

void remove_temporary_files_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = remove_pending_and_end;
  sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // nohup, or a shell's background
  }
  // Not ignored: programs that are started would inherit that.
  action.sa_handler = [](int) {};
  sigaction(SIGXFSZ, &action, nullptr);
}

}  // namespace lubjoint::reports
