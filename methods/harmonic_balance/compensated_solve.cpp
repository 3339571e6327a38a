#include "methods/harmonic_balance/compensated_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "methods/discretisation/trajectories.hpp"
#include "methods/harmonic_balance/harmonic_climb.hpp"
#include "methods/harmonic_balance/projected_contact.hpp"
#include "methods/hat_functions/hat_grids.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

constexpr int kBracketed = 16;      // samples per harmonic: contacts told apart as in a climb
constexpr double kOnTheWay = 1e-4;  // of a compensation that only leads to another, relative to x
constexpr int kNodesInAll = 2 * kFinestHatGrid;  // nodes times contacts that a second start may take
constexpr int kNodesPerHarmonic = 4;             // fewer do not carry the harmonics asked for

/// One solve, its impacts, and what it spends.
class Compensating {
 public:
  Compensating(const CompensatedSolve& compensated, const ProjectedEquations& equations, const Start& start,
               Work& work)
      : compensation_(compensated.compensation()),
        hardening_(compensated.hardening()),
        equations_(equations),
        start_(start),
        work_(work) {}

  /// The compensated answer near a guess that is one itself, by Newton's method at once; nothing if there is
  /// none.
  [[nodiscard]] std::optional<Solution> from_guess() const {
    const auto* guess = dynamic_cast<const FourierTrajectory*>(start_.guess.get());
    if (guess == nullptr || static_cast<int>(guess->data().shifts.size()) != equations_.receptance.contacts())
      return std::nullopt;
    const ImpactCompensation::Result result =
        compensate(hard_law(), force_of(*guess), guess->data().shifts, equations_.tolerance);
    count(result);
    if (!result.converged || result.impacts == 0) return std::nullopt;
    return answer(hard_law(), result, "Newton from the guess");
  }

  enum class Outcome {
    settled,  ///< compensated, or without impacts
    open,     ///< a solution of the projected equations whose impacts cannot be compensated
    loose,    ///< not even that: one of the sampled equations alone
  };

  /// Gives a converged answer its compensated impacts, within `limit` pivots and steps in all.
  Outcome settle(Solution& solution, long limit) const {
    const bool hardens = limit == 0 && hardening_ != 1.0;
    const ImpactCompensation::Result result = compensate(equations_.law, force_of(*solution.trajectory), {},
                                                         hardens ? kOnTheWay : equations_.tolerance);
    const bool in_limit = limit == 0 || spent(work_) + result.iterations <= limit;
    if (in_limit) count(result);
    if (result.converged && result.impacts == 0) return Outcome::settled;
    if (!result.converged || !in_limit) return result.exact ? Outcome::open : Outcome::loose;
    const std::optional<Solution> found =
        hardens ? hardened(result, solution.message) : answer(equations_.law, result, solution.message);
    if (!found) return Outcome::open;
    solution = *found;
    return Outcome::settled;
  }

  /// The compensated answer that a motion on hat functions leads to; nothing if there is none.
  [[nodiscard]] std::optional<Solution> from_hat(const Trajectory& motion, int samples) const {
    const ImpactCompensation::Result result =
        compensate(equations_.law, force_of(motion), {}, equations_.tolerance);
    count(result);
    if (!result.converged) return std::nullopt;
    const std::string how = fmt::format("{} hat functions first, Newton from there", samples);
    if (result.impacts > 0) return hardened(result, how);
    return exact_solution(equations_.receptance, equations_.gap, equations_.law, result.series, how);
  }

 private:
  static long spent(const Work& work) { return work.pivots.value_or(0) + work.iterations.value_or(0); }

  void count(const ImpactCompensation::Result& result) const {
    work_.iterations = work_.iterations.value_or(0) + result.iterations;
  }

  [[nodiscard]] Eigen::MatrixXcd force_of(const Trajectory& motion) const {
    return force_spectrum(motion, equations_.receptance.harmonics());
  }

  [[nodiscard]] ImpactCompensation::Result compensate(const ProjectedLaw& law, const Eigen::MatrixXcd& lambda,
                                                      const StopShifts& shifts, double tolerance) const {
    const int samples = kBracketed * std::max(equations_.receptance.harmonics(), kFewestOnGrid);
    return compensation_(equations_.receptance, equations_.gap, law, lambda, shifts, samples, tolerance,
                         start_);
  }

  [[nodiscard]] ProjectedLaw hard_law() const {
    return {hardening_ * equations_.law.constant, equations_.law.relief};
  }

  /// The answer behind impacts compensated at least nearly, and a harder law, whose force is nearer to an
  /// impulse: an improvement of the same motion; under the law itself if there is none. Nothing if that does
  /// not converge either.
  [[nodiscard]] std::optional<Solution> hardened(const ImpactCompensation::Result& near,
                                                 const std::string& how) const {
    const auto from_there = [&](const ProjectedLaw& law) {
      const ImpactCompensation::Result result =
          compensate(law, near.series.lambda, near.shifts, equations_.tolerance);
      count(result);
      return result;
    };
    const ImpactCompensation::Result shorter = from_there(hard_law());
    if (shorter.converged && shorter.impacts == near.impacts &&
        near_by(distance(shorter.series.lambda, near.series.lambda)))
      return answer(hard_law(), shorter, how);
    const ImpactCompensation::Result own = from_there(equations_.law);
    if (!own.converged || own.impacts == 0) return std::nullopt;
    return answer(equations_.law, own, how);
  }

  /// Of the motions under two forces, relative.
  [[nodiscard]] double distance(const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& other) const {
    const Eigen::MatrixXcd x = contact_motion(equations_.receptance, force);
    return (contact_motion(equations_.receptance, other) - x).norm() / x.norm();
  }

