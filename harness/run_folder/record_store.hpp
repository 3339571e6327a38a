#pragma once
// DIR/records.jsonl: one record per line, each written whole and flushed. Beside it, while a run is under
// way, DIR/unfinished.jsonl: records that lack rounds of timing, the last of a key counts.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "harness/records/line_file.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// Calls `take` with each record of a file and the place of its line, in order, one in memory at a time. A
/// last line that a kill tore is left out, and so is, with a warning on stderr that names file and line, one
/// that is no record. \return bytes up to the end of the last whole line. \throws UsageError if the file
/// cannot be read
std::uint64_t for_each_record(const std::filesystem::path& file,
                              const std::function<void(Record, const LinePlace&)>& take);

/// Records of a file by the places of their lines.
class StoredRecords {
 public:
  /// \throws UsageError if the file cannot be read
  explicit StoredRecords(const std::filesystem::path& file) : lines_(file) {}
  /// \throws UsageError if the file has changed so that there is no such record
  [[nodiscard]] Record at(const LinePlace& place) const;

 private:
  StoredLines lines_;
};

/// What is kept in memory of a record of a folder: whether it counts, what became of its case and how long
/// that took, and where the rest of it stands.
struct RecordEntry {
  std::string key = {};
  std::string case_id = {};
  std::string method = {};
  Status status = Status::not_converged;
  Measure elapsed = {};     ///< Record::elapsed [s]
  LinePlace place = {};     ///< of its line in records.jsonl
  std::size_t ordinal = 0;  ///< among all records of the file
  std::size_t part = 0;     ///< of runs that are merged: which of them holds it
};

/// The entry of a record. \param place, ordinal  of its line
RecordEntry entry_of(const Record& record, const LinePlace& place = {}, std::size_t ordinal = 0);

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
  /// \throws UsageError if there is no room, or the disk refuses otherwise
  void append(const Record& record);

  /// Keeps what is known of a case whose rounds are not complete, for a run that resumes this one.
  /// \throws UsageError if there is no room
  void keep_unfinished(const Record& record);
  /// What was kept of a case and is not complete; empty if nothing was.
  [[nodiscard]] std::optional<Record> unfinished(const std::string& key) const;
  /// Forgets what was kept of this run's cases, whose records are complete; of cases that it does not run the
  /// rounds stay for a run that does. \throws UsageError if the disk refuses
  void clear_unfinished();

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_, unfinished_file_;
  std::unordered_set<std::string> keys_;
  std::unordered_map<std::string, Record> unfinished_;
  Descriptor lock_, records_, kept_;
};

}  // namespace signorini
