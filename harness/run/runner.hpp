#pragma once
// Runs cases in child processes and turns whatever happens into records.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/build_info.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/run/isolation.hpp"
#include "harness/run/trial.hpp"

namespace signorini {

/// Applicability and law of one case, or how asking for them failed.
struct Survey {
  bool ok = false;
  std::string reason = {};
  std::optional<RepresentedLaw> law = {};
  std::optional<ChildEnd> failure = {};
};

/// What one solve wants beyond its case.
struct SolveExtras {
  std::shared_ptr<const Trajectory> start = {};  ///< null: as the case says, cold unless it does
  int samples = 0;
  bool timed = true;
  bool certified = true;  ///< look for the orbit behind the answer
};

/// A surveyed case, ready to run. What it points to must outlive it.
struct Job {
  const Case* run = nullptr;
  const Survey* survey = nullptr;
};

/// Told of the record of job `index`, first round and each later one.
using TakeRecord = std::function<void(std::size_t index, Record record)>;

/// Identifies the code behind a method's records.
using CodeVersion = std::function<std::string(std::string_view method)>;

class Runner {
 public:
  explicit Runner(Limits limits, OrbitTools orbits = orbit_tools(), CodeVersion version = code_version);

  /// Asks the methods of several cases of one scene whether they apply and what law they represent.
  [[nodiscard]] std::vector<Survey> survey(const Scene& scene, std::span<const Case* const> cases) const;

  /// Computes the scene's references under all laws met, side by side; they are kept until
  /// `forget_references`, which must be called before another scene's turn.
  void compute_references(const Scene& scene, std::span<const Survey> surveys);
  void forget_references() { references_.clear(); }

  /// The first round of surveyed cases, each in a process of its own, at most `parallel` at the same time:
  /// solves, times one round, measures and certifies. Keeps new orbits behind answers as confirmed. Silent
  /// about those that an interrupt prevented.
  void run_first(const Scene& scene, std::span<const Job> jobs, int parallel, const TakeRecord& take,
                 const SolveExtras& extras = {});

  /// One more round of timing of each job, added to its record. A method that fails this time fails its case.
  /// Silent about those that an interrupt prevented.
  void run_later(const Scene& scene, std::span<const Job> jobs, std::span<const Record> records, int parallel,
                 const TakeRecord& take, const SolveExtras& extras = {}) const;

  /// Rounds of timing that a record still lacks.
  [[nodiscard]] int rounds_missing(const Record& record) const;

  /// Runs one case with all its rounds one after the other. Empty if the parent was interrupted: then there
  /// is no record.
  [[nodiscard]] std::optional<Record> run(const Scene& scene, const Job& job, const SolveExtras& extras = {});

  /// Records shall hold the motions as they are drawn.
  void keep_waveforms() { waveforms_ = true; }

  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] std::string key_of(const Scene& scene, const Case& run) const;

 private:
  /// Why there is no motion to start from for a case that asks for one; empty if there is, or none is asked
  /// for.
  [[nodiscard]] std::string start_obstacle(const Scene& scene, const Job& job) const;
  /// Where the solves of a job begin, if there is no obstacle. Null: cold.
  [[nodiscard]] std::shared_ptr<const Trajectory> start_of(const Scene& scene, const Job& job,
                                                           const SolveExtras& extras) const;
  [[nodiscard]] std::optional<Record> without_run(const Scene& scene, const Job& job) const;
  [[nodiscard]] Trial trial_of(const Scene& scene, const Job& job, const SolveExtras& extras) const;
  [[nodiscard]] Record blank(const Scene& scene, const Case& run, const Survey& survey) const;
  [[nodiscard]] const Reference& reference_for(const Problem& problem, const RepresentedLaw& law) const;
  void keep_confirmed(const Problem& problem, const Record& record);
  [[nodiscard]] IsolationLimits trial_limits() const;

  Limits limits_;
  OrbitTools orbits_;
  CodeVersion code_version_;
  bool waveforms_ = false;
  std::map<std::string, Reference> references_;  // by law
};

/// Status, signal and message of a run whose child ended this way before there was an answer.
void take_failure(const ChildEnd& end, Record& record);

/// Adds what a later round came to: its times, or its failure, which is the case's.
void take_round(const ChildEnd& end, Record& record);

}  // namespace signorini
