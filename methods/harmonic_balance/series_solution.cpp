#include "methods/harmonic_balance/series_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>

#include "methods/solvers/lcp/lcp.hpp"
#include "methods/structure/mean_balance.hpp"

namespace signorini {

namespace {

// Where the exact contact integral follows, kCoarseSampling will do: it decides the path, not the answer.
int coarsest_grid(int harmonics, Quadrature quadrature) {
  const int per_harmonic = quadrature == Quadrature::exact ? kCoarseSampling : kSampledPerHarmonic;
  return std::max(kCoarseSampling * kFewestOnGrid, per_harmonic * harmonics);
}

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
  if (!grid.solved || refined.exact || setup.options.contact_integral() != Quadrature::exact) return refined;
  const ExactProjection projected =
      project_exactly(equations, grid.lambda, {.samples = samples, .tolerance = setup.options.tolerance});
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

double net_work_ratio(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda) {
  double net = 0.0;
  double exchanged = 0.0;
  for (Eigen::Index n = 1; n < x.rows(); ++n) {
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      // Re(conj(lambda) i x) = Im(conj(x) lambda); 2 T w is common to both sums.
      const double order = static_cast<double>(n);
      net += order * std::imag(std::conj(x(n, c)) * lambda(n, c));
      exchanged += order * std::abs(x(n, c)) * std::abs(lambda(n, c));
    }
  }
  return exchanged > 0.0 ? std::abs(net) / exchanged : 0.0;
}

FourierTrajectory::Data series_data(const ProjectedEquations& equations, Eigen::MatrixXcd lambda) {
  Eigen::MatrixXcd x = carried_motion(equations.receptance, lambda);
  return {equations.receptance.period,
          std::move(x),
          balanced_force(equations.receptance, lambda),
          equations.gap,
          equations.law.constant,
          equations.law.multiplier_weight};
}

Solution exact_solution(const ProjectedEquations& equations, const ExactProjection& solved,
                        const std::string& how) {
  FourierTrajectory::Data data = series_data(equations, solved.lambda);
  const double ratio = net_work_ratio(data.x, data.lambda);
  return {.verdict = Verdict::converged,
          .message = fmt::format("{}; contact integral exact, net contact work {:.1e} of that exchanged", how,
                                 ratio),
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .residual = solved.residual,
          .condition = solved.condition};
}

Solution contact_free_response(const ContactReceptance& receptance) {
  FourierTrajectory::Data data;
  data.period = receptance.period;
  data.x = receptance.free_response;
  data.lambda = data.x;  // no columns: there is no contact
  return {.verdict = Verdict::converged,
          .message = "no contact in the scene: linear response",
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .work = {.unknowns = 0},
          .residual = 0.0};
}

Solution solve_on_grids(const HarmonicSetup& setup, const Start& start, Work& work, Eigen::MatrixXcd near) {
  const HarmonicOptions& options = setup.options;
  const int harmonics = setup.receptance.harmonics();
  const bool sampled = options.contact_integral() == Quadrature::sampled;
  const std::optional<int> fixed = options.fixed_samples(harmonics);
  const int finest = fixed ? 0 : 4 * kSampledPerHarmonic * harmonics;
  Solution solution;
  for (int samples = fixed.value_or(coarsest_grid(harmonics, options.contact_integral()));; samples *= 2) {
    const GridSolution grid = setup.method.grid_solver(setup.equations(), samples, near, start, work);
    Refined refined = refine_quadrature(setup, grid, samples, work);
    const double ratio = net_work_ratio(refined.data.x, refined.data.lambda);
    const bool in_limit = options.max_iterations == 0 || steps_spent(work) <= options.max_iterations;
    const bool identity = ratio <= 1e-3;  // good enough of a sampled answer
    const bool accepted = grid.solved && in_limit && (refined.exact || sampled || identity);
    solution.verdict = accepted ? Verdict::converged : Verdict::not_converged;
    solution.residual = grid.residual;
    solution.condition = refined.condition;
    solution.message =
        fmt::format("{}; {}, net contact work {:.1e} of that exchanged",
                    in_limit ? grid.message : describe(LcpStatus::limit), refined.quadrature, ratio);
    if (grid.lambda.allFinite())
      solution.trajectory = std::make_shared<FourierTrajectory>(std::move(refined.data));
    // On few samples the identity may hold by accident.
    const bool settled =
        grid.solved && (refined.exact || (samples >= kSampledPerHarmonic * harmonics && identity));
    if (!in_limit || !grid.finer_may_help || settled || 2 * samples > finest) return solution;
    if (grid.solved) near = grid.lambda;
  }
}

}  // namespace signorini
