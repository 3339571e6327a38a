#pragma once
// Named texts as one file: an archive of regular files as `tar` knows it (ustar, POSIX.1-1988) in a gzip
// stream (RFC 1952), so that it can be unpacked without this program.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/failure.hpp"

namespace signorini {

/// What is no archive, or none that is read; what() is what it must be, a clause.
class BadArchive : public OneLineError {
 public:
  using OneLineError::OneLineError;
};

/// A file of an archive.
struct ArchivedFile {
  std::string name = {};  ///< with folders before it, parted by "/"
  std::string text = {};
};

/// The tar archive. Equal files in equal order give equal bytes: no date, owner or machine is in it. Requires
/// names of 1 to 99 bytes and texts below 1 GiB.
std::string write_tar(std::span<const ArchivedFile> files);

/// The files of a tar archive that anybody may have written, in order; nothing is written. Names are as they
/// stand there: whoever makes files of them has to look at them. \throws BadArchive for one that is damaged,
/// holds anything but regular files with names that write_tar takes, or a name twice
std::vector<ArchivedFile> read_tar(std::string_view archive);

/// The bytes in a gzip stream, the same for the same bytes. Requires less than 4 GiB.
std::string gzipped(std::string_view bytes);

/// What is in a gzip stream that anybody may have written, of at most `most` bytes, in memory of little more.
/// \throws BadArchive for one that is damaged or holds more, and for bytes behind it
std::string gunzipped(std::string_view bytes, std::size_t most);

}  // namespace signorini
