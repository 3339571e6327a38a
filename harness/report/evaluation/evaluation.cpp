#include "harness/report/evaluation/evaluation.hpp"

#include <algorithm>

#include "harness/table.hpp"

namespace signorini {

namespace {

bool before(const Record& a, const Record& b) {
  if (a.scene != b.scene) return natural_less(a.scene, b.scene);
  if (a.method != b.method) return a.method < b.method;
  if (a.case_id != b.case_id) return natural_less(a.case_id, b.case_id);
  return a.key < b.key;
}

std::vector<Record> sorted(std::vector<Record> records) {
  std::stable_sort(records.begin(), records.end(), before);
  return records;
}

}  // namespace

Evaluation::Evaluation(std::vector<Record> records, const Limits& limits)
    : records_(sorted(std::move(records))),
      time_limit_(limits.timeout),
      ladders_(ladders_of(records_)),
      contests_(contests_of(ladders_)) {
  for (const Ladder& ladder : ladders_) {
    contestants_.push_back(ladder.contestant);
    if (scenes_.empty() || scenes_.back() != ladder.scene) scenes_.push_back(ladder.scene);
  }
  std::sort(contestants_.begin(), contestants_.end());
  contestants_.erase(std::unique(contestants_.begin(), contestants_.end()), contestants_.end());
}

std::size_t Evaluation::place_of(const Record& record) const {
  return static_cast<std::size_t>(&record - records_.data());
}

std::size_t Evaluation::place_of(const std::string& contestant) const {
  return static_cast<std::size_t>(std::lower_bound(contestants_.begin(), contestants_.end(), contestant) -
                                  contestants_.begin());
}

}  // namespace signorini
