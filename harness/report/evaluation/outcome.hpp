#pragma once
// What became of cases, by which every table counts, ranks and averages.
//
// Solved is one notion in all of them: the harness certifies the answer (claim_of), and the law that the
// method represents is the scene's. Which of the scene's orbits the answer is plays no part. What is
// certified under another law is counted apart, and a problem that a method is given twice counts once.

#include <optional>
#include <vector>

#include "harness/report/evaluation/case_result.hpp"

namespace signorini {

/// claim_of the record.
std::optional<Claim> claim_of(const CaseOutcome& outcome);

/// Whether the case states another problem than its scene: the method represents another law.
bool has_another_law(const CaseOutcome& outcome);

/// Whether the case is solved: certified, under the law of the scene.
bool is_solved(const CaseOutcome& outcome);

/// For each result, whether it states a problem (Record::problem) that the same method with the same settings
/// is given in another one too, which counts for both: one under its scene's law before others, else the
/// first. False of results that do not know their problem.
std::vector<bool> repeated_problems(const std::vector<CaseResult>& results);

/// The error of x, of u where the scene has no contact, but not below ten error bars of the orbit. Whether
/// its orbit certifies the answer is not asked.
Measure bounded_error(const CaseResult& result);

/// bounded_error of a certified answer; empty for all others.
Measure certified_error(const CaseResult& result);

/// The error that levels of accuracy ask of a certified answer (level_error), bounded alike; empty for all
/// others.
Measure certified_level(const CaseResult& result);

/// How many cases ended how.
struct OutcomeCounts {
  int cases = 0, not_applicable = 0, failed = 0, refuted = 0, unproven = 0, certified = 0;
  int same_orbit = 0, other_orbit = 0;  ///< certified, and the orbit reached from rest or another one
  int stable = 0, unstable = 0;         ///< certified, of these orbits; of the rest it is not determined
  int another_law = 0;                  ///< applicable cases of another law than the scene's
  int solved = 0;                       ///< certified cases of the scene's law
  int followed = 0;                     ///< responses with a branch, of which nothing is claimed

  void add(const CaseOutcome& outcome);
  [[nodiscard]] int applicable() const { return cases - not_applicable; }
  /// Applicable cases of the scene's law.
  [[nodiscard]] int own_law() const { return applicable() - another_law; }
  /// Certified cases of another law.
  [[nodiscard]] int solved_under_another_law() const { return certified - solved; }
  /// Claims that are not refuted.
  [[nodiscard]] int converged() const { return certified + unproven; }
  [[nodiscard]] int claims() const { return converged() + refuted; }
};

}  // namespace signorini
