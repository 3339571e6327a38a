#pragma once
// The checks that every method must pass, alone and on a scene: one for each promise of the plugin interface.
// `signorini check` and the tests of the project call the same functions. Each may throw what the method
// throws.

#include "harness/conformance/check_result.hpp"
#include "harness/conformance/checked_method.hpp"

namespace signorini {

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
