#include "harness/responses/response_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <utility>

#include "harness/build_info.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"
#include "harness/responses/curve_comparison.hpp"
#include "harness/responses/true_motion.hpp"
#include "harness/run/runner.hpp"
#include "harness/sweep/attractors.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

/// Frequencies of a sweep by steps, one way.
constexpr int kSteps = 61;
/// What the judge may take of the time limit for motions that are on no exact branch.
constexpr double kShareOfJudge = 0.5;
/// What one solve of a sweep may take of the time limit.
constexpr double kShareOfSolve = 0.1;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

SweepRange range_of(const ResponseQuestion& question) {
  return {.from = question.from, .to = question.to, .points = kSteps, .back = true};
}

double window_of(const ResponseQuestion& question) { return std::abs(question.to - question.from); }

/// What the processes of one case know.
struct Asked {
  const Scene& scene;
  const Case& planned_case;
  const Limits& limits;
  ResponseQuestion question = {};

  /// Its motions are free ones, of which each frequency has those of some energies.
  [[nodiscard]] bool is_free() const { return highest_load_harmonic(scene.problem) == 0; }
  /// \param amplitude  A of ResponseMetric [m]
  [[nodiscard]] ResponseMetric metric(double amplitude) const {
    return {window_of(question), amplitude, is_free() ? Delays::any : Delays::whole_periods};
  }
  [[nodiscard]] ParametrisedScene varied() const {
    return over_frequency(scene.problem, question.from, question.to);
  }
  [[nodiscard]] BranchDiagram branches(double timeout, int phases) const {
    return branches_of(varied(), planned_case.choice,
                       {.max_order = question.orders, .phases = phases, .deadline = Deadline::after(timeout)})
        .value();
  }
  [[nodiscard]] std::vector<SweepPoint> steps(double timeout) const {
    return frequency_response(scene, planned_case.choice, range_of(question),
                              {.timeout = kShareOfSolve * timeout,
                               .memory_mb = limits.memory_mb,
                               .deadline = Deadline::after(timeout)});
  }
};

void refuse(const std::string& reason, Record& record) {
  record.status = Status::not_applicable;
  record.message = as_message(reason);
}

std::string digest_of_branches(const std::vector<DrawnBranch>& branches) {
  std::string text;
  for (const DrawnBranch& branch : branches) text += json_line(write_fields(branch)) + "\n";
  return sha256(text).substr(0, 16);
}

/// Branches, points and open ends of a response; converged where there is a point.
void take_curve(const ResponseCurve& curve, Record& record) {
  RecordedResponse& response = record.response.value();
  response.points = 0;  // of a first, shorter look
  response.open_ends.clear();
  for (const ResponseBranch& branch : curve.branches)
    response.points += static_cast<int>(branch.points.size());
  record.status = response.points > 0 ? Status::converged : Status::not_converged;
  for (const std::string& end : curve.open_ends) response.open_ends.push_back(as_message(end));
  response.located = distinct_points(curve.located, window_of(response.question));
  response.branches = drawn(curve);
}

class ExactTask final : public CaseTask {
 public:
  ExactTask(Asked asked, ExactResponse& exact) : asked_(asked), exact_(exact) {}

  [[nodiscard]] double seconds() const override {
    return 3.0 * enforced(asked_.limits.reference_timeout) + kQuickSeconds;
  }

  void run(Record record, const std::function<void(const Record&)>& stage_done) const override {
    try {
      ResponseCurve curve = from_attractors();
      add_orbits_beside(curve);
      take_curve(curve, record);
      // Without contacts there is nothing to compare, and no scale of motions.
      if (const double amplitude = amplitude_of(curve); amplitude > 0.0)
        curve = thinned(std::move(curve), asked_.metric(amplitude));
      record.response->branches = drawn_with_motions(curve);
    } catch (const std::runtime_error& error) {  // the scene cannot be followed
      refuse(error.what(), record);
    }
    record.not_timed = "it is what others are measured against";
    stage_done(record);
  }

  [[nodiscard]] RepeatedSolve repeat() const override { return {}; }
  void release(Record& record) const override { exact_.take(record); }

