#include "methods/reduction/reduced_problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// Whether the inverse of C_m, scaled to unit diagonal, means anything.
bool is_well_definite(const Eigen::MatrixXd& C) {
  if (C.size() == 0) return true;
  if (!(C.diagonal().minCoeff() > 0.0)) return false;
  const Eigen::VectorXd unit = C.diagonal().cwiseSqrt().cwiseInverse();
  return symmetric_eigenvalues(unit.asDiagonal() * C * unit.asDiagonal()).minCoeff() > kMatrixRounding;
}

// The contacts that have a static residual; a spring without one acts on the vectors alone, as where they are
// all of the structure's, or on a part that relaxes (ContactSpace).
std::vector<int> with_residual(const Problem& scene, const ContactReduction& reduction) {
  std::vector<int> contacts;
  for (int j = 0; j < scene.contact_count(); ++j) {
    const double of_vectors = reduction.rows.col(j).cwiseAbs2().cwiseQuotient(reduction.squares).sum();
    const bool spring = std::holds_alternative<Spring>(scene.contacts[static_cast<std::size_t>(j)].law);
    if (!spring || reduction.compliance(j, j) > kMatrixRounding * of_vectors) contacts.push_back(j);
  }
  return contacts;
}

// \param rows  n of the contacts with a residual
Structure structure_of(const ContactReduction& reduction, const Eigen::MatrixXd& rows,
                       const Eigen::MatrixXd& G) {
  const Eigen::Index vectors = reduction.vectors(), contacts = rows.cols();
  const Eigen::MatrixXd pulled = product(rows, G);
  Eigen::MatrixXd K(vectors + contacts, vectors + contacts);
  K.topLeftCorner(vectors, vectors) = product_by_transposed(pulled, rows);
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

// (phi^T f - n G s_m, G s_m) of every harmonic.
std::vector<ForceTerm> load_of(const ContactReduction& reduction, const Eigen::MatrixXd& rows,
                               const Eigen::MatrixXd& G, const std::vector<int>& own, double frequency) {
  const Eigen::MatrixXcd shifts = rows_of(reduction.shift, own);
  std::vector<ForceTerm> terms;
  for (std::size_t h = 0; h < reduction.rates.size(); ++h) {
    const auto column = static_cast<Eigen::Index>(h);
    Eigen::VectorXcd load(rows.rows() + rows.cols());
    const Eigen::VectorXcd shifted = image_of_complex(G, shifts.col(column));
    Eigen::VectorXcd of_vectors = reduction.load.col(column);
    subtract_image_of_complex(rows, shifted, of_vectors);
    load << of_vectors, shifted;
    const auto harmonic = static_cast<int>(std::lround(reduction.rates[h] / frequency));
    for (int dof = 0; dof < load.size(); ++dof) {
      if (load[dof] == 0.0) continue;
      terms.push_back({.dof = dof,
                       .harmonic = harmonic,
                       .cos = load[dof].real(),
                       .sin = harmonic == 0 ? 0.0 : 0.0 - load[dof].imag()});
    }
  }
  return terms;
}

}  // namespace

ReducedProblem reduced_problem(const Problem& scene, const ContactReduction& reduction) {
  ReducedProblem result{.obstacle = reduction.obstacle};
  if (result.obstacle.empty() && scene.contacts.empty()) result.obstacle = "it has no contact";
  if (result.obstacle.empty() && has_impacts(scene))
    result.obstacle = "a contact with mass and an impact law is another one in a reduced structure";
  if (result.obstacle.empty() && reduction.relaxation > 0.0 && std::holds_alternative<MixedLaws>(scene.law()))
    result.obstacle = kMixedRelaxing;
  if (!result.obstacle.empty()) return result;
  const std::vector<int> own = with_residual(scene, reduction);
  const Eigen::MatrixXd residual = block_of(reduction.compliance, own, own);
  if (!is_well_definite(residual)) {
    result.obstacle = "the static residual at the contacts is not definite: fewer vectors are needed";
    return result;
  }
  const auto vectors = static_cast<int>(reduction.vectors()), contacts = static_cast<int>(own.size());
  const Eigen::MatrixXd rows = columns_of(reduction.rows, own);
  const Eigen::MatrixXd G = contacts > 0 ? CholeskyFactors(residual).inverse() : Eigen::MatrixXd(residual);
  Problem& problem = result.problem;
  problem = scene;
  problem.kind = "matrices";
  problem.structure = std::make_shared<const Structure>(structure_of(reduction, rows, G));
  problem.force = load_of(reduction, rows, G, own, scene.frequency);
  for (int j = 0; j < scene.contact_count(); ++j) {
    auto& normal = problem.contacts[static_cast<std::size_t>(j)].normal;
    const auto place = std::ranges::find(own, j);
    if (place != own.end()) {
      normal = {{vectors + static_cast<int>(place - own.begin()), 1.0}};
      continue;
    }
    normal.clear();
    for (int k = 0; k < vectors; ++k)
      if (reduction.rows(k, j) != 0.0) normal.emplace_back(k, reduction.rows(k, j));
  }
  return result;
}

}  // namespace signorini
