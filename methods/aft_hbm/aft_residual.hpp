#pragma once
// The alternating frequency/time residual and its products, matrix-free.

#include <Eigen/Core>
#include <vector>

#include "methods/complementarity/contact_symbol.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// R(lambda) = lambda + P max(0, y),   y = y_f + B lambda,
///
/// per contact in units of sqrt(c): lambda = lambda_physical / sqrt(c), y_f = sqrt(c) (x_f - g),
/// B_n = sqrt(c) C_n sqrt(c) - relief. Unknowns are real, as in harmonic_vector.hpp: |lambda|_2 is the root
/// mean square in time.
class AftResidual {
 public:
  AftResidual(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
              int samples);

  [[nodiscard]] int unknowns() const { return symbol_.unknowns(); }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] int contacts() const { return symbol_.contacts(); }
  /// Root mean square of the load on the constraint, |max(0, y_f)|_2: the scale of the residual.
  [[nodiscard]] double load_scale() const { return load_scale_; }

  /// B v at the samples, N Nc.
  [[nodiscard]] Eigen::VectorXd gap_rate(const Eigen::VectorXd& v);
  /// P s of a signal at the samples.
  [[nodiscard]] Eigen::VectorXd project(const Eigen::VectorXd& signal);
  /// R, and in `contact` where y > 0, N Nc.
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& lambda, std::vector<char>& contact);
  /// J v = v + P chi B v.
  [[nodiscard]] Eigen::VectorXd product(const std::vector<char>& contact, const Eigen::VectorXd& v);
  /// The preconditioner of J for this contact pattern.
  [[nodiscard]] LastingContactInverse lasting_inverse(const std::vector<char>& contact) const;

  /// Unscaled coefficients n = 0..H of lambda, (H+1) x Nc [N], and back.
  [[nodiscard]] Eigen::MatrixXcd coefficients(const Eigen::VectorXd& lambda) const;
  [[nodiscard]] Eigen::VectorXd unknowns_of(const Eigen::MatrixXcd& coefficients) const;

 private:
  ContactSymbol symbol_;
  int samples_;
  Eigen::VectorXd free_;  // y_f at the samples
  double load_scale_ = 0.0;
  RealFft fft_;
};

}  // namespace signorini
