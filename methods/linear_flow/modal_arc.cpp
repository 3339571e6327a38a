#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"
#include "methods/linear_flow/modes/harmonic_integrals.hpp"
#include "methods/linear_flow/modes/waves.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

using Complex = std::complex<double>;

/// A motion as amplitudes of the modes.
class ModalFlow::Arc final : public LinearArc {
 public:
  explicit Arc(const ModalFlow& flow) : LinearArc(flow.equations_), flow_(flow), rates_(equations_.rates()) {
    growth_.resize(flow.mu().size());
    wave_.resize(equations_.harmonics());
    amplitude_.resize(flow.mu().size());
    constexpr Eigen::Index kMany = 32;
    evenly_ = wave_.size() >= kMany && evenly_spaced(rates_);
  }

  void start(double time, const State& state) override;
  [[nodiscard]] std::vector<FadingRate> fading_rates(double floor, double turn, int order) const override;
  void state(double time, State& state) const override {
    state.u.resize(flow_.positions());
    state.v.resize(flow_.size());
    differentiate(time, 0, state.u);
    differentiate(time, 1, state.v);
  }
  [[nodiscard]] bool add_force_integrals(double begin, double end, double w,
                                         Eigen::MatrixXcd& sums) const override;
  [[nodiscard]] Eigen::MatrixXd outputs_at(double time, int highest) const override;
  [[nodiscard]] std::vector<Eigen::MatrixXd> outputs(std::span<const double> times,
                                                     int highest) const override;
  [[nodiscard]] std::vector<Eigen::MatrixXd> open_displacements(std::span<const double> times, int highest,
                                                                int first, int count) const override;
  void rate(double time, Eigen::VectorXd& rate) const override {
    rate.resize(flow_.states());
    differentiate(time, 1, rate.head(flow_.positions()));
    differentiate(time, 2, rate.tail(flow_.size()));
  }

 private:
  [[nodiscard]] double output(Eigen::Index row, double time, int order) const override;
  [[nodiscard]] double curvature_bound(Eigen::Index row, double time) const override;
  void differentiate(double time, int order, Eigen::Ref<Eigen::VectorXd> derivative) const;
  [[nodiscard]] double fastest_wave(double floor, double turn, int order) const;
  [[nodiscard]] double largest_share(const OutputRows& outputs, Eigen::Index term, Complex amplitude,
                                     const Eigen::Ref<const Eigen::VectorXcd>& shape, double direct) const;
  [[nodiscard]] double rate(Eigen::Index h) const { return rates_[static_cast<std::size_t>(h)]; }
  void move_to(double time) const;
  void add_waves(Eigen::Index row, int order, double& sum) const;
  struct Terms {
    std::vector<Eigen::Index> alive;  // modes that have not faded, m
    Eigen::VectorXcd rates;           // of these and of the load, m + Nh
    Eigen::MatrixXcd becomes;         // e^{rate t}, (m + Nh) x times
    [[nodiscard]] Eigen::Index mode(Eigen::Index k) const { return alive[static_cast<std::size_t>(k)]; }
  };
  [[nodiscard]] Terms terms_at(std::span<const double> times) const;
  [[nodiscard]] Eigen::MatrixXcd of_outputs(Eigen::Index first, Eigen::Index count, const Terms& terms) const;
  [[nodiscard]] std::vector<Eigen::MatrixXd> derivatives(const Eigen::MatrixXcd& of_output, Terms terms,
                                                         int highest) const;

  const ModalFlow& flow_;
  const std::vector<double>& rates_;  // of the load
  double begin_ = 0.0;
  Eigen::VectorXcd amplitude_;                // a_k
  OutputRows contribution_;                   // row_of_mode times a_k
  mutable Eigen::MatrixXd real_, imaginary_;  // of it, column by mode; empty until outputs_at asks for them
  bool evenly_ = false;                       // whether rates are many and evenly spaced
  mutable double now_ = 0.0;
  mutable bool placed_ = false;
  mutable Eigen::VectorXcd growth_, wave_;  // e^{mu_k s}, e^{i h omega t}
};

