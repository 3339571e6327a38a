#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

using Complex = std::complex<double>;

std::optional<ComplexModes> modes_of_flow(const ModeEquations& equations, const EnergyForm& energy) {
  // The periodic response to a load near an eigenvalue is 1 / |i rate - mu| as large as the load, the free
  // motion cancels it: at a relative distance of 1e-4 four digits are lost.
  constexpr double kResonance = 1e-4;
  if (equations.free() == 0) return ComplexModes{};  // nothing moves
  std::optional<ComplexModes> modes = complex_modes(energy);
  if (!modes) return std::nullopt;
  for (Eigen::Index h = 0; h < equations.harmonics(); ++h) {
    if (equations.reduced_load(h).isZero(0.0)) continue;
    const double rate = equations.rates()[static_cast<std::size_t>(h)];
    if ((modes->mu.array() - Complex(0.0, rate)).abs().minCoeff() <
        kResonance * std::max(rate, equations.structure().frequency))
      return std::nullopt;
  }
  return modes;
}

ModalFlow::ModalFlow(ModeEquations equations, const ComplexModes& modes)
    : LinearFlow(std::move(equations)), mu_(modes.mu), weight_(modes.weight) {
  const Eigen::MatrixXd& Q = equations_.form.basis;
  const Eigen::Index n = equations_.free(), harmonics = equations_.harmonics();
  shapes_ = Q * modes.shapes;
  left_.resize(mu_.size(), 2 * size());
  left_.leftCols(size()) = modes.left.leftCols(n) * Q.transpose();
  left_.rightCols(size()) = modes.left.rightCols(n) * Q.transpose();
  forced_ = Eigen::MatrixXcd::Zero(size(), harmonics);
  Eigen::MatrixXcd states(2 * size(), mu_.size()), waves(2 * size(), harmonics);
  // P_h = Q (of the modes' response), plus the offset of held contacts, which is constant.
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    const Eigen::VectorXcd load = equations_.reduced_load(h);
    if (!load.isZero(0.0))
      forced_.col(h) = Q * modes.forced(load, equations_.rates()[static_cast<std::size_t>(h)]);
  }
  forced_.col(0) += equations_.form.offset.cast<Complex>();
  states.topRows(size()) = shapes_;
  states.bottomRows(size()) = shapes_ * mu_.asDiagonal();
  waves.topRows(size()) = forced_;
  for (Eigen::Index h = 0; h < harmonics; ++h)
    waves.col(h).tail(size()) =
        Complex(0.0, equations_.rates()[static_cast<std::size_t>(h)]) * forced_.col(h);
  row_of_mode_ = equations_.output_of_state * states * weight_.asDiagonal();
  row_of_harmonic_ = equations_.output_of_state * waves + equations_.output_of_load;
}

Eigen::MatrixXd ModalFlow::transition(double duration) const {
  const int n = size();
  Eigen::MatrixXd result(2 * n, 2 * n);
  // Deviations obey the homogeneous equation: Re sum_k w_k (U_k, mu_k U_k) e^{mu_k s} left_k.
  const Eigen::VectorXcd growth = weight_.array() * (mu_.array() * duration).exp();
  const Eigen::MatrixXcd scaled = growth.asDiagonal() * left_;
  result.topRows(n) = (shapes_ * scaled).real();
  result.bottomRows(n) = (shapes_ * mu_.asDiagonal() * scaled).real();
  return result;
}

State ModalFlow::response(const std::vector<Impulse>& impulses) const {
  // All impulses excite the same modes: their amplitudes are summed before the shapes are taken.
  const Eigen::MatrixXcd excited = left_.rightCols(size()) * equations_.structure().velocity_per_impulse;
  Eigen::VectorXcd amplitude = Eigen::VectorXcd::Zero(mu_.size());
  for (const Impulse& impulse : impulses) {
    amplitude.array() +=
        impulse.value * excited.col(impulse.contact).array() * (impulse.time * mu_.array()).exp();
  }
  amplitude.array() *= weight_.array();
  const Eigen::VectorXcd rates = mu_.cwiseProduct(amplitude);
  return {.u = (shapes_ * amplitude).real(), .v = (shapes_ * rates).real()};
}

/// A motion as amplitudes of the modes.
class ModalFlow::Arc final : public LinearArc {
 public:
  explicit Arc(const ModalFlow& flow) : LinearArc(flow.equations_), flow_(flow), rates_(equations_.rates()) {
    growth_.resize(flow.mu_.size());
    wave_.resize(equations_.harmonics());
    amplitude_.resize(flow.mu_.size());
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
    amplitude_ += u * flow_.left_.col(i) + v * flow_.left_.col(n + i);
  }
  contribution_ = flow_.row_of_mode_ * amplitude_.asDiagonal();
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
    const Complex mu = flow_.mu_[k];
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
    const Complex mu = flow_.mu_[k];
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
    for (int i = 0; i < order; ++i) term *= flow_.mu_[k];
    sum += term.real();
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    Complex term = flow_.row_of_harmonic_(row, h) * wave_[h];
    for (int i = 0; i < order; ++i) term *= Complex(0.0, rate(h));
    sum += term.real();
  }
  return sum;
}

// order-th derivative (0..2) of u.
void ModalFlow::Arc::differentiate(double time, int order, Eigen::VectorXd& derivative) const {
  move_to(time);
  const int n = flow_.size();
  derivative.setZero(n);
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    Complex a = flow_.weight_[k] * amplitude_[k] * growth_[k];
    for (int i = 0; i < order; ++i) a *= flow_.mu_[k];
    for (int i = 0; i < n; ++i) derivative[i] += (a * flow_.shapes_(i, k)).real();
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
