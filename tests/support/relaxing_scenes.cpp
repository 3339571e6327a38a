#include "tests/support/relaxing_scenes.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "problems/linear_algebra/exponential.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::test {

namespace {

// The wall, and a row behind it.
Eigen::Matrix4d row_of(const Eigen::Vector4d& links) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 4; ++i) {
    A(i, i) += links[i];
    if (i == 0) continue;
    A(i - 1, i - 1) += links[i];
    A(i, i - 1) -= links[i];
    A(i - 1, i) -= links[i];
  }
  return A;
}

}  // namespace

Problem damped_tip_chain(double dashpot) {
  Problem problem;
  problem.name = "damped-tip-chain";
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Vector4d(1.0, 1.0, 1.0, 0.0).asDiagonal()).sparseView();
    s.damping = Eigen::MatrixXd(row_of({0.05, 0.05, 0.05, dashpot})).sparseView();
    s.stiffness = Eigen::MatrixXd(row_of(Eigen::Vector4d::Constant(4.0))).sparseView();
  });
  problem.frequency = 1.1;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 0.5, .sin = 0.0}};
  problem.contacts = {{.normal = {{3, 1.0}}, .gap = 0.2}};
  problem.set_law(Massless{});
  return problem;
}

Problem rayleigh_chain() {
  Problem problem = damped_tip_chain(0.0);
  problem.name = "rayleigh-chain";
  problem.edit_structure(
      [](Structure& s) { s.damping = SparseMatrix(0.02 * s.mass) + SparseMatrix(0.06 * s.stiffness); });
  problem.force.push_back({.dof = 3, .harmonic = 0, .cos = 0.1, .sin = 0.0});
  return problem;
}

Problem damped_coupled_scene(unsigned seed, double beta) {
  Problem problem = coupled_massless_scene(seed);
  problem.edit_structure([&](Structure& s) { s.damping += SparseMatrix(beta * s.stiffness); });
  return problem;
}

DescriptorFlow::DescriptorFlow(const Problem& problem) {
  std::vector<int> i, b;
  for (int dof = 0; dof < problem.size(); ++dof)
    (problem.mass().coeff(dof, dof) > 0.0 ? i : b).push_back(dof);
  const Eigen::MatrixXd M = problem.mass(), D = problem.damping(), K = problem.stiffness(),
                        W = contact_directions(problem);
  masses_ = std::ssize(i);
  const Eigen::Index n = masses_, nb = std::ssize(b), size = 2 * n + nb;
  const Eigen::MatrixXd free_b = LuFactors(D(b, b)).inverse(), free_i = LuFactors(M(i, i)).inverse();
  Eigen::MatrixXd to_b(nb, size), to_i(n, size);
  to_b << -free_b * K(b, i), -free_b * D(b, i), -free_b * K(b, b);
  to_i << -K(i, i), -D(i, i), -K(i, b);
  A_ = Eigen::MatrixXd::Zero(size, size);
  A_.block(0, n, n, n).setIdentity();
  A_.middleRows(n, n) = free_i * (to_i - D(i, b) * to_b);
  A_.bottomRows(nb) = to_b;
  const auto input = [&](const Eigen::MatrixXd& f) {
    Eigen::MatrixXd column = Eigen::MatrixXd::Zero(size, f.cols());
    column.bottomRows(nb) = free_b * f(b, Eigen::all);
    column.middleRows(n, n) = free_i * (f(i, Eigen::all) - D(i, b) * column.bottomRows(nb));
    return column;
  };
  B_ = input(W);
  E_ = Eigen::MatrixXd::Zero(W.cols(), size);
  E_.rightCols(nb) = W(b, Eigen::all).transpose();
  const int highest = highest_load_harmonic(problem);
  cos_.resize(size, highest + 1);
  sin_.resize(size, highest + 1);
  for (int h = 0; h <= highest; ++h) {
    const Eigen::VectorXcd load = load_harmonic(problem, h);
    rates_.push_back(h * problem.frequency);
    cos_.col(h) = input(load.real());
    sin_.col(h) = -input(load.imag());
  }
}

Eigen::VectorXd DescriptorFlow::load(double time) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(size());
  for (std::size_t h = 0; h < rates_.size(); ++h) {
    const auto column = static_cast<Eigen::Index>(h);
    sum += std::cos(rates_[h] * time) * cos_.col(column) + std::sin(rates_[h] * time) * sin_.col(column);
  }
  return sum;
}

