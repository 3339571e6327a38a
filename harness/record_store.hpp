#pragma once
// DIR/records.jsonl: one record per line, each written whole and flushed.

#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include "harness/record.hpp"

namespace signorini {

/// Records of a file in order; of several with one key the last. A last line that a kill tore is left out.
/// \throws UsageError if the file cannot be read or another line is no record (file and line named)
std::vector<Record> read_records(const std::filesystem::path& file);

class RecordStore {
 public:
  /// Opens DIR/records.jsonl, making the folder, and keeps other runs out of it. With `resume` what is there
  /// stays, and a torn last line is cut off; otherwise a file that is there is kept as
  /// records.previous.jsonl. \throws UsageError if folder or file cannot be written, another run writes
  /// there, or a whole line is no record
  RecordStore(const std::filesystem::path& folder, bool resume);
  ~RecordStore();
  RecordStore(const RecordStore&) = delete;
  RecordStore& operator=(const RecordStore&) = delete;

  [[nodiscard]] bool contains(const std::string& key) const { return keys_.contains(key); }
  /// Appends by one write and fsync; a key that is there already is not written again.
  /// \throws std::system_error if the disk refuses
  void append(const Record& record);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  std::unordered_set<std::string> keys_;
  int descriptor_ = -1;
  int lock_ = -1;
};

}  // namespace signorini