// a = left (y - y_forced), y = (u, v); the free motion is what the periodic response does not account for.
// Scalar by scalar, for a product of Eigen's would allocate.
void ModalFlow::Arc::start(double time, const State& state) {
  begin_ = time;
  placed_ = false;
  const int n = flow_.size(), positions = flow_.positions();
  for (Eigen::Index h = 0; h < wave_.size(); ++h) wave_[h] = std::polar(1.0, rate(h) * time);
  amplitude_.setZero();
  for (int i = 0; i < positions; ++i) {
    double u = state.u[i], v = i < n ? state.v[i] : 0.0;
    for (Eigen::Index h = 0; h < wave_.size(); ++h) {
      const Complex part = flow_.forced_(i, h) * wave_[h];
      u -= part.real();
      v += rate(h) * part.imag();
    }
    const Eigen::MatrixXcd& left = flow_.basis_->left;
    for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
      amplitude_[k] += u * left(k, i);
      if (i < n) amplitude_[k] += v * left(k, positions + i);
    }
  }
  const auto& row_of_mode = flow_.basis_->row_of_mode;
  contribution_.resize(row_of_mode.rows(), row_of_mode.cols());
  for (Eigen::Index row = 0; row < contribution_.rows(); ++row)
    for (Eigen::Index k = 0; k < contribution_.cols(); ++k)
      contribution_(row, k) = row_of_mode(row, k) * amplitude_[k];
  real_.resize(0, 0);
}

std::vector<FadingRate> ModalFlow::Arc::fading_rates(double floor, double turn, int order) const {
  struct Mode {
    double rate, decay;
    double excess, turned;  // logarithms: of the share at the beginning over `floor`, of turn times the rate
  };
  std::vector<Mode> modes;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
    const double share = largest_share(contribution_, k, flow_.weight()[k] * amplitude_[k],
                                       flow_.basis_->shapes.col(k).head(flow_.size()), 0.0);
    const Complex mu = flow_.mu()[k];
    modes.push_back({.rate = std::abs(mu),
                     .decay = std::max(0.0, -mu.real()),
                     .excess = std::log(share / floor),
                     .turned = order > 0 ? std::log(turn * std::abs(mu)) : 0.0});
  }
  std::ranges::sort(modes, std::greater(), &Mode::rate);
  const double wave = fastest_wave(floor, turn, order);
  std::vector<FadingRate> terms;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    // Once this one no longer matters, the next slower one makes the step for all faster ones.
    const double next = std::log(std::max(wave, k + 1 < modes.size() ? modes[k + 1].rate : 0.0));
    double until = -kInfinity;
    for (std::size_t j = order > 0 ? 0 : k; j <= k; ++j) {
      const double excess = modes[j].excess + order * std::max(0.0, modes[j].turned - next);
      until = std::max(until, modes[j].decay > 0.0 ? begin_ + excess / modes[j].decay : kInfinity);
    }
    if (until > begin_) terms.push_back({.rate = modes[k].rate, .until = until});
  }
  terms.push_back({.rate = wave, .until = kInfinity});
  std::ranges::stable_sort(terms, std::greater(), &FadingRate::rate);
  return terms;
}

// The largest rate of a harmonic of the load that matters together with all faster ones, at least omega. Of
// displacements that are added there are many harmonics, the last ones tiny.
double ModalFlow::Arc::fastest_wave(double floor, double turn, int order) const {
  const Eigen::MatrixXcd& open_waves = equations_.structure().open_waves;
  const double least = equations_.structure().frequency;
  double sum = 0.0, turning = 0.0;  // of all faster ones; turned by a rate of 1
  for (Eigen::Index h = wave_.size() - 1; h >= 0 && rate(h) > least; --h) {
    const double direct = open_waves.size() > 0 ? open_waves.col(h).lpNorm<Eigen::Infinity>() : 0.0;
    const double share =
        largest_share(flow_.row_of_harmonic_, h, 1.0, flow_.forced_.col(h).head(flow_.size()), direct);
    sum += share;
    if (order > 0) turning += share * std::pow(turn * rate(h), order);
    const double slower = h > 0 ? std::max(rate(h - 1), least) : least;
    if (sum + turning / std::pow(slower, order) > floor) return rate(h);
  }
  return least;
}

