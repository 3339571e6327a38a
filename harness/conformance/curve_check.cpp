// The check of curves: their points are the answers of solves.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "harness/conformance/checked_method.hpp"
#include "harness/plan/deadline.hpp"
#include "methods/curve.hpp"

namespace signorini {

namespace {

constexpr int kPhases = 16;  // of a forcing period at which motions are compared

/// Where the answer is looked for on the curve, over the frequency of the scene [-]
constexpr std::array kPlaces{1.0, 1.01, 1.02};

/// Times CheckSettings::agreement: next to a grazing the tolerance of a solve moves it by more [-].
constexpr double kSlack = 10.0;

/// Whether a point is one of the curve at this frequency.
bool stands_at(const SolutionPoint& point, double frequency) {
  constexpr double kSame = 1e-9;
  return std::abs(point.frequency - frequency) <= kSame * frequency;
}

/// The largest difference of x between a point and a motion, begun any number of forcing periods later,
/// relative to the scale [-].
double difference(const SolutionPoint& point, const Eigen::MatrixXd& motion, double scale) {
  const Eigen::Index rows = std::max(point.motion.rows(), motion.rows());
  if (point.motion.cols() != motion.cols() || point.motion.rows() == 0 || rows % motion.rows() != 0 ||
      rows % point.motion.rows() != 0)
    return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index shift = 0; shift < rows; shift += kPhases) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const auto apart = point.motion.row((i + shift) % point.motion.rows()) - motion.row(i % motion.rows());
      largest = std::max(largest, apart.cwiseAbs().maxCoeff());
    }
    least = std::min(least, largest / scale);
  }
  return least;
}

/// From a motion to the nearest point of a diagram at its frequency.
double distance(const BranchDiagram& diagram, const Problem& problem, const Trajectory& motion) {
  const double periods = motion.period() * problem.frequency / (2.0 * std::numbers::pi);
  const Samples samples = motion.sample(kPhases * std::max(1, static_cast<int>(std::lround(periods))));
  const double scale = displacement_scale(problem, samples);
  double least = std::numeric_limits<double>::infinity();
  for (const Branch& branch : diagram.branches) {
    for (const SolutionPoint& point : branch.points)
      if (stands_at(point, problem.frequency)) least = std::min(least, difference(point, samples.x, scale));
  }
  return least;
}

}  // namespace

CheckResult check_curve(const CheckedMethod& checked) {
  if (auto no_answer = unless_answered(checked)) return *no_answer;
  const CurveMethod* const curve = checked.method().curve();
  if (curve == nullptr) return not_applicable("it follows no curve");
  if (checked.problem().contacts.empty()) return not_applicable("there is no contact to look at");
  const double frequency = checked.problem().frequency;
  const ParametrisedScene scene =
      over_frequency(checked.problem(), kPlaces.front() * frequency, kPlaces.back() * frequency);
  if (const Support follows = curve->follows(scene); !follows.ok)
    return not_applicable("it does not follow the scene: " + follows.reason);
  const BranchDiagram diagram =
      curve->follow(scene, {.max_order = checked.problem().subharmonic,
                            .phases = kPhases,
                            .at = {kPlaces[1] * frequency},
                            .deadline = Deadline::after(checked.settings().timeout)});
  const auto first = checked.answer().trajectory;
  const Solution last = checked.solve(scene.at(scene.to));
  // Inside, another motion may be nearer to a solve than those of the branches: one way there must lead to
  // them.
  const Problem inside = scene.at(kPlaces[1] * frequency);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& guess : {first, last.trajectory, std::shared_ptr<const Trajectory>()}) {
    const Solution answer = checked.solve(inside, guess);
    if (answer.verdict == Verdict::converged && answer.trajectory)
      least = std::min(least, distance(diagram, inside, *answer.trajectory));
    if (least <= kSlack * checked.settings().agreement) break;
  }
  double apart = std::max(least, distance(diagram, checked.problem(), *first));
  if (last.verdict == Verdict::converged && last.trajectory)
    apart = std::max(apart, distance(diagram, scene.at(scene.to), *last.trajectory));
  if (apart <= kSlack * checked.settings().agreement) return passed();
  if (!diagram.unfinished.empty()) return remarked("its curve is unfinished: " + diagram.unfinished);
  return failed(fmt::format(
      "an answer from {:.10g} to {:.10g} rad/s is {:.1e} of the motion from every point of its {} branches",
      scene.from, scene.to, apart, diagram.branches.size()));
}

}  // namespace signorini
