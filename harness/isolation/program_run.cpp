#include "harness/isolation/program_run.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <optional>

#include "harness/interrupt.hpp"
#include "harness/isolation/child_process.hpp"

namespace signorini {

ProgramEnd run_to_end(const std::vector<std::string>& words, std::size_t most) {
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
    _exit(ProgramEnd::kMissing);
  });
  pipe.write.reset();
  set_non_blocking(pipe.read);
  ProgramEnd end;
  std::optional<std::chrono::steady_clock::time_point> last;  // after an interrupt
  while (!child.has_ended()) {
    std::array<pollfd, 1> waited{{{.fd = pipe.read.number(), .events = POLLIN, .revents = 0}}};
    poll(waited.data(), waited.size(), kLook);
    read_available(pipe.read, end.output, most);
    if (end.output.size() > most) return end;
    if (interrupted() && !last) {
      child.send_signal(SIGTERM);
      last = std::chrono::steady_clock::now() + kGrace;
    }
    if (last && std::chrono::steady_clock::now() > *last) break;
  }
  read_available(pipe.read, end.output, most);
  const int status = child.reap();
  if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
  return end;
}

}  // namespace signorini
