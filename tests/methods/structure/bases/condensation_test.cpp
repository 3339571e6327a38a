#include "methods/structure/bases/condensation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "problems/damped_stops.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/massless_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::condensation_test {
namespace {

using Complex = std::complex<double>;

TEST(Condense, TurnsAMasslessNodeIntoACompliantStop) {
  const CondensedStructure condensed = condense(test::massless_node());
  ASSERT_EQ(condensed.obstacle, "");
  EXPECT_EQ(condensed.kept, (std::vector<int>{0}));
  EXPECT_EQ(condensed.mass.coeff(0, 0), 1.0);
  EXPECT_NEAR(condensed.stiffness.coeff(0, 0), 1.0, 1e-14);
  EXPECT_NEAR(condensed.normals.coeff(0, 0), 1.0, 1e-15);
  EXPECT_NEAR(condensed.massless_compliance(0, 0), 1.0 / 20.0, 1e-17);
}

TEST(Condense, LeavesAStructureWithMassEverywhereAsItIs) {
  const Problem problem = test::stopped_chain(5, 0.5, 2);
  const CondensedStructure condensed = condense(problem);
  EXPECT_EQ(condensed.kept.size(), 5U);
  EXPECT_EQ(Eigen::MatrixXd(condensed.stiffness - problem.stiffness()).norm(), 0.0);
  EXPECT_EQ(Eigen::MatrixXd(condensed.normals - contact_directions(problem)).norm(), 0.0);
  EXPECT_TRUE(condensed.massless_compliance.isZero(0.0));
  EXPECT_TRUE(condensed.shift.isZero(0.0));
}

// At any frequency the condensed structure answers loads and contact forces as the whole one does, xi as
// (s + C lambda) / (1 + i beta w).
void expect_same_receptance(const Problem& problem) {
  const CondensedStructure condensed = condense(problem);
  ASSERT_EQ(condensed.obstacle, "");
  const auto stiffness = [](const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& K, double w) {
    return Eigen::MatrixXcd(Eigen::MatrixXd(K - w * w * M).cast<Complex>() +
                            Complex(0.0, w) * Eigen::MatrixXd(D).cast<Complex>());
  };
  const Eigen::MatrixXcd W = Eigen::MatrixXd(contact_directions(problem)).cast<Complex>();
  const Eigen::MatrixXcd N = Eigen::MatrixXd(condensed.normals).cast<Complex>();
  for (std::size_t h = 0; h < condensed.rates.size(); ++h) {
    const auto column = static_cast<Eigen::Index>(h);
    const double w = condensed.rates[h];
    const CompleteComplexLuFactors whole(
        stiffness(problem.mass(), problem.damping(), problem.stiffness(), w));
    const CompleteComplexLuFactors reduced(
        stiffness(condensed.mass, condensed.damping, condensed.stiffness, w));
    const Eigen::MatrixXcd C = W.transpose() * whole.solve(W);
    const Eigen::VectorXcd relaxing =
        (Complex(1.0) + Complex(0.0, w) * condensed.relaxation.cast<Complex>().array()).inverse().matrix();
    const Eigen::MatrixXcd C_condensed =
        N.transpose() * reduced.solve(N) +
        relaxing.asDiagonal() * Eigen::MatrixXcd(condensed.massless_compliance.cast<Complex>());
    EXPECT_LT((C - C_condensed).norm(), 1e-13 * C.norm()) << "rate " << w;
    const Eigen::VectorXcd x = W.transpose() * whole.solve(load_harmonic(problem, static_cast<int>(h)));
    const Eigen::VectorXcd x_condensed = N.transpose() * reduced.solve(condensed.load.col(column)) +
                                         relaxing.cwiseProduct(condensed.shift.col(column));
    EXPECT_LT((x - x_condensed).norm(), 1e-13 * x.norm()) << "rate " << w;
  }
}

TEST(Condense, KeepsTheReceptanceOfCoupledAndLoadedContacts) {
  const Problem problem = test::coupled_massless_scene(3);
  ASSERT_EQ(condense(problem).kept.size(), 4U);
  ASSERT_EQ(condense(problem).rates.size(), 3U);
  EXPECT_TRUE(condense(problem).relaxation.isZero(0.0));
  expect_same_receptance(problem);
}

// D_ii is of any form: what relaxes is decided by the rows of the massless coordinates.
TEST(Condense, KeepsTheReceptanceOfRelaxingContacts) {
  constexpr double kBeta = 0.07;
  Problem problem = test::coupled_massless_scene(3);
  problem.edit_structure([&](Structure& s) { s.damping += SparseMatrix(kBeta * s.stiffness); });
  EXPECT_NEAR(condense(problem).relaxation[0], kBeta, 1e-15);
  expect_same_receptance(problem);
}

// Faces of two damped stops: each contact relaxes in its own time.
TEST(Condense, KeepsTheReceptanceOfContactsThatRelaxInDifferentTimes) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2, .static_load = 0.3});
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.3});
  damp_stops(problem, {{.contact = 0, .normal = {{0, 1.0}}, .stiffness = 10.0, .damping = 2.0},
                       {.contact = 1, .normal = {{0, -1.0}}, .stiffness = 30.0, .damping = 3.0}});
  EXPECT_NEAR(condense(problem).relaxation[0], 0.2, 1e-15);
  EXPECT_NEAR(condense(problem).relaxation[1], 0.1, 1e-15);
  expect_same_receptance(problem);
}

