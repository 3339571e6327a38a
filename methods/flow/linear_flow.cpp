#include "methods/flow/linear_flow.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "methods/flow/complex_modes.hpp"
#include "methods/flow/matrix_exponential.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
constexpr int kLargest = 300;  // coordinates of a dense flow
// Digits that cancel between a resonance and its free motion.
constexpr double kResonance = 1e-4;

}  // namespace

LinearFlow::LinearFlow(const ContactDynamics& dynamics, ContactMode mode, FlowForm form)
    : dynamics_(&dynamics), mode_(std::move(mode)) {
  const int n = dynamics.size();
  if (n > kLargest) {
    throw std::runtime_error("the closed-form flow is dense: " + std::to_string(n) +
                             " coordinates are more than " + std::to_string(kLargest));
  }
  Eigen::MatrixXd stiffness = dynamics.stiffness();
  rates_ = dynamics.load_rates();
  load_ = dynamics.load_amplitudes();
  offset_ = Eigen::VectorXd::Zero(n);
  if (mode_.active.empty() || !dynamics.rigid()) {
    basis_ = Eigen::MatrixXd::Identity(n, n);
    if (!mode_.active.empty()) {
      const Eigen::MatrixXd pull = dynamics.directions()(Eigen::all, mode_.active) * mode_.response;
      stiffness += pull * dynamics.directions()(Eigen::all, mode_.active).transpose();
      load_ -= pull * dynamics.shift_amplitudes()(mode_.active, Eigen::all);
      load_.col(0) += (pull * dynamics.gaps()(mode_.active)).cast<Complex>();
    }
  } else {
    const Eigen::MatrixXd W = dynamics.directions()(Eigen::all, mode_.active);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(W);
    const Eigen::MatrixXd whole = qr.householderQ() * Eigen::MatrixXd::Identity(n, n);
    basis_ = whole.rightCols(n - qr.rank());
    offset_ =
        W.transpose().completeOrthogonalDecomposition().solve(Eigen::VectorXd(dynamics.gaps()(mode_.active)));
  }
  const ExtendedMatrix Q = basis_.cast<long double>();
  const auto reduced = [&](const Eigen::MatrixXd& A) -> ExtendedMatrix {
    if (Q.cols() == n) return A.cast<long double>();  // nothing is held: Q is the identity
    return Q.transpose() * (A.cast<long double>() * Q);
  };
  const EnergyForm energy(reduced(dynamics.mass()), reduced(dynamics.damping()), reduced(stiffness),
                          dynamics.frequency());
  fastest_rate_ = rates_.back();
  modal_ = form == FlowForm::automatic && find_modes(energy);
  if (!modal_) prepare_exponential(energy);
  prepare_outputs();
}

// Q^T (f_h - K u_g).
Eigen::VectorXcd LinearFlow::reduced_load(Eigen::Index h) const {
  Eigen::VectorXcd load = load_.col(h);
  if (h == 0) load -= (dynamics_->stiffness() * offset_).cast<Complex>();
  return basis_.transpose() * load;
}

// False where they are ill-conditioned, or the load resonates with one of them.
bool LinearFlow::find_modes(const EnergyForm& energy) {
  const Eigen::Index n = basis_.cols();
  const auto harmonics = static_cast<Eigen::Index>(rates_.size());
  shapes_ = Eigen::MatrixXcd(size(), 0);
  left_ = Eigen::MatrixXcd(0, 2 * size());
  forced_ = Eigen::MatrixXcd::Zero(size(), harmonics);
  if (n > 0) {  // else nothing moves
    const std::optional<ComplexModes> modes = complex_modes(energy);
    if (!modes) return false;
    mu_ = modes->mu;
    weight_ = modes->weight;
    shapes_ = basis_ * modes->shapes;
    left_.resize(mu_.size(), 2 * size());
    left_ << modes->left.leftCols(n) * basis_.transpose(), modes->left.rightCols(n) * basis_.transpose();
    fastest_rate_ = std::max(fastest_rate_, mu_.cwiseAbs().maxCoeff());
    for (Eigen::Index h = 0; h < harmonics; ++h) {
      const Eigen::VectorXcd load = reduced_load(h);
      if (load.isZero(0.0)) continue;
      const double rate = rates_[static_cast<std::size_t>(h)];
      if ((mu_.array() - Complex(0.0, rate)).abs().minCoeff() <
          kResonance * std::max(rate, dynamics_->frequency()))
        return false;
      forced_.col(h) = basis_ * modes->forced(load, rate);
    }
  }
  forced_.col(0) += offset_.cast<Complex>();
  return true;
}

