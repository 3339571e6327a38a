// Checks of what a method answers on a scene, and of when its solve ends.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>
#include <variant>

#include "harness/conformance/checked_method.hpp"
#include "harness/records/sampled_trajectory.hpp"

namespace signorini {

namespace {

/// Numbers of samples per period at which answers are compared.
constexpr std::array kCounts{1, 2, 7, 64, 1000};
/// Relative deviation of the period of an answer from a whole number of periods of the load [-].
constexpr double kPeriodTolerance = 1e-9;

std::string size_defect(const Problem& problem, const Samples& samples, int count) {
  if (const std::string defect = samples_defect(samples, count, problem.contact_count()); !defect.empty())
    return fmt::format("at {} instants {}", count, defect);
  if ((samples.force.array() > 0.0).any())
    return fmt::format("at {} instants a force pulls (must be <= 0)", count);
  return {};
}

std::string impulse_defect(const Trajectory& trajectory) {
  double before = 0.0;
  for (const Impulse& impulse : trajectory.impulses()) {
    if (impulse.value > 0.0) return fmt::format("an impulse is {} N s (must be <= 0)", impulse.value);
    if (!(impulse.time >= before) || !(impulse.time < trajectory.period()))
      return fmt::format("an impulse comes at {} s, out of order or outside the period", impulse.time);
    before = impulse.time;
  }
  return {};
}

std::string period_defect(const Problem& problem, const Trajectory& trajectory) {
  const double periods = trajectory.period() * problem.frequency / (2.0 * std::numbers::pi);
  const double whole = std::round(periods);
  if (whole >= 1.0 && std::abs(periods - whole) <= kPeriodTolerance * periods) return {};
  return fmt::format("its period of {} s is {} periods of the load, no whole number", trajectory.period(),
                     periods);
}

double largest_deviation(const Eigen::MatrixXd& coarse, const Eigen::MatrixXd& fine) {
  const Eigen::Index common = std::gcd(coarse.rows(), fine.rows());
  double worst = 0.0;
  for (Eigen::Index i = 0; i < common; ++i) {
    const auto deviation = coarse.row(i * (coarse.rows() / common)) - fine.row(i * (fine.rows() / common));
    worst = std::max(worst, deviation.cwiseAbs().maxCoeff());
  }
  return worst;
}

/// What differs at the instants that two samplings of a trajectory have in common.
std::string sampling_defect(const Trajectory& trajectory, int few, int many, double scale, double tolerance) {
  const Samples coarse = trajectory.sample(few), fine = trajectory.sample(many);
  const double velocity_scale = scale * 2.0 * std::numbers::pi / trajectory.period() * many;
  const double force_scale = std::max(fine.force.cwiseAbs().maxCoeff(), coarse.force.cwiseAbs().maxCoeff());
  for (const auto& [name, deviation, whole] :
       {std::tuple{"x", largest_deviation(coarse.x, fine.x), scale},
        std::tuple{"velocity", largest_deviation(coarse.velocity, fine.velocity), velocity_scale},
        std::tuple{"force", largest_deviation(coarse.force, fine.force), force_scale}}) {
    if (!(deviation <= tolerance * whole))
      return fmt::format("{} at common instants differs by {:.1e} between {} and {} samples of a period",
                         name, deviation, few, many);
  }
  return {};
}

std::string consistency_defect(const Problem& problem, const Trajectory& trajectory, double tolerance) {
  if (problem.contact_count() == 0) return {};
  const double scale = displacement_scale(problem, trajectory.sample(kCounts.back()));
  for (const int few : kCounts) {
    for (const int many : kCounts) {
      if (few >= many) continue;
      if (std::string defect = sampling_defect(trajectory, few, many, scale, tolerance); !defect.empty())
        return defect;
    }
  }
  return {};
}

/// What is wrong with the form of a solution; whether it is right is not asked here.
std::string solution_defect(const Problem& problem, const Solution& solution) {
  if (solution.message.empty()) return "its message is empty";
  if (!solution.trajectory)
    return solution.verdict == Verdict::converged ? "it says converged without a trajectory" : "";
  const Trajectory& trajectory = *solution.trajectory;
  std::string defect =
      trajectory_defect(trajectory, problem.contact_count(), 2.0 * std::numbers::pi / problem.frequency);
  if (!defect.empty()) return defect;
  if (defect = period_defect(problem, trajectory); !defect.empty()) return defect;
  for (const int count : kCounts) {
    if (defect = size_defect(problem, trajectory.sample(count), count); !defect.empty()) return defect;
  }
  return impulse_defect(trajectory);
}

struct LawDefect {
  const Problem& problem;
  std::string operator()(std::monostate) const {
    return problem.contacts.empty() ? "" : "it represents no law, and the scene has contacts";
  }
  std::string operator()(const Restitution& law) const {
    const auto has_none = [](const Contact& contact) {
      return !std::holds_alternative<Restitution>(contact.law);
    };
    if (problem.contacts.empty() || std::ranges::any_of(problem.contacts, has_none))
      return "it represents a restitution, and the scene has none";
    return law.e >= 0.0 && law.e <= 1.0 ? "" : fmt::format("it represents e = {} (must be in [0, 1])", law.e);
  }
  std::string operator()(const Penalty& law) const {
    const auto contacts = static_cast<std::size_t>(problem.contact_count());
    if (law.stiffness.size() != contacts)
      return fmt::format("it represents {} springs at {} contacts", law.stiffness.size(), contacts);
    for (const double stiffness : law.stiffness) {
      if (!std::isfinite(stiffness) || !(stiffness > 0.0))
        return fmt::format("it represents a spring of {} N/m (must be positive)", stiffness);
    }
    return {};
  }
  std::string operator()(const Massless&) const {
    return std::holds_alternative<Massless>(problem.law())
               ? ""
               : "it represents massless contacts, and these have mass";
  }
  std::string operator()(const MixedLaws& mixed) const {
    if (std::ssize(mixed.laws) != problem.contact_count())
      return fmt::format("it represents {} laws at {} contacts", mixed.laws.size(), problem.contact_count());
    return std::holds_alternative<MixedLaws>(problem.law())
               ? ""
               : "it represents different laws, and the scene has one";
  }
  std::string operator()(const Undetermined&) const { return {}; }
};

}  // namespace

CheckResult check_applicability(const CheckedMethod& checked) {
  const Support& support = checked.support();
  if (support.ok && !support.reason.empty())
    return failed(fmt::format("it applies, and gives a reason why not: {}", support.reason));
  if (!support.ok) return support.reason.empty() ? failed("it refuses the scene without a reason") : passed();
  const RepresentedLaw law = checked.method().law(checked.problem());
  if (std::string defect = std::visit(LawDefect{checked.problem()}, law); !defect.empty())
    return failed(defect);
  (void)checked.method().prepare(checked.problem());
  return passed();
}

CheckResult check_trajectory(const CheckedMethod& checked) {
  if (const auto refusal = unless_supported(checked)) return *refusal;
  const Solution& solution = checked.answer();
  if (std::string defect = solution_defect(checked.problem(), solution); !defect.empty())
    return failed(defect);
  if (!solution.trajectory) return not_applicable("there is no iterate: " + solution.message);
  return passed_unless(
      consistency_defect(checked.problem(), *solution.trajectory, checked.settings().identity));
}

CheckResult check_time_budget(const CheckedMethod& checked) {
  if (const auto refusal = unless_supported(checked)) return *refusal;
  using Clock = std::chrono::steady_clock;
  const std::unique_ptr<PreparedMethod> prepared = checked.method().prepare(checked.problem());
  const auto begin = Clock::now();
  const Solution solution = solve_or_stopped(*prepared, {.guess = {}, .deadline = Deadline::min()});
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (seconds > checked.settings().patience)
    return failed(fmt::format("it went on for {:.1f} s after its time was up", seconds));
  const std::string defect = solution_defect(checked.problem(), solution);
  return defect.empty() ? passed() : failed("with its time up, " + defect);
}

}  // namespace signorini
