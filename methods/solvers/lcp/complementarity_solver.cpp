#include "methods/solvers/lcp/complementarity_solver.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/lcp/bordered_lcp.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

/// F(y) = max(0, -y) - q - A max(0, y) as a JacobianSystem.
class NormalMap {
 public:
  explicit NormalMap(const Lcp& lcp) : lcp_(lcp) {}

  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& y) {
    y_ = y;
    Eigen::VectorXd gaps = (-y).cwiseMax(0.0);
    gaps.tail(2 * lcp_.free).setZero();  // balances are equations
    return gaps - lcp_.offset - *lcp_.matrix * y.cwiseMax(0.0);
  }

  /// y - y_new. With the active set S = {y > 0} frozen, F is linear and its zero is A_SS z_S = -q_S, y = z on
  /// S and y = -w = -(q + A z) off it. Empty where A_SS is singular, or GMRES fails on it.
  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& /*r*/) {
    ++factorisations_;
    std::vector<int> active;
    const auto contacts = static_cast<int>(lcp_.contact_unknowns());
    for (int i = 0; i < contacts; ++i) {
      if (y_[i] > 0.0) active.push_back(i);
    }
    for (int i = 0; i < lcp_.free; ++i) active.push_back(contacts + i);
    if (active.empty()) return {.x = y_ + lcp_.offset, .condition = std::nullopt};
    const KrylovSolve held = solve_held(active, -lcp_.offset(active));
    if (held.x.size() == 0 || !held.x.allFinite()) return {};
    Eigen::VectorXd zero = -(lcp_.offset + *lcp_.matrix * spread(active, held.x));
    zero(active) = held.x;
    zero.tail(lcp_.free) = -held.x.tail(lcp_.free);  // y = (a, -a): a+ and a- are its positive parts
    return {.x = y_ - zero, .condition = held.condition};
  }

  /// Both the complementarity residual of z = max(0, y) and F itself must be small: F = 0 alone is relative
  /// to y, which may be far larger than z where contact is loose.
  [[nodiscard]] double error(const Eigen::VectorXd& y, const Eigen::VectorXd& value) {
    natural_residual_ = natural_residual(lcp_, y.cwiseMax(0.0));
    const double scale = std::max(lcp_.offset.lpNorm<Eigen::Infinity>(), y.lpNorm<Eigen::Infinity>());
    const double largest = value.lpNorm<Eigen::Infinity>();
    return std::max(natural_residual_, largest > 0.0 ? largest / scale : 0.0);
  }

  /// Of the iterate that `error` was asked for last.
  [[nodiscard]] double last_natural_residual() const { return natural_residual_; }
  [[nodiscard]] long factorisations() const { return factorisations_; }

 private:
  // Unknowns up to which A_SS is factorised: as many as make a factorisation cost what GMRES does.
  static constexpr std::size_t kMostDense = 600;
  static constexpr Eigen::Index kMostKrylov = 300;  // vectors of a Krylov space

  /// Zero off S.
  [[nodiscard]] Eigen::VectorXd spread(const std::vector<int>& active, const Eigen::VectorXd& held) const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(y_.size());
    z(active) = held;
    return z;
  }

  /// A_SS z = b. By GMRES, (A^{-1})_SS stands for the inverse: exact where S is everything, and elsewhere up
  /// to a few dimensions for each end of an interval of contact.
  [[nodiscard]] KrylovSolve solve_held(const std::vector<int>& active, const Eigen::VectorXd& b) const {
    if (active.size() <= kMostDense || lcp_.free > 0) return factorised(active, b);
    const auto product = [&](const Eigen::VectorXd& v) {
      return Eigen::VectorXd((*lcp_.matrix * spread(active, v))(active));
    };
    const auto precondition = [&](const Eigen::VectorXd& v) {
      return Eigen::VectorXd(lcp_.matrix->solve(spread(active, v))(active));
    };
    KrylovSolve held = solve_by_gmres(product, precondition, b, kKrylovTolerance, kMostKrylov);
    if (held.x.size() == 0) return b.size() <= kMostByFactors ? factorised(active, b) : KrylovSolve{};
    // What GMRES leaves of a badly scaled system Newton's method would leave too: it solves for all of z.
    const Eigen::VectorXd rest = b - product(held.x);
    if (rest.norm() > kKrylovTolerance * b.norm()) {
      const KrylovSolve refined = solve_by_gmres(product, precondition, rest, 1e-4, kMostKrylov);
      if (refined.x.size() > 0) held.x += refined.x;
    }
    return held;
  }

  [[nodiscard]] KrylovSolve factorised(const std::vector<int>& active, const Eigen::VectorXd& b) const {
    const LuFactors lu(lcp_.matrix->submatrix(active, active));
    return {.x = lu.solve(b), .condition = condition_from(lu.reciprocal_condition())};
  }

  const Lcp& lcp_;
  Eigen::VectorXd y_;  // whose residual was asked for last
  double natural_residual_ = 0.0;
  long factorisations_ = 0;
};

