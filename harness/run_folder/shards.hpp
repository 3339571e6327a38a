#pragma once
// A plan cut into parts of about equal length, all cases of one scene in one part.

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/run_folder/record_store.hpp"

namespace signorini {

/// Part `index` of `count`, from 1.
struct Shard {
  int index = 1;
  int count = 1;
};

/// Reads "I/N". \throws UsageError unless 1 <= I <= N
Shard parse_shard(const std::string& text);

/// Expected wall times of cases [s], from records of cases that have run.
class Durations {
 public:
  Durations() = default;
  explicit Durations(std::span<const RecordEntry> records);

  /// Of several records of a case the last that was added counts.
  void add(std::span<const RecordEntry> records);

  /// The case's own time if it is known, else the mean of its method, else that of all, else one second.
  [[nodiscard]] double of(const std::string& case_id, std::string_view method) const;

 private:
  struct Mean {
    double sum = 0.0;
    int count = 0;
  };
  std::map<std::string, double> cases_;
  std::map<std::string, Mean, std::less<>> methods_;
  Mean all_;
};

/// The part that each item goes to, from 0: the longest first, each to the part that is the shortest so far
/// (Graham, SIAM Journal on Applied Mathematics 17(2):416-429, 1969); at most 4/3 of the best.
std::vector<int> balance(std::span<const double> seconds, int parts);

/// Cases and scenes of one part, in the order of the plan; empty where there are fewer scenes than parts.
Plan take_shard(const Plan& plan, const Shard& shard, const Durations& durations);

}  // namespace signorini
