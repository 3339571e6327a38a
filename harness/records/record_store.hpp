#pragma once
// DIR/records.jsonl: one record per line, each written whole and flushed. Beside it, while a run is under
// way, DIR/unfinished.jsonl: records that lack rounds of timing, the last of a key counts.

#include <filesystem>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "harness/records/line_file.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// Records of a file in order; of several with one key the last. A last line that a kill tore is left out,
/// and so is, with a warning on stderr that names file and line, one that is no record. \throws UsageError if
/// the file cannot be read
std::vector<Record> read_records(const std::filesystem::path& file);

class RecordStore {
 public:
  /// Opens DIR/records.jsonl, making the folder, and keeps other runs out of it. With `resume` what is there
  /// stays, and a torn last line is cut off; otherwise a file that is there is kept as
  /// records.previous.jsonl. \throws UsageError if folder or file cannot be written, or another run writes
  /// there
  RecordStore(const std::filesystem::path& folder, bool resume);
  ~RecordStore();

  [[nodiscard]] bool contains(const std::string& key) const { return keys_.contains(key); }
  /// Appends by one write and fsync; a key that is there already is not written again.
  /// \throws UsageError if there is no room, std::system_error if the disk refuses otherwise
  void append(const Record& record);

  /// Keeps what is known of a case whose rounds are not complete, for a run that resumes this one.
  /// \throws UsageError if there is no room
  void keep_unfinished(const Record& record);
  /// What was kept of a case and is not complete; empty if nothing was.
  [[nodiscard]] std::optional<Record> unfinished(const std::string& key) const;
  /// Forgets what was kept of this run's cases, whose records are complete; of cases that it does not run the
  /// rounds stay for a run that does. \throws std::system_error if the disk refuses
  void clear_unfinished();

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_, unfinished_file_;
  std::unordered_set<std::string> keys_;
  std::unordered_map<std::string, Record> unfinished_;
  Descriptor lock_, records_, kept_;
};

}  // namespace signorini
