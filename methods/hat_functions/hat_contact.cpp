#include "methods/hat_functions/hat_contact.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/free_penetration.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/hat_functions/period_marching.hpp"
#include "methods/solvers/newton.hpp"
#include "methods/structure/periodic_response.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// Pivots per unknown after which a path counts as long: scenes without chatter need one to two.
constexpr int kShortPath = 4;
constexpr int kLongPath = 100;
constexpr int kMarchedPeriods = 300;

int bounded_pivots(int per_unknown, long unknowns) {
  return static_cast<int>(std::min<long>(per_unknown * unknowns, std::numeric_limits<int>::max()));
}

class PreparedHat final : public PreparedMethod {
 public:
  PreparedHat(const Problem& problem, const HatSettings& options, std::optional<double> restitution)
      : problem_(problem),
        options_(options),
        receptance_(contact_receptance(problem, options.samples / 2,
                                       [&](int n) {
                                         return scheme_weights(options.scheme, angle(n),
                                                               problem.period() / options.samples);
                                       })),
        gap_(contact_gaps(problem)),
        restitution_(restitution) {
    compliance_ = Eigen::VectorXd::Zero(problem.contact_count());
    if (const auto* stop = std::get_if<Penalty>(&problem.law)) {
      compliance_ =
          Eigen::Map<const Eigen::VectorXd>(stop->stiffness.data(), compliance_.size()).cwiseInverse();
    }
  }

  Solution solve(const Start& start) override {
    if (receptance_.contacts() == 0) return finish(Eigen::VectorXd{}, {.status = LcpStatus::solved});
    const Eigen::VectorXd scale = force_scale();
    Lcp lcp = assemble(scale);
    const LcpResult result =
        solve_scaled(lcp, scale, start,
                     start.guess ? pressure_samples(*start.guess, samples(), scale) : Eigen::VectorXd{});
    Eigen::VectorXd pressure = result.z;
    for (int c = 0; c < receptance_.contacts(); ++c) pressure.segment(c * samples(), samples()) *= scale[c];
    return finish(pressure, result);
  }

 private:
  [[nodiscard]] int samples() const { return options_.samples; }
  [[nodiscard]] double angle(int n) const { return 2.0 * std::numbers::pi * n / options_.samples; }