// Of a term in all guards: the larger of what it is in those of contacts that act, from its outputs, and a
// bound of what it is in those of open ones, from its shape in u and its part in their waves.
double ModalFlow::Arc::largest_share(const OutputRows& outputs, Eigen::Index term, Complex amplitude,
                                     const Eigen::Ref<const Eigen::VectorXcd>& shape, double direct) const {
  const ContactDynamics& dynamics = *equations_.dynamics;
  const FlowStructure& structure = dynamics.structure();
  double share = 0.0;
  for (int j = 0; j < dynamics.contact_count(); ++j) {
    const Eigen::Index force = equations_.force_row(j);
    share = std::max(share, force < 0 ? std::abs(outputs(j, term)) / dynamics.scales().displacement
                                      : std::abs(outputs(force, term)) / dynamics.force_scale(j));
  }
  if (structure.open.contacts.empty()) return share;
  double moved = 0.0;
  for (int j = 0; j < dynamics.contact_count(); ++j) moved = std::max(moved, std::abs(outputs(j, term)));
  double reach = structure.open_contact_sum * moved;
  reach += direct + structure.open_row_norm * std::abs(amplitude) * shape.norm();
  for (std::size_t c = 0; c < mode().active.size() && structure.open_compliance.size() > 0; ++c) {
    reach += structure.open_compliance[mode().active[c]] *
             std::abs(outputs(equations_.force_row(mode().active[c]), term));
  }
  return std::max(share, reach / dynamics.scales().displacement);
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
    growth_[k] = has_faded(mu, s) ? Complex(0.0) : std::polar(std::exp(mu.real() * s), mu.imag() * s);
  }
  if (evenly_)
    turn_evenly(rates_, time, wave_);
  else
    for (Eigen::Index h = 0; h < wave_.size(); ++h)
      wave_[h] = rate(h) == 0.0 ? Complex(1.0) : std::polar(1.0, rate(h) * time);
}

double ModalFlow::Arc::output(Eigen::Index row, double time, int order) const {
  move_to(time);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    if (growth_[k] == Complex(0.0)) continue;
    Complex term = contribution_(row, k) * growth_[k];
    for (int i = 0; i < order; ++i) term *= flow_.mu()[k];
    sum += term.real();
  }
  add_waves(row, order, sum);
  return sum;
}

// Re (i r)^order c w of each harmonic, at the instant moved to.
void ModalFlow::Arc::add_waves(Eigen::Index row, int order, double& sum) const {
  const double sign = order % 4 == 0 || order % 4 == 3 ? 1.0 : -1.0;
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    const Complex c = flow_.row_of_harmonic_(row, h), w = wave_[h];
    double part = order % 2 == 0 ? c.real() * w.real() - c.imag() * w.imag()
                                 : c.real() * w.imag() + c.imag() * w.real();
    for (int i = 0; i < order; ++i) part *= rate(h);
    sum += sign * part;
  }
}

