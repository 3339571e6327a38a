#include "harness/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "harness/failure.hpp"
#include "problems/files/input_file.hpp"

namespace signorini {

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  try {
    return read_input_file(path, most);
  } catch (const UnreadableFile& error) {
    throw UsageError("file = {} (must be a readable file; it is {})", path.string(), error.found);
  }
}

std::string first_line(const std::filesystem::path& path) {
  try {
    const std::string text = read_input_file(path, kLargestFile);
    return text.substr(0, text.find('\n'));
  } catch (const UnreadableFile&) {
    return {};
  }
}

namespace {

/// What will be a file: made anew under a name of its own beside it. What stands there under that name, of a
/// run that was killed or of somebody else, is removed and never followed. The folder is looked up once: one
/// that is exchanged meanwhile gets nothing.
class Draft {
 public:
  explicit Draft(const std::filesystem::path& file) : file_(file.filename().string()), name_(file_ + ".new") {
    const std::filesystem::path parent = file.has_parent_path() ? file.parent_path() : ".";
    folder_ = open(parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (folder_ >= 0) {
      unlinkat(folder_, name_.c_str(), 0);
      constexpr mode_t kReadable = 0666;  // less the umask
      descriptor_ =
          openat(folder_, name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kReadable);
    }
    if (descriptor_ < 0) reason_ = errno;
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    if (descriptor_ >= 0) {
      close(descriptor_);
      unlinkat(folder_, name_.c_str(), 0);
    }
    if (folder_ >= 0) close(folder_);
  }

  void add(std::string_view piece) {
    constexpr std::size_t kBuffered = std::size_t{1} << 16U;
    buffer_ += piece;
    if (buffer_.size() >= kBuffered) flush();
  }

  /// Under its final name. Returns the system's reason where that failed, else 0.
  int keep() {
    flush();
    if (reason_ == 0 && fsync(descriptor_) != 0 && errno != EINVAL) reason_ = errno;
    if (reason_ != 0) return reason_;
    if (close(std::exchange(descriptor_, -1)) != 0 ||
        renameat(folder_, name_.c_str(), folder_, file_.c_str()) != 0) {
      reason_ = errno;
      unlinkat(folder_, name_.c_str(), 0);
    }
    return reason_;
  }

 private:
  void flush() {
    for (std::size_t done = 0; reason_ == 0 && done < buffer_.size();) {
      const ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
      if (count >= 0)
        done += static_cast<std::size_t>(count);
      else if (errno != EINTR)
        reason_ = errno;
    }
    buffer_.clear();
  }

  std::string file_, name_, buffer_;
  int folder_ = -1, descriptor_ = -1, reason_ = 0;
};

/// \throws UsageError for a device, and for what else stands in /dev: root would rename a file over /dev/null
void require_no_device(const std::filesystem::path& file) {
  struct stat found {};
  const bool is_device =
      lstat(file.c_str(), &found) == 0 && (S_ISCHR(found.st_mode) || S_ISBLK(found.st_mode));
  if (is_device || file.parent_path() == "/dev")
    throw UsageError("out = {} (must be a file, and no device)", file.string());
}

}  // namespace

void write_whole(const std::filesystem::path& file, std::string_view text) {
  write_whole(file, [&](const TextSink& sink) { sink(text); });
}

void write_whole(const std::filesystem::path& file, const std::function<void(const TextSink&)>& write) {
  require_no_device(file);
  Draft draft(file);
  write([&](std::string_view piece) { draft.add(piece); });
  if (const int reason = draft.keep(); reason != 0) {
    throw UsageError("out = {} (must be in a folder that can be written: {})", file.string(),
                     std::error_code(reason, std::generic_category()).message());
  }
}

void require_own_file(const std::filesystem::path& file, int descriptor) {
  struct stat found {};
  const bool is_there = descriptor < 0 ? lstat(file.c_str(), &found) == 0 : fstat(descriptor, &found) == 0;
  if (!is_there || (S_ISREG(found.st_mode) && found.st_nlink == 1)) return;
  throw UsageError("out = {} (must be a regular file with no other name, or missing)", file.string());
}

std::filesystem::path folder_inside(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path inside = folder / name;
  std::error_code failure;
  std::filesystem::create_directories(inside, failure);
  if (!std::filesystem::is_directory(std::filesystem::symlink_status(inside, failure)))
    throw UsageError("out = {} (must be a folder, and no link to one)", inside.string());
  return inside;
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("OpenSSL refuses to compute SHA-256");
  }
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::string short_digest(std::string_view bytes) { return sha256(bytes).substr(0, 16); }

std::string sha256_of_file(const std::filesystem::path& path) { return sha256(read_file(path)); }

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "signorini-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw UsageError("{} (must be a folder for temporary files that can be written)",
                     std::filesystem::temp_directory_path().string());
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace signorini
