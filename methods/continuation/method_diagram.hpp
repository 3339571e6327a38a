#pragma once
// All branches of a method that hang together with its answers at both ends of an interval of frequencies.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/continuation/curve_queue.hpp"
#include "methods/continuation/curve_tracer.hpp"

namespace signorini {

/// An answer of a method at one end of an interval of frequencies.
struct EndAnswer {
  Problem problem;                                ///< the scene there
  std::shared_ptr<const Trajectory> motion = {};  ///< that solves it
};

/// Those from cold starts, at scene.from and scene.to. Where there is none `notes` says why.
/// \throws std::runtime_error if the structure cannot be factorised
inline std::vector<EndAnswer> end_answers(const ParametrisedScene& scene, const Method& method,
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

/// Follows the contact-free motion where nothing touches and the method's own answer, from both ends into the
/// interval, then what begins on these branches. What lies on a branch already followed is left out. Start:
/// as of CurveTracer.
template <class Start>
class MethodDiagram : protected FollowedCurves {
 public:
  /// The diagram of a scene over the frequency of its load. \param answers  at its ends
  BranchDiagram run(const ParametrisedScene& scene, const std::vector<EndAnswer>& answers) {
    for (const double frequency : {scene.from, scene.to})
      add(contact_free(frequency), "contact-free motion", frequency);
    for (const EndAnswer& answer : answers) {
      const double frequency = answer.problem.frequency;
      if (!add(on_curve(answer), "answer of the method", frequency))
        queue_.note(fmt::format("the answer of the method at {:.10g} rad/s is not on a curve", frequency));
    }
    while (auto start = queue_.next()) {
      if (is_known(*start)) continue;
      if (queue_.is_full()) break;
      TracedBranch<Start> traced = trace(*start);
      for (Start& other : traced.others) queue_.add(std::move(other));
      if (!traced.rejected.empty()) {
        queue_.note(fmt::format("{}: {}", start->origin, traced.rejected));
        continue;
      }
      queue_.keep(std::move(traced.branch));
      FollowedCurves::add(start->periods(), std::move(traced.points));
    }
    BranchDiagram diagram = queue_.template finish<BranchDiagram>();
    if (diagram.branches.empty() && diagram.unfinished.empty())
      diagram.unfinished = "the method has no answer at either end of the interval";
    return diagram;
  }

 protected:
  /// \param limits  kept by the caller
  explicit MethodDiagram(const CurveLimits& limits) : limits_(limits), queue_(limits) {}

  [[nodiscard]] const CurveLimits& limits() const { return limits_; }

 private:
  /// The motion without contact forces, from where it goes into the interval; empty where it touches a stop.
  virtual std::optional<Start> contact_free(double frequency) = 0;
  /// An answer, likewise; empty where it does not solve the equations of the curve.
  virtual std::optional<Start> on_curve(const EndAnswer& answer) = 0;
  /// Whether a start lies on a branch that was followed.
  [[nodiscard]] virtual bool is_known(const Start& start) const = 0;
  /// The branch through a start, with all that begins on it.
  virtual TracedBranch<Start> trace(const Start& start) = 0;

  bool add(std::optional<Start> start, const char* origin, double frequency) {
    if (!start) return false;
    start->origin = fmt::format("{} at {:.10g} rad/s", origin, frequency);
    queue_.add(*std::move(start));
    return true;
  }

  const CurveLimits& limits_;
  CurveQueue<Start> queue_;
};

}  // namespace signorini
