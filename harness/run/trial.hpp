#pragma once
// What the child process of one case does in its first round: solve, time, measure, certify.

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// What a first round is given. What it refers to must outlive it.
struct Trial {
  const Scene& scene;
  const Case& planned_case;
  const Limits& limits;
  RepresentedLaw law = {};           ///< that the method represents on this scene
  const Reference& reference;        ///< of the scene under that law
  const Reference& scene_reference;  ///< of the scene under its own
  const OrbitTools& orbits;
  std::shared_ptr<const Trajectory> start = {};  ///< null: cold
  int samples = 0;                               ///< instants of the trajectory kept in the record; 0: none
  bool timed = true;
  bool certified = true;   ///< look for the orbit behind the answer
  bool waveforms = false;  ///< keep the answer and its orbit as they are drawn
};

/// Stages of a trial, in order; its first round of timing is one of them.
enum class TrialStage { solved, timed, measured, certified };

/// Runs a trial into `record`, which already names scene, method and law, and calls `stage_done` with it
/// after each stage. Stops after the stage `solved` where there is no answer. Does not catch what the method
/// throws.
void run_trial(const Trial& trial, Record record, const std::function<void(const Record&)>& stage_done);

/// One more round of timing: its times, or why there are none.
struct RepeatedSolve {
  std::optional<TimedRound> times = {};
  std::string answer = {};   ///< answer_digest of its first solve
  std::string message = {};  ///< of a method that does not converge this time
};

/// Sets up and solves anew from the same start, for the times and to see whether the answer is the same.
/// Does not catch what the method throws.
RepeatedSolve repeat_solve(const Scene& scene, const Case& planned_case, const Limits& limits,
                           const std::shared_ptr<const Trajectory>& start);

/// Thrown by the solve of a method that runs a command which crashed or printed no answer.
class CommandFailure : public std::runtime_error {
 public:
  CommandFailure(Status record_status, const std::string& message, std::optional<int> ending_signal = {})
      : std::runtime_error(message), status(record_status), signal(ending_signal) {}
  Status status;
  std::optional<int> signal;  ///< that ended the crashed process
};

struct StartPoint {
  std::shared_ptr<const Trajectory> motion = {};  ///< null: cold, at rest
  std::string obstacle = {};                      ///< why there is no motion though one is asked for
};

/// The reference orbit, late by the share of its period that the case asks for (MethodChoice::start) and
/// repeated to the period of the problem; cold if the case asks for none.
StartPoint start_point(const Case& planned_case, const Problem& problem, const Reference& reference);

}  // namespace signorini
