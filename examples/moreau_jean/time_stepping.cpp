#include "time_stepping.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace moreau_jean {

TimeStepping::TimeStepping(const signorini::Problem& problem, double h, double theta)
    : problem_(problem),
      h_(h),
      theta_(theta),
      W_(contact_directions(problem)),
      gaps_(contact_gaps(problem)),
      p_(Eigen::VectorXd::Zero(problem.contact_count())) {
  const signorini::Law scene_law = problem.law();
  if (const auto* law = std::get_if<signorini::Restitution>(&scene_law)) e_ = law->e;
  const double a = h * theta;
  A_.compute(signorini::SparseMatrix(problem.mass() + a * problem.damping() + a * a * problem.stiffness()));
  if (A_.info() != Eigen::Success) throw std::runtime_error("the matrix of a step cannot be factorised");
  response_ = A_.solve(Eigen::MatrixXd(W_));
  G_ = W_.transpose() * response_;
}

void TimeStepping::add_load(double t, Eigen::VectorXd& rhs) const {
  for (const signorini::ForceTerm& term : problem_.force) {
    const double w = term.harmonic * problem_.frequency;
    const std::complex<double> amplitude = signorini::force_amplitude(term, problem_.frequency);
    const auto value = [&](double time) { return (amplitude * std::polar(1.0, w * time)).real(); };
    rhs[term.dof] += h_ * (theta_ * value(t + h_) + (1.0 - theta_) * value(t));
  }
}

// Gauss-Seidel with projection: a sweep solves each contact's own line for its impulse, the others fixed.
void TimeStepping::find_impulses(const Eigen::VectorXd& predicted, const Eigen::VectorXd& free,
                                 const Eigen::VectorXd& before) {
  constexpr int kSweeps = 10000;
  constexpr double kAccuracy = 1e-14;  // relative, of the impulses
  p_.setZero();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double change = 0.0;
    for (Eigen::Index j = 0; j < p_.size(); ++j) {
      if (predicted[j] < gaps_[j]) continue;  // open
      const double excess = free[j] + e_ * before[j] + G_.row(j).dot(p_);
      const double next = std::min(0.0, p_[j] - excess / G_(j, j));
      change = std::max(change, std::abs(next - p_[j]));
      p_[j] = next;
    }
    if (change <= kAccuracy * p_.cwiseAbs().maxCoeff()) return;
  }
}

const Eigen::VectorXd& TimeStepping::advance(State& state, double t) {
  const double rest = h_ * (1.0 - theta_);
  // A v_+ = M v - h (1 - theta) D v - h K (u + h theta (1 - theta) v) + h f* + W p
  Eigen::VectorXd rhs = problem_.mass() * state.v - rest * (problem_.damping() * state.v) -
                        h_ * (problem_.stiffness() * (state.u + rest * theta_ * state.v));
  add_load(t, rhs);
  Eigen::VectorXd next = A_.solve(rhs);
  p_.setZero();
  if (p_.size() > 0) {
    const Eigen::VectorXd predicted = W_.transpose() * (state.u + 0.5 * h_ * state.v);
    if ((predicted.array() >= gaps_.array()).any()) {
      find_impulses(predicted, W_.transpose() * next, W_.transpose() * state.v);
      next += response_ * p_;
    }
  }
  state.u += h_ * (theta_ * next + (1.0 - theta_) * state.v);
  state.v = std::move(next);
  return p_;
}

}  // namespace moreau_jean
