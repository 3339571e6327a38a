#include "problems/linear_algebra/lapack.hpp"

#include <algorithm>

namespace signorini {

bool is_for_lapack(const Eigen::MatrixXd& A) {
  return std::min(A.rows(), A.cols()) >= kLeastForLapack && A.allFinite();
}

}  // namespace signorini
