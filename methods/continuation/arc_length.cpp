#include "methods/continuation/arc_length.hpp"

#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

Eigen::VectorXd solve_bordered(const Eigen::MatrixXd& B, const Eigen::VectorXd& right, double last) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(B.rows());
  all.head(right.size()) = right;
  all[right.size()] = last;
  return B.rows() == B.cols() ? lu_solve(B, all) : full_rank_least_squares(B, all);
}

}  // namespace signorini
