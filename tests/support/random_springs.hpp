#pragma once
// Springs between any two coordinates, for scenes in which everything is coupled.

#include <Eigen/Core>
#include <random>

namespace signorini::test {

/// Ties coordinate i to every one before it, by springs drawn from 1 to 3 N/m.
inline void tie_to_all_before(Eigen::MatrixXd& K, int i, std::mt19937& random) {
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int j = 0; j < i; ++j) {
    const double k = 2.0 + draw(random);
    K(i, i) += k;
    K(j, j) += k;
    K(i, j) -= k;
    K(j, i) -= k;
  }
}

}  // namespace signorini::test