void LinearFlow::prepare_exponential(const EnergyForm& energy) {
  const Eigen::Index n = basis_.cols();
  const auto harmonics = static_cast<Eigen::Index>(rates_.size());
  generator_ = Eigen::MatrixXd::Zero(2 * n + 2 * harmonics, 2 * n + 2 * harmonics);
  generator_.topLeftCorner(2 * n, 2 * n) = energy.B.cast<double>();
  v_of_z_ = basis_ * energy.q_of_z.cast<double>();
  u_of_e_ = basis_ * ExtendedMatrix(energy.q_of_z * energy.z_of_e).cast<double>();
  z_of_v_ = energy.L.transpose().cast<double>() * basis_.transpose();
  e_of_u_ = ExtendedMatrix(energy.E.transpose() * energy.L.transpose()).cast<double>() * basis_.transpose();
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    const Eigen::Index c = 2 * n + 2 * h;
    const Eigen::VectorXcd load = energy.q_of_z.transpose().cast<double>() * reduced_load(h);
    generator_.block(n, c, n, 1) = load.real();
    generator_.block(n, c + 1, n, 1) = -load.imag();
    generator_(c, c + 1) = -rates_[static_cast<std::size_t>(h)];
    generator_(c + 1, c) = rates_[static_cast<std::size_t>(h)];
  }
  // The bound of a Gershgorin disc would be too large for M far from the identity.
  fastest_rate_ = std::max(fastest_rate_, 1.1 * dynamics_->fastest_rate());
  if (!dynamics_->rigid()) {
    for (std::size_t i = 0; i < mode_.active.size(); ++i) {
      const int j = mode_.active[i];
      const auto row = static_cast<Eigen::Index>(i);
      fastest_rate_ =
          std::hypot(fastest_rate_, std::sqrt(mode_.response(row, row) * dynamics_->delassus()(j, j)));
    }
  }
}

