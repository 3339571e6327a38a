#pragma once
// Whole files: read, written in one piece, identified by their bytes; a folder for some of them.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace signorini {

/// Largest file that is read whole [bytes].
inline constexpr std::size_t kLargestFile = std::size_t{1} << 32U;

/// All bytes of a regular file. \throws UsageError if it cannot be read, or is no regular file of at most
/// `most` bytes
std::string read_file(const std::filesystem::path& path, std::size_t most = kLargestFile);

/// The first line of a file; empty where there is none.
std::string first_line(const std::filesystem::path& path);

/// Takes a piece of a text.
using TextSink = std::function<void(std::string_view piece)>;

/// Writes text to a file in one piece: a reader sees the old contents or the new. Nothing that stands there
/// is followed or opened: a link is replaced, not what it leads to. \throws UsageError for a device,
/// and, with the system's reason, if the folder cannot be written or is full
void write_whole(const std::filesystem::path& file, std::string_view text);

/// The same of a text that `write` gives piece by piece, which is never in memory as a whole.
void write_whole(const std::filesystem::path& file, const std::function<void(const TextSink&)>& write);

/// For a file that is to be changed where it stands. \throws UsageError where its name is that of a link, a
/// pipe, a device or a folder, or one of several names of a file: of a folder from somebody else that may be
/// any file of the user. \param descriptor  the file as it was opened, which its name may have left since;
/// -1: it is not open yet
void require_own_file(const std::filesystem::path& file, int descriptor = -1);

/// A folder in a folder, made with those above it where they are missing. \throws UsageError where its name
/// is that of a link or of a file
std::filesystem::path folder_inside(const std::filesystem::path& folder, const std::string& name);

/// SHA-256 of the bytes, 64 lower-case hexadecimal digits (FIPS 180-4).
std::string sha256(std::string_view bytes);

/// Its first sixteen digits: what tells texts apart that nobody has made to be alike.
std::string short_digest(std::string_view bytes);

/// SHA-256 of a file's bytes. \throws UsageError if it cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

/// A folder among those for temporary files, of a name that nobody could foretell, which only this user may
/// enter; gone, with all that is in it, when this object is.
class TemporaryFolder {
 public:
  /// \throws UsageError where none can be made
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace signorini