  /// Unit of z per contact, 1 / sqrt(|lag 0 of A|): makes the diagonal of the scaled problem of order one.
  [[nodiscard]] Eigen::VectorXd force_scale() const {
    Eigen::VectorXd lag = compliance_;
    for (int n = 0; n <= samples() / 2; ++n) {
      const bool single = n == 0 || 2 * n == samples();
      const Complex shift = restitution_shift(restitution_, angle(n));
      const auto& block = receptance_.receptance[static_cast<std::size_t>(n)];
      lag += (single ? 1.0 : 2.0) / samples() * (shift * block.diagonal()).real();
    }
    double largest = lag.cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) largest = 1.0;
    // A contact whose own lag vanishes by accident borrows the scale of the others.
    return lag.cwiseAbs().cwiseMax(1e-3 * largest).cwiseSqrt().cwiseInverse();
  }

  [[nodiscard]] Lcp assemble(const Eigen::VectorXd& scale) const {
    std::vector<Eigen::MatrixXcd> symbol;
    symbol.reserve(receptance_.receptance.size());
    Eigen::MatrixXcd free(receptance_.free_response.rows(), receptance_.contacts());
    for (int n = 0; n <= receptance_.harmonics(); ++n) {
      const Complex shift = restitution_shift(restitution_, angle(n));
      symbol.emplace_back(shift * (scale.asDiagonal() * receptance_.receptance[static_cast<std::size_t>(n)] *
                                   scale.asDiagonal()));
      symbol.back().diagonal() += (compliance_.array() * scale.array().square()).matrix();
      free.row(n) = shift * receptance_.free_response.row(n);
    }
    return {BlockCirculant(samples(), symbol), -free_penetration(free, gap_, scale, samples())};
  }

  /// The solver asked for; with `auto`, a path of pivots that grows long (chatter: as many solutions as
  /// bounces) gives way to marching in time, and is followed to its end only if that fails too.
  LcpResult solve_scaled(Lcp& lcp, const Eigen::VectorXd& scale, const Start& start,
                         const Eigen::VectorXd& guess) {
    SolverSettings settings{options_.solver, options_.tolerance, options_.max_iterations, start.deadline};
    settings.cover_amplitude = options_.cover_amplitude;
    settings.cover_phase = options_.cover_phase;
    if (options_.solver != ComplementaritySolver::automatic) return solve_lcp(lcp, settings, guess);
    const int shortest = bounded_pivots(kShortPath, lcp.matrix.size());
    if (options_.max_iterations == 0 || options_.max_iterations > shortest)
      settings.max_iterations = shortest;
    LcpResult result = solve_lcp(lcp, settings, guess);
    if (result.status != LcpStatus::limit || settings.max_iterations == options_.max_iterations)
      return result;
    const long spent = result.pivots;
    NewtonOptions newton{.tolerance = options_.tolerance, .deadline = start.deadline};
    newton.guess = march_to_period(problem_, options_, restitution_.value_or(0.0), kMarchedPeriods, start);
    if (newton.guess.size() > 0) {
      for (int c = 0; c < receptance_.contacts(); ++c)
        newton.guess.segment(c * samples(), samples()) /= scale[c];
      result = solve_by_newton(lcp, newton);
    }
    if (result.status != LcpStatus::solved) {
      settings.max_iterations = options_.max_iterations > 0 ? options_.max_iterations
                                                            : bounded_pivots(kLongPath, lcp.matrix.size());
      result = solve_lcp(lcp, settings);
    }
    result.pivots += spent;
    return result;
  }

  /// Nodal motion behind the nodal pressures -lambda >= 0 [N].
  [[nodiscard]] Solution finish(const Eigen::VectorXd& pressure, const LcpResult& result) const {
    const int contacts = receptance_.contacts();
    RealFft fft(samples());
    Eigen::MatrixXcd spectrum(fft.coefficients(), contacts);
    Eigen::MatrixXd force(samples(), contacts);
    for (int c = 0; c < contacts; ++c) {
      force.col(c) = -pressure.segment(c * samples(), samples());
      fft.forward(force.col(c), spectrum.col(c));
    }
    Eigen::MatrixXd x(samples(), contacts);
    if (contacts > 0) spectrum = contact_motion(receptance_, spectrum);
    for (int c = 0; c < contacts; ++c) fft.inverse(spectrum.col(c), x.col(c));
    Solution solution;
    const bool finite = x.allFinite() && force.allFinite();
    solution.verdict =
        finite && result.status == LcpStatus::solved ? Verdict::converged : Verdict::not_converged;
    solution.message = contacts == 0 ? "no contact in the scene: linear response" : describe(result.status);
    solution.residual = result.residual;
    solution.condition = result.condition;
    solution.work.unknowns = samples() * contacts;
    if (options_.solver == ComplementaritySolver::newton) {
      solution.work.iterations = result.iterations;
      solution.work.factorisations = result.factorisations;
    } else {
      solution.work.pivots = result.pivots;
    }
    if (finite) {
      solution.trajectory =
          std::make_shared<NodalTrajectory>(receptance_.period, std::move(x), std::move(force));
    }
    return solution;
  }

  const Problem& problem_;
  HatSettings options_;
  ContactReceptance receptance_;
  Eigen::VectorXd gap_;
  Eigen::VectorXd compliance_;
  std::optional<double> restitution_;
};

}  // namespace

std::unique_ptr<PreparedMethod> hat_contact(const Problem& problem, const HatSettings& settings,
                                            std::optional<double> restitution) {
  return std::make_unique<PreparedHat>(problem, settings, restitution);
}

}  // namespace signorini
