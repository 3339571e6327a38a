#include "methods/harmonic_balance/sample_grids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "methods/complementarity/energy_identity.hpp"
#include "methods/complementarity/exact_projection.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/solvers/lcp.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

// Samples per harmonic. On 32 the path of pivots met no ray on a population with damping ratios down to
// 0.0016 (docs/theory.md). Where the exact contact integral follows, kCoarseSampling will do to begin with:
// it decides the path, not the answer.
constexpr int kSampled = 32;
constexpr int kFinest = 128;
// A sampled answer is good enough when the contact's net work is this small a part of the work exchanged.
constexpr double kEnergyIdentity = 1e-3;

/// One grid's solution with its contact integral made exact where that is asked for and possible.
struct Refined {
  FourierTrajectory::Data data;
  bool exact = false;
  std::optional<double> condition = {};
  std::string quadrature;  // how the contact integral was taken, for the message
};

Refined refine_quadrature(const HarmonicSetup& setup, const GridSolution& grid, int samples, Work& work) {
  const ProjectedEquations equations = setup.equations();
  Refined refined{.data = series_data(equations, grid.lambda),
                  .condition = grid.condition,
                  .quadrature = fmt::format("N = {}", samples)};
  // Where nothing touches, the sampled integral is exact.
  refined.exact = grid.solved && refined.data.lambda.norm() == 0.0;
  if (!grid.solved || refined.exact || setup.settings.quadrature != Quadrature::exact) return refined;
  const ExactProjection projected =
      project_exactly(equations, grid.lambda, {.samples = samples, .tolerance = setup.settings.tolerance});
  refined.exact = projected.converged;
  refined.quadrature +=
      refined.exact ? ", contact integral exact" : ", contact integral sampled: no exact one nearby";
  if (!refined.exact) return refined;
  count_iterations(projected.iterations, work);
  refined.data = series_data(equations, projected.lambda);
  if (projected.condition) refined.condition = projected.condition;
  return refined;
}

}  // namespace

SampleLadder::SampleLadder(int harmonics, std::optional<int> fixed, Quadrature quadrature)
    : quadrature_(quadrature),
      samples_(fixed.value_or(
          std::max(kCoarseSampling * kFewestOnGrid,
                   (quadrature == Quadrature::exact ? kCoarseSampling : kSampled) * harmonics))),
      trusted_(kSampled * harmonics),
      finest_(fixed ? 0 : kFinest * harmonics) {}

bool SampleLadder::accepts(bool exact, double net_work) const {
  return exact || quadrature_ == Quadrature::sampled || net_work <= kEnergyIdentity;
}

bool SampleLadder::refine(bool converged, bool exact, double net_work) {
  const bool sampled_well = samples_ >= trusted_ && net_work <= kEnergyIdentity;
  if ((converged && (exact || sampled_well)) || 2 * samples_ > finest_) return false;
  samples_ *= 2;
  return true;
}

Solution solve_on_grids(const HarmonicSetup& setup, const Start& start, Work& work) {
  const HarmonicSettings& settings = setup.settings;
  const int harmonics = setup.receptance.harmonics();
  SampleLadder ladder(harmonics, settings.samples, settings.quadrature);
  Solution solution;
  Eigen::MatrixXcd previous;
  while (true) {
    const int samples = ladder.samples();
    const GridSolution grid = setup.grid_solver->solve(setup.equations(), samples, previous, start, work);
    Refined refined = refine_quadrature(setup, grid, samples, work);
    const double ratio = net_work_ratio(refined.data.x, refined.data.lambda);
    const bool in_limit = settings.limit == 0 || steps_spent(work) <= settings.limit;
    const bool accepted = grid.solved && in_limit && ladder.accepts(refined.exact, ratio);
    solution.verdict = accepted ? Verdict::converged : Verdict::not_converged;
    solution.residual = grid.residual;
    solution.condition = refined.condition;
    solution.message =
        fmt::format("{}; {}, net contact work {:.1e} of that exchanged",
                    in_limit ? grid.message : describe(LcpStatus::limit), refined.quadrature, ratio);
    if (grid.lambda.allFinite())
      solution.trajectory = std::make_shared<FourierTrajectory>(std::move(refined.data));
    if (!in_limit || !grid.finer_may_help || !ladder.refine(grid.solved, refined.exact, ratio))
      return solution;
    if (grid.solved) previous = grid.lambda;
  }
}

}  // namespace signorini
