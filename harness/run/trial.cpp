#include "harness/run/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <fstream>

#include "harness/build_info.hpp"
#include "harness/isolation/process_state.hpp"
#include "harness/judge/certificate.hpp"
#include "harness/judge/measures/impacts.hpp"
#include "harness/judge/measures/measures.hpp"
#include "harness/judge/measures/waveform.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/summary/coordinate_motion.hpp"
#include "methods/structure/dynamic_stiffness.hpp"

namespace signorini {

namespace {

using Clock = std::chrono::steady_clock;

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Processor time of this process between one reading and the next.
class ProcessorClock {
 public:
  double lap() {
    const std::clock_t now = std::clock();
    const auto ticks = static_cast<double>(now - last_);
    last_ = now;
    return ticks / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t last_ = std::clock();
};

/// A figure of /proc/self/status in bytes; empty where there is none.
std::optional<long> status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key + ":")) return std::stol(line.substr(key.size() + 1)) * 1024;
  }
  return std::nullopt;
}

/// One solve and its time, the method's own where it tells one [s].
double timed_solve(PreparedMethod& prepared, const Start& start, Solution& solution) {
  const double passed = seconds_of([&] { solution = prepared.solve(start); });
  const std::optional<double> own = prepared.own_times().last;
  if (!own) return passed;
  return std::max(*own, kLeastShare * passed);
}

std::optional<long> restart_peak_memory() {
  // 5 resets the peak VmHWM to the present size (proc(5)): the peak read later is that of this solve.
  std::ofstream("/proc/self/clear_refs") << "5";
  return status_bytes("VmRSS");
}

/// The judge's own space of a structure that is not factorised harmonic by harmonic; null for others.
std::shared_ptr<const ContactSpace> space_of_large(const Trial& trial) {
  const Problem& problem = trial.scene.problem;
  return problem.size() > kMostFactorised ? trial.orbits.spaces->of(problem) : nullptr;
}

/// Fills in what the first solve says. Returns the motion of its answer, sampled once for all that is
/// measured on it; nothing where there is no answer.
std::optional<Motion> take_solution(const Trial& trial, const Solution& solution, bool expired,
                                    Record& record) {
  record.message = as_message(solution.message);
  record.work.counts = solution.work;
  record.residual = solution.residual;
  record.condition = solution.condition;
  if (solution.verdict != Verdict::converged) {
    record.status = expired ? Status::timeout : Status::not_converged;
    return std::nullopt;
  }
  SampledAnswer answer{.defect = "it says converged without a trajectory"};
  if (solution.trajectory) answer = check_answer(trial.scene.problem, *solution.trajectory);
  if (!answer.defect.empty()) {
    record.status = Status::invalid_output;
    record.message = answer.defect;
    return std::nullopt;
  }
  record.status = Status::converged;
  record.period = solution.trajectory->period();
  record.answer = answer_digest(*solution.trajectory);
  if (trial.extras.samples > 0) record.trajectory = samples_of(*solution.trajectory, trial.extras.samples);
  return std::move(answer.motion);
}

void take_failure(const SolveFailure& failure, Record& record) {
  record.status = failure.status;
  record.message = as_message(failure.what());
  record.signal = failure.signal;
}

bool is_outside(const Case& planned_case) { return !planned_case.choice.entry->plugin.empty(); }

/// The problem as a method is given it: one from outside the tree gets matrices of its own, so that the
/// harness judges by those of the scene whatever the method writes, and not the scene's name.
Problem problem_for(const Case& planned_case, const Problem& problem) {
  Problem given = problem;
  if (!is_outside(planned_case)) return given;
  given.structure = std::make_shared<const Structure>(*problem.structure);
  given.name = "scene";
  return given;
}

/// What was set up and solved for the first time in this process.
struct FirstCall {
  const Problem& problem;  ///< as the method is given it
  const Method& method;
  PreparedMethod& prepared;
  std::shared_ptr<const Trajectory> start = {};
  double setup = 0.0, solve = 0.0;  // [s]
  bool outside = false;             ///< the method is from outside the tree
};

/// The same scene to all digits but the last ones of its frequency: other ones whenever it is asked for.
std::unique_ptr<Problem> with_other_digits(const Problem& problem) {
  constexpr double kShare = 1e-12;  // of the frequency
  constexpr std::int64_t kKinds = 4096;
  const std::int64_t ticks = std::chrono::steady_clock::now().time_since_epoch().count();
  auto changed = std::make_unique<Problem>(problem);
  changed->frequency *= 1.0 + kShare * static_cast<double>(1 + ticks % kKinds) / kKinds;
  return changed;
}

/// What the solves of a round are asked of. A method from outside the tree may keep its answers, in memory or
/// on disc, whatever it has been asked: each of its solves is of a scene that is new in its last digits;
/// where it takes no other frequency, each round.
class TimedScenes {
 public:
  explicit TimedScenes(const FirstCall& first) : first_(first), prepared_(&first.prepared) {
    if (first.outside) change();
  }

  [[nodiscard]] const Problem& problem() const { return problem_ ? *problem_ : first_.problem; }

