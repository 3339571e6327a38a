#include "methods/structure/receptance_rate.hpp"

#include <complex>
#include <cstddef>

#include "methods/structure/rigid_motions.hpp"

namespace signorini {

ReceptanceRate receptance_with_rate(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights) {
  using Complex = std::complex<double>;
  const int contacts = problem.contact_count();
  const Eigen::MatrixXcd directions = Eigen::MatrixXd(contact_directions(problem)).cast<Complex>();
  const Eigen::SparseMatrix<Complex> mass = problem.mass().cast<Complex>();
  const Eigen::SparseMatrix<Complex> damping = problem.damping().cast<Complex>();
  const int loaded = load_bandwidth(problem);
  const bool grows = load_grows(problem);
  const SpeedTerms* speed = problem.structure->speed.get();
  DynamicStiffness stiffness(problem);
  ReceptanceRate result;
  result.value.period = problem.period();
  result.value.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, contacts);
  result.free_response = result.value.free_response;
  result.value.receptance.resize(static_cast<std::size_t>(harmonics) + 1);
  Eigen::MatrixXcd right(problem.size(), contacts + 1);
  right.leftCols(contacts) = directions;
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights weight = weights(n);
    if (!factorise_or_hold(problem, weight, stiffness, result.value)) {
      // Of the held structure the springs of rigid motions alone, w^2 each, change.
      if (grows && !load_coefficient_rate(problem, 0).isZero(0.0)) throw SingularStiffness();
      const double base = problem.base_frequency();
      const Eigen::MatrixXd& E = result.value.rigid;
      const double change = -2.0 / (problem.frequency * base * base);
      result.receptance.emplace_back(Eigen::MatrixXcd::Zero(contacts, contacts));
      if (E.cols() == 0) continue;  // motions that no contact feels
      result.receptance.back() = (change * E * E.transpose()).cast<Complex>();
      result.free_response.row(n) = (change * E * result.value.rigid_load).transpose().cast<Complex>();
      continue;
    }
    right.col(contacts).setZero();
    if (n <= loaded) right.col(contacts) = weight.load * load_coefficient(problem, n);
    const Eigen::MatrixXcd X = stiffness.solve(right);
    const Complex of_mass = 2.0 * weight.mass / problem.frequency;
    const Complex of_damping = weight.damping / problem.frequency;
    Eigen::MatrixXcd changes = -(of_mass * (mass * X) + of_damping * (damping * X));
    if (speed != nullptr)
      changes -= weight.damping * (speed->gyroscopic.cast<Complex>() * X) +
                 weight.stiffness * (speed->circulatory.cast<Complex>() * X);
    if (grows && n <= loaded) changes.col(contacts) += weight.load * load_coefficient_rate(problem, n);
    const Eigen::MatrixXcd rate = stiffness.solve(changes);
    const Eigen::MatrixXcd seen = directions.transpose() * X, changed = directions.transpose() * rate;
    result.value.receptance[static_cast<std::size_t>(n)] = seen.leftCols(contacts);
    result.value.free_response.row(n) = seen.col(contacts).transpose();
    result.receptance.emplace_back(changed.leftCols(contacts));
    result.free_response.row(n) = changed.col(contacts).transpose();
  }
  return result;
}

}  // namespace signorini
