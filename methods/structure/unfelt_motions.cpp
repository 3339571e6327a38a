#include "methods/structure/unfelt_motions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "methods/structure/bases/modal_reduction.hpp"
#include "methods/structure/rigid_motions.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Combinations of the columns of R that A takes to zero.
MatrixXd null_combinations(const MatrixXd& R, const MatrixXd& A) {
  if (R.cols() == 0 || A.rows() == 0) return R;
  const MatrixXd image = A * R;
  const double scale = A.cwiseAbs().maxCoeff() * R.cwiseAbs().maxCoeff() * static_cast<double>(R.rows());
  if (!(image.cwiseAbs().maxCoeff() > kMatrixRounding * scale)) return R;
  const SingularValues found = singular_vectors(image);
  const Index rank = (found.values.array() > kMatrixRounding * scale).count();
  return R * found.V.rightCols(R.cols() - rank);
}

/// Whether loads of the harmonics that are chosen do work on one of the motions.
template <class Chosen>
bool is_pushed(const Problem& problem, const MatrixXd& R, const Chosen& chosen) {
  std::map<std::pair<int, int>, MatrixXd> works;  // by harmonic and power of omega: of cosine and sine
  double most = 0.0;
  for (const ForceTerm& term : problem.force) {
    if (!chosen(term.harmonic)) continue;
    const Eigen::RowVector2d load(term.cos, term.sin);
    MatrixXd& work =
        works.try_emplace({term.harmonic, term.omega_power}, MatrixXd::Zero(R.cols(), 2)).first->second;
    work += R.row(term.dof).transpose() * load;
    most = std::max(most, load.cwiseAbs().maxCoeff() * R.row(term.dof).cwiseAbs().maxCoeff());
  }
  return std::ranges::any_of(
      works, [&](const auto& entry) { return entry.second.cwiseAbs().maxCoeff() > kMatrixRounding * most; });
}

/// Q of u = Q q: the unit matrix on the coordinates that are kept; on the others what makes B u = 0.
MatrixXd expressed(const MatrixXd& B, const std::vector<Index>& left_out, const std::vector<Index>& kept) {
  MatrixXd Q = MatrixXd::Zero(B.cols(), std::ssize(kept));
  Q(kept, Eigen::all).setIdentity();
  Q(left_out, Eigen::all) = -LuFactors(B(Eigen::all, left_out)).solve(MatrixXd(B(Eigen::all, kept)));
  return Q;
}

/// Loads and contacts on q.
void take_coordinates(const MatrixXd& Q, Problem& problem) {
  std::vector<ForceTerm> force;
  for (const ForceTerm& term : problem.force) {
    for (Index k = 0; k < Q.cols(); ++k) {
      const double share = Q(term.dof, k);
      if (share == 0.0) continue;
      force.push_back(term);
      force.back().dof = static_cast<int>(k);
      force.back().cos *= share;
      force.back().sin *= share;
    }
  }
  problem.force = std::move(force);
  for (Contact& contact : problem.contacts) {
    Eigen::VectorXd normal = Eigen::VectorXd::Zero(Q.cols());
    for (const auto& [dof, weight] : contact.normal) normal += weight * Q.row(dof).transpose();
    const double least = kMatrixRounding * normal.cwiseAbs().maxCoeff();
    contact.normal.clear();
    for (Index k = 0; k < normal.size(); ++k)
      if (std::abs(normal[k]) > least) contact.normal.emplace_back(static_cast<int>(k), normal[k]);
  }
}

}  // namespace

std::optional<WithoutUnfeltMotions> without_unfelt_motions(const Problem& problem) {
  if (problem.size() > kMostModal || !problem.frame.empty() || problem.contacts.empty() ||
      follows_speed(problem))
    return std::nullopt;
  MatrixXd R = null_combinations(rigid_motions(problem), MatrixXd(contact_directions(problem).transpose()));
  R = null_combinations(R, MatrixXd(problem.damping()));
  if (R.cols() == 0 || R.cols() == problem.size() ||
      is_pushed(problem, R, [](int harmonic) { return harmonic == 0; }))
    return std::nullopt;
  // R^T M R = 1 again: combinations of its columns by an orthogonal matrix keep it so.
  const MatrixXd B = (problem.mass() * R).transpose();
  const std::vector<Index> left_out = supports(B.transpose());
  std::vector<Index> kept;
  for (Index i = 0; i < problem.size(); ++i)
    if (std::ranges::find(left_out, i) == left_out.end()) kept.push_back(i);
  const MatrixXd Q = expressed(B, left_out, kept);
  const MatrixXd left = MatrixXd::Identity(problem.size(), problem.size()) - R * B;
  WithoutUnfeltMotions found{.problem = problem,
                             .of = left(kept, Eigen::all),
                             .driven = is_pushed(problem, R, [](int harmonic) { return harmonic > 0; })};
  const auto on_q = [&Q](const SparseMatrix& A) {
    return SparseMatrix(MatrixXd(Q.transpose() * MatrixXd(A * Q)).sparseView());
  };
  found.problem.edit_structure([&](Structure& s) {
    s.mass = on_q(s.mass);
    s.damping = on_q(s.damping);
    s.stiffness = on_q(s.stiffness);
  });
  take_coordinates(Q, found.problem);
  return found;
}

}  // namespace signorini