LcpStatus status_of(NewtonEnd end) {
  // In the order of NewtonEnd: solved, limit, interrupted, singular, stalled.
  constexpr std::array kStatus{LcpStatus::solved, LcpStatus::limit, LcpStatus::interrupted,
                               LcpStatus::breakdown, LcpStatus::stalled};
  return kStatus[static_cast<std::size_t>(end)];
}

/// Where the guess presses, y = z; elsewhere y = -w. Without a guess the contact-free response, z = 0.
Eigen::VectorXd first_iterate(const Lcp& lcp, const Eigen::VectorXd& guess) {
  if (guess.size() != lcp.offset.size()) {
    Eigen::VectorXd y = -lcp.offset;
    y.tail(2 * lcp.free).setZero();
    return y;
  }
  Eigen::VectorXd y = (guess.array() > 0.0).select(guess, -(lcp.offset + *lcp.matrix * guess));
  const Eigen::Index n = lcp.contact_unknowns();
  y.tail(lcp.free) = guess.tail(lcp.free) - guess.segment(n, lcp.free);
  y.segment(n, lcp.free) = -y.tail(lcp.free);
  return y;
}

// Covering vectors of the restarts, (amplitude, phase) of their wave: the stronger, the more different the
// path from the first, constant one.
constexpr std::array kRestarts{std::pair{0.03, 1.6}, std::pair{0.03, 4.7}, std::pair{0.3, 3.1},
                               std::pair{0.3, 0.0}};

/// Whether another covering vector may help. A path that ran out of pivots wanders through many solutions;
/// with another cover it would wander as long.
bool worth_a_restart(const LcpResult& result) {
  return result.status == LcpStatus::ray || result.status == LcpStatus::breakdown;
}

}  // namespace

std::optional<LcpResult> permanent_contact(const Lcp& lcp, double tolerance) {
  for (int c = 0; c < lcp.contacts(); ++c) {
    // Open on average: no need to solve, unless the mean is free.
    if (lcp.free == 0 && !(lcp.offset.segment(c * lcp.samples, lcp.samples).sum() < 0.0)) return std::nullopt;
  }
  LcpResult result;
  result.z = lcp.matrix->solve(-lcp.offset);
  if (!result.z.allFinite() || !(result.z.head(lcp.contact_unknowns()).minCoeff() > 0.0)) return std::nullopt;
  result.residual = natural_residual(lcp, result.z);
  if (!(result.residual <= tolerance)) return std::nullopt;
  result.status = LcpStatus::solved;
  return result;
}

LcpResult solve_by_newton(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess) {
  return solve_by_newton_from(lcp, settings, first_iterate(lcp, guess));
}

LcpResult solve_by_newton_from(const Lcp& lcp, const SolverSettings& settings, Eigen::VectorXd y) {
  NormalMap equations(lcp);
  DampedNewtonLimits limits{.deadline = settings.deadline};
  if (settings.max_iterations > 0) limits.max_steps = settings.max_iterations;
  const NewtonKrylovResult newton = solve_newton_krylov(equations, std::move(y), settings.tolerance, limits);
  return {.status = status_of(newton.end),
          .z = newton.unknowns.cwiseMax(0.0),
          .residual = equations.last_natural_residual(),
          .iterations = newton.iterations,
          .factorisations = equations.factorisations(),
          .condition = newton.condition};
}

LcpResult solve_lcp(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& contacts_guess) {
  const Eigen::VectorXd guess = with_free_unknowns(lcp, contacts_guess);
  if (settings.solver == ComplementaritySolver::newton) return solve_by_newton(lcp, settings, guess);
  const bool automatic = settings.solver == ComplementaritySolver::automatic;
  const bool warm = guess.size() > 0;
  if (automatic && !warm) {
    if (std::optional<LcpResult> pressed = permanent_contact(lcp, settings.tolerance))
      return *std::move(pressed);
  }
  LcpResult result = solve_by_pivoting(lcp, settings, guess);
  const auto try_cold = [&](const SolverSettings& path) {
    const long before = result.pivots;
    result = solve_by_pivoting(lcp, path);
    result.pivots += before;
  };
  if (warm && result.status != LcpStatus::solved) try_cold(settings);
  if (!automatic) return result;
  SolverSettings path = settings;
  for (const auto& [amplitude, phase] : kRestarts) {
    if (!worth_a_restart(result)) break;
    path.cover_amplitude = amplitude;
    path.cover_phase = phase;
    try_cold(path);
  }
  return result;
}

}  // namespace signorini
