#include "methods/linear_flow/flow_structure.hpp"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

Eigen::VectorXd wave_derivative(const Eigen::MatrixXcd& amplitudes, const std::vector<double>& rates,
                                double time, int order) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(amplitudes.rows());
  for (std::size_t h = 0; h < rates.size(); ++h) {
    if (rates[h] == 0.0 && order > 0) continue;
    const double angle = rates[h] * time + 0.5 * std::numbers::pi * order;
    const double factor = order == 0 ? 1.0 : std::pow(rates[h], order);
    const double of_real = std::cos(angle), of_imaginary = std::sin(angle);
    const std::complex<double>* column = amplitudes.col(static_cast<Eigen::Index>(h)).data();
    for (Eigen::Index i = 0; i < sum.size(); ++i)
      sum[i] += factor * (of_real * column[i].real() - of_imaginary * column[i].imag());
  }
  return sum;
}

FlowStructure::FlowStructure(const Problem& problem) : FlowStructure(problem, condense(problem)) {}

FlowStructure::FlowStructure(const Problem& problem, CondensedStructure condensed)
    : CondensedStructure(std::move(condensed)),
      gaps(contact_gaps(problem)),
      highest_harmonic(std::max(1, highest_load_harmonic(problem))) {
  if (!obstacle.empty()) throw std::runtime_error(obstacle);
  directions = normals;
  compliance = massless_compliance;
  if (relaxation.size() > 0 && !relaxation.isZero(0.0))
    xi_times = (relaxation.array() > 0.0).select(relaxation, relaxation.maxCoeff());
  factors = std::make_shared<const SparseLlt>(mass);
  if (!factors->definite())
    throw std::runtime_error("the mass matrix is singular on the coordinates with mass");
  if (has_springs(problem)) {
    const Eigen::VectorXd springs = stop_compliance(problem);
    for (int j = 0; j < contact_count(); ++j) {
      const double give = springs[scene_contact(j)];
      if (give > 0.0 && relaxes(j)) throw std::runtime_error(spring_on_relaxing(scene_contact(j)));
      compliance(j, j) += give;
    }
  }
  if (!open.contacts.empty()) {
    const Eigen::VectorXd all = gaps;
    gaps = entries_of(all, acting);
    open_gaps = entries_of(all, open.contacts);
  }
  follow_open();
  velocity_per_impulse = factors->solve(directions);
  delassus = product_of_transposed(directions, velocity_per_impulse);
  measure_rates();
  set_frequency(problem.frequency);
  measure_scales(problem);
}

int FlowStructure::scene_contact(int contact) const {
  const int act = contact_count();
  if (contact >= act) return open.contacts[static_cast<std::size_t>(contact - act)];
  return acting.empty() ? contact : acting[static_cast<std::size_t>(contact)];
}

std::vector<int> FlowStructure::scene_contacts() const {
  std::vector<int> contacts(static_cast<std::size_t>(contact_count()) + open.contacts.size());
  for (std::size_t j = 0; j < contacts.size(); ++j) contacts[j] = scene_contact(static_cast<int>(j));
  return contacts;
}

// Open contacts relax to C_oj of the forces as acting ones do to C_jj of them: with R = C_oj C_jj^-1, once
// the beginning is forgotten,
//
//     x_o = N_o^T u + R (x - N^T u) + Re sum_h (s_o - R s)_h / (1 + i beta_o r_h) e^{i r_h t}.
void FlowStructure::follow_open() {
  if (open.contacts.empty()) return;
  open_rows = open.normals.transpose();
  open_waves = open.shift;
  if (relaxing() > 0) {
    open_by_contacts =
        least_norm_solve(massless_compliance, Eigen::MatrixXd(open.compliance.transpose())).transpose();
    find_unclear();
    open_contact_sum = open_by_contacts.cwiseAbs().rowwise().sum().maxCoeff();
    open_rows -= product_by_transposed(open_by_contacts, directions);
    open_waves -= product_of_complex(open_by_contacts, shift);
  } else if (contact_count() > 0) {
    open_compliance = open.compliance.cwiseAbs().colwise().maxCoeff().transpose();
  }
  for (std::size_t h = 0; h < rates.size(); ++h)
    for (Eigen::Index o = 0; o < open_waves.rows(); ++o)
      open_waves(o, static_cast<Eigen::Index>(h)) /= std::complex<double>(1.0, open.relaxation[o] * rates[h]);
  open_row_norm = open_rows.rowwise().norm().maxCoeff();
}

