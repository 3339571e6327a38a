#include "methods/solvers/lcp.hpp"

#include <algorithm>
#include <limits>

namespace signorini {

double natural_residual(const Lcp& lcp, const Eigen::VectorXd& z) {
  const Eigen::VectorXd w = lcp.offset + *lcp.matrix * z;
  const double scale = std::max(lcp.offset.lpNorm<Eigen::Infinity>(), z.lpNorm<Eigen::Infinity>());
  const double residual = z.cwiseMin(w).lpNorm<Eigen::Infinity>();
  if (!z.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  return scale > 0.0 ? residual / scale : residual;
}

std::string describe(LcpStatus status) {
  switch (status) {
    case LcpStatus::solved:
      return "solved";
    case LcpStatus::ray:
      return "the path of pivots ended on a ray";
    case LcpStatus::stalled:
      return "the line search found no descent";
    case LcpStatus::limit:
      return "pivots or iterations used up";
    case LcpStatus::breakdown:
      return "the active block is singular to working precision";
    case LcpStatus::interrupted:
      return "time budget used up";
  }
  return "unknown";
}

}  // namespace signorini
