#pragma once
// The alternating frequency/time residual and its products, matrix-free.

#include <Eigen/Core>
#include <vector>

#include "methods/kernels/projected_law.hpp"
#include "methods/kernels/real_fft.hpp"
#include "methods/kernels/receptance.hpp"

namespace signorini {

/// R(lambda, tau) = lambda + P [chi y],   y = y_f + B lambda - tau d,
///
/// per contact in units of sqrt(c): lambda = lambda_physical / sqrt(c), y_f = sqrt(c) (x_f - g),
/// B_n = sqrt(c) C_n sqrt(c) - relief, d the gap shift per unit of tau (1 for the stiffest contact, but for
/// the part in 1e9 that separates ties). chi marks the samples in contact; chi = {y > 0} gives the residual
/// proper. Unknowns are real, as in harmonic_vector.hpp: |lambda|_2 is the root mean square in time.
class AftResidual {
 public:
  AftResidual(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
              int samples);

  [[nodiscard]] int unknowns() const { return (2 * harmonics_ + 1) * contacts_; }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] int contacts() const { return contacts_; }
  /// Root mean square of the load on the constraint, |max(0, y_f)|_2: the scale of the residual.
  [[nodiscard]] double load_scale() const { return load_scale_; }

  /// y at the samples, N Nc.
  [[nodiscard]] Eigen::VectorXd gap_function(const Eigen::VectorXd& lambda, double tau);
  /// B v at the samples, N Nc.
  [[nodiscard]] Eigen::VectorXd gap_rate(const Eigen::VectorXd& v);
  /// d at every sample, N Nc.
  [[nodiscard]] const Eigen::VectorXd& shift() const { return shift_; }
  /// P s of a signal at the samples.
  [[nodiscard]] Eigen::VectorXd project(const Eigen::VectorXd& signal);
  /// lambda + P max(0, y); also the signal max(0, y)'s pattern.
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& lambda, std::vector<char>& contact);
  /// J v = v + P chi B v.
  [[nodiscard]] Eigen::VectorXd product(const std::vector<char>& contact, const Eigen::VectorXd& v);
  /// Adopts the harmonic-wise preconditioner (1 + mean(chi) B_n)^{-1} for this contact pattern.
  void prepare_preconditioner(const std::vector<char>& contact);
  [[nodiscard]] Eigen::VectorXd precondition(const Eigen::VectorXd& v) const;

  /// Unscaled coefficients n = 0..H of lambda, (H+1) x Nc [N], and back.
  [[nodiscard]] Eigen::MatrixXcd coefficients(const Eigen::VectorXd& lambda) const;
  [[nodiscard]] Eigen::VectorXd unknowns_of(const Eigen::MatrixXcd& coefficients) const;

 private:
  int harmonics_, contacts_, samples_;
  std::vector<Eigen::MatrixXcd> symbol_;          // B_n
  std::vector<Eigen::MatrixXcd> preconditioner_;  // Nc x Nc per harmonic
  Eigen::VectorXd root_;                          // sqrt(c)
  Eigen::VectorXd free_;                          // y_f at the samples
  Eigen::VectorXd shift_;
  double load_scale_ = 0.0;
  RealFft fft_;
};

}  // namespace signorini