// The sums of `output`, term by term in its order, those of all rows side by side.
Eigen::MatrixXd ModalFlow::Arc::outputs_at(double time, int highest) const {
  move_to(time);
  const Eigen::Index rows = contribution_.rows();
  if (real_.size() == 0) {
    real_ = contribution_.real();
    imaginary_ = contribution_.imag();
  }
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(rows, highest + 1);
  Eigen::ArrayXd re(rows), im(rows), turned(rows);
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    const Complex g = growth_[k], mu = flow_.mu()[k];
    if (g == Complex(0.0)) continue;
    const auto c = real_.col(k).array(), d = imaginary_.col(k).array();
    re = c * g.real() - d * g.imag();
    im = c * g.imag() + d * g.real();
    sums.col(0).array() += re;
    for (int order = 1; order <= highest; ++order) {
      turned = re * mu.real() - im * mu.imag();
      im = re * mu.imag() + im * mu.real();
      re.swap(turned);
      sums.col(order).array() += re;
    }
  }
  for (int order = 0; order <= highest; ++order)
    for (Eigen::Index row = 0; row < rows; ++row) add_waves(row, order, sums(row, order));
  return sums;
}

// What becomes of the modes that have not faded by the first of some times, and of the waves.
ModalFlow::Arc::Terms ModalFlow::Arc::terms_at(std::span<const double> times) const {
  const double first = times.empty() ? begin_ : *std::ranges::min_element(times);
  Terms terms;
  for (Eigen::Index k = 0; k < growth_.size(); ++k)
    if (!has_faded(flow_.mu()[k], first - begin_)) terms.alive.push_back(k);
  const auto modes = std::ssize(terms.alive), harmonics = wave_.size();
  terms.rates.resize(modes + harmonics);
  terms.rates.head(modes) = flow_.mu()(terms.alive);
  for (Eigen::Index h = 0; h < harmonics; ++h) terms.rates[modes + h] = Complex(0.0, rate(h));
  terms.becomes.resize(modes + harmonics, std::ssize(times));
  for (Eigen::Index i = 0; i < terms.becomes.cols(); ++i) {
    move_to(times[static_cast<std::size_t>(i)]);
    terms.becomes.col(i).head(modes) = growth_(terms.alive);
    terms.becomes.col(i).tail(harmonics) = wave_;
  }
  return terms;
}

// Re (C G) = Re C Re G - Im C Im G, C the terms of each output, G what becomes of them.
std::vector<Eigen::MatrixXd> ModalFlow::Arc::derivatives(const Eigen::MatrixXcd& of_output, Terms terms,
                                                         int highest) const {
  const Eigen::MatrixXd real = of_output.real(), imaginary = of_output.imag();
  std::vector<Eigen::MatrixXd> result;
  for (int order = 0; order <= highest; ++order) {
    if (order > 0) terms.becomes = terms.rates.asDiagonal() * terms.becomes;
    result.push_back(dense_product(real, Eigen::MatrixXd(terms.becomes.real())));
    subtract_product(imaginary, terms.becomes.imag(), result.back());
  }
  return result;
}

std::vector<Eigen::MatrixXd> ModalFlow::Arc::outputs(std::span<const double> times, int highest) const {
  Terms terms = terms_at(times);
  const Eigen::MatrixXcd all = of_outputs(0, equations_.outputs(), terms);
  return derivatives(all, std::move(terms), highest);
}

// What the terms are in some of the outputs.
Eigen::MatrixXcd ModalFlow::Arc::of_outputs(Eigen::Index first, Eigen::Index count,
                                            const Terms& terms) const {
  Eigen::MatrixXcd result(count, terms.rates.size());
  result.leftCols(std::ssize(terms.alive)) = contribution_(Eigen::seqN(first, count), terms.alive);
  result.rightCols(wave_.size()) = flow_.row_of_harmonic_.middleRows(first, count);
  return result;
}

