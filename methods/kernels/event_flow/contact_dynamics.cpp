#include "methods/kernels/event_flow/contact_dynamics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace signorini {

bool ContactMode::closed(int contact) const {
  return std::binary_search(active.begin(), active.end(), contact);
}

ContactDynamics::ContactDynamics(const Problem& problem)
    : mass_matrix_(problem.mass),
      stiffness_(problem.stiffness),
      damping_(problem.damping),
      force_(problem.force),
      directions_(contact_directions(problem)),
      gaps_(contact_gaps(problem)),
      highest_harmonic_(std::max(1, highest_load_harmonic(problem))),
      frequency_(problem.frequency),
      forcing_period_(2.0 * std::numbers::pi / problem.frequency) {
  mass_.compute(problem.mass);
  if (mass_.info() != Eigen::Success) {
    throw std::runtime_error("the mass matrix is singular: time marching needs M positive definite");
  }
  if (const auto* law = std::get_if<Restitution>(&problem.law)) restitution_ = law->e;
  if (const auto* law = std::get_if<Penalty>(&problem.law)) {
    penalty_ = Eigen::VectorXd::Map(law->stiffness.data(), static_cast<Eigen::Index>(law->stiffness.size()));
  }
  impulse_response_ = mass_.solve(directions_);
  delassus_ = directions_.transpose() * impulse_response_;
  prepare_small();
  measure_rates();
  measure_scales(problem);
}

void ContactDynamics::prepare_small() {
  constexpr int kSmall = 32;  // a dense product is then no dearer than sparse ones and a sparse solve
  small_ = size() <= kSmall;
  if (!small_) return;
  inverse_mass_stiffness_ = mass_.solve(Eigen::MatrixXd(stiffness_));
  inverse_mass_damping_ = mass_.solve(Eigen::MatrixXd(damping_));
  for (int h = 0; h <= highest_harmonic_; ++h) {
    Eigen::VectorXd cos = Eigen::VectorXd::Zero(size()), sin = cos;
    for (const ForceTerm& term : force_) {
      if (term.harmonic != h) continue;
      cos[term.dof] += term.cos;
      sin[term.dof] += term.sin;
    }
    if (cos.isZero(0.0) && sin.isZero(0.0)) continue;
    load_rates_.push_back({.rate = h * frequency_, .cos = mass_.solve(cos), .sin = mass_.solve(sin)});
  }
}

std::vector<double> ContactDynamics::load_rates() const {
  std::vector<double> rates{0.0};
  for (const ForceTerm& term : force_) {
    const double rate = term.harmonic * frequency_;
    if (std::find(rates.begin(), rates.end(), rate) == rates.end()) rates.push_back(rate);
  }
  std::sort(rates.begin(), rates.end());
  return rates;
}

Eigen::MatrixXcd ContactDynamics::load_amplitudes() const {
  const std::vector<double> rates = load_rates();
  Eigen::MatrixXcd loads = Eigen::MatrixXcd::Zero(size(), static_cast<Eigen::Index>(rates.size()));
  for (const ForceTerm& term : force_) {
    const auto at = std::lower_bound(rates.begin(), rates.end(), term.harmonic * frequency_) - rates.begin();
    loads(term.dof, at) += std::complex<double>(term.cos, term.harmonic == 0 ? 0.0 : -term.sin);
  }
  return loads;
}

ContactMode ContactDynamics::mode(const std::vector<bool>& closed) const {
  ContactMode result;
  for (int j = 0; j < contact_count(); ++j) {
    if (closed[static_cast<std::size_t>(j)]) result.active.push_back(j);
  }
  if (rigid() && !result.active.empty()) {
    const Eigen::MatrixXd G = delassus_(result.active, result.active);
    result.response = G.completeOrthogonalDecomposition().pseudoInverse();
  }
  return result;
}

Eigen::VectorXd ContactDynamics::load_derivative(double time, int order) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(size());
  for (const ForceTerm& term : force_) {
    const double rate = term.harmonic * frequency_;
    if (rate == 0.0) {
      if (order == 0) load[term.dof] += term.cos;
      continue;
    }
    const double angle = rate * time + 0.5 * std::numbers::pi * order;
    const double factor = order == 0 ? 1.0 : std::pow(rate, order);
    load[term.dof] += factor * (term.cos * std::cos(angle) + term.sin * std::sin(angle));
  }
  return load;
}

// lambda_A that cancels the acceleration W_A^T `free` of a structure without contact forces.
Eigen::VectorXd ContactDynamics::multiplier(const ContactMode& mode, const Eigen::VectorXd& free) const {
  return -mode.response * (directions_(Eigen::all, mode.active).transpose() * free);
}

void ContactDynamics::acceleration(const ContactMode& mode, double time,
                                   const Eigen::Ref<const Eigen::VectorXd>& u,
                                   const Eigen::Ref<const Eigen::VectorXd>& v,
                                   Eigen::Ref<Eigen::VectorXd> a) const {
  if (small_) {
    a.noalias() = inverse_mass_stiffness_.lazyProduct(-u);
    a.noalias() -= inverse_mass_damping_.lazyProduct(v);
    for (const LoadRate& load : load_rates_) {
      a += std::cos(load.rate * time) * load.cos + std::sin(load.rate * time) * load.sin;
    }
  } else {
    Eigen::VectorXd force = load_derivative(time, 0);
    force.noalias() -= stiffness_ * u;
    force.noalias() -= damping_ * v;
    a = mass_.solve(force);
  }
  if (mode.active.empty()) return;
  if (rigid()) {
    a += impulse_response_(Eigen::all, mode.active) * multiplier(mode, a);
  } else {
    for (const int j : mode.active)
      a -= impulse_response_.col(j) * (penalty_[j] * (directions_.col(j).dot(u) - gaps_[j]));
  }
}

