#include "problems/problem.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "problems/definiteness.hpp"

namespace signorini {

namespace {

// A coordinate combination whose inertia or stiffness is below this fraction of the matrix's largest
// entry has none: what is left is rounding of the assembly.
constexpr double kNothing = 1e-14;

// w^T A w / |w|^4, zero where it is rounding only.
double reduced(const SparseMatrix& A, const Eigen::VectorXd& w) {
  const double form = w.dot(A * w);
  const double length2 = w.squaredNorm();
  return form > kNothing * largest_entry(A) * length2 ? form / (length2 * length2) : 0.0;
}

}  // namespace

SparseMatrix contact_directions(const Problem& problem) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < problem.contact_count(); ++j) {
    for (const auto& [dof, coefficient] : problem.contacts[static_cast<std::size_t>(j)].normal) {
      entries.emplace_back(dof, j, coefficient);
    }
  }
  SparseMatrix W(problem.size(), problem.contact_count());
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

Eigen::VectorXd contact_gaps(const Problem& problem) {
  Eigen::VectorXd gaps(problem.contact_count());
  std::transform(problem.contacts.begin(), problem.contacts.end(), gaps.begin(),
                 [](const Contact& contact) { return contact.gap; });
  return gaps;
}

Eigen::VectorXcd load_harmonic(const Problem& problem, int harmonic) {
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(problem.size());
  for (const ForceTerm& term : problem.force) {
    if (term.harmonic != harmonic) continue;
    load(term.dof) += std::complex<double>(term.cos, harmonic == 0 ? 0.0 : -term.sin);
  }
  return load;
}

int highest_load_harmonic(const Problem& problem) {
  int highest = 0;
  for (const ForceTerm& term : problem.force) {
    if (term.cos != 0.0 || term.sin != 0.0) highest = std::max(highest, term.harmonic);
  }
  return highest;
}

Eigen::VectorXd load_at(const Problem& problem, double time) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(problem.size());
  for (const ForceTerm& term : problem.force) {
    const double angle = term.harmonic * problem.frequency * time;
    load(term.dof) += term.cos * std::cos(angle) + term.sin * std::sin(angle);
  }
  return load;
}

Eigen::MatrixXd delassus_matrix(const Problem& problem) {
  if (!is_definite(problem.mass)) {
    throw std::invalid_argument("mass = singular (must be positive definite for the Delassus matrix)");
  }
  const SparseMatrix W = contact_directions(problem);
  const Eigen::SimplicialLDLT<SparseMatrix> factors(problem.mass);
  return W.transpose() * factors.solve(Eigen::MatrixXd(W));
}

Eigen::VectorXd contact_stiffness_scale(const Problem& problem) {
  const SparseMatrix W = contact_directions(problem);
  const double omega = problem.frequency;
  Eigen::VectorXd scale(problem.contact_count());
  for (int j = 0; j < problem.contact_count(); ++j) {
    const Eigen::VectorXd w = W.col(j);
    scale(j) = reduced(problem.stiffness, w);
    if (scale(j) == 0.0) scale(j) = omega * omega * reduced(problem.mass, w);
    // Neither spring nor mass: validate() has made sure of a damper.
    if (scale(j) == 0.0) scale(j) = omega * reduced(problem.damping, w);
  }
  return scale;
}

bool contacts_are_massless(const Problem& problem) {
  const SparseMatrix W = contact_directions(problem);
  const double inertia = largest_entry(problem.mass);
  for (int j = 0; j < problem.contact_count(); ++j) {
    const Eigen::VectorXd w = W.col(j);
    const Eigen::VectorXd momentum = problem.mass * w;
    if (momentum.cwiseAbs().maxCoeff() > kNothing * inertia * w.cwiseAbs().maxCoeff()) return false;
  }
  return problem.contact_count() > 0;
}

}  // namespace signorini
