#include "methods/structure/mean_balance.hpp"

#include <numbers>

#include "methods/structure/periodic_response.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/cholesky.hpp"

namespace signorini {

MeanBalance::MeanBalance(const ContactReceptance& receptance) {
  if (receptance.rigid_count() == 0) return;
  const Eigen::MatrixXd& E = receptance.rigid;
  const CholeskyFactors gram(E.transpose() * E);
  const double rate = 2.0 * std::numbers::pi / receptance.period;
  share = E * gram.solve(Eigen::MatrixXd(E.transpose()));
  force = -(E * gram.solve(receptance.rigid_load));
  compliance = E * E.transpose() / (rate * rate);
  const Eigen::MatrixXd& still = receptance.receptance.front().real();
  moved = still - still * share + compliance;
}

namespace {

Eigen::MatrixXcd balanced_by(const MeanBalance& balance, const Eigen::MatrixXcd& carried) {
  Eigen::MatrixXcd lambda = carried;
  lambda.row(0) += (balance.force - balance.share * carried.row(0).real().transpose())
                       .transpose()
                       .cast<std::complex<double>>();
  return lambda;
}

}  // namespace

Eigen::MatrixXcd balanced_force(const ContactReceptance& receptance, const Eigen::MatrixXcd& carried) {
  return receptance.rigid_count() == 0 ? carried : balanced_by(MeanBalance(receptance), carried);
}

Eigen::MatrixXcd carried_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& carried) {
  if (receptance.rigid_count() == 0) return contact_motion(receptance, carried);
  const MeanBalance balance(receptance);
  Eigen::MatrixXcd x = contact_motion(receptance, balanced_by(balance, carried));
  x.row(0) +=
      (balance.compliance * carried.row(0).real().transpose()).transpose().cast<std::complex<double>>();
  return x;
}

Eigen::MatrixXcd carried_force(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda,
                               const Eigen::RowVectorXd& mean) {
  if (receptance.rigid_count() == 0) return lambda;
  // E a = E E^T mu_0 / w^2 of the mu_0 in the range of E.
  const Eigen::MatrixXd& E = receptance.rigid;
  const MeanBalance balance(receptance);
  const CholeskyFactors gram(E.transpose() * E);
  const double rate = 2.0 * std::numbers::pi / receptance.period;
  const Eigen::VectorXd a = gram.solve(Eigen::VectorXd(E.transpose() * mean.transpose()));
  const Eigen::VectorXd along = E * gram.solve(Eigen::VectorXd(rate * rate * a));
  Eigen::MatrixXcd carried = lambda;
  const Eigen::VectorXd force = lambda.row(0).real().transpose();
  carried.row(0) = (force - balance.share * force + along).transpose().cast<std::complex<double>>();
  return carried;
}

Eigen::MatrixXcd carried_spectrum(const ContactReceptance& receptance, const Trajectory& motion) {
  Eigen::MatrixXcd lambda = force_spectrum(motion, receptance.harmonics());
  if (receptance.rigid_count() == 0) return lambda;
  Eigen::RowVectorXd mean = motion.sample(motion.nodes().value_or(kFineInstants)).x.colwise().mean();
  const Eigen::MatrixXcd held = contact_motion(receptance, lambda);
  return carried_force(receptance, lambda, mean - held.row(0).real());
}

}  // namespace signorini
