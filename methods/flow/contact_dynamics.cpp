#include "methods/flow/contact_dynamics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "methods/structure/condensation.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

bool ContactMode::closed(int contact) const {
  return std::binary_search(active.begin(), active.end(), contact);
}

namespace {

// Re sum_h A_h (i r_h)^order e^{i r_h time}.
Eigen::VectorXd wave_derivative(const Eigen::MatrixXcd& amplitudes, const std::vector<double>& rates,
                                double time, int order) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(amplitudes.rows());
  for (std::size_t h = 0; h < rates.size(); ++h) {
    if (rates[h] == 0.0 && order > 0) continue;
    const double angle = rates[h] * time + 0.5 * std::numbers::pi * order;
    const double factor = order == 0 ? 1.0 : std::pow(rates[h], order);
    const auto column = amplitudes.col(static_cast<Eigen::Index>(h));
    sum += factor * (std::cos(angle) * column.real() - std::sin(angle) * column.imag());
  }
  return sum;
}

// The inverse where there is one to working precision, else the pseudo-inverse; A is symmetric.
Eigen::MatrixXd symmetric_inverse(const Eigen::MatrixXd& A) {
  constexpr double kDependent = 1e-13;
  const Eigen::LLT<Eigen::MatrixXd> factors(A);
  if (factors.info() == Eigen::Success && factors.rcond() > kDependent)
    return factors.solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace

ContactDynamics::ContactDynamics(const Problem& problem)
    : gaps_(contact_gaps(problem)),
      highest_harmonic_(std::max(1, highest_load_harmonic(problem))),
      frequency_(problem.frequency),
      forcing_period_(problem.forcing_period()) {
  take_structure(problem);
  if (const auto* law = std::get_if<Restitution>(&problem.law)) restitution_ = law->e;
  rigid_ = !std::holds_alternative<Penalty>(problem.law) && !std::holds_alternative<Massless>(problem.law);
  if (const auto* law = std::get_if<Penalty>(&problem.law)) {
    const auto k = Eigen::VectorXd::Map(law->stiffness.data(), contact_count());
    compliance_.diagonal() += k.cwiseInverse();
  }
  velocity_per_impulse_ = mass_.solve(directions_);
  delassus_ = directions_.transpose() * velocity_per_impulse_;
  prepare_small();
  measure_rates();
  measure_scales(problem);
}

void ContactDynamics::take_structure(const Problem& problem) {
  CondensedStructure structure = condense(problem);
  if (!structure.obstacle.empty()) throw std::runtime_error(structure.obstacle);
  kept_ = std::move(structure.kept);
  mass_matrix_ = std::move(structure.mass);
  damping_ = std::move(structure.damping);
  stiffness_ = std::move(structure.stiffness);
  directions_ = structure.directions;
  massless_compliance_ = structure.compliance;
  compliance_ = std::move(structure.compliance);
  rates_ = std::move(structure.rates);
  load_ = std::move(structure.load);
  shift_ = std::move(structure.shift);
  mass_.compute(mass_matrix_);
  if (mass_.info() != Eigen::Success) throw std::runtime_error(flow_obstacle(problem));
}

void ContactDynamics::prepare_small() {
  constexpr int kSmall = 32;  // a dense product is then no dearer than sparse ones and a sparse solve
  small_ = size() <= kSmall;
  if (!small_) return;
  inverse_mass_stiffness_ = mass_.solve(Eigen::MatrixXd(stiffness_));
  inverse_mass_damping_ = mass_.solve(Eigen::MatrixXd(damping_));
  for (std::size_t h = 0; h < rates_.size(); ++h) {
    const Eigen::VectorXcd load = load_.col(static_cast<Eigen::Index>(h));
    if (load.isZero(0.0)) continue;
    inverse_mass_load_.push_back({.rate = rates_[h],
                                  .cos = mass_.solve(Eigen::VectorXd(load.real())),
                                  .sin = mass_.solve(Eigen::VectorXd(-load.imag()))});
  }
}

ContactMode ContactDynamics::mode(const std::vector<bool>& closed) const {
  ContactMode result;
  for (int j = 0; j < contact_count(); ++j) {
    if (closed[static_cast<std::size_t>(j)]) result.active.push_back(j);
  }
  if (!result.active.empty())
    result.response = symmetric_inverse((rigid_ ? delassus_ : compliance_)(result.active, result.active));
  return result;
}

double ContactDynamics::force_scale(int contact) const {
  return rigid_ ? scales_.acceleration / delassus_(contact, contact)
                : scales_.displacement / compliance_(contact, contact);
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
    for (const LoadRate& load : inverse_mass_load_) {
      a += std::cos(load.rate * time) * load.cos + std::sin(load.rate * time) * load.sin;
    }
  } else {
    Eigen::VectorXd force = wave_derivative(load_, rates_, time, 0);
    force.noalias() -= stiffness_ * u;
    force.noalias() -= damping_ * v;
    a = mass_.solve(force);
  }
  if (mode.active.empty()) return;
  if (rigid()) {
    a += velocity_per_impulse_(Eigen::all, mode.active) * multiplier(mode, a);
  } else {
    const Eigen::VectorXd lambda = compliant_force(mode, unloaded(time, u, 0), 0);
    for (const int j : mode.active) a += lambda[j] * velocity_per_impulse_.col(j);
  }
}

