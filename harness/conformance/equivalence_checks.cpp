// Checks by other problems: equivalent problems must have equivalent answers, equal problems equal ones, and
// a problem without contact the linear response.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "harness/conformance/checked_method.hpp"
#include "harness/conformance/resolution_series.hpp"
#include "harness/conformance/transformations.hpp"
#include "harness/judge/measures/motion.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/structure/periodic_response.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

// No powers of two: every product is rounded.
constexpr double kLoad = 3.7;
constexpr double kStructure = 0.23;
constexpr double kTime = 1.9;

/// Sum of the listed impulses of a period, per contact [N s].
Eigen::VectorXd listed_impulse(const Trajectory& trajectory, int contacts) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(contacts);
  for (const Impulse& impulse : trajectory.impulses()) {
    if (impulse.contact >= 0 && impulse.contact < contacts) sum[impulse.contact] += impulse.value;
  }
  return sum;
}

/// Largest deviation of the listed impulses per period, relative to the larger of the impulse itself and the
/// impulse of the load over a period [-].
double impulse_deviation(const CheckedMethod& checked, const Trajectory& before, const Trajectory& after,
                         const MotionMap& map) {
  const int contacts = checked.problem().contact_count();
  const Eigen::VectorXd expected = listed_impulse(before, contacts);
  const Eigen::VectorXd found = listed_impulse(after, contacts) / (map.force * map.time);
  const double scale = load_scale(checked.problem()) * checked.problem().period();
  double worst = 0.0;
  for (int c = 0; c < contacts; ++c)
    worst = std::max(worst, std::abs(found[c] - expected[c]) / std::max(scale, std::abs(expected[c])));
  return worst;
}

/// Largest deviation of `after` from what `map` makes of `before`, at settings().grid instants: of x relative
/// to the displacement scale, of the contact force relative to the larger of the largest force and the load
/// scale, of the impulses as above [-].
double deviation(const CheckedMethod& checked, const Trajectory& before, const Trajectory& after,
                 const MotionMap& map) {
  const int count = checked.settings().grid;
  const Samples expected = before.sample(count), found = after.sample(count);
  if (expected.x.cols() != found.x.cols()) return std::numeric_limits<double>::infinity();
  if (found.x.cols() == 0) return 0.0;
  const double x_scale = displacement_scale(checked.problem(), expected);
  // Forces on the scale of the load: a contact that barely presses is judged by what could press it.
  const double f_scale = std::max(expected.force.cwiseAbs().maxCoeff(), load_scale(checked.problem()));
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    // Instant i of the scene is instant i + delay of the equivalent problem, modulo the period.
    const int j = ((i + map.delay) % count + count) % count;
    Eigen::RowVectorXd back = found.x.row(j);
    if (map.origin.size() > 0) back -= map.origin.transpose();
    const auto x = (back / map.displacement - expected.x.row(i)).cwiseAbs().maxCoeff();
    const auto force = (found.force.row(j) / map.force - expected.force.row(i)).cwiseAbs().maxCoeff();
    worst = std::max({worst, x / x_scale, force / f_scale});
  }
  return std::max(worst, impulse_deviation(checked, before, after, map));
}

/// Whether `motion` is a solution of the scene: a solve that starts from it stays there. The forces follow
/// from x.
bool is_solution(const CheckedMethod& checked, const std::shared_ptr<const Trajectory>& motion) {
  const Solution again = checked.solve(checked.problem(), motion);
  if (again.verdict != Verdict::converged || !again.trajectory) return false;
  const int count = checked.settings().grid;
  const Samples given = motion->sample(count), kept = again.trajectory->sample(count);
  return (given.x - kept.x).cwiseAbs().maxCoeff() <=
         checked.settings().agreement * displacement_scale(checked.problem(), given);
}

/// Whether the method answers `problem`, which `map` makes of its scene, with what the map makes of its
/// answer. A different answer is accepted with a remark if, mapped back, it is a solution of the scene.
/// `shifts`: number of equal parts of the period by any whole number of which the answer may come later
/// still. `least`: difference that is allowed in any case.
CheckResult compare(const CheckedMethod& checked, const Problem& problem, const MotionMap& map,
                    int shifts = 1, double least = 0.0) {
  if (auto no_answer = unless_answered(checked)) return *no_answer;
  validate(problem);
  const Solution found = checked.solve(problem);
  if (found.verdict != Verdict::converged || !found.trajectory)
    return failed("the equivalent problem is not solved: " + found.message);
  const Trajectory& answer = *checked.answer().trajectory;
  double nearest = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < shifts; ++shift) {
    MotionMap shifted = map;
    shifted.delay += shift * map.grid / shifts;
    nearest = std::min(nearest, deviation(checked, answer, *found.trajectory, shifted));
  }
  const double allowed = std::max(least, checked.settings().agreement);
  if (nearest <= allowed) return passed();
  if (is_solution(checked, std::make_shared<MappedMotion>(found.trajectory, map.inverse())))
    return remarked(
        fmt::format("the equivalent problem gets another solution of the scene, {:.1e} away", nearest));
  return failed(
      fmt::format("the answers to equivalent problems differ by {:.1e} of their scale (must be <= {:.1e})",
                  nearest, allowed));
}

