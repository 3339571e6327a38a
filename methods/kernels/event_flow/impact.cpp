#include "methods/kernels/event_flow/impact.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

namespace signorini {

namespace {

// z on the indices in `basis`, zero elsewhere, with w = 0 on the basis.
Eigen::VectorXd basic_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                               const std::vector<int>& basis) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(q.size());
  if (basis.empty()) return z;
  const Eigen::MatrixXd block = A(basis, basis);
  const Eigen::VectorXd right = -q(basis);
  const Eigen::VectorXd on_basis = block.completeOrthogonalDecomposition().solve(right);
  z(basis) = on_basis;
  return z;
}

std::vector<int> indices_of(const std::vector<bool>& flags) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i]) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace

std::optional<Eigen::VectorXd> solve_small_lcp(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                                               const std::vector<bool>& held) {
  constexpr double kRoundOff = 64.0 * std::numeric_limits<double>::epsilon();
  constexpr int kMaxPivots = 100000;
  const double w_noise = kRoundOff * (q.size() == 0 ? 0.0 : q.cwiseAbs().maxCoeff());
  const double z_noise =
      w_noise / std::max(A.size() == 0 ? 0.0 : A.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  std::vector<bool> basic = held;
  for (int pivot = 0; pivot < kMaxPivots; ++pivot) {
    Eigen::VectorXd z = basic_solution(A, q, indices_of(basic));
    const Eigen::VectorXd w = A * z + q;
    std::size_t flipped = basic.size();
    for (std::size_t i = 0; i < basic.size() && flipped == basic.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (!held[i] && (basic[i] ? z[row] < -z_noise : w[row] < -w_noise)) flipped = i;
    }
    if (flipped == basic.size()) {
      for (std::size_t i = 0; i < basic.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        if (!held[i]) z[row] = std::max(z[row], 0.0);
      }
      return z;
    }
    basic[flipped] = !basic[flipped];
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> newton_impulses(const ImpactInput& input) {
  const Eigen::VectorXd closing = input.approach.cwiseMax(0.0);
  const Eigen::VectorXd q = -(input.approach + input.restitution.cwiseProduct(closing));
  const auto z =
      solve_small_lcp(input.delassus, q, std::vector<bool>(static_cast<std::size_t>(q.size()), false));
  if (!z) return std::nullopt;
  return Eigen::VectorXd(-*z);
}

}  // namespace signorini
