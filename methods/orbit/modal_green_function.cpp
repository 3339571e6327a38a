#include "methods/orbit/modal_green_function.hpp"

#include <Eigen/Core>
#include <complex>

#include "methods/discretisation/periodic_time.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/general_eigen.hpp"

namespace signorini {

using Complex = std::complex<double>;

ModalGreenFunction::ModalGreenFunction(const ContactDynamics& dynamics, double period)
    : period_(period), rates_(dynamics.structure().rates) {
  constexpr double kIllConditioned = 1e-8;
  const int n = dynamics.size();
  const double unit = 1.0 / dynamics.structure().frequency;  // velocities count as v / omega
  const CholeskyFactors mass(Eigen::MatrixXd(dynamics.structure().mass));
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).diagonal().setConstant(1.0 / unit);
  A.bottomLeftCorner(n, n) = -unit * mass.solve(Eigen::MatrixXd(dynamics.structure().stiffness));
  A.bottomRightCorner(n, n) = -mass.solve(Eigen::MatrixXd(dynamics.structure().damping));
  const GeneralEigen modes = general_eigen(A);
  if (!modes.converged) return;
  const CompleteComplexLuFactors lu(modes.vectors);
  mu_ = modes.values;
  const Eigen::ArrayXcd closing = 1.0 - (mu_.array() * period).exp();
  if (!(lu.reciprocal_condition() > kIllConditioned) || closing.abs().minCoeff() < kIllConditioned) return;
  shapes_ = modes.vectors.topRows(n);
  if (dynamics.contact_count() > 0) {
    Eigen::MatrixXcd struck = Eigen::MatrixXcd::Zero(2 * n, dynamics.contact_count());
    struck.bottomRows(n) = unit * dynamics.structure().velocity_per_impulse.cast<Complex>();
    // The impulses of all periods past: sum_n e^{mu (tau + n T)} = e^{mu tau} / (1 - e^{mu T}).
    excitation_ = closing.inverse().matrix().asDiagonal() * lu.solve(struck);
  }
  const Eigen::MatrixXcd load = dynamics.structure().load;
  forced_.resize(n, load.cols());
  for (Eigen::Index h = 0; h < load.cols(); ++h) {
    const double w = rates_[static_cast<std::size_t>(h)];
    const Eigen::MatrixXcd Z =
        Eigen::MatrixXcd(dynamics.structure().stiffness.cast<Complex>()) +
        Complex(0.0, w) * Eigen::MatrixXcd(dynamics.structure().damping.cast<Complex>()) -
        w * w * Eigen::MatrixXcd(dynamics.structure().mass.cast<Complex>());
    forced_.col(h) = CompleteComplexLuFactors(Z).solve(load.col(h));  // zero under no load, resonance or not
  }
  defined_ = forced_.allFinite();
}

State ModalGreenFunction::state(double time, const std::vector<Impulse>& impulses) const {
  Eigen::VectorXcd terms = Eigen::VectorXcd::Zero(mu_.size());
  for (const Impulse& impulse : impulses) {
    const double tau = wrapped_time(time - impulse.time, period_);
    terms.array() += impulse.value * (mu_.array() * tau).exp() * excitation_.col(impulse.contact).array();
  }
  State state{.u = (shapes_ * terms).real(), .v = (shapes_ * mu_.cwiseProduct(terms)).real()};
  for (Eigen::Index h = 0; h < forced_.cols(); ++h) {
    const double w = rates_[static_cast<std::size_t>(h)];
    const Eigen::VectorXcd wave = std::polar(1.0, w * time) * forced_.col(h);
    state.u += wave.real();
    state.v -= w * wave.imag();
  }
  return state;
}

}  // namespace signorini