  /// For the next solve.
  PreparedMethod& next() {
    if (problem_ && !anew_) change();
    return *prepared_;
  }

 private:
  void change() {
    std::unique_ptr<Problem> changed = with_other_digits(first_.problem);
    if (!prepared_->take_frequency(*changed)) {
      anew_ = first_.method.prepare(*changed);
      prepared_ = anew_.get();
    }
    problem_ = std::move(changed);
  }

  const FirstCall& first_;
  std::unique_ptr<Problem> problem_;  // null: the scene as it is
  std::unique_ptr<PreparedMethod> anew_;
  PreparedMethod* prepared_;
};

/// The times of a round, and the digest of the last answer it gave to the scene as it is after the first
/// call's; nothing where the first call was the only one.
struct Round {
  TimedRound times;
  std::optional<std::string> latest;
};

bool has_answer(const Solution& solution) {
  return solution.verdict == Verdict::converged && solution.trajectory;
}

SolveFailure no_answer(const Solution& solution, const Start& start) {
  return {start.expired() ? Status::timeout : Status::not_converged, as_message(solution.message)};
}

/// \throws SolveFailure where a solve has no answer
Round round_from(const FirstCall& first, const Limits& limits) {
  Round round;
  std::optional<Solution> latest;
  TimedScenes scenes(first);
  const auto set_up = [&] {
    std::unique_ptr<PreparedMethod> fresh;
    return seconds_of([&] { fresh = first.method.prepare(scenes.problem()); });
  };
  const auto solve = [&] {
    const Start start{.guess = first.start, .deadline = Deadline::after(limits.timeout)};
    Solution solution;
    const double seconds = timed_solve(scenes.next(), start, solution);
    if (!has_answer(solution)) throw no_answer(solution, start);
    latest = std::move(solution);
    return seconds;
  };
  round.times.setup = time_round(set_up, first.setup, {});
  round.times.solve = time_round(solve, first.outside ? solve() : first.solve, {});
  if (!first.outside) round.times.first = first.setup + first.solve;
  if (latest && !first.outside) round.latest = answer_digest(*latest->trajectory);
  return round;
}

void take_times(const Trial& trial, const FirstCall& first, Record& record) {
  const std::string& untimed = trial.planned_case.choice.entry->untimed;
  if (!trial.extras.timed) {
    record.not_timed = "not asked for";
  } else if (!untimed.empty()) {
    record.not_timed = untimed;
  } else if (!build_may_be_timed()) {
    record.not_timed = "not a Release build";
  } else {
    const Round round = round_from(first, trial.limits);
    record.seconds = summarise({round.times});
    record.seconds->exchange = first.prepared.own_times().least_exchange;
    if (round.latest) count_repeat(*round.latest, record);
  }
}

void take_certificate(const Trial& trial, const std::shared_ptr<const Trajectory>& answer,
                      const Motion& motion, Record& record) {
  const Problem problem = under_law(trial.scene.problem, trial.law);
  CertifiedAnswer certified{.certificate = {.reason = "switched off by --certificate 0"}};
  if (const double seconds = trial.limits.certificate_timeout; seconds > 0.0)
    certified = certify(problem, answer, motion, trial.reference, trial.orbits, Deadline::after(seconds));
  record.certificate = certified.certificate;
  if (certified.orbit)
    record.errors = measure_errors(problem, motion, *certified.orbit, space_of_large(trial).get());
  if (trial.waveforms)
    record.waveforms =
        draw_waveforms(motion, certified.orbit ? &*certified.orbit : nullptr, *trial.waveforms);
  if (record.law_matches_scene == false && trial.scene_reference.orbit) {
    const Motion scene_orbit = sample_motion(problem, *trial.scene_reference.orbit);
    record.errors.x_l2_scene = distance(motion, scene_orbit, best_shift(motion, scene_orbit)).x_l2;
  }
}

/// What the motion does, and where samples were asked for those of coordinates too.
void take_physics(const Trial& trial, Motion& motion, Record& record) {
  const Problem& problem = trial.scene.problem;
  if (trial.extras.measured || trial.extras.certified) {
    motion.least = least_size(problem, space_of_large(trial).get());
    record.physics = measure_physics(problem, trial.law, motion, space_of_large(trial).get());
  } else if (problem.contact_count() > 0) {
    record.physics.contact_ratio = contact_ratio(motion);
  }
}

void take_summary(const Trial& trial, const Trajectory& answer, const Motion& motion, Record& record) {
  const Problem& problem = trial.scene.problem;
  record.motion = summarise_motion(problem, trial.law, answer, motion, *trial.extras.summary);
  if (record.motion->u.empty()) return;
  const CoordinateMotion field(problem, answer, motion, trial.extras.summary->dofs);
  if (field.error()) record.message += fmt::format("; u to {:.1e} m", *field.error());
  if (!record.trajectory) return;
  record.trajectory->dofs = trial.extras.summary->dofs;
  const Eigen::MatrixXd samples = field.displacement(trial.extras.samples);
  for (const auto& u : samples.colwise()) record.trajectory->u.emplace_back(u.begin(), u.end());
}

}  // namespace

