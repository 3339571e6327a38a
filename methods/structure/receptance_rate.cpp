#include "methods/structure/receptance_rate.hpp"

#include <complex>

namespace signorini {

ReceptanceRate receptance_with_rate(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights) {
  using Complex = std::complex<double>;
  const int contacts = problem.contact_count();
  const Eigen::MatrixXcd directions = Eigen::MatrixXd(contact_directions(problem)).cast<Complex>();
  const Eigen::SparseMatrix<Complex> mass = problem.mass().cast<Complex>();
  const Eigen::SparseMatrix<Complex> damping = problem.damping().cast<Complex>();
  const int loaded = load_bandwidth(problem);
  const bool grows = load_grows(problem);
  DynamicStiffness stiffness(problem);
  ReceptanceRate result;
  result.value.period = problem.period();
  result.value.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, contacts);
  result.free_response = result.value.free_response;
  Eigen::MatrixXcd right(problem.size(), contacts + 1);
  right.leftCols(contacts) = directions;
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights weight = weights(n);
    stiffness.factorise(weight);
    right.col(contacts).setZero();
    if (n <= loaded) right.col(contacts) = weight.load * load_coefficient(problem, n);
    const Eigen::MatrixXcd X = stiffness.solve(right);
    const Complex of_mass = 2.0 * weight.mass / problem.frequency;
    const Complex of_damping = weight.damping / problem.frequency;
    Eigen::MatrixXcd changes = -(of_mass * (mass * X) + of_damping * (damping * X));
    if (grows && n <= loaded) changes.col(contacts) += weight.load * load_coefficient_rate(problem, n);
    const Eigen::MatrixXcd rate = stiffness.solve(changes);
    const Eigen::MatrixXcd seen = directions.transpose() * X, changed = directions.transpose() * rate;
    result.value.receptance.emplace_back(seen.leftCols(contacts));
    result.value.free_response.row(n) = seen.col(contacts).transpose();
    result.receptance.emplace_back(changed.leftCols(contacts));
    result.free_response.row(n) = changed.col(contacts).transpose();
  }
  return result;
}

}  // namespace signorini
