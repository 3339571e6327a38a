#pragma once
// The records of a file, all at once.

#include <filesystem>
#include <unordered_map>
#include <utility>
#include <vector>

#include "harness/run_folder/record_store.hpp"

namespace signorini {

/// In order; of several with one key the last. \throws UsageError if the file cannot be read
inline std::vector<Record> read_records(const std::filesystem::path& file) {
  std::vector<Record> records;
  std::unordered_map<std::string, std::size_t> places;
  for_each_record(file, [&](Record record, const LinePlace&) {
    const auto place = places.find(record.key);
    if (!record.key.empty() && place != places.end()) {
      records[place->second] = std::move(record);
      return;
    }
    places[record.key] = records.size();
    records.push_back(std::move(record));
  });
  return records;
}

}  // namespace signorini
