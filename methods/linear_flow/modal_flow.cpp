#include <cmath>
#include <complex>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"
#include "methods/linear_flow/modes/waves.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

using Complex = std::complex<double>;

ModalFlow::ModalFlow(ModeEquations equations, std::shared_ptr<const ModalBasis> basis)
    : LinearFlow(std::move(equations)), basis_(std::move(basis)) {
  const Eigen::Index harmonics = equations_.harmonics();
  forced_ = Eigen::MatrixXcd::Zero(positions(), harmonics);
  // P_h = Q (of the modes' response), plus the offset of held contacts, which is constant.
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    const Eigen::VectorXcd load = equations_.reduced_load(h);
    if (load.isZero(0.0)) continue;
    const Eigen::VectorXcd response =
        basis_->reduced.forced(load, equations_.rates()[static_cast<std::size_t>(h)]);
    forced_.col(h).head(size()) =
        equations_.free() == size() ? response : image_of_complex(equations_.form.basis, response);
  }
  forced_.col(0).head(size()) += equations_.form.offset.cast<Complex>();
  if (positions() > size()) force_relaxing();
  Eigen::MatrixXcd waves(states(), harmonics);
  waves.topRows(positions()) = forced_;
  for (Eigen::Index h = 0; h < harmonics; ++h)
    waves.col(h).tail(size()) =
        Complex(0.0, equations_.rates()[static_cast<std::size_t>(h)]) * forced_.col(h).head(size());
  row_of_harmonic_ = product_of_complex(equations_.output_of_state, waves) + equations_.output_of_load;
}

// Of what relaxes alone, z = shift / (1 + i beta rate), and of what follows u.
void ModalFlow::force_relaxing() {
  const RelaxingForm& relaxing = equations_.form.relaxing;
  const Eigen::Index contacts = positions() - size();
  for (Eigen::Index h = 0; h < forced_.cols(); ++h) {
    Eigen::VectorXcd alone = relaxing.shift.col(h);
    for (Eigen::Index k = 0; k < alone.size(); ++k)
      alone[k] /= Complex(1.0, relaxing.times[k] * equations_.rates()[static_cast<std::size_t>(h)]);
    forced_.col(h).tail(contacts) =
        image_in_complex(relaxing.of_u, forced_.col(h).head(size())) + image_in_complex(relaxing.of_z, alone);
  }
  forced_.col(0).tail(contacts) += relaxing.offset.cast<Complex>();
}

// Deviations obey the homogeneous equation: Re sum_k w_k (U_k, mu_k U_k) e^{mu_k s} left_k.
Eigen::MatrixXd ModalFlow::transition(double duration) const {
  const TransitionFactors factors = transition_factors(duration);
  return product(factors.writing, factors.reading);
}

// Re(s l) = Re s Re l - Im s Im l: two columns of a pair, one of a real mode.
TransitionFactors ModalFlow::transition_factors(double duration) const {
  std::vector<Eigen::Index> alive;
  Eigen::Index columns = 0;
  for (Eigen::Index k = 0; k < mu().size(); ++k) {
    if (has_faded(mu()[k], duration)) continue;
    alive.push_back(k);
    columns += mu()[k].imag() > 0.0 ? 2 : 1;
  }
  TransitionFactors factors{.writing = Eigen::MatrixXd(states(), columns),
                            .reading = Eigen::MatrixXd(columns, states())};
  Eigen::Index c = 0;
  for (const Eigen::Index k : alive) {
    const Complex growth = weight()[k] * std::exp(mu()[k] * duration);
    const bool pair = mu()[k].imag() > 0.0;
    for (Eigen::Index i = 0; i < states(); ++i) {
      const Complex position = growth * basis_->shapes(i < positions() ? i : i - positions(), k);
      const Complex written = i < positions() ? position : mu()[k] * position;
      factors.writing(i, c) = written.real();
      if (pair) factors.writing(i, c + 1) = -written.imag();
    }
    c += pair ? 2 : 1;
  }
  for (Eigen::Index i = 0; i < states(); ++i) {  // column by column, as they lie in memory
    double* read = factors.reading.col(i).data();
    for (const Eigen::Index k : alive) {
      *read++ = basis_->left(k, i).real();
      if (mu()[k].imag() > 0.0) *read++ = basis_->left(k, i).imag();
    }
  }
  return factors;
}

State ModalFlow::response(const std::vector<Impulse>& impulses) const {
  if (impulses.empty()) return equations_.dynamics->at_rest();  // there may be no contact that takes one
  // All impulses excite the same modes: their amplitudes are summed before the shapes are taken.
  const FlowStructure& structure = equations_.structure();
  Eigen::MatrixXcd excited = product_by_real(basis_->left.rightCols(size()), structure.velocity_per_impulse);
  if (positions() > size())  // xi takes C p / beta at once
    excited +=
        product_by_real(basis_->left.middleCols(size(), positions() - size()),
                        structure.xi_times.cwiseInverse().asDiagonal() * structure.massless_compliance);
  Eigen::VectorXcd amplitude = Eigen::VectorXcd::Zero(mu().size());
  for (const Impulse& impulse : impulses) {
    for (Eigen::Index k = 0; k < amplitude.size(); ++k)
      amplitude[k] += impulse.value * excited(k, impulse.contact) * std::exp(impulse.time * mu()[k]);
  }
  for (Eigen::Index k = 0; k < amplitude.size(); ++k) amplitude[k] *= weight()[k];
  const Eigen::VectorXcd rates = mu().cwiseProduct(amplitude);
  return {.u = complex_image(basis_->shapes, amplitude).real(),
          .v = complex_image(basis_->shapes.topRows(size()), rates).real()};
}

}  // namespace signorini
