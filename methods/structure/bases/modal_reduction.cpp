#include "methods/structure/bases/modal_reduction.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "methods/structure/bases/structure_modes.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/products.hpp"
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

/// How many modes have mass: they are the last ones.
Eigen::Index count_with_mass(const StructureModes& modes) {
  const Eigen::Index size = modes.mass.size();
  const double least = kEpsilon * static_cast<double>(size) * modes.mass[size - 1];
  Eigen::Index count = 0;
  while (count < size && modes.mass[size - 1 - count] > least) ++count;
  return count;
}

/// From the modes that all who look at the structure share; those without mass follow statically, undamped.
ContactReduction on_shared_modes(const Problem& problem) {
  const LoadColumns load = load_columns(problem);
  if (problem.contacts.empty() && load.columns.empty())
    return ContactReduction::refused("nothing acts on the structure");
  const std::shared_ptr<const StructureModes> modes = uncoupled_modes(problem);
  if (!modes) return ContactReduction::refused("the damping couples modes");
  if (modes->shift > 0.0) return ContactReduction::refused(kNotDefinite);
  const Eigen::Index kept = count_with_mass(*modes), still = modes->mass.size() - kept;
  if (still > 0 && modes->damping.head(still).maxCoeff() > kMatrixRounding * modes->damping.maxCoeff())
    return ContactReduction::refused("motions without mass are damped");
  ContactReduction result;
  result.squares = modes->mass.tail(kept).reverse().cwiseInverse();
  result.damping = modes->damping.tail(kept).reverse().cwiseProduct(result.squares);
  const Eigen::MatrixXd contacts = (contact_directions(problem).transpose() * modes->vectors).transpose();
  const Eigen::MatrixXd pushes =
      (contact_directions(load.columns, problem.size()).transpose() * modes->vectors).transpose();
  const Eigen::VectorXd omega = result.squares.cwiseSqrt();
  result.rows = omega.asDiagonal() * contacts.bottomRows(kept).colwise().reverse();
  result.rates = load.rates;
  result.load =
      product_in_complex(omega.asDiagonal() * pushes.bottomRows(kept).colwise().reverse(), load.weight);
  const Eigen::MatrixXd seen = contacts.topRows(still);
  result.compliance = transposed_product(seen, seen);
  result.shift = product_in_complex(transposed_product(seen, pushes.topRows(still)), load.weight);
  result.complete = true;
  return result;
}

}  // namespace

bool has_shared_modes(const Problem& problem) {
  return problem.size() > kMostModal && problem.size() <= kMostModalCoordinates && has_full_damping(problem);
}

ContactReduction modal_reduction(const Problem& problem) {
  if (has_shared_modes(problem)) return on_shared_modes(problem);
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
