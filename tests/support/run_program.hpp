/// Runs the built program as a user does, and keeps what it said.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.hpp"

namespace lubjoint::test {

struct ProgramResult {
  int status = -1;  ///< exit status; 128 + signal if it was killed
  std::string out;
  std::string err;
};

/// How to run it, beyond its arguments.
struct ProgramSetting {
  std::string input = {};                               ///< its standard input
  std::map<std::string, std::string> environment = {};  ///< added to ours
  std::string folder = {};                              ///< where it runs; empty: here
  std::string output = {};                              ///< file that standard output goes to, in place of `out`
  double seconds = 60;                                  ///< then it is killed: no command under test takes a tenth
  std::function<void()> before = {};                    ///< done in the new process before the program starts
  int signal = 0;                                       ///< sent to it after `signal_after`, unless it has ended
  double signal_after = 0;                              ///< [s]
};

namespace detail {
inline void redirect(const std::string& file, int flags, int descriptor) {
  const int opened = ::open(file.c_str(), flags, 0600);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(127);
  ::close(opened);
}
}  // namespace detail

/// Runs a program. @throws std::runtime_error if it can't be started or does not end in time
inline ProgramResult run(const std::string& program, const std::vector<std::string>& arguments,
                         const ProgramSetting& setting = {}) {
  const TemporaryFolder folder;
  const std::string in = folder.write("in", setting.input);
  const std::string out = setting.output.empty() ? folder.write("out", "") : setting.output;
  const std::string err = folder.write("err", "");
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process for " + program);
  if (child == 0) {
    for (const auto& [name, value] : setting.environment) ::setenv(name.c_str(), value.c_str(), 1);
    detail::redirect(in, O_RDONLY, STDIN_FILENO);
    detail::redirect(out, O_WRONLY | O_CREAT, STDOUT_FILENO);
    detail::redirect(err, O_WRONLY, STDERR_FILENO);
    if (!setting.folder.empty() && ::chdir(setting.folder.c_str()) != 0) ::_exit(127);
    if (setting.before) setting.before();
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  bool signalled = setting.signal == 0;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (!signalled && passed() > setting.signal_after) {
      ::kill(child, setting.signal);
      signalled = true;
    }
    if (passed() > setting.seconds) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      throw std::runtime_error(program + " did not end within " + std::to_string(setting.seconds) + " s");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ProgramResult result;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (setting.output.empty()) result.out = read_text(out);
  result.err = read_text(err);
  return result;
}

/// Runs lubjoint.
inline ProgramResult lubjoint_program(const std::vector<std::string>& arguments, const ProgramSetting& setting = {}) {
  return run(LUBJOINT_PROGRAM, arguments, setting);
}

}  // namespace lubjoint::test
