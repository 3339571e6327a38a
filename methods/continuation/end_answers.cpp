#include "methods/continuation/end_answers.hpp"

#include <fmt/format.h>

#include <utility>

namespace signorini {

std::vector<EndAnswer> end_answers(const ParametrisedScene& scene, const Method& method,
                                   const CurveLimits& limits, std::vector<std::string>& notes) {
  std::vector<EndAnswer> answers;
  for (const double end : {scene.from, scene.to}) {
    Problem problem = scene.at(end);
    Solution solution = method.prepare(problem)->solve({.guess = {}, .deadline = limits.deadline});
    if (solution.verdict == Verdict::converged && solution.trajectory)
      answers.push_back({std::move(problem), std::move(solution.trajectory)});
    else
      notes.push_back(
          fmt::format("no answer of the method at {:.10g} rad/s: {}", problem.frequency, solution.message));
  }
  return answers;
}

}  // namespace signorini
