#include "harness/reduction/shared_reduction.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/child_process.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr int kNotFound = 127;  // as shells say it

fs::path reducer() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / kSharedReducer;
  if (!fs::exists(program))
    throw UsageError(
        fmt::format("mpi (must be left out: {} is not beside the program; the package signorini-mpi has it, "
                    "and a build where libmumps-dev is installed)",
                    kSharedReducer));
  return program;
}

std::vector<std::string> words_of(const ReductionOrder& order, const MpiLaunch& launch) {
  std::vector<std::string> words = split(launch.launcher, ' ');
  std::erase(words, "");
  if (words.empty()) throw UsageError("launcher (must name a command)");
  for (const std::string& word : {std::string("-n"), std::to_string(launch.processes), reducer().string(),
                                  order.scene, order.out.string(), std::to_string(order.vectors)})
    words.push_back(word);
  return words;
}

/// All that the command prints, and its exit code.
std::pair<std::string, int> output_of(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  arguments.push_back(nullptr);
  constexpr int kLook = 50;                                           // [ms]
  constexpr std::chrono::seconds kGrace(5);                           // for a launcher to end its processes
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));  // launchers read what is not for them
  Pipe pipe = make_pipe();
  ChildProcess child({.in = nothing.number(), .out = pipe.write.number(), .err = -1}, -1, [&] {
    execvp(arguments.front(), arguments.data());
    _exit(kNotFound);
  });
  pipe.write.reset();
  set_non_blocking(pipe.read);
  std::string text;
  std::optional<std::chrono::steady_clock::time_point> last;  // after an interrupt
  while (!child.has_ended()) {
    std::array<pollfd, 1> waited{{{.fd = pipe.read.number(), .events = POLLIN, .revents = 0}}};
    poll(waited.data(), waited.size(), kLook);
    read_available(pipe.read, text);
    if (interrupted() && !last) {
      child.send_signal(SIGTERM);
      last = std::chrono::steady_clock::now() + kGrace;
    }
    if (last && std::chrono::steady_clock::now() > *last) break;
  }
  read_available(pipe.read, text);
  const int status = child.reap();
  return {text, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

}  // namespace

std::string reduce_by_mpi(const ReductionOrder& order, const MpiLaunch& launch) {
  const std::vector<std::string> words = words_of(order, launch);
  const auto [text, code] = output_of(words);
  if (code == kNotFound) throw UsageError(fmt::format("launcher = {} (could not be run)", launch.launcher));
  const std::string last = last_line(text);
  if (last.starts_with(kReductionRefused)) throw UsageError(last.substr(kReductionRefused.size()));
  if (last.starts_with(kReductionFailed)) throw ReductionFailure(last.substr(kReductionFailed.size()));
  if (interrupted()) return {};
  if (last != kReductionDone)
    throw ReductionFailure(fmt::format("{} ended with code {} before it was done", words.front(), code));
  return text.substr(0, text.rfind(kReductionDone));
}

}  // namespace signorini