TEST(Condense, RefusesWhatIsTooLargeToBeFollowedThroughTime) {
  Problem large;
  large.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(kMostInTime + 1, kMostInTime + 1);
    s.mass.setIdentity();
    s.damping = s.stiffness = s.mass;
  });
  EXPECT_EQ(flow_obstacle(large), "10001 coordinates: at most 10000 are followed through time");
  EXPECT_EQ(flow_obstacle(test::massless_bar({.alpha = 0.1}, kMostRelaxing + 1)), "");
  EXPECT_EQ(flow_obstacle(test::massless_bar({.alpha = 0.1, .beta = 0.01}, kMostRelaxing + 1)),
            "1001 coordinates: at most 1000 are followed through time where massless ones are damped");
}

TEST(Condense, SaysWhereItCannotBeDone) {
  Problem damped = test::massless_node();
  damped.edit_structure([&](Structure& s) {
    s.damping = Eigen::MatrixXd((Eigen::Matrix2d() << 0.1, -0.1, -0.1, 0.1).finished()).sparseView();
  });
  EXPECT_NEAR(condense(damped).relaxation[0], 0.1 / 20.0, 1e-17);  // a dashpot along the spring of 20 N/m
  damped.edit_structure([&](Structure& s) {
    s.damping = Eigen::MatrixXd((Eigen::Matrix2d() << 0.1, 0.0, 0.0, 0.1).finished()).sparseView();
  });
  EXPECT_EQ(condense(damped).obstacle,
            "the damping of coordinates without mass is not proportional to their stiffness");
  Problem loose = test::massless_node();
  loose.edit_structure([&](Structure& s) {
    s.stiffness = Eigen::MatrixXd(Eigen::Vector2d(1.0, 0.0).asDiagonal()).sparseView();
  });
  EXPECT_EQ(condense(loose).obstacle, "coordinates without mass have no stiffness of their own");
  Problem tied = test::massless_node();  // the sum of both coordinates carries mass, the difference none
  tied.edit_structure([&](Structure& s) { s.mass = Eigen::MatrixXd(Eigen::Matrix2d::Ones()).sparseView(); });
  EXPECT_EQ(flow_obstacle(tied), "the mass matrix is singular on the coordinates with mass");
  EXPECT_EQ(flow_obstacle(test::massless_node()), "");
  Problem circulatory = test::massless_node();
  circulatory.edit_structure(
      [&](Structure& s) { s.stiffness.coeffRef(0, 1) += 0.5, s.stiffness.coeffRef(1, 0) -= 0.5; });
  EXPECT_EQ(flow_obstacle(circulatory), "a circulatory force acts on coordinates without mass");
}

}  // namespace
}  // namespace signorini::condensation_test
