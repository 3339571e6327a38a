#include "methods/aft_hbm/aft_grid_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/complementarity/forms.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

constexpr int kNewtonSteps = 100;
// Cold, Newton converges at once or creeps (of the one-mass population it solves no scene): the
// homotopy takes over early.
constexpr int kColdSteps = 5;

class AftGridSolver final : public GridSolver {
 public:
  AftGridSolver(const SolverSettings& settings, bool homotopy) : settings_(settings), homotopy_(homotopy) {}

  [[nodiscard]] Work initial_counts() const override { return {.iterations = 0}; }

  [[nodiscard]] GridSolution solve(const ProjectedEquations& equations, int samples,
                                   const Eigen::MatrixXcd& previous, const Start& start,
                                   Work& work) const override {
    AftResidual residual(equations, samples);
    const bool cold = previous.size() == 0 && !start.guess;
    NewtonKrylovResult newton =
        newton_from(first_iterate(residual, equations, previous, start),
                    cold && homotopy_ ? kColdSteps : kNewtonSteps, residual, start, work);
    const auto converged = [&] { return newton.end == NewtonEnd::solved; };
    GridSolution solution{.message = converged() ? "Newton-Krylov" : "Newton-Krylov found no descent"};
    if (!converged() && homotopy_ && !is_spent(settings_.max_iterations, work))
      newton = from_homotopy(std::move(newton), residual, equations, start, work, solution.message);
    solution.solved = converged();
    // Newton alone that has lost its way is not helped by more samples.
    solution.finer_may_help = (converged() || homotopy_) && !start.expired();
    solution.lambda = residual.coefficients(newton.unknowns);
    solution.residual = newton.residual;
    solution.condition = newton.condition;
    return solution;
  }

 private:
  static Eigen::VectorXd first_iterate(const AftResidual& residual, const ProjectedEquations& equations,
                                       const Eigen::MatrixXcd& previous, const Start& start) {
    if (previous.size() > 0) return residual.unknowns_of(previous);
    if (start.guess)
      return residual.unknowns_of(force_spectrum(*start.guess, equations.receptance.harmonics()));
    return Eigen::VectorXd::Zero(residual.unknowns());
  }

  /// One run of Newton's method. The equations are piecewise linear: near a solution one full step ends it.
  [[nodiscard]] NewtonKrylovResult newton_from(Eigen::VectorXd lambda, int steps, AftResidual& residual,
                                               const Start& start, Work& work) const {
    const int allowed = settings_.max_iterations > 0 ? std::min(settings_.max_iterations, steps) : steps;
    NewtonKrylovResult newton =
        solve_newton_krylov(residual, std::move(lambda), settings_.tolerance,
                            {.max_steps = allowed, .max_halvings = 16, .deadline = start.deadline});
    count_iterations(newton.iterations, work);
    return newton;
  }

  /// Newton's method from the end of the gap homotopy, or `failed` where that has none.
  [[nodiscard]] NewtonKrylovResult from_homotopy(NewtonKrylovResult failed, AftResidual& residual,
                                                 const ProjectedEquations& equations, const Start& start,
                                                 Work& work, std::string& message) const {
    const auto& [receptance, gap, law] = equations;
    SolverSettings settings = settings_;
    settings.deadline = start.deadline;
    if (settings.max_iterations > 0) settings.max_iterations -= static_cast<int>(steps_spent(work));
    Lcp lcp = projected_lcp(receptance, gap, law, residual.samples());
    const LcpResult path = solve_lcp(lcp, settings);
    work.pivots = work.pivots.value_or(0) + path.pivots;
    message = fmt::format("gap homotopy: {}", describe(path.status));
    if (path.status != LcpStatus::solved) return failed;
    const Eigen::MatrixXcd lambda =
        force_coefficients(law, path.z, residual.samples(), receptance.harmonics());
    NewtonKrylovResult newton =
        newton_from(residual.unknowns_of(lambda), kNewtonSteps, residual, start, work);
    if (!newton.condition) newton.condition = path.condition;  // no step was needed
    message = "gap homotopy and Newton-Krylov";
    return newton;
  }

