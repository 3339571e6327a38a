#pragma once
// Linear solves with the Jacobian of the projected contact equations, by whichever way is the shorter one.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "methods/complementarity/contact_nodes.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

/// Solves J v = r, J = 1 + P chi B, in the steps of Newton's method on one problem:
///
///   1. by a factorisation of J where it is known as a matrix and has at most a hundred unknowns;
///   2. at the nodes of contact (NodalJacobian) where these are few;
///   3. by GMRES with LastingContactInverse, whose products cost O(H log H Nc + H Nc^2) however long contacts
///      last, for as many vectors as cost what a factorisation at the nodes does. Contacts that share a
///      force, as those of a patch do, take more: once it has failed, steps are solved at the nodes.
///
/// A solution at the nodes is corrected by its residual until that is 1e-12 |r|, twice at most.
class JacobianSolver {
 public:
  /// The contacts of one step, as the ways need them.
  struct Contacts {
    Eigen::Index nodes = 0;                                               ///< of all contacts
    Eigen::VectorXd duty = {};                                            ///< as of LastingContactInverse
    std::function<std::vector<ContactNodes>()> place = {};                ///< the nodes of each contact, Nc
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> product = {};  ///< v -> J v
    std::function<Eigen::MatrixXd()> matrix = {};                         ///< J; empty: unknown
  };

  /// J^{-1} r, its residual at most 1e-8 |r|; x is empty where no way comes so far. The condition is that of
  /// the system that was factorised, or GMRES' estimate.
  KrylovSolve solve(const ContactSymbol& symbol, const Contacts& contacts, const Eigen::VectorXd& r);

 private:
  bool gmres_fails_ = false;
};

}  // namespace signorini