/// Names what differs between two solutions; empty if their bits are equal.
std::string difference(const Solution& a, const Solution& b) {
  if (a.verdict != b.verdict) return "their verdicts";
  if (a.message != b.message) return fmt::format("their messages, '{}' and '{}'", a.message, b.message);
  if (a.residual != b.residual) return "their residuals";
  if (a.condition != b.condition) return "their condition estimates";
  if ((a.trajectory == nullptr) != (b.trajectory == nullptr)) return "their having a trajectory";
  if (!a.trajectory) return {};
  if (answer_digest(*a.trajectory) == answer_digest(*b.trajectory)) return {};
  constexpr int kCount = 50;
  const Samples x = a.trajectory->sample(kCount), y = b.trajectory->sample(kCount);
  const double largest = x.x.size() > 0 ? (x.x - y.x).cwiseAbs().maxCoeff() : 0.0;
  return fmt::format("their trajectories, x by {:.1e} m", largest);
}

/// Distance of the new origin of x, in units of the motion [-].
constexpr double kFarOrigin = 10.0;
/// Errors of x at two origins may differ by this [-].
constexpr double kSameError = 0.01;
/// Answers at two origins may differ by this: solvers stop relative to a load ten times as large [-].
constexpr double kFarAgreement = 1e-6;

/// The harness's error of x of an answer that comes a fraction of a period late [-].
double late_error(const Problem& problem, const std::shared_ptr<const Trajectory>& answer) {
  const SampledAnswer here = sample_answer(problem, *answer);
  const MappedMotion late(answer, {.delay = 1, .grid = kGrid / 8});
  return distance(sample_motion(problem, late), here.motion).x_l2.value_or(0.0);
}

constexpr int kInstants = 1024;  // of a period of the load
/// Relative error of x at which no decay is asked for: the residual of an iterative solve [-].
constexpr double kExact = 1e-8;
/// Largest contact force without contact, relative to the load [-].
constexpr double kNoForce = 1e-9;
/// Distance of the stops in units of the largest displacement [-].
constexpr double kOutOfReach = 10.0;

/// Linear response x at the contacts over a period of the load, kInstants x Nc [m]. \throws SingularStiffness
Eigen::MatrixXd linear_response(const Problem& problem) {
  Problem linear = problem;
  linear.subharmonic = 1;
  const ContactReceptance receptance = contact_receptance(
      linear, highest_load_harmonic(linear), [&](int n) { return exact_weights(n * linear.frequency); });
  return sample_series(receptance.free_response, kInstants);
}

/// Number of periods of the load in the period of the answer, at least 1.
int load_periods(const Problem& problem, const Trajectory& answer) {
  return std::max(
      1, static_cast<int>(std::lround(answer.period() * problem.frequency / (2.0 * std::numbers::pi))));
}

/// The relative error of x at one resolution, or what is wrong with the answer.
struct LinearAnswer {
  std::optional<double> error = {};
  std::string defect = {};
};

LinearAnswer linear_answer(const CheckedMethod& checked, const Problem& open,
                           const Eigen::MatrixXd& response) {
  const Solution solution = checked.solve(open);
  if (solution.verdict != Verdict::converged || !solution.trajectory)
    return {.defect = "with the stops out of reach it does not converge: " + solution.message};
  const int periods = load_periods(open, *solution.trajectory);
  const Samples samples = solution.trajectory->sample(periods * kInstants);
  if (samples.x.cols() != response.cols())
    return {.defect = "its trajectory has the wrong number of contacts"};
  if (!solution.trajectory->impulses().empty())
    return {.defect = "it finds impulses where no stop is in reach"};
  if (samples.force.cwiseAbs().maxCoeff() > kNoForce * load_scale(open))
    return {.defect = "it finds contact forces where no stop is in reach"};
  const Eigen::MatrixXd expected = response.replicate(periods, 1);
  return {.error = (samples.x - expected).norm() / expected.norm()};
}

}  // namespace

CheckResult check_determinism(const CheckedMethod& checked) {
  if (auto refusal = unless_answered(checked)) return *refusal;
  const auto prepared = checked.method().prepare(checked.problem());
  const Solution first = prepared->solve({});
  const Solution again = prepared->solve({});
  if (const std::string what = difference(first, again); !what.empty())
    return failed("two solves of one set-up differ in " + what);
  if (const std::string what = difference(first, checked.method().prepare(checked.problem())->solve({}));
      !what.empty())
    return failed("the solves of two set-ups differ in " + what);
  return passed();
}

