#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"

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
  const Eigen::Index n = equations.free(), size = equations.size();
  shapes = Q * reduced.shapes;
  left.resize(reduced.mu.size(), 2 * size);
  left.leftCols(size) = reduced.left.leftCols(n) * Q.transpose();
  left.rightCols(size) = reduced.left.rightCols(n) * Q.transpose();
  Eigen::MatrixXcd states(2 * size, reduced.mu.size());
  states.topRows(size) = shapes;
  states.bottomRows(size) = shapes * reduced.mu.asDiagonal();
  row_of_mode = equations.output_of_state * states * reduced.weight.asDiagonal();
}

std::shared_ptr<const ModalBasis> modal_basis(const ModeEquations& equations) {
  std::optional<ComplexModes> modes =
      equations.free() == 0 ? ComplexModes{} : complex_modes(equations.energy());
  if (!modes) return nullptr;
  return std::make_shared<const ModalBasis>(equations, *std::move(modes));
}

ModalFlow::ModalFlow(ModeEquations equations, std::shared_ptr<const ModalBasis> basis)
    : LinearFlow(std::move(equations)), basis_(std::move(basis)) {
  const Eigen::Index harmonics = equations_.harmonics();
  forced_ = Eigen::MatrixXcd::Zero(size(), harmonics);
  Eigen::MatrixXcd waves(2 * size(), harmonics);
  // P_h = Q (of the modes' response), plus the offset of held contacts, which is constant.
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    const Eigen::VectorXcd load = equations_.reduced_load(h);
    if (!load.isZero(0.0))
      forced_.col(h) = equations_.form.basis *
                       basis_->reduced.forced(load, equations_.rates()[static_cast<std::size_t>(h)]);
  }
  forced_.col(0) += equations_.form.offset.cast<Complex>();
  waves.topRows(size()) = forced_;
  for (Eigen::Index h = 0; h < harmonics; ++h)
    waves.col(h).tail(size()) =
        Complex(0.0, equations_.rates()[static_cast<std::size_t>(h)]) * forced_.col(h);
  row_of_harmonic_ = equations_.output_of_state * waves + equations_.output_of_load;
}

Eigen::MatrixXd ModalFlow::transition(double duration) const {
  const int n = size();
  Eigen::MatrixXd result(2 * n, 2 * n);
  // Deviations obey the homogeneous equation: Re sum_k w_k (U_k, mu_k U_k) e^{mu_k s} left_k.
  const Eigen::VectorXcd growth = weight().array() * (mu().array() * duration).exp();
  const Eigen::MatrixXcd scaled = growth.asDiagonal() * basis_->left;
  result.topRows(n) = (basis_->shapes * scaled).real();
  result.bottomRows(n) = (basis_->shapes * mu().asDiagonal() * scaled).real();
  return result;
}

// Re(s l) = Re s Re l - Im s Im l: two columns of a pair, one of a real mode.
TransitionFactors ModalFlow::transition_factors(double duration) const {
  constexpr double kFaded = -50.0;
  const int n = size();
  std::vector<Eigen::Index> alive;
  Eigen::Index columns = 0;
  for (Eigen::Index k = 0; k < mu().size(); ++k) {
    if (mu()[k].real() * duration < kFaded) continue;
    alive.push_back(k);
    columns += mu()[k].imag() > 0.0 ? 2 : 1;
  }
  TransitionFactors factors{.writing = Eigen::MatrixXd(2 * n, columns),
                            .reading = Eigen::MatrixXd(columns, 2 * n)};
  Eigen::Index c = 0;
  for (const Eigen::Index k : alive) {
    const Complex growth = weight()[k] * std::exp(mu()[k] * duration);
    const Eigen::VectorXcd position = growth * basis_->shapes.col(k), velocity = mu()[k] * position;
    factors.writing.col(c) << position.real(), velocity.real();
    factors.reading.row(c++) = basis_->left.row(k).real();
    if (!(mu()[k].imag() > 0.0)) continue;
    factors.writing.col(c) << -position.imag(), -velocity.imag();
    factors.reading.row(c++) = basis_->left.row(k).imag();
  }
  return factors;
}

State ModalFlow::response(const std::vector<Impulse>& impulses) const {
  // All impulses excite the same modes: their amplitudes are summed before the shapes are taken.
  const Eigen::MatrixXcd excited =
      basis_->left.rightCols(size()) * equations_.structure().velocity_per_impulse;
  Eigen::VectorXcd amplitude = Eigen::VectorXcd::Zero(mu().size());
  for (const Impulse& impulse : impulses) {
    amplitude.array() +=
        impulse.value * excited.col(impulse.contact).array() * (impulse.time * mu().array()).exp();
  }
  amplitude.array() *= weight().array();
  const Eigen::VectorXcd rates = mu().cwiseProduct(amplitude);
  return {.u = (basis_->shapes * amplitude).real(), .v = (basis_->shapes * rates).real()};
}

/// A motion as amplitudes of the modes.
class ModalFlow::Arc final : public LinearArc {
 public:
  explicit Arc(const ModalFlow& flow) : LinearArc(flow.equations_), flow_(flow), rates_(equations_.rates()) {
    growth_.resize(flow.mu().size());
    wave_.resize(equations_.harmonics());
    amplitude_.resize(flow.mu().size());
  }

  void start(double time, const State& state) override;
  [[nodiscard]] std::vector<FadingRate> fading_rates(double floor, double step, int order) const override;
  void state(double time, State& state) const override {
    differentiate(time, 0, state.u);
    differentiate(time, 1, state.v);
  }
  void acceleration(double time, Eigen::VectorXd& a) const override { differentiate(time, 2, a); }

