#pragma once
// Random complementarity problems, and an oracle that shares no code with their solvers.

#include <random>
#include <vector>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::test {

/// All z >= 0 with q + A z >= 0 and z^T (q + A z) = 0, by trying the 2^m active sets.
inline std::vector<Eigen::VectorXd> enumerate_solutions(const Eigen::MatrixXd& a, const Eigen::VectorXd& q) {
  const auto size = static_cast<int>(q.size());
  std::vector<Eigen::VectorXd> solutions;
  for (unsigned set = 0; set < (1U << size); ++set) {
    std::vector<int> active;
    for (int i = 0; i < size; ++i) {
      if ((set >> i & 1U) != 0) active.push_back(i);
    }
    Eigen::VectorXd z = Eigen::VectorXd::Zero(size);
    if (!active.empty()) {
      const CompleteLuFactors lu(a(active, active));
      if (!lu.regular()) continue;
      z(active) = lu.solve(-q(active));
    }
    const Eigen::VectorXd w = q + a * z;
    if (z.minCoeff() >= -1e-11 && w.minCoeff() >= -1e-11 * q.norm()) solutions.push_back(z);
  }
  return solutions;
}

/// Positive definite symmetric part and a skew one: every principal minor is positive.
inline Eigen::MatrixXd random_p_matrix(int size, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd g(size, size);
  Eigen::MatrixXd skew(size, size);
  for (double& x : g.reshaped()) x = normal(random);
  for (double& x : skew.reshaped()) x = normal(random);
  return g * g.transpose() / size + 0.1 * Eigen::MatrixXd::Identity(size, size) + (skew - skew.transpose());
}

/// Normally distributed numbers.
inline Eigen::VectorXd random_vector(int size, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd q(size);
  for (double& x : q) x = normal(random);
  return q;
}

}  // namespace signorini::test
