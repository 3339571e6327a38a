#pragma once
// Files of lines in a folder that one process writes: each line by one write, so that a kill tears the last
// one only.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "harness/isolation/child_process.hpp"

namespace signorini {

/// Where a line stands in its file.
struct LinePlace {
  std::uint64_t begin = 0;  ///< [bytes]
  std::uint64_t size = 0;   ///< without its break [bytes]
};

/// A line, and where it stands.
struct Line {
  std::string_view text = {};
  LinePlace place = {};
};

/// Calls `take` with each line that was written whole and is not empty, in order, in memory of a few lines
/// whatever the size of the file. A last line without its break was torn, and is left out. So is, with a
/// warning on stderr that names file and line, one that `take` refuses with a BadRecord, or that is longer
/// than kLongestLine: the others are worth as much as before.
///
/// \param remedy  how what such a line held is had again, a clause for the warning
/// \return bytes up to the end of the last whole line. \throws UsageError if the file cannot be read
std::uint64_t read_lines(const std::filesystem::path& file, const std::function<void(const Line&)>& take,
                         std::string_view remedy);

/// Lines of a file by their places.
class StoredLines {
 public:
  /// \throws UsageError if the file cannot be read
  explicit StoredLines(const std::filesystem::path& file);
  /// \throws UsageError if the file has changed so that there is no such line
  [[nodiscard]] std::string at(const LinePlace& place) const;

 private:
  std::filesystem::path file_;
  Descriptor descriptor_;
};

/// \throws UsageError if the file cannot be written
Descriptor open_to_append(const std::filesystem::path& file);

/// Appends a line by one write. \throws UsageError if there is no room
void append_line(const Descriptor& descriptor, const std::string& line, const std::filesystem::path& file);

/// Returns once the disk has what was appended. \throws UsageError if it refuses
void keep_lines(const Descriptor& descriptor, const std::filesystem::path& file);

/// Leaves the first `size` bytes. \throws UsageError if the disk refuses
void cut_lines(const Descriptor& descriptor, std::uint64_t size, const std::filesystem::path& file);

/// Makes a folder for results. \throws UsageError if it cannot be made
void make_folder(const std::filesystem::path& folder);

/// Keeps others out of a folder as long as it is open. \throws UsageError if another process writes there
Descriptor lock_folder(const std::filesystem::path& folder);
/// True while a process that locked the folder writes there.
bool folder_in_use(const std::filesystem::path& folder);

}  // namespace signorini
