#pragma once
// A folder for files that nobody needs for long.

#include <filesystem>

namespace signorini {

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
