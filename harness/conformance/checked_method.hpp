#pragma once
// A method on a scene while it is checked, and the checks that every method must pass, alone and on a scene:
// one for each promise of the plugin interface. `signorini check` and the tests of the project call the same
// functions. Each may throw what the method throws.

#include <memory>
#include <optional>

#include "harness/conformance/check_result.hpp"
#include "harness/plan/plan.hpp"
#include "methods/catalogue.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// How a method is run by the checks, and how far two of its answers may differ.
struct CheckSettings {
  Settings resolution = {};  ///< options of the method: a cheap resolution
  int grid = 64;  ///< instants of a period at which answers are compared; the method's own grid if it has one
  double agreement = 1e-8;  ///< of answers to equivalent problems, relative to the largest x and force [-]
  double identity = 1e-9;   ///< of one trajectory with itself at common instants, relative [-]
  double timeout = 10.0;    ///< processor time of one solve [s]
  double patience = 1.0;    ///< allowed from the end of the time budget to the end of the solve [s]
};

/// The ladder of resolutions that the method declares. If it cannot be read or the method refuses it, which
/// check_declaration reports, the method's defaults alone.
std::vector<Settings> usable_ladder(const MethodEntry& entry);

/// Settings from what a method declares: the first step of its ladder; `samples` fixed where the method would
/// choose it, because a delay by whole steps needs a known grid; and an agreement of its `tolerance` times
/// the amplification by the slowest decay of any scene.
CheckSettings check_settings_of(const MethodEntry& entry);

/// The value of an option; null if there is none of this name.
const OptionValue* value_of(const std::vector<OptionEcho>& options, std::string_view name);

/// The value of a number, whole or not; empty if it is none.
std::optional<double> as_number(const OptionValue& value);

/// The answer; of a command that was stopped at its time limit a solution that has not converged, and says
/// so. \throws what `solve` throws otherwise
Solution solve_or_stopped(PreparedMethod& prepared, const Start& start);

/// A method on a scene, and its answer from a cold start, computed when it is first asked for.
class CheckedMethod {
 public:
  /// \throws InvalidOption if the method refuses the settings
  CheckedMethod(const MethodEntry& entry, Problem problem, CheckSettings settings);

  [[nodiscard]] const MethodEntry& entry() const { return entry_; }
  [[nodiscard]] const Method& method() const { return *method_; }
  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const CheckSettings& settings() const { return settings_; }
  [[nodiscard]] const Support& support() const { return support_; }
  /// The answer on the scene from a cold start. Requires support().ok.
  [[nodiscard]] const Solution& answer() const;
  /// The answer on any problem, within settings().timeout.
  [[nodiscard]] Solution solve(const Problem& problem, std::shared_ptr<const Trajectory> guess = {}) const;
  /// The same method and scene with another resolution. \throws InvalidOption
  [[nodiscard]] CheckedMethod with(const Settings& resolution) const;

 private:
  const MethodEntry& entry_;
  Problem problem_;
  CheckSettings settings_;
  std::unique_ptr<Method> method_;
  Support support_;
  mutable std::optional<Solution> answer_;
};

/// The result of a check that needs the method to apply, if it does not.
std::optional<CheckResult> unless_supported(const CheckedMethod& checked);

/// The result of a check that needs a converged trajectory, if there is none. That the method should have
/// converged is the business of check_convergence.
std::optional<CheckResult> unless_answered(const CheckedMethod& checked);

/// Scale of displacements: the largest |x| and |gap| [m].
double displacement_scale(const Problem& problem, const Samples& samples);

/// Scale of forces: the largest term of the load [N].
double load_scale(const Problem& problem);

/// The method declares name, title, laws and ladder; it accepts the settings of the ladder; it has the
/// options that all methods have; and every option has a unit and a meaning.
CheckResult check_declaration(const MethodEntry& entry);
/// Options are echoed as they were set: the settings of the ladder, and every default that is a word.
CheckResult check_echo(const MethodEntry& entry);
/// Unknown options and impossible values are refused with a message of one line that names the option.
CheckResult check_refusals(const MethodEntry& entry);

/// A refusal of the scene has a reason. On a scene that it accepts, the method represents a law that fits the
/// scene, and can be set up.
CheckResult check_applicability(const CheckedMethod& checked);
/// The answer has a message, matrices of the right size, a period that is a whole number of periods of the
/// load, finite values, forces <= 0, impulses in the order of time, and equal values at common instants of
/// two samplings.
CheckResult check_trajectory(const CheckedMethod& checked);
/// Two solves of one set-up and a solve of a second set-up give the same bits.
CheckResult check_determinism(const CheckedMethod& checked);
/// A solve whose deadline has passed returns within CheckSettings::patience, with a sound answer or none.
CheckResult check_time_budget(const CheckedMethod& checked);
/// f and g times a factor: x and lambda times the same factor.
CheckResult check_load_scaling(const CheckedMethod& checked);
/// M, D, K, f and the stiffness of a spring stop times a factor: lambda times the same factor, the same x.
CheckResult check_structure_scaling(const CheckedMethod& checked);
/// Another unit of time: the same x and lambda at the same part of the period.
CheckResult check_time_scaling(const CheckedMethod& checked);
/// Coordinates in reverse order: the same answer.
CheckResult check_numbering(const CheckedMethod& checked);
/// A load that is delayed by whole steps of the grid: the answer is delayed by as much.
CheckResult check_time_shift(const CheckedMethod& checked);
/// The origin of x ten times the motion away: the same motion and force, and harness errors of x that agree
/// to 1 %.
CheckResult check_origin_shift(const CheckedMethod& checked);
/// With all stops out of reach the contact force is zero and x is the linear response: to rounding, or with
/// an error that decays along the ladder.
CheckResult check_contact_free(const CheckedMethod& checked);
/// The points of its curve are its solves. Over 2 % of the frequency, from the scene's own on: the cold
/// answers at both ends, and in the middle the cold one or that from an end, are points of a branch, to ten
/// times CheckSettings::agreement of x. A curve that is unfinished is remarked upon.
CheckResult check_curve(const CheckedMethod& checked);

}  // namespace signorini
