#pragma once
// What a case may ask of its method in place of one solve of its scene.

#include <functional>

#include "harness/plan/suite.hpp"
#include "harness/records/record.hpp"
#include "harness/run/trial.hpp"

namespace signorini {

/// A question with processes of its own, as a solve has them.
class CaseTask {
 public:
  virtual ~CaseTask() = default;
  /// Processor time that the first answer may take [s].
  [[nodiscard]] virtual double seconds() const = 0;
  /// In the process of the first round: answers and judges, then times one round.
  /// \param record      names scene, method and law
  /// \param stage_done  called with the record after the stages of TrialStage but the last
  virtual void run(Record record, const std::function<void(const Record&)>& stage_done) const = 0;
  /// In the process of a later round: answers once more, for the time.
  [[nodiscard]] virtual RepeatedSolve repeat() const = 0;
  /// In the parent, after the first round: takes out of the record what other cases need of it, and is not to
  /// be kept.
  virtual void release(Record& record) const = 0;
};

}  // namespace signorini
