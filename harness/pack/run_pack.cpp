#include "harness/pack/run_pack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/line_file.hpp"
#include "problems/files/kebab_case.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSums = "SHA256SUMS";
constexpr std::string_view kRecords = "records.jsonl";
/// The files of a run's folder that are in every pack.
constexpr std::array<std::string_view, 3> kRunFiles{"manifest.json", "plan.txt", kRecords};
constexpr std::string_view kPlugins = "plugins/", kDescription = ".toml";

/// "HASH  NAME", a line of what `sha256sum` prints.
std::string sum_line(const ArchivedFile& file) {
  return fmt::format("{}  {}\n", sha256(file.text), file.name);
}

/// \throws UsageError
void require_small(std::size_t size, const RunFolder& run) {
  if (size > kLargestPack)
    throw UsageError("dir = {} (must be a run of at most {} MiB to be packed)", run.path.string(),
                     kLargestPack >> 20U);
}

/// The records of a run that count, each as it stands in its file.
std::string records_text(const RunFolder& run) {
  const StoredLines lines(run.path / kRecords);
  std::string text;
  for (const RecordEntry& entry : run.records) {
    text += lines.at(entry.place) + "\n";
    require_small(text.size(), run);
  }
  return text;
}

/// The method that a file of a pack describes; empty where its name is not "plugins/METHOD.toml".
std::string_view described_method(std::string_view name) {
  if (!name.starts_with(kPlugins) || !name.ends_with(kDescription)) return {};
  name.remove_prefix(kPlugins.size());
  name.remove_suffix(kDescription.size());
  return is_lower_kebab_case(name) ? name : std::string_view();
}

/// \throws BadArchive unless the files are those of a pack, each with its hash
void require_pack(std::span<const ArchivedFile> files) {
  std::string sums, expected;
  for (const ArchivedFile& file : files) {
    if (file.name == kSums) {
      sums = file.text;
      continue;
    }
    if (std::ranges::find(kRunFiles, file.name) == kRunFiles.end() && described_method(file.name).empty())
      throw BadArchive("must hold the files of a pack alone");
    expected += sum_line(file);
  }
  for (const std::string_view name : kRunFiles)
    if (std::ranges::find(files, name, &ArchivedFile::name) == files.end())
      throw BadArchive("must hold {}", name);
  if (sums != expected) throw BadArchive("must hold files of the hashes in its SHA256SUMS, in that order");
}

/// The name of a pack's folder: that of the file without ".tar.gz", or without its last extension.
std::string pack_name(const fs::path& file) {
  constexpr std::string_view kUsual = ".tar.gz";
  std::string name = file.filename().string();
  name = name.ends_with(kUsual) ? name.substr(0, name.size() - kUsual.size()) : file.stem().string();
  return name.empty() || name.front() == '.' ? "pack" : name;
}

void unpack(const fs::path& file, const fs::path& folder) {
  try {
    const std::vector<ArchivedFile> files = read_tar(gunzipped(read_file(file, kLargestPack), kLargestPack));
    require_pack(files);
    for (const ArchivedFile& one : files) {
      const std::string_view method = described_method(one.name);
      const fs::path place = method.empty()
                                 ? folder / one.name
                                 : folder_inside(folder, "plugins") / fmt::format("{}.toml", method);
      write_whole(place, one.text);
    }
  } catch (const BadArchive& error) {
    throw UsageError(
        "file = {} (must be the folder of a run, or a file that `signorini pack` "
        "made: it {})",
        file.string(), error.what());
  }
}

}  // namespace

std::string pack_run(const RunFolder& run, std::span<const PluginDescriptionFile> descriptions) {
  std::vector<ArchivedFile> files;
  for (const std::string_view name : kRunFiles) {
    if (name == kRecords)
      files.push_back({std::string(name), records_text(run)});
    else if (fs::exists(run.path / name))
      files.push_back({std::string(name), read_file(run.path / name, kLargestPack)});
    else
      throw UsageError("dir = {} (must hold {}, as run writes it)", run.path.string(), name);
  }
  for (const PluginDescriptionFile& one : descriptions)
    files.push_back({fmt::format("{}{}{}", kPlugins, one.method, kDescription), one.text});
  std::string sums;
  std::size_t size = 0;
  for (const ArchivedFile& file : files) {
    sums += sum_line(file);
    size += file.text.size();
  }
  require_small(size, run);
  files.insert(files.begin(), ArchivedFile{kSums, sums});
  return gzipped(write_tar(files));
}

OpenedRun::OpenedRun(const fs::path& place) : folder_(place) {
  if (!fs::is_regular_file(place)) return;
  unpacked_ = std::make_unique<TemporaryFolder>();
  folder_ = folder_inside(unpacked_->path(), pack_name(place));
  unpack(place, folder_);
}

std::vector<OpenedRun> opened_runs(std::span<const std::string> places) {
  std::vector<OpenedRun> runs;
  for (const std::string& place : places) runs.emplace_back(place);
  return runs;
}

}  // namespace signorini