Eigen::VectorXd ContactDynamics::unloaded(double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                                          int order) const {
  return directions_.transpose() * u + wave_derivative(shift_, rates_, time, order);
}

Eigen::VectorXd ContactDynamics::compliant_force(const ContactMode& mode, const Eigen::VectorXd& unloaded,
                                                 int order) const {
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(contact_count());
  Eigen::VectorXd depth = unloaded(mode.active);
  if (order == 0) depth -= gaps_(mode.active);
  lambda(mode.active) = -mode.response * depth;
  return lambda;
}

MotionDerivatives ContactDynamics::derivatives(const ContactMode& mode, double time, const State& state,
                                               int order) const {
  MotionDerivatives result{.u = Eigen::MatrixXd::Zero(size(), order + 1),
                           .x = Eigen::MatrixXd::Zero(contact_count(), order - 1),
                           .lambda = Eigen::MatrixXd::Zero(contact_count(), order - 1)};
  result.u.col(0) = state.u;
  result.u.col(1) = state.v;
  for (int k = 0; k + 2 <= order; ++k) {
    Eigen::VectorXd force = wave_derivative(load_, rates_, time, k) - stiffness_ * result.u.col(k) -
                            damping_ * result.u.col(k + 1);
    result.x.col(k) = unloaded(time, result.u.col(k), k);
    if (!rigid()) {
      result.lambda.col(k) = compliant_force(mode, result.x.col(k), k);
      result.x.col(k) += massless_compliance_ * result.lambda.col(k);
      force += directions_ * result.lambda.col(k);
    }
    Eigen::VectorXd next = mass_.solve(force);
    if (rigid() && !mode.active.empty()) {
      const Eigen::VectorXd lambda = multiplier(mode, next);
      next += velocity_per_impulse_(Eigen::all, mode.active) * lambda;
      result.lambda(mode.active, k) = lambda;
    }
    result.u.col(k + 2) = next;
  }
  return result;
}

Eigen::MatrixXd ContactDynamics::flow_matrix(const ContactMode& mode) const {
  const int n = size();
  Eigen::MatrixXd stiffness = stiffness_;
  const Eigen::MatrixXd active = directions_(Eigen::all, mode.active);
  if (!rigid() && !mode.active.empty()) stiffness += active * mode.response * active.transpose();
  Eigen::MatrixXd from_u = -mass_.solve(stiffness);
  Eigen::MatrixXd from_v = -mass_.solve(Eigen::MatrixXd(damping_));
  if (rigid() && !mode.active.empty()) {
    const Eigen::MatrixXd back = velocity_per_impulse_(Eigen::all, mode.active) * mode.response;
    from_u -= back * (active.transpose() * from_u);
    from_v -= back * (active.transpose() * from_v);
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

namespace {

// Largest coordinate of the contact-free periodic response [m]; infinite at an undamped resonance.
double linear_amplitude(const Problem& problem) {
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(problem.size());
  DynamicStiffness stiffness(problem);
  for (int h = 0; h <= highest_load_harmonic(problem); ++h) {
    const Eigen::VectorXcd load = load_harmonic(problem, h);
    if (load.isZero(0.0)) continue;
    try {
      stiffness.factorise(exact_weights(h * problem.frequency));
      amplitude += stiffness.solve(load).cwiseAbs().col(0);
    } catch (const std::runtime_error&) {
      return std::numeric_limits<double>::infinity();
    }
  }
  return amplitude.size() == 0 ? 0.0 : amplitude.maxCoeff();
}

// What the load moves without help from a resonance: |f_i| / (K_ii + (h omega)^2 M_ii) [m].
double forced_amplitude(const Problem& problem) {
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(problem.size());
  const Eigen::VectorXd k = problem.stiffness().diagonal(), m = problem.mass().diagonal();
  for (const ForceTerm& term : problem.force) {
    const double w = std::max(1, term.harmonic) * problem.frequency;
    amplitude[term.dof] += std::hypot(term.cos, term.sin) / (k[term.dof] + w * w * m[term.dof]);
  }
  return amplitude.maxCoeff();
}

}  // namespace

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
