// Interrupted, out of disk, read-only: nothing half-written is left under a name that somebody reads, and what is
// left under another is removed by the next run.
#include <fcntl.h>
#include <linux/capability.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <future>

#include "oracle/files/files.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace unfinished_files_test {

using namespace lubjoint::test;
using namespace lubjoint::reports;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

/// Begins a file and gets the signal with half of it written. @returns how the process ended
int interrupted_in_the_middle(const std::string& file, int signal) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::signal(signal, SIG_DFL);  // Catch2 has its own
    remove_temporary_files_on_interrupt();
    TemporaryFile unfinished(file);
    unfinished.write("half");
    ::raise(signal);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// Root without the right to ignore permissions; anybody else as they are.
void obey_permissions() {
  ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
  ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH);
}

void limit_file_size() {
  const rlimit limit{4096, 4096};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

bool is_whole(const fs::path& file) {
  const std::string text = read_text(file);
  if (file.extension() == ".png") return text.find("IEND") != std::string::npos;
  if (file.extension() == ".svg") return text.find("</svg>") != std::string::npos;
  return text.ends_with('\n');
}

}  // namespace

TEST_CASE("Unfinished files: an interrupt removes them, and the program ends by the signal") {
  const TemporaryFolder folder;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const int status = interrupted_in_the_middle(folder / "a.csv", signal);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.entries().empty());
  }
}

TEST_CASE("Unfinished files: what a killed program leaves has no name that is read, and the next run removes it") {
  const TemporaryFolder folder;
  write_file(folder / "a.csv", "as it was");
  CHECK(WTERMSIG(interrupted_in_the_middle(folder / "a.csv", SIGKILL)) == SIGKILL);
  CHECK(folder.entries().size() == 2);
  CHECK(read_text(folder / "a.csv") == "as it was");
  prepare_folder(folder.path());
  CHECK(folder.entries() == Names{"a.csv"});
}

TEST_CASE("Unfinished files: those that another process is writing, and those of other names, are left alone") {
  const TemporaryFolder folder;
  const std::string busy = folder.write("a.csv.unfinished-12-0", "in use");
  folder.write("b.csv.unfinished-draft", "a user's");
  folder.write("c.csv.unfinished-13-4", "abandoned");
  const int descriptor = ::open(busy.c_str(), O_WRONLY | O_CLOEXEC);
  REQUIRE(::flock(descriptor, LOCK_EX) == 0);
  prepare_folder(folder.path());
  CHECK(folder.entries() == Names{"a.csv.unfinished-12-0", "b.csv.unfinished-draft"});
  ::close(descriptor);
}

TEST_CASE("Unfinished files: writing goes through symbolic links and into pipes, and replaces neither") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  fs::create_symlink(file, folder / "link");
  write_file(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_text(file) == "new");

  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  auto reader = std::async(std::launch::async, [&] { return read_text(pipe); });
  write_file(pipe, "through");
  CHECK(reader.get() == "through");
  CHECK(fs::is_fifo(pipe));
}

TEST_CASE("Interrupted: whenever a command is stopped, its folder holds whole files or none") {
  struct Stop {
    std::vector<std::string> command;
    double after;  // [s]
  };
  const TemporaryFolder folder;
  const std::string out = "--out=" + (folder / "out");
  std::vector<Stop> stops = {{{"reproduce", out}, 0.3}, {{"accuracy", "--out", folder / "out/a.csv"}, 0.1}};
  for (const double after : {0.005, 0.02, 0.04, 0.06, 0.08})
    stops.push_back({{"simulate", journal_scene_file, out}, after});
  const bool has_golden = lubjoint_program({"golden", "--help"}).status == 0;  // built with FLINT
  if (has_golden) stops.push_back({{"golden", out}, 0.3});
  for (const Stop& stop : stops) {
    for (const int signal : {SIGINT, SIGKILL}) {
      INFO(stop.command.front() << " after " << stop.after << " s, signal " << signal);
      const ProgramResult result = lubjoint_program(stop.command, {.signal = signal, .signal_after = stop.after});
      CHECK((result.status == 128 + signal || result.status == 0));
      if (!fs::exists(folder / "out")) continue;
      for (const auto& entry : fs::directory_iterator(folder / "out")) {
        const bool unfinished = entry.path().string().find(".unfinished-") != std::string::npos;
        if (signal == SIGINT) CHECK_FALSE(unfinished);
        if (!unfinished) CHECK(is_whole(entry.path()));
      }
      fs::remove_all(folder / "out");
    }
  }
}

TEST_CASE("Interrupted: a trajectory that is cut off is not taken for one, and gets no manifest") {
  if (lubjoint_program({"golden", "--help"}).status != 0) {
    WARN("skipped: built without FLINT, and so without golden");
    return;
  }
  const TemporaryFolder folder;
  fs::create_directory(folder / "trajectories");
  const std::string whole = read_text(LUBJOINT_SOURCE_DIR "/data/golden/trajectories/journal-short_full.csv");
  for (const std::size_t kept : {whole.size() / 2, whole.size() - 1, whole.rfind('\n', whole.size() - 2) + 1}) {
    const std::string file = folder.write("trajectories/journal-short_full.csv", whole.substr(0, kept));
    const ProgramResult result = lubjoint_program({"golden", "--trajectories", "--out", folder.path().string()});
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Contains(file) && Contains("is cut off") && Contains("allowed is"));
    CHECK(folder.entries() == Names{"trajectories", "trajectories/journal-short_full.csv"});
  }
}

TEST_CASE("Out of space: the message says what, where and why, nothing is left, and what was there stays") {
  const TemporaryFolder folder;
  const std::string old = folder.write("journal.csv", "as it was");
  const ProgramResult result =
      lubjoint_program({"simulate", journal_scene_file, "--out", folder.path().string()}, {.before = limit_file_size});
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains("\"" + old + "\" can't be written: File too large"));
  CHECK(result.out.empty());
  CHECK(folder.entries() == Names{"journal.csv"});
  CHECK(read_text(old) == "as it was");
}

TEST_CASE("Out of space: a device that is full is an error, and stays a device") {
  const TemporaryFolder folder;
  std::string full = folder / "full";
  if (::mknod(full.c_str(), S_IFCHR | 0600, makedev(1, 7)) != 0) full = "/dev/full";  // not root: can't harm it
  const ProgramResult result = lubjoint_program({"accuracy", "--directions", "0", "--out", full});
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains("\"" + full + "\" can't be written: No space left on device"));
  CHECK(fs::is_character_file(full));
}

TEST_CASE("Read-only: a folder that can't be written to is refused before anything is computed") {
  const TemporaryFolder folder;
  REQUIRE(::chmod(folder.path().c_str(), 0500) == 0);
  const std::string below = folder / "below";
  for (const std::string& place : {folder.path().string(), below}) {
    const ProgramResult result =
        lubjoint_program({"reproduce", "--out", place}, {.seconds = 2, .before = obey_permissions});
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Contains("\"" + place + "\"") && Contains("Permission denied") && Contains("allowed is"));
  }
  CHECK(folder.entries().empty());
}

}  // namespace unfinished_files_test
