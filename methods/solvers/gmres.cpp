#include "methods/solvers/gmres.hpp"

#include <Eigen/Jacobi>
#include <cmath>
#include <vector>

#include "methods/solvers/condition_estimate.hpp"

namespace signorini {

KrylovSolve solve_by_gmres(const LinearOperator& product, const LinearOperator& precondition,
                           const Eigen::VectorXd& b, double tolerance) {
  const double norm = b.norm();
  if (!std::isfinite(norm)) return {};
  if (norm == 0.0) return {.x = Eigen::VectorXd::Zero(b.size())};
  const Eigen::Index size = b.size();
  std::vector<Eigen::VectorXd> basis{b / norm};
  std::vector<Eigen::VectorXd> columns;  // of R, after the rotations
  std::vector<Eigen::JacobiRotation<double>> rotations;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(size + 1);
  rhs[0] = norm;
  Eigen::Index used = 0;
  while (used < size && std::abs(rhs[used]) > tolerance * norm) {
    // Arnoldi's step, A M^{-1} V_k = V_{k+1} H_k. The second pass restores the orthogonality that
    // cancellation in the first one costs; without it the residual below is no longer that of the recurrence.
    Eigen::VectorXd next = product(precondition(basis.back()));
    Eigen::VectorXd column = Eigen::VectorXd::Zero(used + 2);
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index k = 0; k <= used; ++k) {
        const double overlap = basis[static_cast<std::size_t>(k)].dot(next);
        column[k] += overlap;
        next -= overlap * basis[static_cast<std::size_t>(k)];
      }
    }
    const double rest = next.norm();
    column[used + 1] = rest;
    if (!std::isfinite(rest)) return {};
    // H_k = Q R by one new rotation; the last entry of Q^T |b| e_1 is the norm of the residual, without
    // forming it.
    for (Eigen::Index k = 0; k < used; ++k) {
      column.applyOnTheLeft(k, k + 1, rotations[static_cast<std::size_t>(k)].adjoint());
    }
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[used], column[used + 1]);
    column.applyOnTheLeft(used, used + 1, rotation.adjoint());
    rhs.applyOnTheLeft(used, used + 1, rotation.adjoint());
    rotations.push_back(rotation);
    columns.push_back(column);
    ++used;
    if (rest == 0.0) break;  // the Krylov space is exhausted: the solution lies in it
    basis.emplace_back(next / rest);
  }
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(used, used);
  Eigen::VectorXd weights = rhs.head(used);
  Eigen::VectorXd combination = Eigen::VectorXd::Zero(size);
  for (Eigen::Index k = used - 1; k >= 0; --k) {
    const Eigen::VectorXd& column = columns[static_cast<std::size_t>(k)];
    triangle.col(k).head(k + 1) = column.head(k + 1);
    weights[k] /= column[k];
    weights.head(k) -= weights[k] * column.head(k);
    combination += weights[k] * basis[static_cast<std::size_t>(k)];
  }
  KrylovSolve solve{.x = precondition(combination), .condition = triangular_condition(triangle)};
  // The recurrence may promise more than rounding keeps; the true residual decides.
  const double residual = (b - product(solve.x)).norm();
  if (!(residual <= std::max(10.0 * tolerance, 1e-8) * norm)) return {};
  return solve;
}

}  // namespace signorini
