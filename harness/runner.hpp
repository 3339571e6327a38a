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
#include "harness/exact_certificate.hpp"
#include "harness/isolation.hpp"
#include "harness/plan.hpp"
#include "harness/record.hpp"
#include "harness/reference.hpp"

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
  std::shared_ptr<const Trajectory> start = {};  ///< null: cold
  int samples = 0;
  bool timed = true;
};

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

  /// Runs one surveyed case, and keeps a new orbit behind its answer as confirmed. Empty if the parent was
  /// interrupted: then there is no record.
  [[nodiscard]] std::optional<Record> run(const Scene& scene, const Case& run, const Survey& survey,
                                          const SolveExtras& extras = {});

  /// Records shall hold the motions as they are drawn.
  void keep_waveforms() { waveforms_ = true; }

  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] std::string key_of(const Scene& scene, const Case& run) const;

 private:
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

}  // namespace signorini