Eigen::MatrixXd DescriptorFlow::projection(const std::vector<int>& active) const {
  Eigen::MatrixXd P = Eigen::MatrixXd::Identity(size(), size());
  if (active.empty()) return P;
  const Eigen::MatrixXd E = E_(active, Eigen::all), B = B_(Eigen::all, active);
  return P - B * LuFactors(E * B).inverse() * E;
}

Eigen::VectorXd DescriptorFlow::rate(const std::vector<int>& active, double time,
                                     const Eigen::VectorXd& y) const {
  return projection(active) * (A_ * y + load(time));
}

Eigen::VectorXd DescriptorFlow::force(const std::vector<int>& active, double time,
                                      const Eigen::VectorXd& y) const {
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(E_.rows());
  if (active.empty()) return lambda;
  const Eigen::MatrixXd E = E_(active, Eigen::all), B = B_(Eigen::all, active);
  lambda(active) = -LuFactors(E * B).inverse() * (E * (A_ * y + load(time)));
  return lambda;
}

Eigen::MatrixXd DescriptorFlow::transition(const std::vector<int>& active, double duration) const {
  return matrix_exponential(projection(active) * A_ * duration);
}

Eigen::VectorXd DescriptorFlow::after(const std::vector<int>& active, double time, const Eigen::VectorXd& y,
                                      double duration) const {
  const Eigen::Index n = size(), count = std::ssize(rates_);
  const Eigen::MatrixXd P = projection(active);
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(n + 2 * count, n + 2 * count);
  Eigen::VectorXd first(n + 2 * count);
  generator.topLeftCorner(n, n) = P * A_;
  first.head(n) = y;
  for (Eigen::Index h = 0; h < count; ++h) {
    const Eigen::Index c = n + 2 * h;
    const double rate = rates_[static_cast<std::size_t>(h)];
    generator.block(0, c, n, 1) = P * cos_.col(h);
    generator.block(0, c + 1, n, 1) = P * sin_.col(h);
    generator(c, c + 1) = -rate;
    generator(c + 1, c) = rate;
    first[c] = std::cos(rate * time);
    first[c + 1] = std::sin(rate * time);
  }
  const Eigen::MatrixXd grown = matrix_exponential(generator * duration);
  return (grown * first).head(n);
}

Eigen::VectorXd DescriptorFlow::state(const Eigen::VectorXd& u, const Eigen::VectorXd& v,
                                      const Eigen::VectorXd& x) const {
  Eigen::VectorXd y(size());
  const Eigen::MatrixXd of_b = E_.rightCols(size() - 2 * masses_);
  y << u.head(masses_), v, CompleteLuFactors(of_b).solve(x);
  return y;
}

Eigen::MatrixXd implicit_euler(const Problem& problem, Eigen::VectorXd u, Eigen::VectorXd v, int steps) {
  const double dt = problem.forcing_period() / steps;
  const Eigen::MatrixXd M = problem.mass(), D = problem.damping(), K = problem.stiffness(),
                        W = contact_directions(problem);
  const LuFactors step(M + dt * D + dt * dt * K);
  const Eigen::MatrixXd moved = dt * step.solve(W);            // v by lambda
  const Eigen::MatrixXd reached = dt * W.transpose() * moved;  // x by lambda
  const Eigen::VectorXd gap = contact_gaps(problem);
  const Eigen::Index contacts = gap.size();
  Eigen::MatrixXd x(steps, contacts);
  for (int k = 1; k <= steps; ++k) {
    const Eigen::VectorXd free = step.solve(Eigen::VectorXd(M * v + dt * (load_at(problem, k * dt) - K * u)));
    const Eigen::VectorXd beyond = W.transpose() * (u + dt * free) - gap;
    bool solved = false;
    for (unsigned set = 0; set < (1U << contacts) && !solved; ++set) {  // every set of closed contacts
      std::vector<int> active;
      for (int j = 0; j < contacts; ++j) {
        if (((set >> j) & 1U) != 0) active.push_back(j);
      }
      Eigen::VectorXd lambda = Eigen::VectorXd::Zero(contacts);
      if (!active.empty())
        lambda(active) = -lu_solve(reached(active, active), Eigen::VectorXd(beyond(active)));
      solved = lambda.maxCoeff() <= 0.0 && (beyond + reached * lambda).maxCoeff() <= 1e-13;
      if (solved) v = free + moved * lambda;
    }
    if (!solved) throw std::runtime_error("no set of closed contacts is admissible");
    u += dt * v;
    x.row(k - 1) = (W.transpose() * u).transpose();
  }
  return x;
}

}  // namespace signorini::test
