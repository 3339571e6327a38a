#pragma once
// The runs of one configuration of a method on one scene at all of its resolutions, with their errors.

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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

/// The method and settings that its runs have in common, and the numbers of the first.
const CaseChoice& choice_of(const ResolutionStudy& study);

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

/// The same of several studies, scene by scene.
std::string answers_of(const std::vector<const ResolutionStudy*>& studies);

/// Its configuration, with the law that it represents where that is not the scene's.
std::string label_of(const ResolutionStudy& study);

/// How many of its runs have an error.
std::ptrdiff_t solved_runs(const ResolutionStudy& study);
/// How many of its runs claim to have converged (claim_of).
std::ptrdiff_t claimed_runs(const ResolutionStudy& study);

/// A result with its error.
ScoredRun scored_run(const CaseResult& result);

/// A method with all its settings but one: "fourier-lipschitz[harmonics=40]", and the key of that one.
using Varied = std::pair<std::string, std::string>;

/// Results by the value of the varied option.
struct Variation {
  std::vector<std::string> values = {};  ///< numbers in rising order; words as they ran
  std::map<std::string, std::vector<const CaseResult*>> results = {};
};

/// Every way to single out one setting while another number stands; a number alone is the method's
/// resolution. \param results  outlive what is returned
std::map<Varied, Variation> variations_of(std::span<const CaseResult> results);

/// The number in a value, "1e3" or in units of a scale "1e3x"; nothing in a word.
std::optional<double> number_in(const std::string& value);

/// A cost by which runs are compared: seconds, or a count of work.
struct CostAxis {
  std::string_view name = {};  ///< "time", "pivots"
  std::optional<double> (*cost)(const CaseResult&) = nullptr;
};

/// Median time of set-up and solve [s].
const CostAxis& time_axis();

/// Pivots, iterations, evaluations of right-hand sides, factorisations, unknowns: free of noise. What an
/// iteration is differs between methods: counts compare resolutions of one method, or methods of one kind.
std::span<const CostAxis> work_axes();

/// Errors at which costs are compared [-].
inline constexpr std::array kErrorLevels{1e-1, 1e-2, 1e-3, 1e-6, 1e-9};
/// Those of them at which methods are compared pair by pair, in work, and with plugins.
inline constexpr std::array kHeadlineErrors{kErrorLevels[1], kErrorLevels[3]};

/// Infinite: not reached.
inline constexpr double kNeverReached = std::numeric_limits<double>::infinity();

/// A run on the curve of error against cost.
struct CurvePoint {
  double cost = 0.0;
  const ScoredRun* run = nullptr;
};

/// Those runs of a study that no other beats in both cost and error, by rising cost. Of runs whose errors
/// are bounds only the cheapest is there: below ten error bars nothing is better than anything.
std::vector<CurvePoint> pareto_curve(const ResolutionStudy& study, const CostAxis& axis);

/// The least cost among the runs whose error is at most `error`, and that run; infinite, and none, where no
/// run reached it. Nothing is inter- or extrapolated.
CurvePoint cost_to_error(const ResolutionStudy& study, const CostAxis& axis, double error);

/// The run by which an error is reached: the cheapest in time, of untimed ones the first; null where there is
/// none.
const ScoredRun* reaching_run(const ResolutionStudy& study, double error);

/// On how many scenes an error is reached, and how fast.
struct Reach {
  int scenes = 0;
  int stable = 0, unstable = 0;      ///< of these, by the motion of reaching_run; the rest is not determined
  std::vector<double> seconds = {};  ///< of each scene; infinite where it is not reached or was not timed

  /// Counts the scene of a study.
  void add(const ResolutionStudy& study, double error);
  /// Scenes whose motion is not known to be unstable: what recommendations count.
  [[nodiscard]] int lasting() const { return scenes - unstable; }
  /// Infinite where half of the scenes or more are not reached, or there is none [s].
  [[nodiscard]] double median_seconds() const;
};

}  // namespace signorini
