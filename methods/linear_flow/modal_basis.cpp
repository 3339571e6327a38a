#include <algorithm>
#include <complex>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

using Complex = std::complex<double>;

bool resonates(const ModeEquations& equations, const ComplexModes& modes) {
  // The periodic response to a load near an eigenvalue is 1 / |i rate - mu| as large as the load, the free
  // motion cancels it: at a relative distance of 1e-4 four digits are lost.
  constexpr double kResonance = 1e-4;
  if (equations.free() == 0) return false;  // nothing moves
  for (Eigen::Index h = 0; h < equations.harmonics(); ++h) {
    if (equations.reduced_load(h).isZero(0.0)) continue;
    const double rate = equations.rates()[static_cast<std::size_t>(h)];
    if ((modes.mu.array() - Complex(0.0, rate)).abs().minCoeff() <
        kResonance * std::max(rate, equations.structure().frequency))
      return true;
  }
  return false;
}

ModalBasis::ModalBasis(const ModeEquations& equations, ComplexModes modes) : reduced(std::move(modes)) {
  const Eigen::MatrixXd& Q = equations.form.basis;
  const RelaxingForm& relaxing = equations.form.relaxing;
  const Eigen::Index n = equations.free(), size = equations.size(), positions = equations.positions();
  const Eigen::Index moving = reduced.mu.size(), alone = relaxing.of_z.cols();
  mu = Eigen::VectorXcd(moving + alone);
  mu.head(moving) = reduced.mu;
  mu.tail(alone) = -relaxing.times.cwiseInverse().cast<Complex>();
  weight = Eigen::VectorXd::Ones(moving + alone);
  weight.head(moving) = reduced.weight;
  shapes = Eigen::MatrixXcd::Zero(positions, moving + alone);
  left = Eigen::MatrixXcd::Zero(moving + alone, positions + size);
  if (n == size) {  // Q is the identity
    shapes.topLeftCorner(size, moving) = reduced.shapes;
    left.topLeftCorner(moving, size) = reduced.left.leftCols(n);
    left.topRightCorner(moving, size) = reduced.left.rightCols(n);
  } else {
    shapes.topLeftCorner(size, moving) = product_of_complex(Q, reduced.shapes);
    left.topLeftCorner(moving, size) = product_by_real_transposed(reduced.left.leftCols(n), Q);
    left.topRightCorner(moving, size) = product_by_real_transposed(reduced.left.rightCols(n), Q);
  }
  if (positions > size) {
    shapes.bottomLeftCorner(positions - size, moving) =
        product_in_complex(relaxing.of_u, shapes.topLeftCorner(size, moving));
    shapes.bottomRightCorner(positions - size, alone) = relaxing.of_z.cast<Complex>();
    left.block(moving, size, alone, positions - size) = relaxing.of_xi.cast<Complex>();
  }
  Eigen::MatrixXcd states(positions + size, moving + alone);
  states.topRows(positions) = shapes;
  for (Eigen::Index k = 0; k < mu.size(); ++k)
    for (Eigen::Index i = 0; i < size; ++i) states(positions + i, k) = shapes(i, k) * mu[k];
  row_of_mode = product_of_complex(equations.output_of_state, states);
  for (Eigen::Index k = 0; k < mu.size(); ++k)
    for (Eigen::Index row = 0; row < row_of_mode.rows(); ++row) row_of_mode(row, k) *= weight[k];
  reduced.left.resize(0, 0);  // which `left` holds: a fourth of what there is to keep
}

std::shared_ptr<const ModalBasis> modal_basis(const ModeEquations& equations) {
  std::optional<ComplexModes> modes =
      equations.free() == 0 ? ComplexModes{}
                            : complex_modes(equations.mass_form(), equations.structure().frequency);
  if (!modes) return nullptr;
  return std::make_shared<const ModalBasis>(equations, *std::move(modes));
}

}  // namespace signorini
