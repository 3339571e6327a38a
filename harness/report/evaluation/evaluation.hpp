#pragma once
// The records of a run with everything that reports derive from them.

#include <string>
#include <vector>

#include "harness/plan/suite.hpp"
#include "harness/records/record.hpp"
#include "harness/report/evaluation/ranking.hpp"

namespace signorini {

/// The same whatever the order of the records.
class Evaluation {
 public:
  /// \param limits  those of the run: its time limit stands for failures in means
  explicit Evaluation(std::vector<Record> records, const Limits& limits = {});
  // Studies and groups point into the records.
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  /// By scene, method and case.
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  [[nodiscard]] const std::vector<ResolutionStudy>& studies() const { return studies_; }
  [[nodiscard]] const std::vector<RankingGroup>& groups() const { return groups_; }
  /// Time limit of set-up and first solve [s].
  [[nodiscard]] double time_limit() const { return time_limit_; }

  /// All configurations, sorted.
  [[nodiscard]] const std::vector<std::string>& configurations() const { return configurations_; }
  /// All scenes, sorted.
  [[nodiscard]] const std::vector<std::string>& scenes() const { return scenes_; }
  /// Whether a record of this evaluation counts by another one: see `repeated_problems`.
  [[nodiscard]] bool is_repeated(const Record& record) const { return repeated_[place_of(record)]; }
  /// The same of all runs of a study.
  [[nodiscard]] bool is_repeated(const ResolutionStudy& study) const;
  /// Where a record of this evaluation stands among its records.
  [[nodiscard]] std::size_t place_of(const Record& record) const;
  /// Where a configuration stands among all.
  [[nodiscard]] std::size_t place_of(const std::string& configuration) const;

 private:
  std::vector<Record> records_;
  double time_limit_;
  std::vector<bool> repeated_;  // by record
  std::vector<ResolutionStudy> studies_;
  std::vector<RankingGroup> groups_;
  std::vector<std::string> configurations_, scenes_;
};

}  // namespace signorini