// Of a compliance that is singular to rounding only a pseudo-inverse is known.
void FlowStructure::find_unclear() {
  const double scale = massless_compliance.diagonal().maxCoeff();
  const Eigen::MatrixXd rest = product(open_by_contacts, massless_compliance) - open.compliance;
  open_unclear.clear();
  for (Eigen::Index k = 0; k < rest.rows(); ++k) {
    if (!(rest.row(k).cwiseAbs().maxCoeff() <= kMatrixRounding * scale))
      open_unclear.push_back(static_cast<int>(k));
  }
}

FlowStructure FlowStructure::at_frequency(double omega) const {
  FlowStructure result = *this;
  for (double& rate : result.rates) rate = std::round(rate / frequency) * omega;
  result.set_frequency(omega);
  result.follow_open();
  result.scales.velocity = omega * scales.displacement;
  result.scales.acceleration = result.fastest_rate * result.scales.velocity;
  return result;
}

Eigen::VectorXd FlowStructure::load_at(double time) const { return wave_derivative(load, rates, time, 0); }

Eigen::VectorXd FlowStructure::free_force(double time, const Eigen::MatrixXd& u, int k) const {
  Eigen::VectorXd force = wave_derivative(load, rates, time, k);
  subtract_sparse_image(stiffness, u.col(k).head(size()), force);
  subtract_sparse_image(damping, u.col(k + 1).head(size()), force);
  return force;
}

Eigen::VectorXd FlowStructure::unloaded(double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                                        int order) const {
  Eigen::VectorXd x = image_by_transposed(directions, u.head(size()));
  if (relaxing() > 0)
    x += u.tail(relaxing());
  else
    x += wave_derivative(shift, rates, time, order);
  return x;
}

Eigen::VectorXd FlowStructure::shift_at(double time, int order) const {
  return wave_derivative(shift, rates, time, order);
}

Eigen::MatrixXd FlowStructure::impulse_of_velocity(const std::vector<int>& pushed,
                                                   const std::vector<double>& restitution) const {
  const Eigen::MatrixXd G = block_of(delassus, pushed, pushed);
  Eigen::MatrixXd speeds = columns_of(directions, pushed).transpose();
  for (Eigen::Index k = 0; k < speeds.rows(); ++k)
    speeds.row(k) *= 1.0 + restitution[static_cast<std::size_t>(k)];
  if (speeds.rows() == 1) return -speeds / G(0, 0);
  return -least_norm_solve(G, speeds);
}

// Power iteration, until it stands still; the factor covers its slow last digits. An estimate is enough: it
// only sizes steps.
void FlowStructure::measure_rates() {
  constexpr int kIterations = 40;
  const auto largest = [&](const SparseMatrix& A) {
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size(), 1.0, 2.0);
    for (int i = 1; i < size(); i += 2) x[i] = -x[i];  // the fastest modes alternate in sign
    double value = 0.0;
    for (int k = 0; k < kIterations && x.norm() > 0.0; ++k) {
      x.normalize();
      x = factors->solve(sparse_image(A, x));
      const double before = std::exchange(value, x.norm());
      if (value == before) break;
    }
    return value;
  };
  oscillation_ = std::sqrt(largest(stiffness));
  decay_ = largest(damping);
  if (relaxing() > 0) decay_ = std::max(decay_, 1.0 / xi_times.minCoeff());
}

