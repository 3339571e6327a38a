#pragma once
// The linear part of the projected contact equations, harmonic by harmonic, and its mean inverse.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "methods/kernels/projected_law.hpp"
#include "methods/kernels/receptance.hpp"

namespace signorini {

/// B_n = sqrt(c) C_n sqrt(c) - relief, n = 0..H: how y = c (x - g) - relief lambda answers to lambda, both
/// per contact in units of sqrt(c). The projected equations lambda + P max(0, y) = 0 have the Jacobian 1 + P
/// chi B, chi the indicator of contact.
class ContactSymbol {
 public:
  ContactSymbol(const ContactReceptance& receptance, const ProjectedLaw& law);

  [[nodiscard]] int harmonics() const { return static_cast<int>(blocks_.size()) - 1; }
  [[nodiscard]] int contacts() const { return static_cast<int>(root_.size()); }
  /// (2 H + 1) Nc, the size of a packed vector (harmonic_vector.hpp).
  [[nodiscard]] int unknowns() const { return (2 * harmonics() + 1) * contacts(); }
  /// sqrt(c), Nc: lambda [N] is this times the scaled one.
  [[nodiscard]] const Eigen::VectorXd& root() const { return root_; }
  /// B_n, Nc x Nc.
  [[nodiscard]] const Eigen::MatrixXcd& block(Eigen::Index n) const {
    return blocks_[static_cast<std::size_t>(n)];
  }

  /// B_n s_n for every harmonic of a packed vector; (H+1) x Nc.
  [[nodiscard]] Eigen::MatrixXcd rate(const Eigen::VectorXd& packed) const;

 private:
  Eigen::VectorXd root_;
  std::vector<Eigen::MatrixXcd> blocks_;
};

/// (1 + mean(chi) B_n)^{-1} harmonic by harmonic: the inverse of the Jacobian with every contact spread
/// evenly over its period. As a preconditioner it leaves GMRES as many steps as the contacts differ from
/// that: about 150 for 1640 unknowns of 40 contacts, whatever the tolerance (docs/decisions/0010).
class MeanContactInverse {
 public:
  /// \param duty  share of the period that each contact is closed, Nc, in [0, 1] [-]
  MeanContactInverse(const ContactSymbol& symbol, const Eigen::VectorXd& duty);

  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& packed) const;

 private:
  std::vector<Eigen::MatrixXcd> inverses_;
};

}  // namespace signorini