std::vector<Eigen::MatrixXd> ModalFlow::Arc::open_displacements(std::span<const double> times, int highest,
                                                                int first, int count) const {
  Terms terms = terms_at(times);
  const FlowStructure& s = equations_.structure();
  const Eigen::Index modes = std::ssize(terms.alive), size = flow_.size(), contacts = s.contact_count();
  Eigen::MatrixXcd of_u(size, terms.rates.size());
  for (Eigen::Index j = 0; j < modes; ++j) {
    const Complex weighted = flow_.weight()[terms.mode(j)] * amplitude_[terms.mode(j)];
    for (Eigen::Index i = 0; i < size; ++i) of_u(i, j) = flow_.basis_->shapes(i, terms.mode(j)) * weighted;
  }
  of_u.rightCols(wave_.size()) = flow_.forced_.topRows(size);
  Eigen::MatrixXcd of_output = dense_product(Eigen::MatrixXd(s.open_rows.middleRows(first, count)), of_u);
  of_output.rightCols(wave_.size()) += s.open_waves.middleRows(first, count);
  const bool relaxes = s.relaxing() > 0;
  const Eigen::MatrixXd follows = relaxes
                                      ? Eigen::MatrixXd(s.open_by_contacts.middleRows(first, count))
                                      : columns_of(s.open.compliance.middleRows(first, count), mode().active);
  if (follows.cols() > 0)
    of_output += dense_product(follows, of_outputs(relaxes ? 0 : contacts, follows.cols(), terms));
  return derivatives(of_output, std::move(terms), highest);
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

// order-th derivative (0..2) of the first coordinates of (u, xi).
void ModalFlow::Arc::differentiate(double time, int order, Eigen::Ref<Eigen::VectorXd> derivative) const {
  move_to(time);
  const Eigen::Index n = derivative.size();
  derivative.setZero();
  for (Eigen::Index k = 0; k < growth_.size(); ++k) {
    if (growth_[k] == Complex(0.0)) continue;
    Complex a = flow_.weight()[k] * amplitude_[k] * growth_[k];
    for (int i = 0; i < order; ++i) a *= flow_.mu()[k];
    // Re (a U), without the other part and its look for what is not a number
    const Complex* shape = flow_.basis_->shapes.col(k).data();
    for (Eigen::Index i = 0; i < n; ++i)
      derivative[i] += a.real() * shape[i].real() - a.imag() * shape[i].imag();
  }
  for (Eigen::Index h = 0; h < wave_.size(); ++h) {
    const double r = rate(h);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Complex part = flow_.forced_(i, h) * wave_[h];  // times (i r)^order
      derivative[i] += order == 0 ? part.real() : order == 1 ? -r * part.imag() : -r * r * part.real();
    }
  }
}

// What relaxes alone pushes nowhere, and most shift harmonics and fast modes are below rounding.
bool ModalFlow::Arc::add_force_integrals(double begin, double end, double w, Eigen::MatrixXcd& sums) const {
  const std::vector<int>& closed = mode().active;
  if (closed.empty()) return true;
  const Eigen::Index modes = growth_.size(), waves = wave_.size();
  Eigen::VectorXcd rates(modes + waves);
  Eigen::MatrixXcd terms(modes + waves, std::ssize(closed));
  move_to(begin);
  rates.head(modes) = flow_.mu();
  for (Eigen::Index h = 0; h < waves; ++h) rates[modes + h] = Complex(0.0, rate(h));
  for (Eigen::Index c = 0; c < terms.cols(); ++c) {
    const Eigen::Index row = equations_.force_row(closed[static_cast<std::size_t>(c)]);
    for (Eigen::Index k = 0; k < modes; ++k) terms(k, c) = contribution_(row, k) * growth_[k];
    for (Eigen::Index h = 0; h < waves; ++h) terms(modes + h, c) = flow_.row_of_harmonic_(row, h) * wave_[h];
  }
  const Eigen::MatrixXcd integrals = harmonic_integrals(rates, terms, begin, end, w, sums.rows() - 1);
  for (Eigen::Index c = 0; c < terms.cols(); ++c)
    sums.col(closed[static_cast<std::size_t>(c)]) += integrals.col(c);
  return true;
}

std::unique_ptr<LinearArc> ModalFlow::arc() const { return std::make_unique<Arc>(*this); }

}  // namespace signorini
