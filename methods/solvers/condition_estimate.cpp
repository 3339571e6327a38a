#include "methods/solvers/condition_estimate.hpp"

#include <algorithm>

namespace signorini {

double triangular_condition(const Eigen::MatrixXd& r) {
  constexpr int kVisits = 5;  // of vertices of the unit ball; Hager's method seldom needs more than two
  const Eigen::Index size = r.rows();
  if (size == 0) return 1.0;
  if (!r.allFinite() || r.diagonal().cwiseAbs().minCoeff() == 0.0) return kSingular;
  const auto upper = r.triangularView<Eigen::Upper>();
  const double norm = upper.toDenseMatrix().cwiseAbs().colwise().sum().maxCoeff();
  // |R^{-1} x|_1 is convex in x: climb from the centre of the unit ball to one of its vertices.
  Eigen::VectorXd x = Eigen::VectorXd::Constant(size, 1.0 / static_cast<double>(size));
  double inverse_norm = 0.0;
  for (int visit = 0; visit < kVisits; ++visit) {
    const Eigen::VectorXd y = upper.solve(x);
    if (!y.allFinite()) return kSingular;
    if (visit > 0 && y.lpNorm<1>() <= inverse_norm) break;
    inverse_norm = y.lpNorm<1>();
    const Eigen::VectorXd sign = (y.array() >= 0.0).select(Eigen::VectorXd::Ones(size), -1.0);
    const Eigen::VectorXd gradient = upper.transpose().solve(sign);
    Eigen::Index steepest = 0;
    if (!gradient.allFinite()) return kSingular;
    if (!(gradient.cwiseAbs().maxCoeff(&steepest) > gradient.dot(x))) break;
    x = Eigen::VectorXd::Unit(size, steepest);
  }
  return std::clamp(norm * inverse_norm, 1.0, kSingular);
}

}  // namespace signorini
