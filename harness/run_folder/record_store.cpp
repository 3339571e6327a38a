#include "harness/run_folder/record_store.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "harness/failure.hpp"
#include "harness/isolation/freed_after.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The record of a line. \throws BadRecord
Record parse_line(std::string_view line) {
  const Json json = try_parse_json(line);
  if (!json.is_object()) throw BadRecord("record = unreadable (must be one JSON object)");
  return checked_record(json);
}

/// Opens a file to append to. Cuts off a last line that a kill tore, so that the next record begins a line of
/// its own; takes the records that are left.
Descriptor open_repaired(const fs::path& file, const std::function<void(Record)>& take) {
  Descriptor opened = open_to_append(file);
  const std::uint64_t whole =
      for_each_record(file, [&](Record record, const LinePlace&) { take(std::move(record)); });
  cut_lines(opened, whole, file);
  return opened;
}

std::string line_of(const Record& record) { return json_line(to_json(record)); }

}  // namespace

std::uint64_t for_each_record(const fs::path& file,
                              const std::function<void(Record, const LinePlace&)>& take) {
  const FreedAfter freed(0);
  // The case of a line that holds none counts as one that has not run.
  return read_lines(
      file, [&](const Line& line) { take(parse_line(line.text), line.place); },
      "`run --resume` runs its case again");
}

Record StoredRecords::at(const LinePlace& place) const {
  try {
    return parse_line(lines_.at(place));
  } catch (const BadRecord& error) {
    throw UsageError("record = changed (must not change while it is read: {})", error.what());
  }
}

RecordEntry entry_of(const Record& record, const LinePlace& place, std::size_t ordinal) {
  return {.key = record.key,
          .case_id = record.case_id,
          .method = record.method,
          .status = record.status,
          .elapsed = record.elapsed,
          .place = place,
          .ordinal = ordinal};
}

RecordStore::RecordStore(const fs::path& folder, bool resume)
    : file_(folder / "records.jsonl"), unfinished_file_(folder / "unfinished.jsonl") {
  make_folder(folder);
  std::error_code failure;
  lock_ = lock_folder(folder);
  if (fs::exists(file_) && !resume) fs::rename(file_, folder / "records.previous.jsonl", failure);
  if (!resume) fs::remove(unfinished_file_, failure);
  records_ = open_repaired(file_, [&](const Record& record) { keys_.insert(record.key); });
  kept_ = open_repaired(unfinished_file_, [&](Record record) {
    if (!contains(record.key)) unfinished_.insert_or_assign(record.key, std::move(record));
  });
}

RecordStore::~RecordStore() {
  std::error_code failure;
  if (fs::file_size(unfinished_file_, failure) == 0 && !failure) fs::remove(unfinished_file_, failure);
}

void RecordStore::append(const Record& record) {
  if (!keys_.insert(record.key).second) return;
  append_line(records_, line_of(record), file_);
  keep_lines(records_, file_);
  std::erase_if(unfinished_, [&](const auto& kept) { return kept.second.case_id == record.case_id; });
}

void RecordStore::keep_unfinished(const Record& record) {
  append_line(kept_, line_of(record), unfinished_file_);
}

std::optional<Record> RecordStore::unfinished(const std::string& key) const {
  const auto found = unfinished_.find(key);
  return found == unfinished_.end() ? std::nullopt : std::optional(found->second);
}

void RecordStore::clear_unfinished() {
  cut_lines(kept_, 0, unfinished_file_);
  for (const auto& [key, record] : unfinished_) append_line(kept_, line_of(record), unfinished_file_);
}

}  // namespace signorini
