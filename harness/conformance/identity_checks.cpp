// Identities that need no oracle: equivalent problems must get equivalent answers.

#include <fmt/format.h>

#include "harness/conformance/answers.hpp"
#include "harness/conformance/checks.hpp"
#include "harness/records/answer_digest.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

// Powers of no base: every product is rounded.
constexpr double kLoad = 3.7;
constexpr double kStructure = 0.23;
constexpr double kTime = 1.9;

CheckResult compare(const Subject& subject, const Problem& problem, const MotionMap& map, int turns = 1) {
  if (auto refusal = why_no_answer(subject)) return *refusal;
  validate(problem);
  return compare_with(subject, problem, map, turns);
}

/// What differs between two solutions; empty if nothing does.
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

}  // namespace

CheckResult check_determinism(const Subject& subject) {
  if (auto refusal = why_no_answer(subject)) return *refusal;
  const auto prepared = subject.method().prepare(subject.problem());
  const Solution first = prepared->solve({});
  const Solution again = prepared->solve({});
  if (const std::string what = difference(first, again); !what.empty())
    return failed("two solves of one set-up differ in " + what);
  if (const std::string what = difference(first, subject.method().prepare(subject.problem())->solve({}));
      !what.empty())
    return failed("the solves of two set-ups differ in " + what);
  return passed();
}

CheckResult check_load_scaling(const Subject& subject) {
  return compare(subject, with_load_scaled(subject.problem(), kLoad),
                 {.displacement = kLoad, .force = kLoad});
}

CheckResult check_structure_scaling(const Subject& subject) {
  return compare(subject, with_structure_scaled(subject.problem(), kStructure), {.force = kStructure});
}

CheckResult check_time_scaling(const Subject& subject) {
  return compare(subject, with_time_scaled(subject.problem(), kTime), {.time = kTime});
}

CheckResult check_numbering(const Subject& subject) {
  return compare(subject, with_coordinates_reversed(subject.problem()), {});
}

CheckResult check_time_shift(const Subject& subject) {
  const Problem& problem = subject.problem();
  const int grid = subject.terms().grid, steps = 5 * grid / 16 + 1;
  const Problem delayed = with_load_delayed(problem, steps * problem.period() / grid);
  // A subharmonic motion may come any number of forcing periods later still.
  return compare(subject, delayed, {.delay = steps, .grid = grid}, problem.subharmonic);
}

}  // namespace signorini
