#include "methods/kernels/event_flow/complex_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <complex>
#include <vector>

#include "methods/kernels/event_flow/energy_form.hpp"

namespace signorini {

namespace {

constexpr Eigen::Index kLongDouble = 12;  // coordinates up to which extended precision is cheap
constexpr double kIllConditioned = 1e3;   // the factor by which digits may cancel between modes

template <class Real>
std::optional<ComplexModes> modes_in(const Eigen::MatrixXd& M, const Eigen::MatrixXd& D,
                                     const Eigen::MatrixXd& K, double rate) {
  using Matrix = typename EnergyForm<Real>::Matrix;
  using ComplexMatrix = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index n = M.rows();
  const EnergyForm<Real> form(M, D, K, static_cast<Real>(rate));
  if (!form.definite) return std::nullopt;
  const Eigen::EigenSolver<Matrix> solver(form.B);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const ComplexMatrix V = solver.eigenvectors();
  const ComplexMatrix inverse = V.partialPivLu().inverse();
  Matrix e_of_q = form.E.transpose() * form.L.transpose(), z_of_q = form.L.transpose(),
         q_of_e = form.q_of_z * form.z_of_e;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    const Real condition = V.col(k).norm() * inverse.row(k).norm();
    if (!(condition < static_cast<Real>(kIllConditioned))) return std::nullopt;
    if (solver.eigenvalues()[k].imag() >= Real(0)) kept.push_back(k);
  }
  const auto count = static_cast<Eigen::Index>(kept.size());
  ComplexModes modes{.mu = Eigen::VectorXcd(count),
                     .shapes = Eigen::MatrixXcd(n, count),
                     .left = Eigen::MatrixXcd(count, 2 * n),
                     .weight = Eigen::VectorXd(count)};
  const ComplexMatrix shapes = q_of_e.template cast<std::complex<Real>>() * V.topRows(n);
  const ComplexMatrix of_q = inverse.leftCols(n) * e_of_q.template cast<std::complex<Real>>();
  const ComplexMatrix of_rate = inverse.rightCols(n) * z_of_q.template cast<std::complex<Real>>();
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index k = kept[static_cast<std::size_t>(i)];
    modes.mu[i] = static_cast<std::complex<double>>(solver.eigenvalues()[k]);
    modes.weight[i] = modes.mu[i].imag() > 0.0 ? 2.0 : 1.0;
    modes.shapes.col(i) = shapes.col(k).template cast<std::complex<double>>();
    modes.left.row(i).head(n) = of_q.row(k).template cast<std::complex<double>>();
    modes.left.row(i).tail(n) = of_rate.row(k).template cast<std::complex<double>>();
  }
  return modes;
}

}  // namespace

std::optional<ComplexModes> complex_modes(const Eigen::MatrixXd& M, const Eigen::MatrixXd& D,
                                          const Eigen::MatrixXd& K, double rate) {
  return M.rows() <= kLongDouble ? modes_in<long double>(M, D, K, rate) : modes_in<double>(M, D, K, rate);
}

}  // namespace signorini
