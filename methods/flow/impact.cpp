#include "methods/flow/impact.hpp"

#include <cstddef>
#include <vector>

#include "methods/solvers/small_lcp.hpp"

namespace signorini {

std::optional<Eigen::VectorXd> newton_impulses(const ImpactInput& input) {
  const Eigen::VectorXd closing = input.approach.cwiseMax(0.0);
  const Eigen::VectorXd q = -(input.approach + input.restitution.cwiseProduct(closing));
  const auto z =
      solve_small_lcp(input.delassus, q, std::vector<bool>(static_cast<std::size_t>(q.size()), false));
  if (!z) return std::nullopt;
  return Eigen::VectorXd(-*z);
}

}  // namespace signorini
