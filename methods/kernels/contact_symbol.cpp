#include "methods/kernels/contact_symbol.hpp"

#include <Eigen/LU>

#include "methods/kernels/harmonic_vector.hpp"

namespace signorini {

namespace {

/// Row n of the result is blocks[n] times row n of the packed spectrum.
Eigen::MatrixXcd multiplied(const std::vector<Eigen::MatrixXcd>& blocks, const Eigen::VectorXd& packed) {
  Eigen::MatrixXcd spectrum = unpack_harmonics(packed, static_cast<int>(blocks.size()) - 1);
  Eigen::VectorXcd row(spectrum.cols());
  for (Eigen::Index n = 0; n < spectrum.rows(); ++n) {
    row.noalias() = blocks[static_cast<std::size_t>(n)] * spectrum.row(n).transpose();
    spectrum.row(n) = row.transpose();
  }
  return spectrum;
}

}  // namespace

ContactSymbol::ContactSymbol(const ContactReceptance& receptance, const ProjectedLaw& law)
    : root_(law.constant.cwiseSqrt()) {
  blocks_.reserve(receptance.receptance.size());
  for (const Eigen::MatrixXcd& c : receptance.receptance) {
    blocks_.emplace_back(root_.asDiagonal() * c * root_.asDiagonal());
    blocks_.back().diagonal() -= law.relief;
  }
}

Eigen::MatrixXcd ContactSymbol::rate(const Eigen::VectorXd& packed) const {
  return multiplied(blocks_, packed);
}

MeanContactInverse::MeanContactInverse(const ContactSymbol& symbol, const Eigen::VectorXd& duty) {
  for (Eigen::Index n = 0; n <= symbol.harmonics(); ++n) {
    Eigen::MatrixXcd block = duty.asDiagonal() * symbol.block(n);
    block.diagonal().array() += 1.0;
    // Nc x Nc only; where the mean Jacobian is singular by accident, the identity serves as well.
    inverses_.emplace_back(block.partialPivLu().inverse());
    if (!inverses_.back().allFinite()) inverses_.back().setIdentity();
  }
}

Eigen::VectorXd MeanContactInverse::operator*(const Eigen::VectorXd& packed) const {
  return pack_harmonics(multiplied(inverses_, packed));
}

}  // namespace signorini