bool TrialSeries::goes_on(const Problem& next) {
  if (!prepared_ || follows_speed(next)) return false;
  auto problem = std::make_unique<Problem>(next);
  problem->structure = problem_->structure;  // a method may refer to its matrices
  const ProcessState usual;
  const std::clock_t begun = std::clock();
  const bool takes = prepared_->take_frequency(*problem);
  static_cast<void>(usual.restore());
  if (!takes) return false;
  problem_ = std::move(problem);
  taken_ = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  return true;
}

void run_trial(const Trial& trial, Record record, const std::function<void(const Record&)>& stage_done) {
  TrialSeries().run(trial, std::move(record), stage_done);
}

double TrialSeries::set_up(const Trial& trial) {
  if (taken_) return *std::exchange(taken_, std::nullopt);
  if (!method_) method_ = trial.planned_case.choice.make();
  prepared_.reset();
  problem_ = std::make_unique<Problem>(problem_for(trial.planned_case, trial.scene.problem));
  return seconds_of([&] { prepared_ = method_->prepare(*problem_); });
}

void TrialSeries::run(const Trial& trial, Record record,
                      const std::function<void(const Record&)>& stage_done) {
  Solution solution;
  const ProcessState usual;
  ProcessorClock processor;
  const std::optional<long> before = restart_peak_memory();
  const Start start{.guess = trial.start, .deadline = Deadline::after(trial.limits.timeout)};
  const double taken = taken_.value_or(0.0);
  double setup = 0.0;
  try {
    setup = set_up(trial);
  } catch (const std::runtime_error& error) {  // as Method::prepare states: the structure is singular
    record.status = Status::not_converged;
    record.message = as_message(error.what());
    stage_done(record);
    return;
  }
  double solve = 0.0;
  try {
    solve = timed_solve(*prepared_, start, solution);
  } catch (const SolveFailure& failure) {
    take_failure(failure, record);
    stage_done(record);
    return;
  }
  if (const auto peak = status_bytes("VmHWM"); peak && before)
    record.work.peak_memory_bytes = std::max(0L, *peak - *before);  // the kernel counts in batches of pages
  const std::string changed = usual.restore();
  std::optional<Motion> motion = take_solution(trial, solution, start.expired(), record);
  if (!changed.empty()) record.message += fmt::format("; it changed {}, which was restored", changed);
  record.processor.solve = processor.lap() + taken;
  if (motion && trial.extras.summary) take_summary(trial, *solution.trajectory, *motion, record);
  stage_done(record);
  if (!motion) return;
  static_cast<void>(processor.lap());  // the summary is no stage of its own
  try {
    take_times(trial,
               {*problem_, *method_, *prepared_, trial.start, setup, solve, is_outside(trial.planned_case)},
               record);
  } catch (const SolveFailure& failure) {
    take_failure(failure, record);
    record.message = kRepeated + record.message;
    stage_done(record);
    return;
  }
  static_cast<void>(usual.restore());  // said above
  record.processor.timing = processor.lap();
  stage_done(record);
  take_physics(trial, *motion, record);
  record.processor.measures = processor.lap();
  stage_done(record);
  if (trial.extras.certified) {
    take_certificate(trial, solution.trajectory, *motion, record);
    record.processor.certificate = processor.lap();
  } else {
    record.certificate.reason = "not asked for";
  }
  stage_done(record);
}

RepeatedSolve repeat_solve(const Scene& scene, const Case& planned_case, const Limits& limits,
                           const std::shared_ptr<const Trajectory>& start) try {
  const std::unique_ptr<Method> method = planned_case.choice.make();
  std::unique_ptr<PreparedMethod> prepared;
  Solution solution;
  const Problem problem = problem_for(planned_case, scene.problem);
  const double setup = seconds_of([&] { prepared = method->prepare(problem); });
  const Start begin{.guess = start, .deadline = Deadline::after(limits.timeout)};
  const double solve = timed_solve(*prepared, begin, solution);
  if (!has_answer(solution)) throw no_answer(solution, begin);
  const std::string answer = answer_digest(*solution.trajectory);
  const FirstCall first{problem, *method, *prepared, start, setup, solve, is_outside(planned_case)};
  return {.times = round_from(first, limits).times, .answer = answer};
} catch (const SolveFailure& failure) {
  return {.message = as_message(failure.what()), .status = failure.status, .signal = failure.signal};
}

StartPoint start_point(const Case& planned_case, const Problem& problem, const Reference& reference) {
  const std::optional<double> late = planned_case.choice.start();
  if (!late) return {};
  if (!reference.orbit) return {.obstacle = "no orbit to start from: " + reference.reason};
  const int periods = whole_periods(problem.period(), reference.orbit->period());
  if (periods == 0) {
    return {.obstacle = fmt::format(
                "no orbit to start from: the one reached from rest has a period of {:.6g} s, asked "
                "for is {:.6g} s",
                reference.orbit->period(), problem.period())};
  }
  return {.motion = std::make_shared<SampledTrajectory>(repeated(delayed(*reference.orbit, *late), periods))};
}

}  // namespace signorini
