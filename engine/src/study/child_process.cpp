#include "child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>
#include <thread>

#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

constexpr int not_started = 127;  // exit status of a child that could not become the program

/// In the child: becomes the program. Only calls that are safe after a fork.
[[noreturn]] void become(char* const* arguments, int complaint, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(not_started);  // that died before the line above
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(complaint, STDERR_FILENO);
  execv(arguments[0], arguments);
  _exit(not_started);
}

/// Waits until the child is its program, or has ended: until then its memory is a copy of ours.
/// @param started  a pipe that the program does not inherit
void wait_for_start(const std::array<int, 2>& started) {
  close(started[1]);
  for (char nothing = 0; read(started[0], &nothing, 1) < 0 && errno == EINTR;) continue;
  close(started[0]);
}

/// What a process holds in memory now [bytes]; 0 where it has ended.
double resident_bytes(pid_t process) {
  std::ifstream pages("/proc/" + std::to_string(process) + "/statm");
  double whole = 0.0;
  double resident = 0.0;
  pages >> whole >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// Waits for the end of the child, or ends it where it meets a limit.
/// @return  the limit that it met, or why its end is not known; else empty
std::string wait_for(pid_t child, const Limits& limits, int& status) {
  using Clock = std::chrono::steady_clock;
  constexpr auto pause = std::chrono::milliseconds(2);  // costs a few thousandths of a core
  const auto start = Clock::now();
  const bool watched = limits.seconds || limits.memory;
  pid_t ended = 0;
  while ((ended = waitpid(child, &status, watched ? WNOHANG : 0)) == 0) {
    std::string met;
    if (limits.seconds && std::chrono::duration<double>(Clock::now() - start).count() > *limits.seconds)
      met = fmt::format("took longer than budget.seconds, {:g} s", *limits.seconds);
    else if (limits.memory && resident_bytes(child) > *limits.memory)
      met = fmt::format("took more memory than budget.memory, {:g} bytes", *limits.memory);
    if (!met.empty()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return met;
    }
    std::this_thread::sleep_for(pause);
  }
  if (ended < 0)  // who starts this program may have it ignore SIGCHLD, and then no status is kept
    return "how it ended is not known: " + std::generic_category().message(errno) + "; start this with SIGCHLD heeded";
  return "";
}

std::string first_line(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const std::string program = "shoreline: ";
  return line.starts_with(program) ? line.substr(program.size()) : line;
}

std::string reason_of(int status, const std::filesystem::path& complaint) {
  if (WIFSIGNALED(status)) {
    const char* guess = WTERMSIG(status) == SIGKILL ? "; the system may have run out of memory" : "";
    return fmt::format("ended by signal {} ({}){}", WTERMSIG(status), strsignal(WTERMSIG(status)), guess);
  }
  const std::string line = first_line(complaint);
  return line.empty() ? fmt::format("ended with status {} and without a message", WEXITSTATUS(status)) : line;
}

}  // namespace

ChildOutcome run_child(const std::vector<std::string>& words, const std::filesystem::path& complaint,
                       const Limits& limits) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int file = open(complaint.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) throw OutputError(complaint.string() + ": cannot write: " + std::generic_category().message(errno));
  std::array<int, 2> started{};
  if (pipe2(started.data(), O_CLOEXEC) != 0) {
    const int problem = errno;
    close(file);
    throw OutputError("cannot start a process: " + std::generic_category().message(problem));
  }
  const auto start = std::chrono::steady_clock::now();
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) become(arguments.data(), file, parent);
  const int problem = errno;
  close(file);
  wait_for_start(started);
  if (child < 0) throw OutputError("cannot start a process: " + std::generic_category().message(problem));

  ChildOutcome outcome;
  int status = 0;
  outcome.reason = wait_for(child, limits, status);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.succeeded = outcome.reason.empty() && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!outcome.succeeded && outcome.reason.empty()) outcome.reason = reason_of(status, complaint);
  return outcome;
}

}  // namespace shoreline
