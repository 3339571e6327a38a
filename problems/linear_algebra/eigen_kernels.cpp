#include "problems/linear_algebra/eigen_kernels.hpp"

namespace Eigen::internal {

SIGNORINI_EIGEN_KERNELS(, double)
SIGNORINI_EIGEN_KERNELS(, std::complex<double>)

}  // namespace Eigen::internal
