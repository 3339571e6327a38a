#include "methods/complementarity/contact_symbol.hpp"

#include <Eigen/LU>

#include "methods/discretisation/harmonic_vector.hpp"

namespace signorini {

namespace {

/// Row n of the result is blocks[n] times row n of the packed spectrum.
Eigen::MatrixXcd multiplied(const std::vector<Eigen::MatrixXcd>& blocks, const Eigen::VectorXd& packed) {
  Eigen::MatrixXcd spectrum = unpack_harmonics(packed, static_cast<int>(blocks.size()) - 1);
  for (Eigen::Index n = 0; n < spectrum.rows(); ++n) {
    const Eigen::VectorXcd row = spectrum.row(n).transpose();
    spectrum.row(n).transpose().noalias() = blocks[static_cast<std::size_t>(n)] * row;
  }
  return spectrum;
}

}  // namespace

ContactSymbol::ContactSymbol(const ContactReceptance& receptance, const ProjectedLaw& law)
    : root_(law.constant.cwiseSqrt()) {
  blocks_.reserve(receptance.receptance.size());
  for (const Eigen::MatrixXcd& c : receptance.receptance) {
    blocks_.emplace_back(root_.asDiagonal() * c * root_.asDiagonal());
    blocks_.back().diagonal() -= law.multiplier_weight;
  }
}

Eigen::MatrixXcd ContactSymbol::rate(const Eigen::VectorXd& packed) const {
  return multiplied(blocks_, packed);
}

LastingContactInverse::LastingContactInverse(const ContactSymbol& symbol, const Eigen::VectorXd& duty) {
  std::vector<int> lasting;
  for (int c = 0; c < symbol.contacts(); ++c) {
    if (duty[c] > 0.5) lasting.push_back(c);
  }
  if (lasting.empty()) return;
  inverses_.reserve(static_cast<std::size_t>(symbol.harmonics()) + 1);
  for (Eigen::Index n = 0; n <= symbol.harmonics(); ++n) {
    Eigen::MatrixXcd block = Eigen::MatrixXcd::Identity(symbol.contacts(), symbol.contacts());
    for (const int c : lasting) block.row(c) += symbol.block(n).row(c);
    inverses_.emplace_back(block.partialPivLu().inverse());
    // Nc x Nc only; where that is singular by accident, the identity serves as well.
    if (!inverses_.back().allFinite()) inverses_.back().setIdentity();
  }
}

Eigen::VectorXd LastingContactInverse::operator*(const Eigen::VectorXd& packed) const {
  return inverses_.empty() ? packed : pack_harmonics(multiplied(inverses_, packed));
}

}  // namespace signorini
