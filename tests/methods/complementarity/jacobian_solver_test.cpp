#include "methods/complementarity/jacobian_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/discretisation/fourier_series.hpp"

namespace signorini::jacobian_solver_test {
namespace {

using Complex = std::complex<double>;
using Intervals = std::vector<std::vector<ContactInterval>>;

constexpr int kHarmonics = 40;

/// A patch of contacts on one mass: each also yields by itself, by so much of what the mass does.
ContactSymbol patch(int contacts, double own, double constant = 1e4) {
  ContactReceptance receptance;
  receptance.period = 1.0;
  for (int n = 0; n <= kHarmonics; ++n) {
    const double w = 1.3 * n;
    const Complex shared = 1.0 / Complex(2.0 - w * w, 0.1 * w);
    Eigen::MatrixXcd C = Eigen::MatrixXcd::Constant(contacts, contacts, shared);
    for (int c = 0; c < contacts; ++c) C(c, c) += own * (1.0 + c);
    receptance.receptance.push_back(C);
  }
  receptance.free_response = Eigen::MatrixXcd::Zero(kHarmonics + 1, contacts);
  return {receptance, {Eigen::VectorXd::Constant(contacts, constant), Eigen::VectorXd::Ones(contacts)}};
}

struct Solved {
  KrylovSolve solve;
  double residual = 0.0;
  int products = 0;
};

/// One solve with contact c closed for `length` from 0.1 + c / 100 of the period on.
Solved solve_with(JacobianSolver& solver, const ContactSymbol& symbol, double length) {
  Intervals intervals;
  std::vector<ContactNodes> nodes;
  JacobianSolver::Contacts contacts{.duty = Eigen::VectorXd::Constant(symbol.contacts(), length)};
  for (int c = 0; c < symbol.contacts(); ++c) {
    intervals.push_back({{0.1 + 0.01 * c, 0.1 + 0.01 * c + length}});
    nodes.push_back(nodes_on(intervals.back(), kHarmonics));
    contacts.nodes += nodes.back().time.size();
  }
  Solved solved;
  const auto product = [&](const Eigen::VectorXd& v) {
    ++solved.products;
    Eigen::MatrixXcd rate = symbol.rate(v);
    for (Eigen::Index c = 0; c < rate.cols(); ++c)
      rate.col(c) =
          ContactIndicator(intervals[static_cast<std::size_t>(c)], kHarmonics).restrict(rate.col(c));
    return Eigen::VectorXd(v + pack_harmonics(rate));
  };
  Eigen::VectorXd r(symbol.unknowns());
  for (int i = 0; i < r.size(); ++i) r[i] = std::sin(1.0 + i * i);
  contacts.place = [&] { return nodes; };
  contacts.product = product;
  contacts.matrix = [&] {
    Eigen::MatrixXd matrix(symbol.unknowns(), symbol.unknowns());
    for (int i = 0; i < symbol.unknowns(); ++i)
      matrix.col(i) = product(Eigen::VectorXd::Unit(symbol.unknowns(), i));
    solved.products = 0;
    return matrix;
  };
  solved.solve = solver.solve(symbol, contacts, r);
  const int spent = solved.products;
  if (solved.solve.x.size() == r.size()) solved.residual = (product(solved.solve.x) - r).norm() / r.norm();
  solved.products = spent;
  return solved;
}

TEST(JacobianSolver, TakesOneProductForShortContacts) {
  const ContactSymbol symbol = patch(3, 0.1);
  JacobianSolver solver;
  const Solved solved = solve_with(solver, symbol, 0.5 / kHarmonics);
  EXPECT_LE(solved.products, 2);  // to see the residual, and once more after a correction
  EXPECT_LT(solved.residual, 1e-11);
}

TEST(JacobianSolver, TakesProductsWhereContactsLast) {
  const ContactSymbol symbol = patch(2, 10.0);
  JacobianSolver solver;
  for (int step = 0; step < 2; ++step) {  // a failure would be remembered
    const Solved solved = solve_with(solver, symbol, 0.95);
    EXPECT_GT(solved.products, 3) << step;
    EXPECT_LT(solved.residual, 1e-11) << step;
  }
}

// Forty nodes share the mass and hardly yield: GMRES fails once and is not asked again.
TEST(JacobianSolver, FactorisesAfterGmresHasFailed) {
  const ContactSymbol symbol = patch(40, 1e-3);
  JacobianSolver solver;
  const Solved first = solve_with(solver, symbol, 0.1);
  EXPECT_GE(first.products, 60);
  EXPECT_LT(first.residual, 1e-8);
  const Solved second = solve_with(solver, symbol, 0.1);
  EXPECT_LE(second.products, 3);
  EXPECT_LT(second.residual, 1e-8);
}

// A constant far above the structure's stiffness: the force at the nodes cancels nearly all of r.
TEST(JacobianSolver, KeepsItsAccuracyWhereTheConstantIsLarge) {
  for (const double constant : {1e6, 1e8, 1e10}) {
    const ContactSymbol symbol = patch(2, 0.1, constant);
    JacobianSolver solver;
    for (const double length : {0.5 / kHarmonics, 0.3})
      EXPECT_LT(solve_with(solver, symbol, length).residual, 1e-8) << constant << " " << length;
  }
}

TEST(JacobianSolver, FactorisesTheJacobianItselfWhereThatIsSmall) {
  const ContactSymbol symbol = patch(1, 0.1);
  JacobianSolver solver;
  const Solved solved = solve_with(solver, symbol, 0.9);
  EXPECT_EQ(solved.products, 0);
  EXPECT_LT(solved.residual, 1e-12);
}

TEST(JacobianSolver, HasNoSolutionForWhatIsNoNumber) {
  const ContactSymbol symbol = patch(1, 0.1);
  Eigen::VectorXd r = Eigen::VectorXd::Constant(symbol.unknowns(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(JacobianSolver().solve(symbol, {}, r).x.size(), 0);
}

}  // namespace
}  // namespace signorini::jacobian_solver_test
