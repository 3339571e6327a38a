#pragma once
// What every method of the catalogue must pass, on its own and on a scene. One entry per promise of the
// plugin interface; the same functions are called by `signorini check` and by the tests.

#include <span>
#include <string_view>

#include "harness/conformance/finding.hpp"
#include "harness/conformance/subject.hpp"

namespace signorini {

/// A promise of the method itself. `examine` may throw what the method throws.
struct MethodCheck {
  std::string_view name;     ///< "declaration"
  std::string_view promise;  ///< what is asked, as a sentence about "it"
  CheckResult (*examine)(const MethodEntry& entry);
};

/// A promise about a method on a scene.
struct SceneCheck {
  std::string_view name;
  std::string_view promise;
  CheckResult (*examine)(const Subject& subject);
};

/// Name, title, laws and ladder are there, the ladder's settings are accepted, and the options that all
/// methods have are among its own, each with unit and meaning.
CheckResult check_declaration(const MethodEntry& entry);
/// What is set is what is echoed: numbers of the ladder, and every default that is a word.
CheckResult check_echo(const MethodEntry& entry);
/// Unknown options and values that cannot be are refused in one line that names them.
CheckResult check_refusals(const MethodEntry& entry);

/// A refusal has its reason; a scene that is accepted has a law that fits it, and can be set up.
CheckResult check_applicability(const Subject& subject);
/// The answer has a message, sizes, a period that fits the load, finite values, forces that never pull,
/// ordered impulses, and the same values at common instants however it is sampled.
CheckResult check_trajectory(const Subject& subject);
/// Two solves of one set-up and a third of another give the same bits.
CheckResult check_determinism(const Subject& subject);
/// With no time left it ends within Terms::patience, by itself and with a sound answer or none.
CheckResult check_time_budget(const Subject& subject);
/// f and g times a factor multiply x and lambda.
CheckResult check_load_scaling(const Subject& subject);
/// M, D, K, f and a spring stop times a factor multiply lambda and leave x.
CheckResult check_structure_scaling(const Subject& subject);
/// Another unit of time changes nothing but velocities and impulses.
CheckResult check_time_scaling(const Subject& subject);
/// Coordinates numbered backwards change nothing.
CheckResult check_numbering(const Subject& subject);
/// A load that comes later by whole steps of the grid moves the answer by as much.
CheckResult check_time_shift(const Subject& subject);
/// With the stops out of reach there is no force, and x is the linear response: exactly, or with an error
/// that falls along the ladder.
CheckResult check_contact_free(const Subject& subject);

std::span<const MethodCheck> method_checks();
std::span<const SceneCheck> scene_checks();

}  // namespace signorini
