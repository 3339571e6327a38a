#pragma once
// What the attacks on the readers share, and those on packs and on plans of runs.

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "problems/problem.hpp"

namespace signorini::test {

/// \throws Violation unless the promise was kept
void require(bool kept, const std::string& promise);

/// A refusal is one line for a terminal: no break, no other control character, of a length that is read.
void require_one_line(const std::string& message);

/// One mass at one stop: what answers and curves are taken for.
const Problem& answered_problem();

/// A regular file that lives in memory, with a path to open it by.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view text) : descriptor_(memfd_create("attack", MFD_CLOEXEC)) {
    if (write(descriptor_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      throw std::runtime_error("no room for a file in memory");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Of untrusted_readers().
bool attack_archive(std::string_view text);
bool attack_pack(std::string_view text);
bool attack_options(std::string_view text);
bool attack_curves(std::string_view text);
bool attack_suite(std::string_view text);

}  // namespace signorini::test
