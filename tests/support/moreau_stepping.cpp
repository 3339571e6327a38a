#include "tests/support/moreau_stepping.hpp"

#include <Eigen/Core>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::test {

namespace {

// p <= 0 with w = v + G p <= 0 and p w = 0, by enumeration; few contacts.
Eigen::VectorXd impulses(const Eigen::MatrixXd& G, const Eigen::VectorXd& v) {
  const auto m = static_cast<int>(v.size());
  for (int set = 0; set < (1 << m); ++set) {
    std::vector<int> in;
    for (int j = 0; j < m; ++j) {
      if ((set >> j) & 1) in.push_back(j);
    }
    Eigen::VectorXd p = Eigen::VectorXd::Zero(m);
    if (!in.empty()) {
      const Eigen::MatrixXd block = G(in, in);
      const Eigen::VectorXd part = -lu_solve(block, Eigen::VectorXd(v(in)));
      p(in) = part;
    }
    const double noise = 1e-12 * (v.cwiseAbs().maxCoeff() + 1e-300);
    if ((p.array() <= 0.0).all() && ((v + G * p).array() <= noise).all()) return p;
  }
  return Eigen::VectorXd::Zero(m);
}

}  // namespace

Eigen::MatrixXd moreau_steady_state(const Problem& problem, int steps, int periods) {
  const Eigen::Index n = problem.size();
  const double T = 2.0 * 3.14159265358979323846 / problem.frequency, h = T / steps;
  const Eigen::MatrixXd M(problem.mass()), K(problem.stiffness()), D(problem.damping()),
      W(contact_directions(problem));
  const Eigen::VectorXd g = contact_gaps(problem);
  const Eigen::MatrixXd A = LuFactors(M + 0.5 * h * D + 0.25 * h * h * K).inverse();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(n), v = u;
  Eigen::MatrixXd x(steps, W.cols());
  for (int k = 0; k < periods * steps; ++k) {
    const double t = (k % steps) * h;
    x.row(k % steps) = W.transpose() * u;
    const Eigen::VectorXd load = 0.5 * (load_at(problem, t) + load_at(problem, t + h));
    Eigen::VectorXd next = v + A * (h * (load - K * u - D * v - 0.5 * h * K * v));
    std::vector<int> near;
    const Eigen::VectorXd predicted = W.transpose() * (u + 0.5 * h * v) - g;
    for (int j = 0; j < g.size(); ++j) {
      if (predicted[j] >= 0.0) near.push_back(j);
    }
    if (!near.empty()) {
      const Eigen::MatrixXd Wn = W(Eigen::all, near);
      const Eigen::MatrixXd back = A * Wn;
      next += back * impulses(Wn.transpose() * back, Wn.transpose() * next);
    }
    u += 0.5 * h * (v + next);
    v = next;
  }
  return x;
}

}  // namespace signorini::test
