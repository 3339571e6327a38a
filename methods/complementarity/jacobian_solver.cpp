#include "methods/complementarity/jacobian_solver.hpp"

#include <limits>

#include "methods/complementarity/nodal_jacobian.hpp"

namespace signorini {

namespace {

constexpr Eigen::Index kFewNodes = 150;     // at which a factorisation costs less than some GMRES products
constexpr Eigen::Index kMostNodes = 5000;   // 200 MB
constexpr Eigen::Index kMostVectors = 80;  // of GMRES, where a factorisation is possible
constexpr double kTolerance = 1e-12;        // of GMRES, relative to the right-hand side

}  // namespace

KrylovSolve JacobianSolver::solve(const ContactSymbol& symbol, const Contacts& contacts,
                                  const Eigen::VectorXd& r) {
  const bool factorisable = contacts.nodes <= kMostNodes;
  const auto at_nodes = [&] { return NodalJacobian(symbol, contacts.place()).solve(r); };
  if (contacts.nodes <= kFewNodes || (gmres_fails_ && factorisable)) return at_nodes();
  const LastingContactInverse lasting(symbol, contacts.duty);
  KrylovSolve krylov = solve_by_gmres(
      contacts.product, [&lasting](const Eigen::VectorXd& v) { return lasting * v; }, r, kTolerance,
      factorisable ? kMostVectors : std::numeric_limits<Eigen::Index>::max());
  if (krylov.x.size() > 0 || !factorisable) return krylov;
  gmres_fails_ = true;
  return at_nodes();
}

}  // namespace signorini
