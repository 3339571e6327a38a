// Multipliers along a curve of a structure of many coordinates against all eigenvalues of each monodromy.

#include "methods/orbit/continuation/bifurcations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>

#include "methods/orbit/continuation/branch_section.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"

namespace signorini::bifurcations_test {
namespace {

Problem long_chain(int masses) {
  Chain chain;
  for (int i = 0; i < masses; ++i) {
    chain.masses.push_back(1.0);
    chain.springs.push_back(100.0);
    chain.dampers.push_back(5.0);
  }
  Problem problem;
  problem.structure = std::make_shared<const Structure>(assemble(chain));
  problem.frequency = 2.2;
  problem.force = {{.dof = masses - 1, .harmonic = 1, .cos = 1.0}};
  problem.contacts = {{.normal = {{masses - 1, 1.0}}, .gap = 0.05}};
  problem.set_law(Restitution{0.8});
  return problem;
}

double worst_of(const Eigen::VectorXcd& given, const Eigen::VectorXcd& all) {
  double worst = 0.0;
  for (const std::complex<double>& mu : given) worst = std::max(worst, (all.array() - mu).abs().minCoeff());
  return worst;
}

// From a contact-free motion through its grazing to one with impacts.
TEST(Multipliers, OfManyAreTheLargestOfThoseOfTheMonodromy) {
  constexpr int kMasses = 36;  // 72 states
  OrbitFamily family(over_frequency(long_chain(kMasses), 2.0, 2.8));
  const OrbitDiagram diagram =
      trace_diagram(family, {contact_free_orbit(family, 2.8).value()}, {.max_branches = 2, .max_points = 30});
  std::size_t points = 0, leading = 0;
  int impacts = 0;
  for (const OrbitBranch& branch : diagram.branches) {
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const SolutionPoint& point = branch.points[i];
      if (point.stability == OrbitStability::undefined) continue;
      const SequencedOrbit there = orbit_of(family, branch, i);
      ExtendedEquations at(family, there);
      ASSERT_TRUE(at.evaluate(there.x));
      const Eigen::VectorXcd all = general_eigenvalues(at.monodromy());
      const double largest = largest_magnitude(all);
      EXPECT_LT(worst_of(point.multipliers, all), 1e-8 * std::max(1.0, largest)) << i;
      EXPECT_NEAR(largest_magnitude(point.multipliers), largest, 1e-8 * largest) << i;
      EXPECT_EQ(point.stability == OrbitStability::stable, largest < 1.0) << i;
      const auto outside = [](const Eigen::VectorXcd& mu) { return (mu.array().abs() > 1.0).count(); };
      EXPECT_EQ(outside(point.multipliers), outside(all)) << i;
      ++points;
      impacts += point.impacts;
      leading += point.multipliers.size() < all.size() ? 1 : 0;
    }
  }
  EXPECT_GT(points, 10U);
  EXPECT_GT(impacts, 5);
  EXPECT_GT(leading, points / 3) << "or all of them were looked at everywhere";
}

}  // namespace
}  // namespace signorini::bifurcations_test