CheckResult check_load_scaling(const CheckedMethod& checked) {
  return compare(checked, with_load_scaled(checked.problem(), kLoad),
                 {.displacement = kLoad, .force = kLoad});
}

CheckResult check_structure_scaling(const CheckedMethod& checked) {
  return compare(checked, with_structure_scaled(checked.problem(), kStructure), {.force = kStructure});
}

CheckResult check_time_scaling(const CheckedMethod& checked) {
  return compare(checked, with_time_scaled(checked.problem(), kTime), {.time = kTime});
}

CheckResult check_numbering(const CheckedMethod& checked) {
  return compare(checked, with_coordinates_reversed(checked.problem()), {});
}

CheckResult check_time_shift(const CheckedMethod& checked) {
  if (auto no_answer = unless_answered(checked)) return *no_answer;
  const Problem& problem = checked.problem();
  // Steps are those of the motion, which may repeat after several periods of the scene.
  const double period = checked.answer().trajectory->period();
  const int grid = checked.settings().grid, steps = 5 * grid / 16 + 1;
  const Problem delayed = with_load_delayed(problem, steps * period / grid);
  // A subharmonic motion may come any number of forcing periods later still.
  const int shifts = static_cast<int>(std::lround(period / problem.period())) * problem.subharmonic;
  return compare(checked, delayed, {.delay = steps, .grid = grid}, std::max(1, shifts));
}

CheckResult check_origin_shift(const CheckedMethod& checked) {
  if (auto no_answer = unless_answered(checked)) return *no_answer;
  const Problem& problem = checked.problem();
  if (problem.contacts.empty()) return not_applicable("there is no contact to look at");
  const Samples samples = checked.answer().trajectory->sample(checked.settings().grid);
  const double motion = (samples.x.rowwise() - samples.x.colwise().mean()).cwiseAbs().maxCoeff();
  const double size = motion > 0.0 ? motion : displacement_scale(problem, samples);
  const Eigen::VectorXd u_0 = origin_before_stops(problem, kFarOrigin * size);
  const Problem moved = with_origin_moved(problem, u_0);
  const MotionMap map{.origin = contact_directions(problem).transpose() * u_0};
  const double here = late_error(problem, checked.answer().trajectory);
  const double there = late_error(moved, std::make_shared<MappedMotion>(checked.answer().trajectory, map));
  if (std::abs(there - here) > kSameError * here)
    return failed(
        fmt::format("the error of a late answer is {:.3e}, and {:.3e} where the origin is far", here, there));
  CheckResult result = compare(checked, moved, map, 1, kFarAgreement);
  if (result.outcome != CheckOutcome::failed) return result;
  // At rest at another origin is another state, from which marching may lead to another motion.
  const auto there_too = std::make_shared<MappedMotion>(checked.answer().trajectory, map);
  const Solution kept = checked.solve(moved, there_too);
  if (kept.verdict != Verdict::converged || !kept.trajectory) return result;
  const double apart = deviation(checked, *checked.answer().trajectory, *kept.trajectory, map);
  if (apart > std::max(kFarAgreement, checked.settings().agreement)) return result;
  return remarked("from rest at another origin it gets another motion, and keeps the same from that itself");
}

CheckResult check_contact_free(const CheckedMethod& checked) {
  if (auto refusal = unless_supported(checked)) return *refusal;
  if (checked.problem().contacts.empty()) return not_applicable("there is no contact to look at");
  Eigen::MatrixXd response;
  try {
    response = linear_response(checked.problem());
  } catch (const SingularStiffness&) {
    return not_applicable("without its stops the structure has no periodic response");
  }
  const double largest = response.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) return not_applicable("without contact nothing moves");
  const Problem open = with_stops_at(checked.problem(), kOutOfReach * largest);
  const std::vector<Settings> ladder = usable_ladder(checked.entry());
  for (const ResolutionSeries& series : resolution_series(ladder)) {
    std::vector<ResolutionStep> steps;
    for (std::size_t i = 0; i < series.places.size(); ++i) {
      const Settings& settings = ladder[series.places[i]];
      const CheckedMethod resolved = checked.with(settings);
      if (!resolved.support().ok) continue;
      const LinearAnswer one = linear_answer(resolved, open, response);
      const std::string label = MethodChoice{&checked.entry(), settings}.label();
      if (!one.error) return failed(label + ": " + one.defect);
      steps.push_back({.size = series.sizes[i], .error = *one.error});
    }
    CheckResult result = check_error_decay(steps, checked.entry().order, kExact);
    if (result.outcome == CheckOutcome::failed) result.why = "with the stops out of reach, " + result.why;
    if (result.outcome != CheckOutcome::passed) return result;
  }
  return passed();
}

}  // namespace signorini
