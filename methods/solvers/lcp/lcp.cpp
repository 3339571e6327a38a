#include "methods/solvers/lcp/lcp.hpp"

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
  // In the order of the enumerators.
  constexpr std::array kSentences{"solved",
                                  "the path of pivots ended on a ray",
                                  "the line search found no descent",
                                  "pivots or iterations used up",
                                  "the active block is singular to working precision",
                                  "time budget used up"};
  return kSentences[static_cast<std::size_t>(status)];
}

}  // namespace signorini
