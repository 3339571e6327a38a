#include "methods/kernels/condensation.hpp"

#include <algorithm>
#include <vector>

namespace signorini {

namespace {

/// The coordinate of each contact; empty and a reason where a contact is not one coordinate of its own.
std::vector<int> contact_dofs(const Problem& problem, std::string& reason) {
  std::vector<int> dofs;
  for (const Contact& contact : problem.contacts) {
    if (contact.normal.size() != 1 || contact.normal.front().second != 1.0) {
      reason = "a massless contact acts on several coordinates";
      return {};
    }
    const int dof = contact.normal.front().first;
    if (std::find(dofs.begin(), dofs.end(), dof) != dofs.end()) {
      reason = "two massless contacts share a coordinate";
      return {};
    }
    dofs.push_back(dof);
  }
  return dofs;
}

/// Empty if the contact coordinates follow the others statically and independently.
std::string obstacle(const Problem& problem, const std::vector<int>& dofs) {
  for (const ForceTerm& term : problem.force) {
    if (std::find(dofs.begin(), dofs.end(), term.dof) != dofs.end())
      return "a load acts on a massless contact";
  }
  const Eigen::MatrixXd damping(problem.damping);
  for (const int dof : dofs) {
    if (!damping.row(dof).isZero(0.0) || !damping.col(dof).isZero(0.0)) return "a massless contact is damped";
    if (problem.stiffness.coeff(dof, dof) <= 0.0) return "a massless contact has no stiffness behind it";
    for (const int other : dofs) {
      if (other != dof && problem.stiffness.coeff(dof, other) != 0.0) return "massless contacts are coupled";
    }
  }
  return {};
}

SparseMatrix kept_block(const Eigen::MatrixXd& matrix, const std::vector<int>& kept) {
  return SparseMatrix(Eigen::MatrixXd(matrix(kept, kept)).sparseView());
}

}  // namespace

CondensedScene condense(const Problem& problem) {
  CondensedScene result;
  const std::vector<int> dofs = contact_dofs(problem, result.reason);
  if (result.reason.empty()) result.reason = obstacle(problem, dofs);
  if (!result.reason.empty()) return result;
  std::vector<int> kept;
  std::vector<int> place(static_cast<std::size_t>(problem.size()), -1);
  for (int dof = 0; dof < problem.size(); ++dof) {
    if (std::find(dofs.begin(), dofs.end(), dof) != dofs.end()) continue;
    place[static_cast<std::size_t>(dof)] = static_cast<int>(kept.size());
    kept.push_back(dof);
  }
  Problem condensed = problem;
  Eigen::MatrixXd stiffness(problem.stiffness);
  Penalty law;
  for (std::size_t c = 0; c < dofs.size(); ++c) {
    const Eigen::VectorXd coupling = stiffness.col(dofs[c]);
    const double own = coupling[dofs[c]];
    Contact& contact = condensed.contacts[c];
    contact.normal.clear();
    for (std::size_t r = 0; r < kept.size(); ++r) {
      if (coupling[kept[r]] != 0.0)
        contact.normal.emplace_back(static_cast<int>(r), -coupling[kept[r]] / own);
    }
    stiffness -= coupling * coupling.transpose() / own;
    law.stiffness.push_back(own);
  }
  condensed.mass = kept_block(Eigen::MatrixXd(problem.mass), kept);
  condensed.damping = kept_block(Eigen::MatrixXd(problem.damping), kept);
  condensed.stiffness = kept_block(stiffness, kept);
  for (ForceTerm& term : condensed.force) term.dof = place[static_cast<std::size_t>(term.dof)];
  condensed.law = law;
  result.problem = std::move(condensed);
  return result;
}

Samples CondensedMotion::sample(int count) const {
  Samples samples = inner_->sample(count);
  for (Eigen::Index c = 0; c < samples.x.cols(); ++c) {
    for (Eigen::Index i = 0; i < samples.x.rows(); ++i) {
      if (samples.x(i, c) < gaps_[c]) continue;
      samples.x(i, c) = gaps_[c];
      samples.velocity(i, c) = 0.0;
    }
  }
  return samples;
}

}  // namespace signorini