 private:
  [[nodiscard]] double output(Eigen::Index row, double time, int order) const override;
  [[nodiscard]] double curvature_bound(Eigen::Index row, double time) const override;
  void differentiate(double time, int order, Eigen::VectorXd& derivative) const;
  [[nodiscard]] double rate(Eigen::Index h) const { return rates_[static_cast<std::size_t>(h)]; }
  void move_to(double time) const;

  const ModalFlow& flow_;
  const std::vector<double>& rates_;  // of the load
  double begin_ = 0.0;
  Eigen::VectorXcd amplitude_;     // a_k
  Eigen::MatrixXcd contribution_;  // row_of_mode times a_k
  mutable double now_ = 0.0;
  mutable bool placed_ = false;
  mutable Eigen::VectorXcd growth_, wave_;  // e^{mu_k s}, e^{i h omega t}
};

// a = left (y - y_forced), y = (u, v); the free motion is what the periodic response does not account for.
// Scalar by scalar, for a product of Eigen's would allocate.
void ModalFlow::Arc::start(double time, const State& state) {
  begin_ = time;
  placed_ = false;
  const int n = flow_.size();
  for (Eigen::Index h = 0; h < wave_.size(); ++h) wave_[h] = std::polar(1.0, rate(h) * time);
  amplitude_.setZero();
  for (int i = 0; i < n; ++i) {
    double u = state.u[i], v = state.v[i];
    for (Eigen::Index h = 0; h < wave_.size(); ++h) {
      const Complex part = flow_.forced_(i, h) * wave_[h];
      u -= part.real();
      v += rate(h) * part.imag();
    }
    amplitude_ += u * flow_.basis_->left.col(i) + v * flow_.basis_->left.col(n + i);
  }
  contribution_ = flow_.basis_->row_of_mode * amplitude_.asDiagonal();
}

std::vector<FadingRate> ModalFlow::Arc::fading_rates(double floor, double step, int order) const {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const ContactDynamics& dynamics = *equations_.dynamics;
  std::vector<FadingRate> terms;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
    double share = 0.0;
    for (int j = 0; j < dynamics.contact_count(); ++j) {
      const Eigen::Index force = equations_.force_row(j);
      share = std::max(share, force < 0 ? std::abs(contribution_(j, k)) / dynamics.scales().displacement
                                        : std::abs(contribution_(force, k)) / dynamics.force_scale(j));
    }
    const Complex mu = flow_.mu()[k];
    share *= std::pow(std::max(1.0, std::abs(mu) * step), order);
    const bool fades = mu.real() < 0.0;
    if (fades && share <= floor) continue;
    // share e^{Re mu (t - begin)} = floor
    terms.push_back(
        {.rate = std::abs(mu), .until = fades ? begin_ + std::log(share / floor) / -mu.real() : kForever});
  }
  terms.push_back({.rate = std::max(rates_.back(), equations_.structure().frequency), .until = kForever});
  std::sort(terms.begin(), terms.end(),
            [](const FadingRate& a, const FadingRate& b) { return a.rate > b.rate; });
  return terms;
}

// Harmonics of the load take the time itself, not the time since the beginning: their phase is that of the
// forcing, and no rounding of begin_ enters it.
void ModalFlow::Arc::move_to(double time) const {
  if (placed_ && now_ == time) return;
  placed_ = true;
  now_ = time;
  const double s = time - begin_;
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    const Complex mu = flow_.mu()[k];
    growth_[k] = std::polar(std::exp(mu.real() * s), mu.imag() * s);
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h)
    wave_[h] = rate(h) == 0.0 ? Complex(1.0) : std::polar(1.0, rate(h) * time);
}

double ModalFlow::Arc::output(Eigen::Index row, double time, int order) const {
  move_to(time);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    Complex term = contribution_(row, k) * growth_[k];
    for (int i = 0; i < order; ++i) term *= flow_.mu()[k];
    sum += term.real();
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    Complex term = flow_.row_of_harmonic_(row, h) * wave_[h];
    for (int i = 0; i < order; ++i) term *= Complex(0.0, rate(h));
    sum += term.real();
  }
  return sum;
}

// The sum of the magnitudes of all terms, |z| <= |Re z| + |Im z|: modes fade, harmonics stay.
double ModalFlow::Arc::curvature_bound(Eigen::Index row, double time) const {
  const auto size = [](const Complex& z) { return std::abs(z.real()) + std::abs(z.imag()); };
  move_to(time);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    const Complex mu = flow_.mu()[k];
    if (mu.real() > 0.0) return LinearArc::curvature_bound(row, time);
    sum += size(contribution_(row, k)) * std::norm(mu) * size(growth_[k]);
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h)
    sum += size(flow_.row_of_harmonic_(row, h)) * rate(h) * rate(h);
  return sum;
}

// order-th derivative (0..2) of u.
void ModalFlow::Arc::differentiate(double time, int order, Eigen::VectorXd& derivative) const {
  move_to(time);
  const int n = flow_.size();
  derivative.setZero(n);
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    Complex a = flow_.weight()[k] * amplitude_[k] * growth_[k];
    for (int i = 0; i < order; ++i) a *= flow_.mu()[k];
    for (int i = 0; i < n; ++i) derivative[i] += (a * flow_.basis_->shapes(i, k)).real();
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    const double r = rate(h);
    for (int i = 0; i < n; ++i) {
      const Complex part = flow_.forced_(i, h) * wave_[h];  // times (i r)^order
      derivative[i] += order == 0 ? part.real() : order == 1 ? -r * part.imag() : -r * r * part.real();
    }
  }
}

std::unique_ptr<LinearArc> ModalFlow::arc() const { return std::make_unique<Arc>(*this); }

}  // namespace signorini
