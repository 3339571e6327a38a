#include "problems/files/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace signorini {

namespace {

/// Closes its descriptor.
class OpenFile {
 public:
  /// Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  explicit OpenFile(const std::filesystem::path& path)
      : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) throw errno == ENOENT ? UnreadableFile("missing", "must exist") : unreadable();
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { close(descriptor_); }

  /// Bytes that the file says it has. \throws UnreadableFile unless it is a regular file
  [[nodiscard]] std::size_t size() const {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) throw unreadable();
    if (S_ISDIR(status.st_mode)) throw UnreadableFile("a folder", "must be a file");
    if (!S_ISREG(status.st_mode)) throw UnreadableFile("no regular file", "must be one");
    return static_cast<std::size_t>(status.st_size);
  }

  /// Appends at most `most` bytes; how many, 0 at the end. \throws UnreadableFile
  std::size_t append_to(std::string& text, std::size_t most) const {
    const std::size_t before = text.size();
    text.resize(before + most);
    ssize_t got = 0;
    do {
      got = read(descriptor_, text.data() + before, most);
    } while (got < 0 && errno == EINTR);
    if (got < 0) throw unreadable();
    text.resize(before + static_cast<std::size_t>(got));
    return static_cast<std::size_t>(got);
  }

 private:
  static UnreadableFile unreadable() { return {"unreadable", "must be a file that may be read"}; }

  int descriptor_;
};

[[noreturn]] void refuse_size(std::size_t most) {
  constexpr std::size_t kMebibyte = 1U << 20U;
  const std::string limit =
      most % kMebibyte == 0 ? fmt::format("{} MiB", most / kMebibyte) : fmt::format("{} bytes", most);
  throw UnreadableFile("more than " + limit, fmt::format("must be a file of at most {}", limit));
}

}  // namespace

UnreadableFile::UnreadableFile(std::string_view what_is_there, std::string_view required)
    : std::runtime_error(fmt::format("{} ({})", what_is_there, required)),
      found(what_is_there),
      requirement(required) {}

std::string read_input_file(const std::filesystem::path& path, std::size_t most) {
  constexpr std::size_t kBlock = 1U << 16U;
  const OpenFile file(path);
  const std::size_t promised = file.size();
  if (promised > most) refuse_size(most);
  std::string text;
  text.reserve(promised + 1);
  // One byte beyond the limit tells a file that grows or hides its size from one that ends there.
  while (text.size() <= most) {
    const std::size_t wanted = std::max(kBlock, promised + 1 - std::min(promised, text.size()));
    if (file.append_to(text, std::min(wanted, most + 1 - text.size())) == 0) return text;
  }
  refuse_size(most);
}

}  // namespace signorini
