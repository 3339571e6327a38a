#include "methods/linear_flow/contact_dynamics.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace signorini {

namespace {

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
    : structure_(std::make_shared<FlowStructure>(problem)), stops_(Stops::of(problem, *structure_)) {
  if (const auto* law = std::get_if<Restitution>(&problem.law)) restitution_ = law->e;
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

ContactDynamics::ContactDynamics(const ContactDynamics& other, double frequency)
    : structure_(std::make_shared<FlowStructure>(other.structure().at_frequency(frequency))),
      stops_(Stops::on(*structure_, other.rigid())),
      restitution_(other.restitution_),
      small_(other.small_),
      inverse_mass_stiffness_(other.inverse_mass_stiffness_),
      inverse_mass_damping_(other.inverse_mass_damping_),
      inverse_mass_load_(other.inverse_mass_load_) {
  for (LoadRate& load : inverse_mass_load_)
    load.rate = std::round(load.rate / other.structure().frequency) * frequency;
}

ContactMode ContactDynamics::mode(const std::vector<bool>& closed) const {
  ContactMode result;
  for (int j = 0; j < contact_count(); ++j) {
    if (closed[static_cast<std::size_t>(j)]) result.active.push_back(j);
  }
  if (!result.active.empty())
    result.response = symmetric_inverse(stops_->coupling()(result.active, result.active));
  return result;
}

double ContactDynamics::force_scale(int contact) const {
  return stops_->scale() / stops_->coupling()(contact, contact);
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
    Eigen::VectorXd force = structure_->load_at(time);
    force.noalias() -= structure_->stiffness * u;
    force.noalias() -= structure_->damping * v;
    a = structure_->factors->solve(force);
  }
  if (!mode.active.empty()) stops_->add_acceleration(mode, time, u, a);
}

Eigen::MatrixXd ContactDynamics::flow_matrix(const ContactMode& mode) const {
  const int n = size();
  Eigen::MatrixXd from_u = -structure_->factors->solve(stops_->stiffness(mode));
  Eigen::MatrixXd from_v = -structure_->factors->solve(Eigen::MatrixXd(structure_->damping));
  if (!mode.active.empty()) stops_->constrain(mode, from_u, from_v);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  B.topRightCorner(n, n).setIdentity();
  B.bottomLeftCorner(n, n) = from_u;
  B.bottomRightCorner(n, n) = from_v;
  return B;
}

}  // namespace signorini
