#pragma once
// Linear solves with the Jacobian of the projected contact equations, by whichever way is the shorter one.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "methods/complementarity/contact_nodes.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

/// Solves (1 + P chi B) v = r in the steps of one run of Newton's method: at the nodes of contact
/// (NodalJacobian) as long as these are few; else by GMRES with LastingContactInverse, whose products cost
/// O(H log H Nc + H Nc^2) however long contacts last, until it fails once. Contacts that share a force, as
/// the nodes of a patch do, are such a case: from there on at the nodes again, as far as memory allows.
class JacobianSolver {
 public:
  /// The contacts of one step, as the two ways need them.
  struct Contacts {
    Eigen::Index nodes = 0;                                          ///< of all contacts
    Eigen::VectorXd duty;                                            ///< as of LastingContactInverse
    std::function<std::vector<ContactNodes>()> place;                ///< the nodes of each contact, Nc
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> product;  ///< v -> J v
  };

  /// J^{-1} r; x is empty where both ways fail.
  KrylovSolve solve(const ContactSymbol& symbol, const Contacts& contacts, const Eigen::VectorXd& r);

 private:
  bool gmres_fails_ = false;
};

}  // namespace signorini