// lambda_A = rows (u, v) + terms of the load, |A| x 2 Nd.
Eigen::MatrixXd LinearFlow::multiplier_rows() const {
  const auto active = static_cast<Eigen::Index>(mode_.active.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(active, 2 * size());
  if (active == 0) return rows;
  if (dynamics_->rigid()) {
    const Eigen::MatrixXd back =
        mode_.response * dynamics_->velocity_per_impulse()(Eigen::all, mode_.active).transpose();
    rows.leftCols(size()) = back * dynamics_->stiffness();
    rows.rightCols(size()) = back * dynamics_->damping();
  } else {
    rows.leftCols(size()) = -mode_.response * dynamics_->directions()(Eigen::all, mode_.active).transpose();
  }
  return rows;
}

// x = rows (u, v) + terms of the load, Nc x 2 Nd.
Eigen::MatrixXd LinearFlow::displacement_rows() const {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(dynamics_->contact_count(), 2 * size());
  rows.leftCols(size()) = dynamics_->directions().transpose();
  rows += dynamics_->massless_compliance()(Eigen::all, mode_.active) * multiplier_rows();
  return rows;
}

// The terms of the load in x and lambda_A, (Nc + |A|) x Nh.
Eigen::MatrixXcd LinearFlow::outputs_of_load() const {
  const int contacts = dynamics_->contact_count();
  const auto active = static_cast<Eigen::Index>(mode_.active.size());
  Eigen::MatrixXcd result(contacts + active, static_cast<Eigen::Index>(rates_.size()));
  result.topRows(contacts) = dynamics_->shift_amplitudes();
  if (active == 0) return result;
  if (dynamics_->rigid()) {
    result.bottomRows(active) =
        -(mode_.response * dynamics_->velocity_per_impulse()(Eigen::all, mode_.active).transpose()) * load_;
    return result;
  }
  Eigen::MatrixXcd depth = dynamics_->shift_amplitudes()(mode_.active, Eigen::all);
  depth.col(0) -= dynamics_->gaps()(mode_.active).cast<Complex>();
  result.bottomRows(active) = -mode_.response * depth;
  result.topRows(contacts) +=
      dynamics_->massless_compliance()(Eigen::all, mode_.active) * result.bottomRows(active);
  return result;
}

void LinearFlow::prepare_outputs() {
  const int contacts = dynamics_->contact_count();
  const auto active = static_cast<Eigen::Index>(mode_.active.size()),
             harmonics = static_cast<Eigen::Index>(rates_.size());
  Eigen::MatrixXd direct(contacts + active, 2 * size());  // of (u, v)
  direct << displacement_rows(), multiplier_rows();
  const Eigen::MatrixXcd of_load = outputs_of_load();
  if (modal_) {
    Eigen::MatrixXcd states(2 * size(), mu_.size()), waves(2 * size(), harmonics);
    states << shapes_, shapes_ * mu_.asDiagonal();
    waves.topRows(size()) = forced_;
    for (Eigen::Index h = 0; h < harmonics; ++h)
      waves.col(h).tail(size()) = Complex(0.0, rates_[static_cast<std::size_t>(h)]) * forced_.col(h);
    row_of_mode_ = direct * states * weight_.asDiagonal();
    row_of_harmonic_ = direct * waves + of_load;
    return;
  }
  const Eigen::Index n = basis_.cols();
  output_ = Eigen::MatrixXd::Zero(contacts + active, generator_.cols());
  output_.leftCols(n) = direct.leftCols(size()) * u_of_e_;
  output_.middleCols(n, n) = direct.rightCols(size()) * v_of_z_;
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    output_.col(2 * n + 2 * h) = of_load.col(h).real();
    output_.col(2 * n + 2 * h + 1) = -of_load.col(h).imag();
  }
  output_.col(2 * n) += direct.leftCols(size()) * offset_;
}

int LinearFlow::place(int contact) const {
  const auto found = std::lower_bound(mode_.active.begin(), mode_.active.end(), contact);
  return found != mode_.active.end() && *found == contact ? static_cast<int>(found - mode_.active.begin())
                                                          : -1;
}

Eigen::RowVectorXd LinearFlow::multiplier_gradient(int contact) const {
  return multiplier_rows().row(place(contact));
}

Eigen::RowVectorXd LinearFlow::displacement_gradient(int contact) const {
  return displacement_rows().row(contact);
}

Eigen::MatrixXd LinearFlow::transition(double duration) const {
  const int n = size();
  Eigen::MatrixXd result(2 * n, 2 * n);
  if (modal_) {
    const Eigen::VectorXcd growth = weight_.array() * (mu_.array() * duration).exp();
    const Eigen::MatrixXcd scaled = growth.asDiagonal() * left_;
    result.topRows(n) = (shapes_ * scaled).real();
    result.bottomRows(n) = (shapes_ * mu_.asDiagonal() * scaled).real();
    return result;
  }
  const Eigen::Index r = basis_.cols();
  const Eigen::MatrixXd reduced = matrix_exponential(generator_.topLeftCorner(2 * r, 2 * r) * duration);
  result.topLeftCorner(n, n) = u_of_e_ * reduced.topLeftCorner(r, r) * e_of_u_;
  result.topRightCorner(n, n) = u_of_e_ * reduced.topRightCorner(r, r) * z_of_v_;
  result.bottomLeftCorner(n, n) = v_of_z_ * reduced.bottomLeftCorner(r, r) * e_of_u_;
  result.bottomRightCorner(n, n) = v_of_z_ * reduced.bottomRightCorner(r, r) * z_of_v_;
  return result;
}