MotionDerivatives ContactDynamics::derivatives(const ContactMode& mode, double time, const State& state,
                                               int order) const {
  MotionDerivatives result{.u = Eigen::MatrixXd::Zero(size(), order + 1),
                           .lambda = Eigen::MatrixXd::Zero(contact_count(), order - 1)};
  result.u.col(0) = state.u;
  result.u.col(1) = state.v;
  for (int k = 0; k + 2 <= order; ++k) {
    Eigen::VectorXd force =
        load_derivative(time, k) - stiffness_ * result.u.col(k) - damping_ * result.u.col(k + 1);
    if (!rigid()) {
      for (const int j : mode.active) {
        result.lambda(j, k) =
            -penalty_[j] * (directions_.col(j).dot(result.u.col(k)) - (k == 0 ? gaps_[j] : 0.0));
        force += directions_.col(j) * result.lambda(j, k);
      }
    }
    Eigen::VectorXd next = mass_.solve(force);
    if (rigid() && !mode.active.empty()) {
      const Eigen::VectorXd lambda = multiplier(mode, next);
      next += impulse_response_(Eigen::all, mode.active) * lambda;
      result.lambda(mode.active, k) = lambda;
    }
    result.u.col(k + 2) = next;
  }
  return result;
}

Eigen::MatrixXd ContactDynamics::flow_matrix(const ContactMode& mode) const {
  const int n = size();
  Eigen::MatrixXd stiffness = stiffness_;
  if (!rigid()) {
    for (const int j : mode.active)
      stiffness += penalty_[j] * directions_.col(j) * directions_.col(j).transpose();
  }
  Eigen::MatrixXd from_u = -mass_.solve(stiffness);
  Eigen::MatrixXd from_v = -mass_.solve(Eigen::MatrixXd(damping_));
  if (rigid() && !mode.active.empty()) {
    const Eigen::MatrixXd back = impulse_response_(Eigen::all, mode.active) * mode.response;
    const Eigen::MatrixXd ahead = directions_(Eigen::all, mode.active).transpose();
    from_u -= back * (ahead * from_u);
    from_v -= back * (ahead * from_v);
  }
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  B.topRightCorner(n, n).setIdentity();
  B.bottomLeftCorner(n, n) = from_u;
  B.bottomRightCorner(n, n) = from_v;
  return B;
}

// Power iteration; the factor covers its slow last digits. An estimate is enough: it only sizes steps.
void ContactDynamics::measure_rates() {
  constexpr int kIterations = 40;
  constexpr double kMargin = 1.1;
  const auto largest = [&](const SparseMatrix& A) {
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size(), 1.0, 2.0);
    for (int i = 1; i < size(); i += 2) x[i] = -x[i];  // the fastest modes alternate in sign
    double value = 0.0;
    for (int k = 0; k < kIterations && x.norm() > 0.0; ++k) {
      x.normalize();
      x = mass_.solve(A * x);
      value = x.norm();
    }
    return value;
  };
  fastest_rate_ = std::max({kMargin * std::sqrt(largest(stiffness_)), kMargin * largest(damping_),
                            highest_harmonic_ * frequency_});
}

// Largest coordinate of the contact-free periodic response [m]; infinite or NaN at an undamped resonance.
double ContactDynamics::linear_amplitude(const Problem& problem) const {
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(size());
  for (int h = 0; h <= highest_load_harmonic(problem); ++h) {
    const Eigen::VectorXcd load = load_harmonic(problem, h);
    if (load.isZero(0.0)) continue;
    const double w = h * frequency_;
    const std::complex<double> iw(0.0, w);
    const Eigen::MatrixXcd Z =
        Eigen::MatrixXcd((problem.stiffness - w * w * problem.mass).cast<std::complex<double>>()) +
        iw * Eigen::MatrixXcd(damping_.cast<std::complex<double>>());
    amplitude += Eigen::VectorXcd(Z.partialPivLu().solve(load)).cwiseAbs();
  }
  return amplitude.size() == 0 ? 0.0 : amplitude.maxCoeff();
}

// What the load moves without help from a resonance: |f_i| / (K_ii + (h omega)^2 M_ii) [m].
double ContactDynamics::forced_amplitude(const Problem& problem) const {
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(size());
  const Eigen::VectorXd k = problem.stiffness.diagonal(), m = problem.mass.diagonal();
  for (const ForceTerm& term : force_) {
    const double w = std::max(1, term.harmonic) * frequency_;
    amplitude[term.dof] += std::hypot(term.cos, term.sin) / (k[term.dof] + w * w * m[term.dof]);
  }
  return amplitude.maxCoeff();
}

void ContactDynamics::measure_scales(const Problem& problem) {
  constexpr double kResonance = 1e6;  // beyond this the linear response is only the round-off of a resonance
  const double linear = linear_amplitude(problem);
  const double gap = gaps_.size() == 0 ? 0.0 : gaps_.cwiseAbs().maxCoeff();
  const double limited = std::max(gap, forced_amplitude(problem));
  const bool usable =
      linear > 0.0 && linear <= kResonance * limited && (contact_count() == 0 || linear < limited);
  double X = usable ? linear : limited;
  if (!(X > 0.0) || !std::isfinite(X)) X = 1.0;  // nothing moves: any unit will do
  scales_ = {.displacement = X, .velocity = frequency_ * X, .acceleration = fastest_rate_ * frequency_ * X};
}

}  // namespace signorini
