#pragma once
// All that a report is made of: a run's records, and what follows from them.

#include <string>
#include <vector>

#include "harness/plan/suite.hpp"
#include "harness/records/record.hpp"
#include "harness/report/evaluation/contest.hpp"

namespace signorini {

/// A run, evaluated. The same whatever the order of its records.
class Evaluation {
 public:
  /// \param limits  those of the run: its time limit stands for failures in means
  explicit Evaluation(std::vector<Record> records, const Limits& limits = {});
  // What it holds points into its records.
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  /// By scene, method and case.
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  [[nodiscard]] const std::vector<Ladder>& ladders() const { return ladders_; }
  [[nodiscard]] const std::vector<Contest>& contests() const { return contests_; }
  /// Of set-up and first solve [s].
  [[nodiscard]] double time_limit() const { return time_limit_; }

  /// All contestants, sorted.
  [[nodiscard]] const std::vector<std::string>& contestants() const { return contestants_; }
  /// All scenes, sorted.
  [[nodiscard]] const std::vector<std::string>& scenes() const { return scenes_; }
  /// Where a record of this evaluation stands among its records.
  [[nodiscard]] std::size_t place_of(const Record& record) const;
  /// Where a contestant stands among all.
  [[nodiscard]] std::size_t place_of(const std::string& contestant) const;

 private:
  std::vector<Record> records_;
  double time_limit_;
  std::vector<Ladder> ladders_;
  std::vector<Contest> contests_;
  std::vector<std::string> contestants_, scenes_;
};

}  // namespace signorini