State LinearFlow::response(const std::vector<Impulse>& impulses) const {
  const int n = size();
  const Eigen::MatrixXd& kicks = dynamics_->velocity_per_impulse();
  if (!modal_) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(2 * n);
    for (const Impulse& impulse : impulses)
      sum += transition(impulse.time).rightCols(n) * (impulse.value * kicks.col(impulse.contact));
    return {.u = sum.head(n), .v = sum.tail(n)};
  }
  const Eigen::MatrixXcd excited = left_.rightCols(n) * kicks;
  Eigen::VectorXcd amplitude = Eigen::VectorXcd::Zero(mu_.size());
  for (const Impulse& impulse : impulses) {
    amplitude.array() +=
        impulse.value * excited.col(impulse.contact).array() * (impulse.time * mu_.array()).exp();
  }
  amplitude.array() *= weight_.array();
  const Eigen::VectorXcd rates = mu_.cwiseProduct(amplitude);
  return {.u = (shapes_ * amplitude).real(), .v = (shapes_ * rates).real()};
}

double fastest_left(const std::vector<FadingRate>& terms, double time) {
  for (const FadingRate& term : terms) {
    if (term.until > time) return term.rate;
  }
  return 0.0;
}

void LinearArc::start(const LinearFlow& flow, double time, const State& state) {
  flow_ = &flow;
  begin_ = time;
  placed_ = false;
  const auto harmonics = static_cast<Eigen::Index>(flow.rates_.size());
  const int n = flow.size();
  if (!flow.modal_) {
    const Eigen::Index r = flow.basis_.cols();
    first_.resize(flow.generator_.cols());
    first_.head(r) = flow.e_of_u_ * (state.u - flow.offset_);
    first_.segment(r, r) = flow.z_of_v_ * state.v;
    for (Eigen::Index h = 0; h < harmonics; ++h) {
      const double angle = flow.rates_[static_cast<std::size_t>(h)] * time;
      first_[2 * r + 2 * h] = std::cos(angle);
      first_[2 * r + 2 * h + 1] = std::sin(angle);
    }
    return;
  }
  growth_.resize(flow.mu_.size());
  wave_.resize(harmonics);
  amplitude_.resize(flow.mu_.size());
  for (Eigen::Index h = 0; h < harmonics; ++h)
    wave_[h] = std::polar(1.0, flow.rates_[static_cast<std::size_t>(h)] * time);
  amplitude_.setZero();
  for (int i = 0; i < n; ++i) {
    double u = state.u[i], v = state.v[i];
    for (Eigen::Index h = 0; h < harmonics; ++h) {
      const Complex part = flow.forced_(i, h) * wave_[h];
      u -= part.real();
      v += flow.rates_[static_cast<std::size_t>(h)] * part.imag();
    }
    amplitude_ += u * flow.left_.col(i) + v * flow.left_.col(n + i);
  }
  contribution_ = flow.row_of_mode_ * amplitude_.asDiagonal();
}

std::vector<FadingRate> LinearArc::fading_rates(double floor, double step, int order) const {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const ContactDynamics& dynamics = *flow_->dynamics_;
  if (!flow_->modal_) return {{.rate = flow_->fastest_rate_, .until = kForever}};
  std::vector<FadingRate> terms;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
    double share = 0.0;
    for (int j = 0; j < dynamics.contact_count(); ++j) {
      const int place = flow_->place(j);
      share = std::max(share, place < 0 ? std::abs(contribution_(j, k)) / dynamics.scales().displacement
                                        : std::abs(contribution_(dynamics.contact_count() + place, k)) /
                                              dynamics.force_scale(j));
    }
    const Complex mu = flow_->mu_[k];
    share *= std::pow(std::max(1.0, std::abs(mu) * step), order);
    const bool fades = mu.real() < 0.0;
    if (fades && share <= floor) continue;
    terms.push_back(
        {.rate = std::abs(mu), .until = fades ? begin_ + std::log(share / floor) / -mu.real() : kForever});
  }
  terms.push_back({.rate = std::max(flow_->rates_.back(), dynamics.frequency()), .until = kForever});
  std::sort(terms.begin(), terms.end(),
            [](const FadingRate& a, const FadingRate& b) { return a.rate > b.rate; });
  return terms;
}

