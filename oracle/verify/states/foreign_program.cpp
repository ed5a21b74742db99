#include "oracle/verify/states/foreign_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>

#include "oracle/verify/states/answers.hpp"

extern char** environ;

namespace lubjoint::verify {

namespace {

using Clock = std::chrono::steady_clock;

/// One end of a pipe, closed with its owner and not inherited by programs started later.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (value_ >= 0) ::close(value_);
    value_ = -1;
  }
  int get() const { return value_; }
  bool open() const { return value_ >= 0; }

 private:
  int value_ = -1;
};

struct Pipe {
  Descriptor read;
  Descriptor write;
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw UnjudgedError(std::string("no pipe: ") + std::strerror(errno));
    read = Descriptor(ends[0]);
    write = Descriptor(ends[1]);
  }
};

/// A program that closes its input early must not end ours.
class BrokenPipesIgnored {
 public:
  BrokenPipesIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~BrokenPipesIgnored() { std::signal(SIGPIPE, before_); }
  BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
  BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;

 private:
  void (*before_)(int);
};

/// While this lives, a signal that ends us ends that program first: an interrupt from the terminal does not reach a
/// process group of its own.
class EndsWithUs {
 public:
  explicit EndsWithUs(pid_t group) {
    ended_group = group;
    struct sigaction action {};
    action.sa_handler = end_both;
    sigfillset(&action.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      ::sigaction(signals[i], nullptr, &handlers_before[i]);
      if (handlers_before[i].sa_handler != SIG_IGN) ::sigaction(signals[i], &action, nullptr);  // nohup
    }
  }
  ~EndsWithUs() {
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &handlers_before[i], nullptr);
  }
  EndsWithUs(const EndsWithUs&) = delete;
  EndsWithUs& operator=(const EndsWithUs&) = delete;

 private:
  static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

  static void end_both(int signal) {
    ::kill(-ended_group, SIGKILL);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (signals[i] == signal) ::sigaction(signal, &handlers_before[i], nullptr);
    }
    ::raise(signal);  // as it would have been, when this returns
  }

  static inline volatile std::sig_atomic_t ended_group = 0;
  static inline std::array<struct sigaction, signals.size()> handlers_before;
};

/// A running program, head of its own process group; killed and reaped if its owner gives up.
class Child {
 public:
  Child(const std::vector<std::string>& command, const Pipe& in, const Pipe& out, const Pipe& error) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.read.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.write.get(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, error.write.get(), STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    const int failure = posix_spawnp(&id_, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failure != 0) {
      id_ = -1;
      throw UnjudgedError(fmt::format("\"{}\" can't be started: {}", command[0], std::strerror(failure)));
    }
    ends_with_us_.emplace(id_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (id_ < 0) return;
    ::kill(-id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
  }

  /// Status as waitpid gives it, or -1 if the program still runs at the deadline.
  int wait_until(Clock::time_point deadline) {
    int status = 0;
    while (true) {
      const pid_t ended = ::waitpid(id_, &status, WNOHANG);
      if (ended == id_) break;
      if (Clock::now() >= deadline) return -1;
      ::usleep(1000);
    }
    id_ = -1;
    ends_with_us_.reset();
    return status;
  }

 private:
  pid_t id_ = -1;
  std::optional<EndsWithUs> ends_with_us_;
};

/// Appends what can be read. False at the end of the stream.
bool drain(const Descriptor& from, std::string& to) {
  std::array<char, 65536> buffer;
  const ssize_t got = ::read(from.get(), buffer.data(), buffer.size());
  if (got < 0) return errno == EINTR || errno == EAGAIN;
  to.append(buffer.data(), static_cast<std::size_t>(got));
  return got > 0;
}

std::string last_words(const std::string& error) {
  std::string_view text = error;
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  if (text.empty()) return {};
  if (text.size() > 600) text.remove_prefix(text.size() - 600);
  return "; its last words:\n" + std::string(text);
}

}  // namespace

std::string run_program(const std::vector<std::string>& command, std::string_view input, const ProgramLimits& limits) {
  if (command.empty() || command[0].empty()) throw UnjudgedError("no program is named");
  const auto after = [](const std::optional<std::chrono::duration<double>>& span) {
    return span ? Clock::now() + std::chrono::duration_cast<Clock::duration>(*span) : Clock::time_point::max();
  };
  const auto deadline = after(limits.in_all);
  auto next_line_due = after(limits.between_lines);
  std::size_t lines = 0, looked_at = 0;
  const BrokenPipesIgnored guard;
  Pipe in;
  Pipe out;
  Pipe error;
  Child child(command, in, out, error);
  in.read.close();
  out.write.close();
  error.write.close();
  ::fcntl(in.write.get(), F_SETFL, O_NONBLOCK);
  std::string answer;
  std::string complaints;
  const auto too_late = [&] {
    if (next_line_due < deadline) {
      return UnjudgedError(
          fmt::format("\"{}\" printed no line for {} s (--state-timeout) and was stopped; it had printed {} lines. A "
                      "program must write each answer when it has it, not when its buffer is full (python3 -u, fflush)",
                      command[0], limits.between_lines->count(), lines) +
          last_words(complaints));
    }
    return UnjudgedError(fmt::format("\"{}\" was not done after {} s (--timeout) and was stopped; it had printed {} "
                                     "bytes. A program must end when its standard input does",
                                     command[0], limits.in_all->count(), answer.size()) +
                         last_words(complaints));
  };
  while (out.read.open() || error.read.open()) {
    std::array<pollfd, 3> ends = {pollfd{in.write.get(), POLLOUT, 0}, pollfd{out.read.get(), POLLIN, 0},
                                  pollfd{error.read.get(), POLLIN, 0}};  // poll skips negative descriptors
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::min(deadline, next_line_due) - Clock::now()).count();
    if (left <= 0) throw too_late();
    if (::poll(ends.data(), ends.size(), static_cast<int>(std::min<long>(left, 1000))) < 0 && errno != EINTR) {
      throw UnjudgedError(std::string("poll: ") + std::strerror(errno));
    }
    if (ends[0].revents != 0) {
      const ssize_t put = ::write(in.write.get(), input.data(), input.size());
      if (put > 0) input.remove_prefix(static_cast<std::size_t>(put));
      if (input.empty() || (put < 0 && errno != EAGAIN && errno != EINTR)) in.write.close();
    }
    if (ends[1].revents != 0 && !drain(out.read, answer)) out.read.close();
    const auto more = static_cast<std::size_t>(
        std::count(answer.begin() + static_cast<std::ptrdiff_t>(looked_at), answer.end(), '\n'));
    looked_at = answer.size();
    lines += more;
    if (more > 0) next_line_due = after(limits.between_lines);
    if (more > 0 && limits.on_lines) limits.on_lines(lines);
    if (ends[2].revents != 0 && !drain(error.read, complaints)) error.read.close();
  }
  in.write.close();
  const int status = child.wait_until(std::min(deadline, next_line_due));
  if (status < 0) throw too_late();
  if (WIFSIGNALED(status)) {
    throw UnjudgedError(
        fmt::format("\"{}\" was ended by signal {} ({})", command[0], WTERMSIG(status), ::strsignal(WTERMSIG(status))) +
        last_words(complaints));
  }
  if (WEXITSTATUS(status) != 0) {
    throw UnjudgedError(fmt::format("\"{}\" ended with status {}", command[0], WEXITSTATUS(status)) +
                        last_words(complaints));
  }
  return answer;
}

}  // namespace lubjoint::verify
