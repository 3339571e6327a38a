#pragma once
// A linear complementarity problem solved again and again, with one matrix and offsets that change little.

#include <Eigen/Core>
#include <map>
#include <vector>

namespace signorini {

/// Finds z >= 0 with w = q + G z >= 0 and z^T w = 0 for one G and many q, by the primal-dual active set
/// method [hintermueller2002] from the set of the last solution,
///
///     z_A = -G_AA^-1 q_A,   A <- {i in A: z_i > 0} together with {i not in A: w_i < 0},
///
/// until A repeats. Along a motion A changes seldom, and one solve with an inverse already known is all. The
/// method may cycle for a positive definite G; after a few changes `solve_small_lcp` takes over, which ends.
/// Where columns of a set depend on each other, z is the one of least norm on the set; w is unique.
class ActiveSetLcp {
 public:
  /// \param G  m x m, symmetric positive semi-definite with a positive diagonal
  explicit ActiveSetLcp(Eigen::MatrixXd G);

  /// The solution for q, m. False if there is none, or rounding decides; then z and w mean nothing.
  [[nodiscard]] bool solve(const Eigen::VectorXd& q);
  /// z_A = -G_AA^-1 q_A for any set A, ascending. \param q_A  |A|; the result likewise
  [[nodiscard]] Eigen::VectorXd on_set(const std::vector<int>& set, const Eigen::VectorXd& q_A);
  /// Forgets the set that the next solution would begin from.
  void restart() { set_.clear(); }

  /// z of the last solution, m.
  [[nodiscard]] const Eigen::VectorXd& z() const { return z_; }
  /// w = q + G z of the last solution, m.
  [[nodiscard]] const Eigen::VectorXd& w() const { return w_; }
  /// Its A, ascending: z may be positive there, w = 0.
  [[nodiscard]] const std::vector<int>& set() const { return set_; }

  /// Sets tried since the beginning [-].
  [[nodiscard]] long changes() const { return changes_; }
  /// Inverses computed since the beginning [-].
  [[nodiscard]] long factorisations() const { return factorisations_; }
  /// Solutions left to `solve_small_lcp` since the beginning [-].
  [[nodiscard]] long fallbacks() const { return fallbacks_; }

 private:
  [[nodiscard]] const Eigen::MatrixXd& inverse(const std::vector<int>& set);
  [[nodiscard]] bool solve_otherwise(const Eigen::VectorXd& q);

  Eigen::MatrixXd G_;
  Eigen::VectorXd z_, w_;
  std::vector<int> set_, next_;
  std::map<std::vector<int>, Eigen::MatrixXd> inverses_;  // of G_AA, by A
  Eigen::Index stored_ = 0;                               // numbers in inverses_
  Eigen::VectorXd offset_, part_;
  long changes_ = 0, factorisations_ = 0, fallbacks_ = 0;
};

}  // namespace signorini
