#include "methods/complementarity/jacobian_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "methods/complementarity/nodal_jacobian.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

constexpr Eigen::Index kFewUnknowns = 100;
constexpr Eigen::Index kFewNodes = 150;  // at which a factorisation costs less than some GMRES products

KrylovSolve factorised(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& r) {
  const LuFactors lu(matrix);
  return {.x = lu.solve(r), .condition = condition_from(lu.reciprocal_condition())};
}

/// At the nodes, corrected; empty where a residual is left. What the force at the nodes adds to r may be far
/// larger than the solution, and its rounding, too, where c is far above the structure's stiffness.
KrylovSolve at_nodes(const ContactSymbol& symbol, const JacobianSolver::Contacts& contacts,
                     const Eigen::VectorXd& r) {
  constexpr int kCorrections = 2;
  constexpr double kAccepted = 1e-8;
  const NodalJacobian jacobian(symbol, contacts.place());
  KrylovSolve solved = jacobian.solve(r);
  for (int k = 0; solved.x.size() > 0; ++k) {
    const Eigen::VectorXd rest = r - contacts.product(solved.x);
    const double left = rest.norm() / r.norm();
    if (left <= kKrylovTolerance || (k == kCorrections && left <= kAccepted)) return solved;
    if (k == kCorrections) break;
    const Eigen::VectorXd correction = jacobian.solve(rest).x;
    if (correction.size() == 0) break;
    solved.x += correction;
  }
  return {};
}

/// Vectors of GMRES that cost about what a factorisation at the nodes costs, which does some eight times as
/// many operations in a second.
Eigen::Index affordable_vectors(const ContactSymbol& symbol, Eigen::Index nodes) {
  constexpr double kFewest = 60.0, kMost = 400.0, kFaster = 8.0;
  const double harmonics = symbol.harmonics() + 1.0;
  const double contacts = symbol.contacts();
  const auto k = static_cast<double>(nodes);
  const double factors = (4.0 * harmonics * k * k + 2.0 / 3.0 * k * k * k) / kFaster;
  const double transforms = 40.0 * harmonics * std::log2(8.0 * harmonics);
  const double product = 8.0 * harmonics * contacts * contacts + 2.0 * contacts * transforms;
  return static_cast<Eigen::Index>(std::clamp(factors / product, kFewest, kMost));
}

}  // namespace

KrylovSolve JacobianSolver::solve(const ContactSymbol& symbol, const Contacts& contacts,
                                  const Eigen::VectorXd& r) {
  if (!r.allFinite()) return {};
  if (r.isZero(0.0)) return {.x = r};
  if (contacts.matrix && r.size() <= kFewUnknowns) return factorised(contacts.matrix(), r);
  const bool factorisable = contacts.nodes <= std::min(kMostByFactors, r.size());
  if (factorisable && (contacts.nodes <= kFewNodes || gmres_fails_)) {
    KrylovSolve solved = at_nodes(symbol, contacts, r);
    if (solved.x.size() > 0 || gmres_fails_) return solved;
  }
  const LastingContactInverse lasting(symbol, contacts.duty);
  KrylovSolve krylov = solve_by_gmres(
      contacts.product, [&lasting](const Eigen::VectorXd& v) { return lasting * v; }, r, kKrylovTolerance,
      factorisable ? affordable_vectors(symbol, contacts.nodes) : std::numeric_limits<Eigen::Index>::max());
  if (krylov.x.size() > 0 || !factorisable) return krylov;
  gmres_fails_ = true;
  return at_nodes(symbol, contacts, r);
}

}  // namespace signorini