 private:
  /// Branches of the orders that are looked for in any sweep, or of more where more are asked for, begun at
  /// the motions too that starts settle to at each of the steps. What of these lies on no branch is told.
  [[nodiscard]] ResponseCurve from_attractors() const {
    const ParametrisedScene varied = asked_.varied();
    const int orders =
        std::max(asked_.question.orders, default_orders(asked_.scene.problem, asked_.planned_case.choice));
    std::vector<AttractorsAt> settled = attractors();
    const BranchDiagram diagram = branches_of(varied, asked_.planned_case.choice,
                                              {.max_order = orders,
                                               .max_branches = 400,
                                               .step_share = 1.0 / 3.0,
                                               .phases = kComparedPhases,
                                               .at = sweep_frequencies(range_of(asked_.question)),
                                               .begin_at = motions_of(varied, settled, orders),
                                               .deadline = Deadline::after(asked_.limits.reference_timeout)})
                                      .value();
    ResponseCurve curve = curve_of(diagram);
    tell_attractors(settled, off_branches(settled, diagram.branches, "rad/s", orders), curve);
    return curve;
  }

  /// What starts settle to at each of the steps. None of a structure that is not followed through time, or
  /// that nothing drives: free motions settle to nothing.
  [[nodiscard]] std::vector<AttractorsAt> attractors() const {
    if (asked_.is_free() || !flow_obstacle(asked_.scene.problem).empty()) return {};
    return attractors_over(asked_.varied(), sweep_frequencies(range_of(asked_.question)),
                           {.starts = 24, .timeout = asked_.limits.reference_timeout / kSteps});
  }

  static void tell_attractors(const std::vector<AttractorsAt>& settled, const std::vector<std::string>& off,
                              ResponseCurve& curve) {
    if (!off.empty())
      curve.open_ends.push_back(fmt::format(
          "{} motions that starts settle to lie on no branch; the first: {}", off.size(), off.front()));
    const auto undecided = std::ranges::count_if(settled, [](const AttractorsAt& at) {
      return std::ranges::all_of(at.attractors,
                                 [](const Attractor& one) { return one.verdict == LongRun::undecided; });
    });
    if (undecided > 0)
      curve.open_ends.push_back(
          fmt::format("no start settled in time at {} of {} frequencies", undecided, settled.size()));
  }

  /// Orbits of steps of the frequency on none of the branches: those of isolated ones, and beyond ends at
  /// which a branch could not be followed. None of free motions: a solve has the state of rest.
  void add_orbits_beside(ResponseCurve& curve) const {
    if (asked_.is_free()) return;
    const ResponseCurve steps = curve_of(asked_.steps(asked_.limits.reference_timeout));
    const double window = window_of(asked_.question);
    const double amplitude = std::max(amplitude_of(curve), amplitude_of(steps));
    if (!(amplitude > 0.0)) return;
    const std::vector<ResponseBranch> beside =
        beside_branches(curve, steps, asked_.metric(amplitude), window);
    std::size_t orbits = 0;
    for (const ResponseBranch& branch : beside) orbits += branch.points.size();
    if (orbits > 0)
      curve.open_ends.push_back(fmt::format("{} orbits in steps of the frequency lie on no branch", orbits));
    curve.branches.insert(curve.branches.end(), beside.begin(), beside.end());
  }

  Asked asked_;
  ExactResponse& exact_;
};

/// A response and the processor time that it took: once for the time alone, of steps the sum over the solves.
struct TimedCurve {
  double seconds = 0.0;
  ResponseCurve curve = {};  ///< without motions, but of steps
};

/// A method's own branches along themselves, or its answers at one frequency after the other.
class ResponseTask final : public CaseTask {
 public:
  ResponseTask(Asked asked, const ExactResponse& exact) : asked_(asked), exact_(exact) {}

  [[nodiscard]] double seconds() const override {  // the last solve or step may begin just before the end
    return enforced((1.0 + kShareOfSolve + kShareOfJudge) * asked_.limits.timeout) + kQuickSeconds;
  }

  void run(Record record, const std::function<void(const Record&)>& stage_done) const override {
    TimedCurve first;
    try {
      first = follow();
    } catch (const UsageError& error) {  // the method does not apply to all of the interval
      refuse(error.what(), record);
      return stage_done(record);
    }
    take_curve(first.curve, record);
    record.processor.solve = first.seconds;
    stage_done(record);
    take_times(first.seconds, record);
    stage_done(record);
    take_answer(with_motions(std::move(first)), record);
    stage_done(record);
  }

  [[nodiscard]] RepeatedSolve repeat() const override {
    TimedCurve again = follow();
    const double round = round_from(again.seconds);
    return {.times = TimedRound{.solve = round},
            .answer = digest_of_branches(drawn(with_motions(std::move(again))))};
  }

  void release(Record& /*record*/) const override {}