void FlowStructure::set_frequency(double omega) {
  constexpr double kMargin = 1.1;
  constexpr double kFast = 100.0;  // below, explicit steps follow the load anyway
  frequency = omega;
  forcing_period = 2.0 * std::numbers::pi / omega;
  fastest_rate = std::max({kMargin * oscillation_, kMargin * decay_, highest_harmonic * frequency});
  stiff = decay_ > 2.0 * oscillation_ && decay_ > kFast * highest_harmonic * frequency;
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

// The largest magnitude; zero of nothing.
double largest_of(const Eigen::VectorXd& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

// What the load moves without help from a resonance: |f_i| / (K_ii + (h omega)^2 M_ii) [m].
double forced_amplitude(const Problem& problem) {
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(problem.size());
  const Eigen::VectorXd k = problem.stiffness().diagonal(), m = problem.mass().diagonal();
  for (const ForceTerm& term : problem.force) {
    const double w = std::max(1, term.harmonic) * problem.frequency;
    amplitude[term.dof] +=
        std::abs(force_amplitude(term, problem.frequency)) / (k[term.dof] + w * w * m[term.dof]);
  }
  return amplitude.maxCoeff();
}

}  // namespace

// The same at the contacts of a reduced structure, whose matrices are diagonal: it is there to be spared the
// factors of the whole one.
double FlowStructure::reduced_amplitude() const {
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(contact_count()),
                  open_amplitude = Eigen::VectorXd::Zero(open_gaps.size());
  for (std::size_t h = 0; h < rates.size(); ++h) {
    const std::complex<double> i_rate(0.0, rates[h]);
    const auto column = static_cast<Eigen::Index>(h);
    // Displacements that are added have many harmonics, of contacts alone.
    Eigen::VectorXcd u;
    if (!load.col(column).isZero(0.0)) {
      Eigen::VectorXcd z(size());
      for (int k = 0; k < size(); ++k) {
        const std::complex<double> elastic = stiffness.coeff(k, k), drag = damping.coeff(k, k),
                                   inertia = mass.coeff(k, k);
        z[k] = elastic + i_rate * drag + i_rate * i_rate * inertia;
      }
      u = load.col(column).cwiseQuotient(z);
    }
    const auto add = [&](const Eigen::MatrixXcd& shifts, const Eigen::VectorXd& times,
                         const Eigen::MatrixXd& directions_of, Eigen::VectorXd& sum) {
      if (sum.size() == 0) return;
      Eigen::VectorXcd x = shifts.col(column);
      for (Eigen::Index j = 0; j < x.size(); ++j) x[j] /= 1.0 + times[j] * i_rate;
      if (u.size() > 0) x += image_of_complex_by_transposed(directions_of, u);
      sum += x.cwiseAbs();
    };
    add(shift, relaxation, directions, amplitude);
    add(open.shift, open.relaxation, open.normals, open_amplitude);
  }
  return std::max(largest_of(amplitude), largest_of(open_amplitude));
}

void FlowStructure::measure_scales(const Problem& problem) {
  constexpr double kResonance = 1e6;  // beyond this the linear response is only the round-off of a resonance
  const double linear = kept.empty() ? reduced_amplitude() : linear_amplitude(problem);
  const double gap = std::max(largest_of(gaps), largest_of(open_gaps));
  const double limited = std::max(gap, forced_amplitude(problem));
  const bool usable = linear > 0.0 && linear <= kResonance * limited &&
                      ((contact_count() == 0 && open.contacts.empty()) || linear < limited);
  // A motion that reaches a stop is no larger than the gap and what the load forces; one that stays clear of
  // it is the linear response.
  double X = usable ? linear : limited;
  if (!(X > 0.0) || !std::isfinite(X)) X = 1.0;  // nothing moves: any unit will do
  scales = {.displacement = X, .velocity = frequency * X, .acceleration = fastest_rate * frequency * X};
}

}  // namespace signorini
