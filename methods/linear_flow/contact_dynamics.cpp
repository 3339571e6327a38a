#include "methods/linear_flow/contact_dynamics.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

namespace {

// The inverse where there is one to working precision, else the pseudo-inverse; A is symmetric.
Eigen::MatrixXd symmetric_inverse(const Eigen::MatrixXd& A) {
  const CholeskyFactors factors(A);
  if (factors.definite() && factors.reciprocal_condition() > kSingularCondition) return factors.inverse();
  return pseudo_inverse(A);
}

}  // namespace

ContactDynamics::ContactDynamics(const Problem& problem) : ContactDynamics(problem, condense(problem)) {}

ContactDynamics::ContactDynamics(const Problem& problem, CondensedStructure condensed)
    : structure_(std::make_shared<FlowStructure>(problem, std::move(condensed))) {
  std::vector<bool> rigid;
  for (int j = 0; j < contact_count(); ++j) {
    const Contact& contact = problem.contacts[static_cast<std::size_t>(structure_->scene_contact(j))];
    const auto* law = std::get_if<Restitution>(&contact.law);
    rigid.push_back(law != nullptr);
    restitution_.push_back(law != nullptr ? law->e : 1.0);
  }
  any_rigid_ = rigid.empty() || std::ranges::find(rigid, true) != rigid.end();
  stops_ = Stops::on(*structure_, rigid);
  constexpr int kSmall = 32;  // a dense product is then no dearer than sparse ones and a sparse solve
  const FlowStructure& s = *structure_;
  small_ = size() <= kSmall;
  if (!small_) return;
  inverse_mass_stiffness_ = s.factors->solve(Eigen::MatrixXd(s.stiffness));
  inverse_mass_damping_ = s.factors->solve(Eigen::MatrixXd(s.damping));
  for (std::size_t h = 0; h < s.rates.size(); ++h) {
    const Eigen::VectorXcd load = s.load.col(static_cast<Eigen::Index>(h));
    if (load.isZero(0.0)) continue;
    inverse_mass_load_.push_back({.rate = s.rates[h],
                                  .cos = s.factors->solve(Eigen::VectorXd(load.real())),
                                  .sin = s.factors->solve(Eigen::VectorXd(-load.imag()))});
  }
}

ContactDynamics::ContactDynamics(const ContactDynamics& other, double frequency) : ContactDynamics(other) {
  structure_ = std::make_shared<FlowStructure>(other.structure().at_frequency(frequency));
  stops_ = Stops::on(*structure_, other.stops().rigid());
  for (LoadRate& load : inverse_mass_load_)
    load.rate = std::round(load.rate / other.structure().frequency) * frequency;
}

ContactMode ContactDynamics::mode(const std::vector<bool>& closed) const {
  ContactMode result;
  for (int j = 0; j < contact_count(); ++j) {
    if (closed[static_cast<std::size_t>(j)]) result.active.push_back(j);
  }
  // Where some are rigid and others compliant, each kind alone: they have different units.
  result.response.setZero(std::ssize(result.active), std::ssize(result.active));
  const Eigen::MatrixXd coupling = block_of(stops_->coupling(), result.active, result.active);
  for (const bool rigid : {true, false}) {
    const std::vector<int> rows = stops_->places(result.active, rigid);
    if (rows.empty()) continue;
    result.response(rows, rows) = symmetric_inverse(block_of(coupling, rows, rows));
  }
  return result;
}

double ContactDynamics::force_scale(int contact) const {
  return stops_->scale(contact) / stops_->coupling()(contact, contact);
}

void ContactDynamics::acceleration(const ContactMode& mode, double time,
                                   const Eigen::Ref<const Eigen::VectorXd>& u,
                                   const Eigen::Ref<const Eigen::VectorXd>& v,
                                   Eigen::Ref<Eigen::VectorXd> a) const {
  const auto moved = u.head(size());
  if (small_) {
    a.noalias() = inverse_mass_stiffness_.lazyProduct(-moved);
    a.noalias() -= inverse_mass_damping_.lazyProduct(v);
    for (const LoadRate& load : inverse_mass_load_) {
      a += std::cos(load.rate * time) * load.cos + std::sin(load.rate * time) * load.sin;
    }
  } else {
    Eigen::VectorXd force = structure_->load_at(time);
    subtract_sparse_image(structure_->stiffness, moved, force);
    subtract_sparse_image(structure_->damping, v, force);
    a = structure_->factors->solve(force);
  }
  if (!mode.active.empty()) stops_->add_acceleration(mode, time, u, v, a);
}

void ContactDynamics::rate(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& y,
                           Eigen::Ref<Eigen::VectorXd> rate) const {
  const auto u = y.head(positions());
  const auto v = y.tail(size());
  rate.head(size()) = v;
  if (positions() > size()) stops_->relax(mode, time, u, v, rate.segment(size(), positions() - size()));
  acceleration(mode, time, u, v, rate.tail(size()));
}

State ContactDynamics::with_mass(const State& whole, const Eigen::VectorXd& x) const {
  const Eigen::VectorXd kept = entries_of(whole.u, structure_->kept);
  State state{.u = Eigen::VectorXd(positions()), .v = entries_of(whole.v, structure_->kept)};
  state.u.head(size()) = kept;
  if (positions() > size())
    state.u.tail(positions() - size()) = x - image_by_transposed(structure_->directions, kept);
  return state;
}

Eigen::MatrixXd ContactDynamics::flow_matrix(const ContactMode& mode) const {
  const int n = size(), p = positions();
  Eigen::MatrixXd from_u = -structure_->factors->solve(stops_->stiffness(mode));
  Eigen::MatrixXd from_v = -structure_->factors->solve(stops_->damping(mode));
  if (!mode.active.empty()) stops_->constrain(mode, from_u, from_v);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(p + n, p + n);
  B.topRightCorner(n, n).setIdentity();
  B.bottomLeftCorner(n, n) = from_u;
  B.bottomRightCorner(n, n) = from_v;
  if (p > n) {  // beta xi' = C_A lambda_A - xi
    const Eigen::VectorXd rates = structure_->xi_times.cwiseInverse();
    const Eigen::MatrixXd pushed = columns_of(structure_->massless_compliance, mode.active);
    B.middleRows(n, p - n) =
        product(Eigen::MatrixXd(rates.asDiagonal() * pushed), stops_->free_form(mode).force_of_state);
    B.block(n, n, p - n, p - n).diagonal() -= rates;
  }
  return B;
}

}  // namespace signorini
