#pragma once
// The records of a run with everything that reports derive from them.

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harness/plan/suite.hpp"
#include "harness/records/record.hpp"
#include "harness/report/evaluation/ranking.hpp"

namespace signorini {

/// Reads a whole record by CaseResult::source.
using RecordReader = std::function<Record(std::size_t source)>;

/// The same whatever the order of the records.
class Evaluation {
 public:
  /// Of records that are in memory.
  /// \param limits  those of the run: its time limit stands for failures in means
  explicit Evaluation(std::vector<Record> records, const Limits& limits = {});
  /// Of results alone; `read` has the record of each.
  Evaluation(CaseResults results, RecordReader read, const Limits& limits = {},
             std::string times_remark = {});
  // Studies and groups point into the results.
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  /// By scene, method and case.
  [[nodiscard]] const std::vector<CaseResult>& results() const { return results_.all; }
  /// Those of a scene of this evaluation.
  [[nodiscard]] std::span<const CaseResult> results_of(const std::string& scene) const;
  /// The whole record of a result of this evaluation; it may have to be read from its file.
  [[nodiscard]] Record record_of(const CaseResult& result) const { return read_(result.source); }
  /// Records of frequency responses by scene, the exact one first, then by arc length before by steps, by
  /// case. They are no results.
  [[nodiscard]] const std::vector<Record>& responses() const { return results_.responses; }
  /// By scene.
  [[nodiscard]] const std::vector<ResolutionStudy>& studies() const { return studies_; }
  /// Those of a scene of this evaluation.
  [[nodiscard]] std::span<const ResolutionStudy> studies_of(const std::string& scene) const;
  [[nodiscard]] const std::vector<RankingGroup>& groups() const { return groups_; }
  /// Time limit of set-up and first solve [s].
  [[nodiscard]] double time_limit() const { return time_limit_; }

  /// What must be said of the times of this run, sentences: why they are not comparable; of runs side by side
  /// whose are left out or multiplied. Empty where they are comparable, as far as is known.
  [[nodiscard]] const std::string& times_remark() const { return times_remark_; }

  /// All configurations, sorted.
  [[nodiscard]] const std::vector<std::string>& configurations() const { return configurations_; }
  /// All scenes, in natural order.
  [[nodiscard]] const std::vector<std::string>& scenes() const { return scenes_; }
  /// Whether a result of this evaluation counts by another one: see `repeated_problems`.
  [[nodiscard]] bool is_repeated(const CaseResult& result) const { return repeated_[place_of(result)]; }
  /// The same of all runs of a study.
  [[nodiscard]] bool is_repeated(const ResolutionStudy& study) const;
  /// Whether rankings take a scene of this evaluation in: it has a contact, and states a problem of its own
  /// to some method.
  [[nodiscard]] bool is_ranked(const std::string& scene) const;
  /// Whether some answer on a scene of this evaluation is certified by an orbit that touches nothing: what
  /// solves such a scene need not know what contact is.
  [[nodiscard]] bool is_contact_free(const std::string& scene) const;
  /// Where a result of this evaluation stands among its results.
  [[nodiscard]] std::size_t place_of(const CaseResult& result) const;
  /// Where a response stands in a report: after all results. \param i  its place in `responses`
  [[nodiscard]] std::size_t place_of_response(std::size_t i) const { return results_.all.size() + i; }
  /// Where a configuration stands among all.
  [[nodiscard]] std::size_t place_of(const std::string& configuration) const;

 private:
  Evaluation(const std::shared_ptr<const std::vector<Record>>& records, const Limits& limits);

  CaseResults results_;
  RecordReader read_;
  double time_limit_;
  std::string times_remark_ = {};
  std::vector<bool> repeated_;  // by result
  std::vector<ResolutionStudy> studies_;
  std::vector<RankingGroup> groups_;
  std::vector<std::string> configurations_, scenes_;
};

/// The evaluation of the records of a folder that count, in memory of some 400 bytes per record: of the
/// records themselves one at a time is in memory. \throws UsageError if a file is unreadable
Evaluation evaluation_of_run(const std::filesystem::path& folder, const Limits& limits);

}  // namespace signorini
