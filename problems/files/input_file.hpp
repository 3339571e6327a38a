#pragma once
// Files that somebody else wrote: read whole, or refused before they can hang or exhaust the program.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace signorini {

/// A file that is not read. what() is "found (requirement)".
class UnreadableFile : public std::runtime_error {
 public:
  /// `found` says what is there instead of the `required`.
  UnreadableFile(std::string_view found, std::string_view required);
  std::string found;        ///< "missing", "a folder", "no regular file", "more than 16 MiB", "unreadable"
  std::string requirement;  ///< "must exist" and so on
};

/// All bytes of a regular file of at most `most` bytes. A pipe, a device or a socket is refused without being
/// read, and without waiting for a writer; a file that is larger than it says, as those of /proc may be, is
/// refused once `most` bytes have been read. \throws UnreadableFile
std::string read_input_file(const std::filesystem::path& path, std::size_t most);

}  // namespace signorini
