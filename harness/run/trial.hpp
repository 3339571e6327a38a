#pragma once
// What the process of a case does: solves, times, measures and certifies.

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/summary/motion_summary.hpp"

namespace signorini {

/// What one solve is asked for beyond its case.
struct SolveExtras {
  std::shared_ptr<const Trajectory> start = {};  ///< null: as the case says, cold unless it has a start
  int samples = 0;                               ///< instants of the trajectory kept in the record; 0: none
  bool timed = true;
  bool certified = true;  ///< look for the orbit behind the answer
  bool measured = true;   ///< measure energy, penetration and restitution, not the contact ratio alone;
                          ///< certified answers are
  std::optional<SummaryRequest> summary = {};  ///< summarise the motion of the answer
  /// Called with what the method answers as soon as it has, before the harness judges it.
  std::function<void(const Record& answer)> on_answer = {};
};

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
  /// Keep the answer and its orbit as they are drawn, to this share of each signal's range.
  std::optional<double> waveforms = {};
  SolveExtras extras = {};  ///< all but their start
};

/// Stages of a trial, in order; its first round of timing is one of them.
enum class TrialStage { solved, timed, measured, certified };

/// Trials of one method, of which all but the first have the scene of the one before at another frequency of
/// the load: what the method has set up serves as long as it says so (`PreparedMethod::take_frequency`).
class TrialSeries {
 public:
  /// Runs a trial into `record`, which already names scene, method and law, and calls `stage_done` with it
  /// after each stage. Stops after the stage `solved` where there is no answer, and after `timed` where a
  /// command fails when asked again. Catches of what the method throws only SolveFailure.
  void run(const Trial& trial, Record record, const std::function<void(const Record&)>& stage_done);
  /// Whether what was set up serves the next trial.
  /// \param next  its scene, different from that of the last one in the frequency of its load alone
  bool goes_on(const Problem& next);

 private:
  /// Unless it was set up before. \return the time that it took [s] \throws std::runtime_error
  double set_up(const Trial& trial);

  std::unique_ptr<Method> method_;
  std::unique_ptr<Problem> problem_;  // as the method is given it
  std::unique_ptr<PreparedMethod> prepared_;
  std::optional<double> taken_ = {};  // the next frequency, and the processor time that it took [s]
};

/// The first trial of a series that ends with it.
void run_trial(const Trial& trial, Record record, const std::function<void(const Record&)>& stage_done);

/// One more round of timing: its times, or why there are none.
struct RepeatedSolve {
  std::optional<TimedRound> times = {};
  std::string answer = {};                ///< answer_digest of its first solve
  std::string message = {};               ///< of a method without an answer this time
  Status status = Status::not_converged;  ///< then
  std::optional<int> signal = {};         ///< that ended its command
};

/// Begins the message of a method that fails in another solve than its first.
inline constexpr const char* kRepeated = "in a repeated solve: ";

/// Sets up and solves anew from the same start, for the times and to see whether the answer is the same.
/// Catches of what the method throws only SolveFailure.
RepeatedSolve repeat_solve(const Scene& scene, const Case& planned_case, const Limits& limits,
                           const std::shared_ptr<const Trajectory>& start);

/// A method that tells its own time is believed down to this share of what passed: a round of timing lasts
/// until such times add up to it.
inline constexpr double kLeastShare = 0.01;

/// Thrown by the solve of a method that runs a command which crashed, was stopped or printed no answer; and
/// where a solve that is repeated has none.
class SolveFailure : public std::runtime_error {
 public:
  SolveFailure(Status record_status, const std::string& message, std::optional<int> ending_signal = {})
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

/// How long to measure.
struct TimingBudget {
  int rounds = 3;
  double round_seconds = 0.01;  ///< least time spent in one round; work slower than this runs once a round
  double total_seconds = 5.0;   ///< slower work gets fewer rounds, never less than one
};

/// Number of rounds of work whose first call took `first` seconds; that call counts as one.
int rounds_for(double first, const TimingBudget& budget);

/// Rounds whose times differ by more than this factor are measured again.
inline constexpr double kSteadyFactor = 1.25;

/// Whether `count` of the rounds, at least one, have times of set-up and solve within kSteadyFactor of each
/// other.
bool rounds_agree(const std::vector<TimedRound>& rounds, int count);

/// Rounds to be taken yet, 0 or more: those that lack of `planned`, and while no so many agree one more, up
/// to `more` more than planned.
int rounds_missing(const std::vector<TimedRound>& rounds, int planned, int more);

/// Least time of one call in one round [s]. The round ends when its two least times agree within 1 %, after
/// five calls and a tenth of its time at least, or when its time is over. Each call of `timed` returns its
/// own time, so that clean-up is not counted. A first call that lasts as long as a round is the round; unless
/// it lasts ten times as long, a second call must confirm that, because an interruption may have prolonged
/// the first. \param first  time of the first call, already made [s]
double time_round(const std::function<double()>& timed, double first, const TimingBudget& budget);

/// Statistics of set-up + solve over the rounds, at least one.
Seconds summarise(const std::vector<TimedRound>& rounds);

}  // namespace signorini
