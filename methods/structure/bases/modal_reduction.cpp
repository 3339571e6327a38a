#include "methods/structure/bases/modal_reduction.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

/// Whether a symmetric matrix in modal coordinates is its diagonal, which may not be negative.
bool is_decoupled(const Eigen::MatrixXd& D) {
  constexpr double kCoupling = 1e-9, kRounding = 1e-14;
  const double floor = kRounding * D.diagonal().cwiseAbs().maxCoeff();
  if (!(D.diagonal().minCoeff() >= -floor)) return false;
  const Eigen::VectorXd root = D.diagonal().cwiseMax(0.0).cwiseSqrt();
  for (Eigen::Index j = 0; j < D.cols(); ++j) {
    for (Eigen::Index k = 0; k < D.rows(); ++k)
      if (j != k && !(std::abs(D(k, j)) <= kCoupling * root[j] * root[k] + floor)) return false;
  }
  return true;
}

}  // namespace

ContactReduction modal_reduction(const Problem& problem) {
  CondensedStructure whole = condense(problem, kMostModal);
  if (!whole.obstacle.empty()) return ContactReduction::refused(whole.obstacle);
  if (whole.normals.cols() == 0 && whole.load.isZero(0.0))
    return ContactReduction::refused("nothing acts on the structure");
  if (!is_symmetric(whole.damping) || !is_symmetric(whole.stiffness))
    return ContactReduction::refused("the matrices are not symmetric");
  const Eigen::MatrixXd K(whole.stiffness), M(whole.mass);
  if (!CholeskyFactors(K).definite()) return ContactReduction::refused(kNotDefinite);
  const SymmetricEigen modes = generalised_eigen(M, K);
  const Eigen::VectorXd theta = modes.values.reverse();  // falling: the lowest mode first
  if (!modes.converged || !(theta.minCoeff() > 0.0))
    return ContactReduction::refused("the mass matrix is singular on the coordinates with mass");
  // phi^T K phi = 1 in the solver's scale.
  const Eigen::MatrixXd phi =
      modes.vectors.rowwise().reverse() * theta.cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd D = phi.transpose() * (whole.damping * phi);
  if (!is_decoupled(D)) return ContactReduction::refused("the damping couples modes");
  ContactReduction result;
  result.damping = D.diagonal().cwiseMax(0.0);
  if (whole.relaxation.size() > 0) result.relaxation = whole.relaxation.maxCoeff();
  for (const double beta : whole.relaxation)
    if (beta > 0.0 && beta != result.relaxation)
      return ContactReduction::refused("contacts relax in different times");
  result.squares = theta.cwiseInverse();
  result.rows = (whole.normals.transpose() * phi).transpose();
  result.compliance = std::move(whole.massless_compliance);
  result.rates = std::move(whole.rates);
  result.load = phi.transpose().cast<std::complex<double>>() * whole.load;
  result.shift = std::move(whole.shift);
  result.complete = true;
  return result;
}

}  // namespace signorini
