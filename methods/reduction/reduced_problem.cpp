#include "methods/reduction/reduced_problem.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// Least eigenvalue of C_m scaled to unit diagonal with which its inverse means anything.
constexpr double kDefinite = 1e-12;

bool is_well_definite(const Eigen::MatrixXd& C) {
  if (!(C.diagonal().minCoeff() > 0.0)) return false;
  const Eigen::VectorXd unit = C.diagonal().cwiseSqrt().cwiseInverse();
  return symmetric_eigenvalues(unit.asDiagonal() * C * unit.asDiagonal()).minCoeff() > kDefinite;
}

Structure structure_of(const ContactReduction& reduction, const Eigen::MatrixXd& G) {
  const Eigen::Index vectors = reduction.vectors(), contacts = reduction.contacts();
  const Eigen::MatrixXd pulled = product(reduction.rows, G);
  Eigen::MatrixXd K(vectors + contacts, vectors + contacts);
  K.topLeftCorner(vectors, vectors) = product_by_transposed(pulled, reduction.rows);
  K.topRightCorner(vectors, contacts) = -pulled;
  K.bottomLeftCorner(contacts, vectors) = -pulled.transpose();
  K.bottomRightCorner(contacts, contacts) = G;
  K.diagonal().head(vectors) += reduction.squares;
  const Eigen::MatrixXd symmetric = 0.5 * (K + K.transpose());
  Structure structure;
  structure.stiffness = symmetric.sparseView();
  structure.mass = SparseMatrix(vectors + contacts, vectors + contacts);
  for (Eigen::Index k = 0; k < vectors; ++k) structure.mass.insert(k, k) = 1.0;
  structure.mass.makeCompressed();
  structure.damping = reduction.relaxation * structure.stiffness;
  for (Eigen::Index k = 0; k < vectors; ++k)
    structure.damping.coeffRef(k, k) += reduction.damping[k] - reduction.relaxation * reduction.squares[k];
  return structure;
}

}  // namespace

ReducedProblem reduced_problem(const Problem& scene, const ContactReduction& reduction) {
  ReducedProblem result{.obstacle = reduction.obstacle};
  if (result.obstacle.empty() && scene.contacts.empty()) result.obstacle = "it has no contact";
  if (result.obstacle.empty() && has_impacts(scene))
    result.obstacle = "a contact with mass and an impact law is another one in a reduced structure";
  if (result.obstacle.empty() && reduction.relaxation > 0.0 && std::holds_alternative<MixedLaws>(scene.law()))
    result.obstacle = kMixedRelaxing;
  if (result.obstacle.empty() && !is_well_definite(reduction.compliance))
    result.obstacle = "the static residual at the contacts is not definite: fewer vectors are needed";
  if (!result.obstacle.empty()) return result;
  const Eigen::Index contacts = reduction.contacts();
  const auto vectors = static_cast<int>(reduction.vectors());
  const Eigen::MatrixXd G = CholeskyFactors(reduction.compliance).inverse();
  Problem& problem = result.problem;
  problem = scene;
  problem.kind = "matrices";
  problem.structure = std::make_shared<const Structure>(structure_of(reduction, G));
  problem.force.clear();
  for (std::size_t h = 0; h < reduction.rates.size(); ++h) {
    const auto column = static_cast<Eigen::Index>(h);
    Eigen::VectorXcd load(vectors + contacts);
    const Eigen::VectorXcd shifted = image_of_complex(G, reduction.shift.col(column));
    Eigen::VectorXcd of_vectors = reduction.load.col(column);
    subtract_image_of_complex(reduction.rows, shifted, of_vectors);
    load << of_vectors, shifted;
    const auto harmonic = static_cast<int>(std::lround(reduction.rates[h] / scene.frequency));
    for (int dof = 0; dof < load.size(); ++dof) {
      if (load[dof] == 0.0) continue;
      problem.force.push_back({.dof = dof,
                               .harmonic = harmonic,
                               .cos = load[dof].real(),
                               .sin = harmonic == 0 ? 0.0 : 0.0 - load[dof].imag()});
    }
  }
  for (int j = 0; j < static_cast<int>(contacts); ++j)
    problem.contacts[static_cast<std::size_t>(j)].normal = {{vectors + j, 1.0}};
  return result;
}

}  // namespace signorini