 private:
  [[nodiscard]] bool by_steps() const { return asked_.question.way == ResponseWay::steps; }

  /// \throws UsageError where the method does not apply
  [[nodiscard]] TimedCurve follow() const {
    if (by_steps()) return stepped();
    const double begin = processor_seconds();
    const BranchDiagram diagram = asked_.branches(asked_.limits.timeout, 0);
    return {.seconds = diagram.seconds.value_or(processor_seconds() - begin), .curve = curve_of(diagram)};
  }

  [[nodiscard]] TimedCurve stepped() const {
    const std::vector<SweepPoint> points = asked_.steps(asked_.limits.timeout);
    TimedCurve all{.curve = curve_of(points)};
    std::size_t failed = 0;
    for (const SweepPoint& point : points) {
      if (point.status == Status::not_applicable) throw UsageError(point.message);
      if (point.status != Status::converged) ++failed;
      all.seconds += point.seconds.value_or(0.0);
    }
    if (failed > 0)
      all.curve.open_ends.push_back(fmt::format("{} of {} solves failed", failed, points.size()));
    if (points.size() < 2 * sweep_frequencies(range_of(asked_.question)).size())
      all.curve.open_ends.emplace_back("the time is up");
    return all;
  }

  /// Of a curve by arc length, followed once more for them.
  [[nodiscard]] ResponseCurve with_motions(TimedCurve first) const {
    if (by_steps()) return std::move(first.curve);
    return curve_of(asked_.branches(asked_.limits.timeout, kComparedPhases));
  }

  /// The time of a round whose first curve took `first`: a short one is followed again and again, for the
  /// system may count processor time in milliseconds [s].
  [[nodiscard]] double round_from(double first) const {
    constexpr double kRound = 0.3;  // s
    double seconds = first;
    int count = 1;
    for (; seconds < kRound && !by_steps(); ++count) seconds += follow().seconds;
    return seconds / count;
  }

  /// The first round of timing, or why there is none.
  void take_times(double first, Record& record) const {
    const std::string& untimed = asked_.planned_case.choice.entry->untimed;
    if (!untimed.empty()) {
      record.not_timed = untimed;
    } else if (!build_may_be_timed()) {
      record.not_timed = "not a Release build";
    } else if (record.status == Status::converged) {
      record.seconds = summarise({{.solve = round_from(first)}});
    }
  }

  /// What the response is worth against the exact one.
  void take_answer(const ResponseCurve& curve, Record& record) const {
    take_curve(curve, record);
    record.answer = digest_of_branches(record.response->branches);
    const double window = window_of(asked_.question), amplitude = amplitude_of(exact_.curve());
    if (amplitude > 0.0)
      compare(curve, asked_.metric(amplitude), window, *record.response);
    else
      record.message = "nothing to compare with: the exact response has no branch, or the scene no contact";
  }

  /// What of the method is on no exact branch is shown to the judge.
  void compare(const ResponseCurve& curve, const ResponseMetric& metric, double window,
               RecordedResponse& response) const {
    TrueMotions judge(asked_.varied(), metric, kWideTolerance,
                      Deadline::after(kShareOfJudge * asked_.limits.timeout));
    response.comparison =
        compare_curves(exact_.curve(), curve, metric, window,
                       {.orders = asked_.question.orders,
                        .is_true = [&](const ResponsePoint& point) { return judge.contain(point); }});
    if (judge.confirmed() > 0)
      response.open_ends.push_back(fmt::format(
          "{} pieces on no exact branch are motions that the judge has confirmed", judge.confirmed()));
    if (judge.unasked() > 0)
      response.open_ends.push_back(fmt::format("the judge had no time for {} pieces", judge.unasked()));
  }

  Asked asked_;
  const ExactResponse& exact_;
};

}  // namespace

void give_tasks(const Scene& scene, const Limits& limits, ExactResponse& exact, std::vector<Job>& jobs) {
  for (Job& job : jobs) {
    const std::optional<ResponseQuestion>& question = job.planned_case->response;
    if (!question) continue;
    const Asked asked{
        .scene = scene, .planned_case = *job.planned_case, .limits = limits, .question = *question};
    if (question->way == ResponseWay::exact) {
      // Whether it can be followed is its own answer.
      job.method = {.applies = true, .law = as_represented(scene.problem.law())};
      job.task = std::make_shared<ExactTask>(asked, exact);
    } else {
      job.task = std::make_shared<ResponseTask>(asked, exact);
    }
  }
}

}  // namespace signorini
