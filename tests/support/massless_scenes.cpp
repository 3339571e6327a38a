#include "tests/support/massless_scenes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "problems/linear_algebra/lu.hpp"
#include "tests/support/random_springs.hpp"

namespace signorini::test {

namespace {

SparseMatrix sparse(const Eigen::MatrixXd& dense) { return dense.sparseView(); }

}  // namespace

Problem massless_node(double gap, double spring) {
  Problem problem;
  problem.name = "massless-node";
  problem.edit_structure([&](Structure& s) {
    s.mass = sparse(Eigen::Vector2d(1.0, 0.0).asDiagonal());
    s.damping = sparse(Eigen::Vector2d(0.1, 0.0).asDiagonal());
    s.stiffness = sparse((Eigen::Matrix2d() << 1.0 + spring, -spring, -spring, spring).finished());
  });
  problem.frequency = 2.2;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = gap}};
  problem.set_law(Massless{});
  return problem;
}

Problem coupled_massless_scene(unsigned seed) {
  constexpr int kMasses = 4, kMassless = 3, kAll = kMasses + kMassless, kContacts = 3;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  // Any two coordinates are tied by a spring, each to the wall too.
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(kAll, kAll);
  for (int i = 0; i < kAll; ++i) {
    K(i, i) += 1.0 + 0.5 * draw(random);
    tie_to_all_before(K, i, random);
  }
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(kAll);
  for (int i = 0; i < kMasses; ++i) mass[i] = 2.0 + draw(random);
  Problem problem;
  problem.name = "coupled-massless";
  problem.edit_structure([&](Structure& s) {
    s.mass = sparse(mass.asDiagonal());
    s.damping = sparse(0.3 * Eigen::MatrixXd(mass.asDiagonal()));
    s.stiffness = sparse(K);
  });
  problem.frequency = 1.3;
  for (int dof = 0; dof < kAll; ++dof) {
    problem.force.push_back({.dof = dof, .harmonic = 0, .cos = 0.3 * draw(random), .sin = 0.0});
    problem.force.push_back(
        {.dof = dof, .harmonic = 1, .cos = 4.0 * draw(random), .sin = 4.0 * draw(random)});
    problem.force.push_back({.dof = dof, .harmonic = 2, .cos = draw(random), .sin = draw(random)});
  }
  for (int c = 0; c < kContacts; ++c) {
    Contact contact{.normal = {}, .gap = 0.1 + 0.05 * draw(random)};
    for (int b = 0; b < kMassless; ++b)
      contact.normal.emplace_back(kMasses + b, (b == c ? 1.0 : 0.0) + 0.4 * draw(random));
    problem.contacts.push_back(contact);
  }
  problem.set_law(Massless{});
  return problem;
}

Problem ring_in_polygon(int facets, double speed, double spring) {
  constexpr double kUnbalance = 0.1, kDamping = 0.05, kGap = 0.3;
  Problem problem;
  problem.name = "ring-in-polygon";
  const Eigen::Vector4d mass(1.0, 1.0, 0.0, 0.0);
  problem.edit_structure([&](Structure& s) {
    s.mass = sparse(mass.asDiagonal());
    s.damping = sparse(kDamping * Eigen::MatrixXd(mass.asDiagonal()));
  });
  Eigen::Matrix4d K = Eigen::Matrix4d::Zero();
  for (int axis = 0; axis < 2; ++axis) {
    K(axis, axis) = 1.0 + spring;
    K(axis + 2, axis + 2) = spring;
    K(axis, axis + 2) = K(axis + 2, axis) = -spring;
  }
  problem.edit_structure([&](Structure& s) { s.stiffness = sparse(K); });
  problem.frequency = speed;
  const double load = kUnbalance * speed * speed;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = load, .sin = 0.0},
                   {.dof = 1, .harmonic = 1, .cos = 0.0, .sin = load}};
  for (int j = 0; j < facets; ++j) {
    const double angle = 2.0 * std::numbers::pi * (j + 0.5) / facets;
    problem.contacts.push_back({.normal = {{2, std::cos(angle)}, {3, std::sin(angle)}}, .gap = kGap});
  }
  problem.set_law(Massless{});
  return problem;
}

StaticContact static_contact(const Problem& problem, const std::vector<int>& massless, double time,
                             const Eigen::VectorXd& u_with_mass) {
  std::vector<int> heavy;
  for (int dof = 0; dof < problem.size(); ++dof) {
    if (std::find(massless.begin(), massless.end(), dof) == massless.end()) heavy.push_back(dof);
  }
  const Eigen::MatrixXd K = problem.stiffness(), W = contact_directions(problem);
  const Eigen::MatrixXd K_bb = K(massless, massless), W_b = W(massless, Eigen::all);
  const Eigen::VectorXd load = load_at(problem, time)(massless) - K(massless, heavy) * u_with_mass;
  const Eigen::VectorXd gap = contact_gaps(problem);
  const double noise = 1e-9 * (load.norm() + K_bb.norm() * gap.norm());
  for (unsigned set = 0; set < 1U << problem.contact_count(); ++set) {
    std::vector<int> closed;
    for (int c = 0; c < problem.contact_count(); ++c) {
      if (set >> c & 1U) closed.push_back(c);
    }
    const auto b = K_bb.rows();
    const auto a = static_cast<Eigen::Index>(closed.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(b + a, b + a);
    A.topLeftCorner(b, b) = K_bb;
    A.topRightCorner(b, a) = -W_b(Eigen::all, closed);
    A.bottomLeftCorner(a, b) = W_b(Eigen::all, closed).transpose();
    Eigen::VectorXd right(b + a);
    right << load, gap(closed);
    const Eigen::VectorXd z = CompleteLuFactors(A).solve(right);
    StaticContact found{.x = W_b.transpose() * z.head(b),
                        .lambda = Eigen::VectorXd::Zero(problem.contact_count())};
    found.lambda(closed) = z.tail(a);
    if ((A * z - right).norm() <= noise && (found.x - gap).maxCoeff() <= noise &&
        found.lambda.maxCoeff() <= noise)
      return found;
  }
  throw std::runtime_error("no set of closed contacts satisfies the conditions");
}

}  // namespace signorini::test
