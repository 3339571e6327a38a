#include "harness/run_folder/shards.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "harness/failure.hpp"

namespace signorini {

namespace {

/// The whole text as a positive number; 0 if it is none.
int positive(std::string_view text) {
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc{} && end == text.data() + text.size() && value > 0 ? value : 0;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view view = text;
  Shard shard{.index = 0, .count = 0};
  if (slash != std::string::npos)
    shard = {.index = positive(view.substr(0, slash)), .count = positive(view.substr(slash + 1))};
  if (shard.index < 1 || shard.index > shard.count)
    throw UsageError("shard = {} (must be I/N with 1 <= I <= N)", text);
  return shard;
}

Durations::Durations(std::span<const RecordEntry> records) { add(records); }

void Durations::add(std::span<const RecordEntry> records) {
  for (const RecordEntry& record : records) {
    if (!record.elapsed) continue;
    cases_[record.case_id] = *record.elapsed;
    for (Mean* mean : {&methods_[record.method], &all_}) {
      mean->sum += *record.elapsed;
      ++mean->count;
    }
  }
}

double Durations::of(const std::string& case_id, std::string_view method_name) const {
  if (const auto known = cases_.find(case_id); known != cases_.end()) return known->second;
  const auto method = methods_.find(method_name);
  const Mean& mean = method == methods_.end() ? all_ : method->second;
  return mean.count == 0 ? 1.0 : mean.sum / mean.count;
}

std::vector<int> balance(std::span<const double> seconds, int parts) {
  std::vector<std::size_t> order(seconds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return seconds[a] > seconds[b]; });
  std::vector<double> sums(static_cast<std::size_t>(parts), 0.0);
  std::vector<int> part_of(seconds.size(), 0);
  for (const std::size_t item : order) {
    const auto shortest = std::ranges::min_element(sums);
    *shortest += seconds[item];
    part_of[item] = static_cast<int>(shortest - sums.begin());
  }
  return part_of;
}

Plan take_shard(const Plan& plan, const Shard& shard, const Durations& durations) {
  std::vector<double> seconds(plan.scenes.size(), 0.0);
  for (const Case& planned_case : plan.cases) {
    seconds[planned_case.scene] += durations.of(planned_case.id, planned_case.choice.entry->name);
  }
  const std::vector<int> part_of = balance(seconds, shard.count);
  Plan part;
  std::vector<std::size_t> places(plan.scenes.size(), 0);  // in the part
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    if (part_of[i] != shard.index - 1) continue;
    places[i] = part.scenes.size();
    part.scenes.push_back(plan.scenes[i]);
  }
  for (const Case& planned_case : plan.cases) {  // scene by scene, as the part is
    if (part_of[planned_case.scene] != shard.index - 1) continue;
    part.cases.push_back(planned_case);
    part.cases.back().scene = places[planned_case.scene];
  }
  return part;
}

}  // namespace signorini
