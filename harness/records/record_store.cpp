#include "harness/records/record_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Contents {
  std::vector<Record> records;
  std::size_t whole_bytes = 0;  // up to the end of the last whole line
};

/// The record of a line. \throws BadRecord
Record parse_line(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) throw BadRecord("record = unreadable (must be one JSON object)");
  return checked_record(json);
}

/// The records of a file. A line that holds none is left out with a warning, and its case counts as one that
/// has not run: the others are worth as much as before.
Contents read_contents(const fs::path& file) {
  Contents contents;
  const std::string text = read_file(file);
  std::size_t begin = 0;
  // Only what ends in a line break was written whole.
  for (std::size_t number = 1; true; ++number) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    try {
      if (end > begin) contents.records.push_back(parse_line(text.substr(begin, end - begin)));
    } catch (const BadRecord& error) {
      fmt::print(stderr, "{}:{}: {}; this line is left out, and `run --resume` runs its case again\n",
                 as_message(file.string()), number, as_message(error.what()));
    }
    begin = end + 1;
  }
  contents.whole_bytes = begin;
  return contents;
}

/// Cuts off a last line that a kill tore, so that the next record begins a line of its own. Returns the
/// records that are left; none where there is no file.
std::vector<Record> repair_file(const fs::path& file) {
  if (!fs::exists(file)) return {};
  Contents contents = read_contents(file);
  std::error_code ignored;  // of a folder that cannot be written opening complains next
  fs::resize_file(file, contents.whole_bytes, ignored);
  return std::move(contents.records);
}

Descriptor open_to_append(const fs::path& file) {
  Descriptor descriptor(open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!descriptor.is_open()) {
    throw UsageError(
        fmt::format("out = {} (must be a folder that can be written)", file.parent_path().string()));
  }
  return descriptor;
}

void write_line(const Descriptor& descriptor, const Record& record, const fs::path& file) {
  const std::string line = json_line(to_json(record)) + "\n";
  // One write to a file opened with O_APPEND: a kill can tear the last line only.
  const ssize_t written = write(descriptor.number(), line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  // A write that stops short sets no error: the disk is full, or a limit of file sizes is reached.
  const std::error_code reason(written < 0 ? errno : ENOSPC, std::generic_category());
  throw UsageError(fmt::format("out = {} (must have room: {}; `run --resume` goes on from here)",
                               file.string(), reason.message()));
}

/// Tries the lock for a moment: children of a run that was killed may hold it for an instant longer.
bool take_lock(int descriptor) {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    // File systems without locks cannot refuse a second run.
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace

Descriptor lock_folder(const fs::path& folder) {
  Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.is_open() && !take_lock(descriptor.number()))
    throw UsageError(fmt::format("out = {} (must not be in use: another run writes there)", folder.string()));
  return descriptor;
}

std::vector<Record> read_records(const fs::path& file) {
  std::vector<Record> records;
  std::unordered_map<std::string, std::size_t> places;
  for (Record& record : read_contents(file).records) {
    const auto place = places.find(record.key);
    if (!record.key.empty() && place != places.end()) {
      records[place->second] = std::move(record);
      continue;
    }
    places[record.key] = records.size();
    records.push_back(std::move(record));
  }
  return records;
}

bool folder_in_use(const fs::path& folder) {
  const Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return descriptor.is_open() && flock(descriptor.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

RecordStore::RecordStore(const fs::path& folder, bool resume)
    : file_(folder / "records.jsonl"), unfinished_file_(folder / "unfinished.jsonl") {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw UsageError(fmt::format("out = {} (must be a folder that can be written: {})", folder.string(),
                                 failure.message()));
  }
  lock_ = lock_folder(folder);
  if (fs::exists(file_) && !resume) fs::rename(file_, folder / "records.previous.jsonl", failure);
  if (!resume) fs::remove(unfinished_file_, failure);
  for (const Record& record : repair_file(file_)) keys_.insert(record.key);
  for (Record& record : repair_file(unfinished_file_)) {
    if (!contains(record.key)) unfinished_.insert_or_assign(record.key, record);
  }
  records_ = open_to_append(file_);
  kept_ = open_to_append(unfinished_file_);
}

RecordStore::~RecordStore() {
  std::error_code failure;
  if (fs::file_size(unfinished_file_, failure) == 0 && !failure) fs::remove(unfinished_file_, failure);
}

void RecordStore::append(const Record& record) {
  if (!keys_.insert(record.key).second) return;
  write_line(records_, record, file_);
  if (fsync(records_.number()) != 0) throw std::system_error(errno, std::generic_category(), file_.string());
  std::erase_if(unfinished_, [&](const auto& kept) { return kept.second.case_id == record.case_id; });
}

void RecordStore::keep_unfinished(const Record& record) { write_line(kept_, record, unfinished_file_); }

std::optional<Record> RecordStore::unfinished(const std::string& key) const {
  const auto found = unfinished_.find(key);
  return found == unfinished_.end() ? std::nullopt : std::optional(found->second);
}

void RecordStore::clear_unfinished() {
  if (ftruncate(kept_.number(), 0) != 0)
    throw std::system_error(errno, std::generic_category(), unfinished_file_.string());
  for (const auto& [key, record] : unfinished_) write_line(kept_, record, unfinished_file_);
}

}  // namespace signorini
