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

[[noreturn]] void refuse_file(const char* must, int reason, const std::filesystem::path& file) {
  throw UsageError("out = {} (must {}: {}; the same command with --resume goes on from here)", file.string(),
                   must, std::error_code(reason, std::generic_category()).message());
}

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

Descriptor open_to_read(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure))
    throw UsageError("file = {} (must be a readable file)", file.string());
  // Files that the kernel makes up are regular too, and to read one may be to wait for ever.
  Descriptor descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!descriptor.is_open()) {
    throw UsageError("file = {} (must be a readable file: {})", file.string(),
                     std::generic_category().message(errno));
  }
  return descriptor;
}

/// A file, block by block.
class Blocks {
 public:
  explicit Blocks(const std::filesystem::path& file) : file_(file), descriptor_(open_to_read(file)) {}

  /// The next block; empty at the end.
  std::string_view next() {
    ssize_t count = -1;
    do {
      count = read(descriptor_.number(), buffer_.data(), buffer_.size());
    } while (count < 0 && errno == EINTR);
    if (count < 0) {
      throw UsageError("file = {} (must be a readable file: {})", file_.string(),
                       std::generic_category().message(errno));
    }
    return std::string_view(buffer_).substr(0, static_cast<std::size_t>(count));
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 18U;
  std::filesystem::path file_;
  Descriptor descriptor_;
  std::string buffer_ = std::string(kBlock, '\0');
};

/// The line that is being read: its beginning comes from earlier blocks, its end from this one.
class OpenLine {
 public:
  void add(std::string_view piece) {
    size_ += piece.size();
    if (size_ <= kLongestLine) text_ += piece;
  }

  /// The whole line, of which `last` is the end. \throws BadRecord if it is too long
  std::string_view closed(std::string_view last) {
    if (size_ == 0 && last.size() <= kLongestLine) return last;
    add(last);
    if (size_ > kLongestLine) throw BadRecord("line = {} bytes (must be at most {})", size_, kLongestLine);
    return text_;
  }

  void clear() {
    text_.clear();
    size_ = 0;
  }

 private:
  std::string text_;
  std::uint64_t size_ = 0;  // with what is too much
};

}  // namespace

std::uint64_t read_lines(const std::filesystem::path& file, const std::function<void(const Line&)>& take,
                         std::string_view remedy) {
  Blocks blocks(file);
  OpenLine open;
  std::uint64_t begin = 0, number = 0, position = 0;  // of the line, its number, and of the block
  for (std::string_view block = blocks.next(); !block.empty(); block = blocks.next()) {
    const std::uint64_t next_block = position + block.size();
    for (std::size_t end = block.find('\n'); end != std::string_view::npos; end = block.find('\n')) {
      const std::uint64_t after = position + end + 1;
      ++number;
      try {
        const std::uint64_t size = after - 1 - begin;
        if (size > 0) take({.text = open.closed(block.substr(0, end)), .place = {begin, size}});
      } catch (const BadRecord& error) {
        fmt::print(stderr, "{}:{}: {}; this line is left out, and {}\n", as_message(file.string()), number,
                   as_message(error.what()), remedy);
      }
      open.clear();
      block.remove_prefix(end + 1);
      begin = position = after;
    }
    open.add(block);
    position = next_block;
  }
  return begin;
}

StoredLines::StoredLines(const std::filesystem::path& file) : file_(file), descriptor_(open_to_read(file)) {}

std::string StoredLines::at(const LinePlace& place) const {
  std::string text(place.size, '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = pread(descriptor_.number(), text.data() + done, text.size() - done,
                                static_cast<off_t>(place.begin + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw UsageError("file = {} (must not change while it is read)", file_.string());
    done += static_cast<std::size_t>(count);
  }
  return text;
}

Descriptor open_to_append(const std::filesystem::path& file) {
  require_own_file(file);
  Descriptor descriptor(
      open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
  if (!descriptor.is_open())
    throw UsageError("out = {} (must be a folder that can be written)", file.parent_path().string());
  require_own_file(file, descriptor.number());
  return descriptor;
}

void append_line(const Descriptor& descriptor, const std::string& line, const std::filesystem::path& file) {
  const std::string whole = line + "\n";
  // One write to a file opened with O_APPEND: a kill can tear the last line only.
  const ssize_t written = write(descriptor.number(), whole.data(), whole.size());
  if (written == static_cast<ssize_t>(whole.size())) return;
  // A write that stops short sets no error: the disk is full, or a limit of file sizes is reached.
  refuse_file("have room", written < 0 ? errno : ENOSPC, file);
}

void keep_lines(const Descriptor& descriptor, const std::filesystem::path& file) {
  if (fsync(descriptor.number()) != 0) refuse_file("keep what is written", errno, file);
}

void cut_lines(const Descriptor& descriptor, std::uint64_t size, const std::filesystem::path& file) {
  if (ftruncate(descriptor.number(), static_cast<off_t>(size)) != 0) refuse_file("be cut", errno, file);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw UsageError("out = {} (must be a folder that can be written: {})", folder.string(),
                     failure.message());
  }
}

Descriptor lock_folder(const std::filesystem::path& folder) {
  Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.is_open() && !take_lock(descriptor.number()))
    throw UsageError("out = {} (must not be in use: another run writes there)", folder.string());
  return descriptor;
}

bool folder_in_use(const std::filesystem::path& folder) {
  const Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return descriptor.is_open() && flock(descriptor.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace signorini
