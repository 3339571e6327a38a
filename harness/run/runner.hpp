#pragma once
// Runs cases in child processes and turns whatever happens into records.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/build_info.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/judge/measures/waveform.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/run/applicability.hpp"
#include "harness/run/references.hpp"
#include "harness/run/trial.hpp"

namespace signorini {

/// What a case may ask of its method in place of one solve of its scene, with processes of its own as a solve
/// has them.
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

/// A case whose method has been asked whether it applies. The case must outlive it.
struct Job {
  const Case* planned_case = nullptr;
  Applicability method = {};
  std::shared_ptr<const CaseTask> task = {};  ///< of a case that is no solve of its scene; else null
};

/// Called with the record of job `index` after its first round and after each later one.
using TakeRecord = std::function<void(std::size_t index, Record record)>;

/// Identifies the code behind a method's records.
using CodeVersion = std::function<std::string(std::string_view method)>;

/// Solves of one case that follow each other, each from what is known of those before, of scenes that differ
/// in the frequency of the load alone. A process that solves several of them has a copy, which goes on as the
/// one here does.
class SolveSeries {
 public:
  virtual ~SolveSeries() = default;
  /// Of the solve that is next.
  [[nodiscard]] virtual const Scene& scene() const = 0;
  /// Where that begins; null: cold.
  [[nodiscard]] virtual std::shared_ptr<const Trajectory> start() const = 0;
  /// Goes on to the one after it. \param record  of that solve  \return whether there is one
  virtual bool go_on(const Record& record) = 0;
};

class Runner {
 public:
  explicit Runner(Limits limits, OrbitTools orbits = orbit_tools(), CodeVersion version = code_version);

  /// Asks the methods of several cases of one scene whether they apply and what law they represent. \return
  /// one job for each case in their order; fewer after an interrupt
  [[nodiscard]] std::vector<Job> make_jobs(const Scene& scene, std::span<const Case* const> cases) const;
  [[nodiscard]] std::vector<Job> make_jobs(const Scene& scene, const std::vector<Case>& cases) const;

  /// Computes the scene's references under all laws of the jobs. They are kept until `forget_references`,
  /// which must be called before another scene's turn. Where several answers are to be judged on a structure
  /// too large for a closed form, the judge's space of it is made here, for their processes to inherit.
  void compute_references(const Scene& scene, std::span<const Job> jobs);
  void forget_references() { references_.clear(); }

  /// The first round of each job in a process of its own, at most `parallel` at the same time: solves, times
  /// one round, measures and certifies, or does its task. Keeps new orbits behind answers as confirmed. No
  /// record of a job that an interrupt prevented.
  /// \param jobs  solves, or tasks of one limit of time
  void run_first(const Scene& scene, std::span<const Job> jobs, int parallel, const TakeRecord& take,
                 const SolveExtras& extras = {});

  /// One more round of timing of each job, added to its record. A method that fails this time fails its case.
  /// No record of a job that an interrupt prevented.
  void run_later(const Scene& scene, std::span<const Job> jobs, std::span<const Record> records, int parallel,
                 const TakeRecord& take, const SolveExtras& extras = {}) const;

  /// Rounds of timing that a record still lacks: signorini::rounds_missing of as many as its first round
  /// allows, `least` at the least, and `more`.
  [[nodiscard]] int rounds_missing(const Record& record, int more, int least = 1) const;

  /// Runs one case with all its rounds one after the other. Empty after an interrupt: then there is no
  /// record.
  [[nodiscard]] std::optional<Record> run(const Scene& scene, const Job& job, const SolveExtras& extras = {});

  /// The next solve of a series, and in the same process those after it as far as what the method has set up
  /// serves them (`PreparedMethod::take_frequency`), each as the first round of its case; key and digest are
  /// those of the first. A process that ends early fails the solve under way.
  /// \param take  called with the record of each solve before the series goes on
  /// \return whether another solve is to come; not after an interrupt
  bool run_series(const Job& job, SolveSeries& series, const std::function<void(const Record&)>& take,
                  const SolveExtras& extras = {});

  /// Records shall hold the motions as they are drawn, to this share of each signal's range.
  void keep_waveforms(double tolerance = kKeptTolerance) { waveforms_ = tolerance; }

  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] std::string key_of(const Scene& scene, const Case& planned_case) const;

 private:
  /// Where the solves of a job begin: `extras.start`, or what the case says.
  [[nodiscard]] StartPoint start_of(const Scene& scene, const Job& job, const SolveExtras& extras) const;
  /// The record of a job that cannot be run.
  [[nodiscard]] std::optional<Record> without_run(const Scene& scene, const Job& job,
                                                  const StartPoint& start) const;
  /// Rounds of timing that are planned for a record with a first one.
  [[nodiscard]] int planned_rounds(const Record& record) const;
  [[nodiscard]] Trial trial_of(const Scene& scene, const Job& job, const StartPoint& start,
                               const SolveExtras& extras) const;
  /// The record of a job before anything has been run.
  [[nodiscard]] Record blank(const Scene& scene, const Job& job) const;

  Limits limits_;
  OrbitTools orbits_;
  CodeVersion code_version_;
  std::optional<double> waveforms_ = {};
  References references_;
};

/// Sixteen hexadecimal digits, equal where M, D, K, load, contacts, period and the law that is represented
/// are equal to the last bit, whatever the scene is called and whatever its own law is. The matrices enter by
/// their products with one fixed vector, so that a million coordinates cost milliseconds.
std::string problem_digest(const Problem& problem, const RepresentedLaw& law);

}  // namespace signorini
