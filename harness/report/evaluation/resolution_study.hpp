#pragma once
// The runs of one configuration of a method on one scene at all of its resolutions, with their errors.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/evaluation/case_result.hpp"

namespace signorini {

/// One run of a study with its error.
struct ScoredRun {
  const CaseResult* result = nullptr;
  Measure error = {};    ///< certified_level: what levels of accuracy ask for
  bool bounded = false;  ///< below ten error bars: never ranked by its error
};

/// Whether a configuration is ranked on a scene.
enum class Eligibility {
  ranked,  ///< it solves the problem that the scene states
  /// It solves another problem than the scene states, or would if it applied: shown apart, never ranked.
  another_law,
  not_applicable  ///< at none of its resolutions; ranked as unsolved where it applies to other scenes
};

/// The names in tables.
template <>
struct EnumNames<Eligibility> {
  /// In order.
  static constexpr std::array<std::string_view, 3> values{"competes", "another-law", "not-applicable"};
};

/// The runs of one configuration on one scene.
struct ResolutionStudy {
  std::string scene = {}, configuration = {};
  Eligibility eligibility = Eligibility::ranked;
  std::vector<ScoredRun> runs = {};  ///< in the order of the results
};

/// Studies of all results, by scene and configuration in the order of their first result. They point into
/// `results`.
std::vector<ResolutionStudy> resolution_studies(const std::vector<CaseResult>& results);

/// Whether the equations of `a` are those of `b`: its method says so (CaseChoice::same_equations_as) and
/// every option that both have has the same value.
bool has_equations_of(const CaseChoice& a, const CaseChoice& b);

/// The digests of a study's answers in alphabetical order, each with a blank behind it, equal where two
/// configurations give the same answers to the last bit. Empty where there is no answer, or one without a
/// digest.
std::string answers_of(const ResolutionStudy& study);

/// Its configuration, with the law that it represents where that is not the scene's.
std::string label_of(const ResolutionStudy& study);

/// How many of its runs have an error.
std::ptrdiff_t solved_runs(const ResolutionStudy& study);

/// A result with its error.
ScoredRun scored_run(const CaseResult& result);

}  // namespace signorini
