#pragma once
// The linear part of the projected contact equations, harmonic by harmonic, and a preconditioner.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "methods/complementarity/projected_law.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// B_n = sqrt(c) C_n sqrt(c) - alpha, n = 0..H: how y = c (x - g) - alpha lambda answers to lambda, both per
/// contact in units of sqrt(c). The projected equations lambda + P max(0, y) = 0 have the Jacobian 1 + P chi
/// B, chi the indicator of contact.
class ContactSymbol {
 public:
  /// B_n of these C_n under this law.
  ContactSymbol(const ContactReceptance& receptance, const ProjectedLaw& law);

  /// H.
  [[nodiscard]] int harmonics() const { return static_cast<int>(blocks_.size()) - 1; }
  /// Nc.
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

/// The inverse of the Jacobian, harmonic by harmonic, as if every contact that is closed for more than half
/// of the period were closed throughout, and the others open: exact for permanent contact, the identity for
/// short ones. What is left is of low rank, a few dimensions per interval of contact: GMRES takes 6 to 8
/// steps for impacts, whatever H, and 18 for 40 contacts. Spreading each contact evenly over the period
/// instead, (1 + mean(chi) B_n)^{-1}, takes five times as many (docs/decisions/0010).
class LastingContactInverse {
 public:
  /// \param duty  share of the period that each contact is closed, Nc, in [0, 1] [-]
  LastingContactInverse(const ContactSymbol& symbol, const Eigen::VectorXd& duty);

  /// The inverse times a packed vector.
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& packed) const;

 private:
  std::vector<Eigen::MatrixXcd> inverses_;
};

}  // namespace signorini