void LinearArc::move_to(double time) const {
  if (placed_ && now_ == time) return;
  placed_ = true;
  now_ = time;
  const double s = time - begin_;
  if (!flow_->modal_) {
    augmented_ = matrix_exponential(flow_->generator_ * s) * first_;
    return;
  }
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    const Complex mu = flow_->mu_[k];
    growth_[k] = std::polar(std::exp(mu.real() * s), mu.imag() * s);
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    const double rate = flow_->rates_[static_cast<std::size_t>(h)];
    wave_[h] = rate == 0.0 ? Complex(1.0) : std::polar(1.0, rate * time);
  }
}

double LinearArc::output(Eigen::Index row, double time, int order) const {
  move_to(time);
  if (!flow_->modal_) {
    Eigen::VectorXd state = augmented_;
    for (int k = 0; k < order; ++k) state = (flow_->generator_ * state).eval();
    return flow_->output_.row(row).dot(state);
  }
  double sum = 0.0;
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    Complex term = contribution_(row, k) * growth_[k];
    for (int i = 0; i < order; ++i) term *= flow_->mu_[k];
    sum += term.real();
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    Complex term = flow_->row_of_harmonic_(row, h) * wave_[h];
    for (int i = 0; i < order; ++i) term *= Complex(0.0, flow_->rates_[static_cast<std::size_t>(h)]);
    sum += term.real();
  }
  return sum;
}

double LinearArc::displacement(int contact, double time, int order) const {
  return output(contact, time, order);
}

double LinearArc::force(int contact, double time, int order) const {
  const int place = flow_->place(contact);
  return place < 0 ? 0.0 : output(flow_->dynamics_->contact_count() + place, time, order);
}

void LinearArc::state(double time, State& state) const {
  move_to(time);
  const int n = flow_->size();
  if (!flow_->modal_) {
    const Eigen::Index r = flow_->basis_.cols();
    state.u = flow_->offset_ + flow_->u_of_e_ * augmented_.head(r);
    state.v = flow_->v_of_z_ * augmented_.segment(r, r);
    return;
  }
  state.u.setZero(n);
  state.v.setZero(n);
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    const Complex a = flow_->weight_[k] * amplitude_[k] * growth_[k], b = a * flow_->mu_[k];
    for (int i = 0; i < n; ++i) {
      state.u[i] += (a * flow_->shapes_(i, k)).real();
      state.v[i] += (b * flow_->shapes_(i, k)).real();
    }
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    for (int i = 0; i < n; ++i) {
      const Complex part = flow_->forced_(i, h) * wave_[h];
      state.u[i] += part.real();
      state.v[i] -= flow_->rates_[static_cast<std::size_t>(h)] * part.imag();
    }
  }
}

void LinearArc::acceleration(double time, Eigen::VectorXd& a) const {
  move_to(time);
  const int n = flow_->size();
  if (!flow_->modal_) {
    const Eigen::Index r = flow_->basis_.cols();
    const Eigen::VectorXd rate = flow_->generator_ * augmented_;
    a = flow_->v_of_z_ * rate.segment(r, r);
    return;
  }
  a.setZero(n);
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    const Complex b = flow_->weight_[k] * amplitude_[k] * growth_[k] * flow_->mu_[k] * flow_->mu_[k];
    for (int i = 0; i < n; ++i) a[i] += (b * flow_->shapes_(i, k)).real();
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    const double rate = flow_->rates_[static_cast<std::size_t>(h)];
    for (int i = 0; i < n; ++i) a[i] -= rate * rate * (flow_->forced_(i, h) * wave_[h]).real();
  }
}

const LinearFlow& LinearFlows::of(const std::vector<bool>& closed) {
  auto& flow = flows_[closed];
  if (!flow) flow = std::make_unique<LinearFlow>(dynamics_, dynamics_.mode(closed), form_);
  return *flow;
}

}  // namespace signorini
