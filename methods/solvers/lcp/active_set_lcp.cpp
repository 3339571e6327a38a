#include "methods/solvers/lcp/active_set_lcp.hpp"

#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

// Sets tried before the method counts as cycling: along motions one or two are enough.
constexpr int kMostChanges = 30;
// Numbers kept in inverses, 160 MB; beyond, all are forgotten.
constexpr Eigen::Index kMostStored = 20'000'000;

// G_AA^-1; where G_AA is singular to rounding, its pseudo-inverse.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& G) {
  const CholeskyFactors factor(G);
  // The condition of a factorisation that failed means nothing.
  const bool regular =
      factor.definite() && factor.reciprocal_condition() > 16.0 * std::numeric_limits<double>::epsilon();
  if (regular) return factor.inverse();
  return pseudo_inverse(G);
}

}  // namespace

ActiveSetLcp::ActiveSetLcp(Eigen::MatrixXd G)
    : G_(std::move(G)), z_(Eigen::VectorXd::Zero(G_.rows())), w_(Eigen::VectorXd::Zero(G_.rows())) {}

const Eigen::MatrixXd& ActiveSetLcp::inverse(const std::vector<int>& set) {
  if (const auto known = inverses_.find(set); known != inverses_.end()) return known->second;
  const auto size = static_cast<Eigen::Index>(set.size());
  if (stored_ + size * size > kMostStored) {
    inverses_.clear();
    stored_ = 0;
  }
  stored_ += size * size;
  ++factorisations_;
  return inverses_.emplace(set, inverse_of(G_(set, set))).first->second;
}

Eigen::VectorXd ActiveSetLcp::on_set(const std::vector<int>& set, const Eigen::VectorXd& q_A) {
  return -(inverse(set) * q_A);
}

bool ActiveSetLcp::solve(const Eigen::VectorXd& q) {
  for (int change = 0; change < kMostChanges; ++change) {
    ++changes_;
    z_.setZero();
    w_ = q;
    if (!set_.empty()) {
      const std::span<const int> set(set_);  // a view by the vector itself copies it
      offset_ = q(set);
      part_.noalias() = inverse(set_) * offset_;
      z_(set) = -part_;
      for (const int i : set_) w_.noalias() += z_[i] * G_.col(i);
    }
    // Both lists ascend: `next` is made in the order of the indices.
    next_.clear();
    auto member = set_.begin();
    for (int i = 0; i < static_cast<int>(q.size()); ++i) {
      const bool active = member != set_.end() && *member == i;
      if (active) ++member;
      if (active ? z_[i] > 0.0 : w_[i] < 0.0) next_.push_back(i);
    }
    if (next_ == set_) {
      for (const int i : set_) w_[i] = 0.0;
      return q.allFinite();
    }
    set_.swap(next_);
  }
  return solve_otherwise(q);
}

bool ActiveSetLcp::solve_otherwise(const Eigen::VectorXd& q) {
  ++fallbacks_;
  set_.clear();
  const std::optional<Eigen::VectorXd> z =
      solve_small_lcp(G_, q, std::vector<bool>(static_cast<std::size_t>(q.size()), false));
  if (!z) return false;
  z_ = *z;
  w_ = q + G_ * z_;
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    if (z_[i] > 0.0) set_.push_back(i);
  }
  for (const int i : set_) w_[i] = 0.0;
  return true;
}

}  // namespace signorini
