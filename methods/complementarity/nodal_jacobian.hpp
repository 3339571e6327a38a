#pragma once
// The Jacobian of the projected contact equations, inverted at the instants of contact.

#include <Eigen/Core>
#include <vector>

#include "methods/complementarity/contact_nodes.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

/// J = 1 + P chi B (ContactSymbol), whose contact integral is a sum over nodes t_q of weights w_q:
///
///     P chi = Phi Phi^T,    Phi_{.q} = sqrt(w_q) (1, sqrt 2 cos 2 pi n t_q, -sqrt 2 sin 2 pi n t_q, ...),
///
/// packed as in fourier_series.hpp, on the rows of the node's contact. What J adds to its argument lies in
/// the span of Phi, so that
///
///     J v = r    is    v = r + Phi a,    (1 + Phi^T B Phi) a = -Phi^T B r,
///
/// a dense system in one unknown per node: about pi H times what contacts last in all, and some for each,
/// however many contacts are open. Forming it costs 4 H operations for a pair of nodes, and as many for a
/// pair of a node and a contact. Where B is large Phi a may be far larger than v, and rounding of it is not
/// small beside r: who asks looks at the residual.
class NodalJacobian {
 public:
  /// Factorises the system.
  /// \param symbol  must outlive this
  /// \param nodes   of each contact, Nc; none where it is open throughout
  NodalJacobian(const ContactSymbol& symbol, const std::vector<ContactNodes>& nodes);
  NodalJacobian(const NodalJacobian&) = delete;             ///< lu_ refers to factors_
  NodalJacobian& operator=(const NodalJacobian&) = delete;  ///< likewise

  /// J^{-1} r with the condition of the dense system; x is empty where it is not finite.
  /// \param r  packed, (2 H + 1) Nc
  [[nodiscard]] KrylovSolve solve(const Eigen::VectorXd& r) const;

 private:
  /// The nodes of one contact that has some.
  struct Touching {
    Eigen::Index contact;
    Eigen::Index first;     // of its nodes among all
    Eigen::MatrixXd waves;  // sqrt(w_q) times (sqrt e_n cos 2 pi n t_q | sqrt e_n sin), e_0 = 1, else 2
  };

  [[nodiscard]] static std::vector<Touching> touching(const std::vector<ContactNodes>& nodes, int harmonics);
  [[nodiscard]] Eigen::Index count() const;
  [[nodiscard]] Eigen::MatrixXd matrix() const;
  [[nodiscard]] Eigen::MatrixXd answers_of(const Touching& row) const;

  const ContactSymbol& symbol_;
  std::vector<Touching> touching_;
  Eigen::MatrixXd factors_;
  LuFactorsInPlace lu_;
};

}  // namespace signorini
