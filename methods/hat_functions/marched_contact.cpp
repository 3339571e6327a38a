#include "methods/hat_functions/marched_contact.hpp"

#include <algorithm>
#include <utility>

#include "methods/discretisation/trajectories.hpp"
#include "methods/marching/periodic_march.hpp"

namespace signorini {

namespace {

// Part of a state below which its change over a period may be rounding.
constexpr double kRoundOfAPeriod = 1e-11;
// Columns of contacts and loads up to which powers of them are taken, as a reduction does unasked.
constexpr int kMostMarchedColumns = 50;

class PreparedMarch final : public PreparedMethod {
 public:
  PreparedMarch(const Problem& problem, int samples, double tolerance,
                std::shared_ptr<const ContactReduction> reduction)
      : tolerance_(std::max(tolerance, kRoundOfAPeriod)),
        reduction_(std::move(reduction)),
        grid_(march_grid(problem, samples)) {}

  Solution solve(const Start& start) override {
    ContactMarch march(*reduction_, grid_);
    PeriodicMarch answer =
        march_to_periodic_motion(march, {.tolerance = tolerance_, .deadline = start.deadline});
    Solution solution{.verdict = answer.found() ? Verdict::converged : Verdict::not_converged,
                      .message = std::string(describe(answer.by)),
                      .work = {.unknowns = grid_.samples * reduction_->contacts(),
                               .iterations = answer.newton_steps,
                               .factorisations = answer.work.factorisations},
                      .residual = answer.residual};
    if (answer.motion.allFinite() && answer.motion.size() > 0) {
      solution.trajectory =
          std::make_shared<NodalTrajectory>(grid_.period, std::move(answer.motion), std::move(answer.force));
    }
    return solution;
  }

 private:
  double tolerance_;
  std::shared_ptr<const ContactReduction> reduction_;
  MarchGrid grid_;
};

}  // namespace

std::shared_ptr<const ContactReduction> marched_reduction(const Problem& problem) {
  if (problem.contact_count() == 0 || !march_obstacle(problem).empty()) return nullptr;
  const int columns = problem.contact_count() + 2 * (highest_load_harmonic(problem) + 1);
  const bool few = columns <= kMostMarchedColumns;
  // The grid leaves an error of 1e-3 to 1e-4: the space, twice as large as a reduction has unasked, less.
  const int vectors = few ? std::max(120, 12 * problem.contact_count()) : 150;
  auto reduction = std::make_shared<ContactReduction>(reduce_to_contacts(
      problem, {.basis = few ? ReductionBasis::krylov : ReductionBasis::modes, .vectors = vectors}));
  return reduction->obstacle.empty() ? reduction : nullptr;
}

std::unique_ptr<PreparedMethod> marched_contact(const Problem& problem, int samples, double tolerance,
                                                std::shared_ptr<const ContactReduction> reduction) {
  return std::make_unique<PreparedMarch>(problem, samples, tolerance, std::move(reduction));
}

}  // namespace signorini
