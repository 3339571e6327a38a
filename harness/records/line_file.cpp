#include "harness/records/line_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <thread>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"

namespace signorini {

namespace {

/// Tries the lock for a moment: children of a run that was killed may hold it for an instant longer.
bool take_lock(int descriptor) {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    // File systems without locks cannot refuse a second run.
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace

std::size_t read_lines(const std::filesystem::path& file, const std::function<void(const std::string&)>& take,
                       std::string_view remedy) {
  const std::string text = read_file(file);
  std::size_t begin = 0;
  for (std::size_t number = 1; true; ++number) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) return begin;
    try {
      if (end > begin) take(text.substr(begin, end - begin));
    } catch (const BadRecord& error) {
      fmt::print(stderr, "{}:{}: {}; this line is left out, and {}\n", as_message(file.string()), number,
                 as_message(error.what()), remedy);
    }
    begin = end + 1;
  }
}

Descriptor open_to_append(const std::filesystem::path& file) {
  Descriptor descriptor(open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!descriptor.is_open()) {
    throw UsageError(
        fmt::format("out = {} (must be a folder that can be written)", file.parent_path().string()));
  }
  return descriptor;
}

void append_line(const Descriptor& descriptor, const std::string& line, const std::filesystem::path& file) {
  const std::string whole = line + "\n";
  // One write to a file opened with O_APPEND: a kill can tear the last line only.
  const ssize_t written = write(descriptor.number(), whole.data(), whole.size());
  if (written == static_cast<ssize_t>(whole.size())) return;
  // A write that stops short sets no error: the disk is full, or a limit of file sizes is reached.
  const std::error_code reason(written < 0 ? errno : ENOSPC, std::generic_category());
  throw UsageError(
      fmt::format("out = {} (must have room: {}; the same command with --resume goes on from here)",
                  file.string(), reason.message()));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw UsageError(fmt::format("out = {} (must be a folder that can be written: {})", folder.string(),
                                 failure.message()));
  }
}

Descriptor lock_folder(const std::filesystem::path& folder) {
  Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.is_open() && !take_lock(descriptor.number()))
    throw UsageError(fmt::format("out = {} (must not be in use: another run writes there)", folder.string()));
  return descriptor;
}

bool folder_in_use(const std::filesystem::path& folder) {
  const Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return descriptor.is_open() && flock(descriptor.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace signorini