  /// The answer behind compensated impacts under one law, found as `how` says.
  [[nodiscard]] Solution answer(const ProjectedLaw& law, const ImpactCompensation::Result& result,
                                const std::string& how) const {
    FourierTrajectory::Data data =
        fourier_data(equations_.receptance, equations_.gap, law, result.series.lambda);
    data.shifts = result.shifts;
    return {.verdict = Verdict::converged,
            .message = fmt::format(
                "{}; {} impact{} compensated, stops moved by up to {:.1e}, net contact work {:.1e}", how,
                result.impacts, result.impacts == 1 ? "" : "s", result.largest,
                net_work_ratio(data.x, data.lambda)),
            .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
            .residual = result.series.residual,
            .condition = result.series.condition};
  }

  const ImpactCompensation& compensation_;
  double hardening_;
  const ProjectedEquations& equations_;
  const Start& start_;
  Work& work_;
};

/// Whether a grid carries so many harmonics and is not too large.
bool serves(int samples, const ContactReceptance& receptance) {
  return samples >= kNodesPerHarmonic * receptance.harmonics() &&
         static_cast<long>(samples) * receptance.contacts() <= kNodesInAll;
}

/// How far hat functions bear out an answer, or what they lead to instead.
struct SecondStart {
  bool asked = false;                   ///< a grid of hat functions serves
  std::optional<Solution> answer = {};  ///< with compensated impacts
  std::optional<double> distance = {};  ///< of the first answer from the motion on the finest grid [-]
};

SecondStart second_start(const Compensating& compensating, Resolutions& grids,
                         const ProjectedEquations& equations, const Start& start, const Solution& first,
                         Work& work) {
  SecondStart second;
  grids.forget_from(0);  // they are part of this solve
  for (std::size_t grid = 0; grid < grids.count(); ++grid) {
    const int samples = grids.value(grid);
    if (!serves(samples, equations.receptance)) continue;
    second.asked = true;
    if (start.expired()) break;
    const Solution hat = grids.solve_at(grid, {.deadline = start.deadline});
    add_effort(hat.work, work);
    if (hat.verdict != Verdict::converged) continue;
    second.answer = compensating.from_hat(*hat.trajectory, samples);
    if (second.answer) break;
    if (first.verdict != Verdict::converged) continue;
    second.distance = relative_distance(*first.trajectory, *hat.trajectory, samples);
  }
  if (start.expired()) second.distance.reset();  // the finest grid has not spoken
  return second;
}

/// What becomes of an answer whose impacts are not compensated, given what hat functions say of it.
Solution uncompensated(Solution solution, Compensating::Outcome outcome, const SecondStart& second) {
  if (second.answer) return *second.answer;
  if (solution.verdict != Verdict::converged) return solution;
  solution.message += "; impacts not compensated";
  if (!second.asked) return solution;
  const bool borne_out = second.distance && near_by(*second.distance);
  if (borne_out && outcome == Compensating::Outcome::open) return solution;
  solution.verdict = Verdict::not_converged;
  if (borne_out) {
    solution.message += ", nor the contact integral exact";
  } else {
    solution.message +=
        second.distance ? fmt::format(" and {:.2g} away from the motion on hat functions", *second.distance)
                        : ", nor borne out by hat functions";
  }
  return solution;
}

/// solve_compensated where there is a compensation.
Solution compensate(CompensatedSolve& compensated, const ProjectedEquations& equations, long limit,
                    const Start& start, Work& work, const std::function<Solution(Work&)>& solve) {
  const Compensating compensating(compensated, equations, start, work);
  if (limit == 0) {
    if (std::optional<Solution> near = compensating.from_guess()) return *std::move(near);
  }
  Solution solution = solve(work);
  auto outcome = Compensating::Outcome::loose;
  if (solution.verdict == Verdict::converged) outcome = compensating.settle(solution, limit);
  if (outcome == Compensating::Outcome::settled) return solution;
  Resolutions* grids = limit == 0 ? compensated.second_starts() : nullptr;
  SecondStart second;
  if (grids != nullptr) second = second_start(compensating, *grids, equations, start, solution, work);
  return uncompensated(std::move(solution), outcome, second);
}

}  // namespace

CompensatedSolve::CompensatedSolve(const Problem& problem, ImpactCompensation compensation,
                                   const CompensationSettings& settings)
    : compensation_(std::move(compensation)), hardening_(settings.hardening) {
  // Restitution 1 is what the projected force represents, whatever the scene's.
  constexpr double kConservative = 1.0;
  if (settings.second_starts && coarsest_hat_grid(problem) * problem.contact_count() <= kNodesInAll)
    grids_ = hat_grids(problem, HatSettings{}, kConservative);
}

std::shared_ptr<CompensatedSolve> compensated_solve(const Problem& problem,
                                                    const ContactReceptance& receptance,
                                                    const CompensationSettings& settings) {
  std::optional<ImpactCompensation> compensation = impact_compensation(problem, receptance);
  if (!compensation) return nullptr;
  return std::make_shared<CompensatedSolve>(problem, *std::move(compensation), settings);
}

Solution solve_compensated(CompensatedSolve* compensated, const ProjectedEquations& equations, long limit,
                           const Start& start, Work work, const std::function<Solution(Work&)>& solve) {
  Solution solution =
      compensated == nullptr ? solve(work) : compensate(*compensated, equations, limit, start, work, solve);
  solution.work = work;
  return solution;
}

}  // namespace signorini
