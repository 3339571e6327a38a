#include "methods/reduction/principal_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

Eigen::MatrixXd mean_square(const Eigen::MatrixXcd& series, const Eigen::VectorXd& weight) {
  Eigen::VectorXd each = std::numbers::sqrt2 * weight;
  if (each.size() > 0) each[0] = weight[0];
  Eigen::MatrixXd parts(2 * series.cols(), series.rows());
  parts << each.asDiagonal() * series.real().transpose(), each.asDiagonal() * series.imag().transpose();
  return transposed_product(parts, parts);
}

double root_mean_square(const Eigen::VectorXd& lengths) {
  if (lengths.size() == 0) return 0.0;
  return std::sqrt(2.0 * lengths.squaredNorm() - lengths[0] * lengths[0]);
}

Eigen::MatrixXd principal_directions(const Eigen::MatrixXd& mean_square, double tolerance,
                                     Eigen::Index most) {
  if (mean_square.size() == 0) return mean_square;
  const SymmetricEigen directions = symmetric_eigen(mean_square);
  const Eigen::VectorXd& squares = directions.values;  // rising
  const Eigen::Index count = squares.size();
  double left = 0.0;
  Eigen::Index dropped = 0;
  while (dropped < count) {
    left += std::max(0.0, squares[dropped]);
    if (left > tolerance * tolerance) break;
    ++dropped;
  }
  return directions.vectors.rightCols(std::min(most, count - dropped));
}

}  // namespace signorini