  SolverSettings settings_;
  bool homotopy_;
};

}  // namespace

AftResidual::AftResidual(const ProjectedEquations& equations, int samples)
    : symbol_(equations.receptance, equations.law),
      samples_(samples),
      free_(free_penetration(equations.receptance.free_response, equations.gap, symbol_.root(), samples)),
      fft_(samples) {
  load_scale_ = std::sqrt(free_.cwiseMax(0.0).squaredNorm() / samples_);
}

Eigen::VectorXd AftResidual::gap_rate(const Eigen::VectorXd& v) {
  const Eigen::MatrixXcd spectrum = symbol_.rate(v);
  Eigen::VectorXd signal(samples_ * contacts());
  for (int c = 0; c < contacts(); ++c) fft_.inverse(spectrum.col(c), signal.segment(c * samples_, samples_));
  return signal;
}

Eigen::VectorXd AftResidual::project(const Eigen::VectorXd& signal) {
  Eigen::MatrixXcd spectrum(symbol_.harmonics() + 1, contacts());
  Eigen::VectorXcd full(fft_.coefficients());
  for (int c = 0; c < contacts(); ++c) {
    fft_.forward(signal.segment(c * samples_, samples_), full);
    spectrum.col(c) = full.head(symbol_.harmonics() + 1);
  }
  return pack_harmonics(spectrum);
}

Eigen::VectorXd AftResidual::residual(const Eigen::VectorXd& lambda) {
  const Eigen::VectorXd y = free_ + gap_rate(lambda);
  in_contact_ = y.array() > 0.0;
  return lambda + project(y.cwiseMax(0.0));
}

Eigen::VectorXd AftResidual::product(const Eigen::VectorXd& v) {
  Eigen::VectorXd signal = gap_rate(v);
  signal = in_contact_.select(signal, 0.0);
  return v + project(signal);
}

std::vector<ContactNodes> AftResidual::nodes() const {
  std::vector<ContactNodes> nodes(static_cast<std::size_t>(contacts()));
  const double step = 1.0 / samples_;
  for (int c = 0; c < contacts(); ++c) {
    const auto pressed = in_contact_.segment(c * samples_, samples_);
    ContactNodes& own = nodes[static_cast<std::size_t>(c)];
    own.time.resize(pressed.count());
    own.weight.setConstant(pressed.count(), step);
    Eigen::Index place = 0;
    for (int i = 0; i < samples_; ++i) {
      if (pressed[i]) own.time[place++] = i * step;
    }
  }
  return nodes;
}

KrylovSolve AftResidual::solve_jacobian(const Eigen::VectorXd& r) {
  JacobianSolver::Contacts pressing{.nodes = in_contact_.count(),
                                    .duty = Eigen::VectorXd(contacts()),
                                    .place = [this] { return nodes(); },
                                    .product = [this](const Eigen::VectorXd& v) { return product(v); }};
  for (int c = 0; c < contacts(); ++c)
    pressing.duty[c] = static_cast<double>(in_contact_.segment(c * samples_, samples_).count()) / samples_;
  return solver_.solve(symbol_, pressing, r);
}

double AftResidual::error(const Eigen::VectorXd& lambda, const Eigen::VectorXd& r) const {
  const double scale = std::max(load_scale_, (r - lambda).norm());
  return scale > 0.0 ? r.norm() / scale : 0.0;
}

Eigen::MatrixXcd AftResidual::coefficients(const Eigen::VectorXd& lambda) const {
  return unpack_harmonics(lambda, symbol_.harmonics()) * symbol_.root().asDiagonal();
}

Eigen::VectorXd AftResidual::unknowns_of(const Eigen::MatrixXcd& coefficients) const {
  return pack_harmonics(coefficients * symbol_.root().cwiseInverse().asDiagonal());
}

std::unique_ptr<GridSolver> aft_grid_solver(const SolverSettings& settings, bool homotopy) {
  return std::make_unique<AftGridSolver>(settings, homotopy);
}

}  // namespace signorini
