#pragma once
// A run as one file that is sent around: its manifest, its plan and the records that count, with the
// descriptions of plugins that it used, and a hash of each.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harness/files.hpp"
#include "harness/pack/archive.hpp"
#include "harness/run_folder/run_folder.hpp"

namespace signorini {

/// Largest pack, packed or not [bytes]: it is in memory as a whole, and records of a catalogue take 4 MiB.
inline constexpr std::size_t kLargestPack = std::size_t{1} << 28U;

/// The description of a plugin that a run used.
struct PluginDescriptionFile {
  std::string method = {};
  std::string text = {};
};

/// The bytes of a pack, a tar archive in a gzip stream: SHA256SUMS, as sha256sum --check takes it;
/// manifest.json, plan.txt, records.jsonl; and plugins/METHOD.toml. Equal runs give equal bytes. \throws
/// UsageError if a file is unreadable, or the whole is larger than kLargestPack
std::string pack_run(const RunFolder& run, std::span<const PluginDescriptionFile> descriptions = {});

/// A run that is read: the folder that is named, or that of a pack for as long as this object is there.
class OpenedRun {
 public:
  /// A regular file is taken for a pack that anybody may have written, and unpacked into a temporary folder
  /// that bears the name of the file without its extension: only files of the names above, each of the hash
  /// that stands in it. Nothing of it is run or loaded. \throws UsageError, one line, for any other file
  explicit OpenedRun(const std::filesystem::path& place);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] bool was_packed() const { return unpacked_ != nullptr; }

 private:
  std::unique_ptr<TemporaryFolder> unpacked_ = {};
  std::filesystem::path folder_;
};

/// The folders of runs that are read, in their order. Each element must outlive what is read from it.
std::vector<OpenedRun> opened_runs(std::span<const std::string> places);

}  // namespace signorini
