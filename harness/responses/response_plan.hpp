#pragma once
// The cases of a suite: motions of its scenes, and its responses.

#include <span>

#include "harness/plan/plan.hpp"

namespace signorini {

/// What a suite asks for: make_plan of its scenes, if it has any, then its responses. Of each response the
/// exact one is a case, and the methods that the suite lists are, by arc length where they have curves of
/// their own, and its `by_steps` by steps. Method names in the filter that the suite does not list take their
/// own ladders. \throws NothingMatched, UsageError, SceneError, InvalidOption
Plan plan_of_suite(const Suite& suite, const Narrowing& narrowing, std::span<const MethodEntry> catalogue,
                   std::span<const SceneSource> sources);

/// A method's case of a response. \throws InvalidOption
Case response_case(const Scene& scene, std::size_t index, MethodChoice choice,
                   const ResponseQuestion& question);
/// The case of the exact response. \param question  its `way` does not count
Case exact_case(const Scene& scene, std::size_t index, ResponseQuestion question);

}  // namespace signorini
