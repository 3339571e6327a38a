#include "harness/conformance/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini {

namespace {

/// Impulse per period and contact, from the impulses that are listed [N s].
Eigen::VectorXd listed_impulse(const Trajectory& trajectory, int contacts) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(contacts);
  for (const Impulse& impulse : trajectory.impulses()) {
    if (impulse.contact >= 0 && impulse.contact < contacts) sum[impulse.contact] += impulse.value;
  }
  return sum;
}

double impulse_deviation(const Subject& subject, const Trajectory& before, const Trajectory& after,
                         const MotionMap& map) {
  const int contacts = subject.problem().contact_count();
  const Eigen::VectorXd expected = listed_impulse(before, contacts);
  const Eigen::VectorXd found = listed_impulse(after, contacts) / (map.force * map.time);
  const double scale = load_scale(subject.problem()) * subject.problem().period();
  double worst = 0.0;
  for (int c = 0; c < contacts; ++c)
    worst = std::max(worst, std::abs(found[c] - expected[c]) / std::max(scale, std::abs(expected[c])));
  return worst;
}

/// Whether a solve of the scene that starts from a motion stays there: then x solves the scene, and the
/// forces follow.
bool stays(const Subject& subject, const std::shared_ptr<const Trajectory>& motion) {
  const Solution again = subject.solve(subject.problem(), motion);
  if (again.verdict != Verdict::converged || !again.trajectory) return false;
  const int count = subject.terms().grid;
  const Samples given = motion->sample(count), kept = again.trajectory->sample(count);
  return (given.x - kept.x).cwiseAbs().maxCoeff() <=
         subject.terms().agreement * displacement_scale(subject.problem(), given);
}

}  // namespace

std::optional<CheckResult> why_not(const Subject& subject) {
  if (subject.support().ok) return std::nullopt;
  return not_applicable("the method does not apply: " + subject.support().reason);
}

std::optional<CheckResult> why_no_answer(const Subject& subject) {
  if (auto refusal = why_not(subject)) return refusal;
  const Solution& answer = subject.answer();
  if (answer.verdict != Verdict::converged) return not_applicable("there is no answer: " + answer.message);
  if (!answer.trajectory) return not_applicable("the answer has no trajectory");
  return std::nullopt;
}

double deviation(const Subject& subject, const Trajectory& before, const Trajectory& after,
                 const MotionMap& map) {
  const int count = subject.terms().grid;
  const Samples expected = before.sample(count), found = after.sample(count);
  if (expected.x.cols() != found.x.cols()) return std::numeric_limits<double>::infinity();
  if (found.x.cols() == 0) return 0.0;
  const double x_scale = displacement_scale(subject.problem(), expected);
  // Forces on the scale of the load: a contact that barely presses is judged by what could press it.
  const double f_scale = std::max(expected.force.cwiseAbs().maxCoeff(), load_scale(subject.problem()));
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const int j = ((i + map.delay) % count + count) % count;
    const auto x = (found.x.row(j) / map.displacement - expected.x.row(i)).cwiseAbs().maxCoeff();
    const auto force = (found.force.row(j) / map.force - expected.force.row(i)).cwiseAbs().maxCoeff();
    worst = std::max({worst, x / x_scale, force / f_scale});
  }
  return std::max(worst, impulse_deviation(subject, before, after, map));
}

CheckResult compare_with(const Subject& subject, const Problem& problem, const MotionMap& map, int turns) {
  const Solution found = subject.solve(problem);
  if (found.verdict != Verdict::converged || !found.trajectory)
    return failed("the equivalent problem is not solved: " + found.message);
  const Trajectory& answer = *subject.answer().trajectory;
  double nearest = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < turns; ++turn) {
    MotionMap turned = map;
    turned.delay += turn * map.grid / turns;
    nearest = std::min(nearest, deviation(subject, answer, *found.trajectory, turned));
  }
  const double allowed = subject.terms().agreement;
  if (nearest <= allowed) return passed();
  if (stays(subject, std::make_shared<MappedMotion>(found.trajectory, map.inverse())))
    return remarked(
        fmt::format("the equivalent problem gets another solution of the scene, {:.1e} away", nearest));
  return failed(
      fmt::format("the answers to equivalent problems differ by {:.1e} of their scale (must be <= {:.1e})",
                  nearest, allowed));
}

}  // namespace signorini
