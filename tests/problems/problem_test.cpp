#include "problems/problem.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "problems/linear_algebra/lu.hpp"
#include "tests/problems/chain_problems.hpp"

namespace signorini::problem_test {
namespace {

using test::chain_problem;
using test::massless_tip;
using test::three_masses;

SparseMatrix sparse(const Eigen::MatrixXd& A) { return A.sparseView(); }

Eigen::MatrixXd random_matrix(int rows, int columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

TEST(Problem, PeriodFollowsTheSubharmonic) {
  Problem problem = three_masses();
  problem.frequency = 4.0;
  problem.subharmonic = 3;

  EXPECT_DOUBLE_EQ(problem.period(), 3.0 * std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(problem.base_frequency(), 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(problem.forcing_period(), std::numbers::pi / 2.0);
}

TEST(WholePeriods, AreCountedToAMillionthOfAPeriod) {
  EXPECT_EQ(whole_periods(2.0, 2.0), 1);
  EXPECT_EQ(whole_periods(6.000003, 2.0), 3);
  EXPECT_EQ(whole_periods(6.00001, 2.0), 0);
  EXPECT_EQ(whole_periods(1.0, 2.0), 0);
  EXPECT_EQ(whole_periods(-2.0, 2.0), 0);
  EXPECT_EQ(whole_periods(3e6, 2.0), 0);  // 1.5 million, and so would be a quarter more
  EXPECT_EQ(whole_periods(std::numeric_limits<double>::infinity(), 2.0), 0);
  EXPECT_EQ(whole_periods(std::numeric_limits<double>::quiet_NaN(), 2.0), 0);
}

TEST(Problem, CopiesShareTheirStructureUntilOneIsEdited) {
  const Problem problem = three_masses();
  Problem other = with_subharmonic(problem, 5);
  EXPECT_EQ(other.subharmonic, 5);
  EXPECT_EQ(problem.subharmonic, 1);
  EXPECT_EQ(&other.stiffness(), &problem.stiffness()) << "no matrix is copied";

  other.edit_structure([](Structure& s) { s.stiffness.coeffRef(0, 0) = 7.0; });
  EXPECT_EQ(other.stiffness().coeff(0, 0), 7.0);
  EXPECT_EQ(problem.stiffness().coeff(0, 0), 30.0);
  EXPECT_EQ(Eigen::MatrixXd(other.mass()), Eigen::MatrixXd(problem.mass()));
}

TEST(Problem, DirectionsAndGapsAreThoseOfTheContacts) {
  Problem problem = three_masses();
  problem.contacts = {{.normal = {{2, 0.8}, {0, -0.6}}, .gap = -0.1}, {.normal = {{1, -1.0}}, .gap = 0.3}};

  Eigen::MatrixXd W(3, 2);
  W << -0.6, 0, 0, -1, 0.8, 0;
  EXPECT_EQ(Eigen::MatrixXd(contact_directions(problem)), W);
  EXPECT_EQ(contact_gaps(problem), Eigen::Vector2d(-0.1, 0.3));
}

TEST(Problem, LoadIsTheSumOfItsHarmonics) {
  Problem problem = three_masses();
  problem.force = {{.dof = 0, .harmonic = 0, .cos = 0.7},
                   {.dof = 2, .harmonic = 1, .cos = 1.0, .sin = -2.0},
                   {.dof = 2, .harmonic = 1, .cos = 0.5},
                   {.dof = 1, .harmonic = 3, .sin = 4.0},
                   {.dof = 1, .harmonic = 9}};
  EXPECT_EQ(highest_load_harmonic(problem), 3) << "a term of size 0 is no load";
  EXPECT_EQ(load_bandwidth(with_subharmonic(problem, 4)), 12);

  for (const double time : {0.0, 0.3, 1.7}) {
    const double a = problem.frequency * time;
    const Eigen::Vector3d by_hand(0.7, 4.0 * std::sin(3 * a), 1.5 * std::cos(a) - 2.0 * std::sin(a));
    EXPECT_LE((load_at(problem, time) - by_hand).norm(), 1e-14 * 4.0);

    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(3);
    for (int h = 0; h <= 3; ++h) sum += load_harmonic(problem, h) * std::polar(1.0, h * a);
    EXPECT_LE((sum.real() - by_hand).norm(), 1e-14 * 4.0);
  }
}

TEST(Problem, ConstantOrAbsentLoadHasHighestHarmonicZero) {
  Problem problem = three_masses();
  problem.force = {{.dof = 0, .harmonic = 0, .cos = 0.7}};
  EXPECT_EQ(highest_load_harmonic(problem), 0);
  problem.force.clear();
  EXPECT_EQ(highest_load_harmonic(problem), 0);
  EXPECT_EQ(load_at(problem, 1.0), Eigen::VectorXd::Zero(3));
}

TEST(ContactDirections, OfAnyListOfContactsAreItsNormals) {
  const SparseMatrix W = contact_directions({{.normal = {{1, -1.0}}, .gap = 0.3}}, 4);
  EXPECT_EQ(Eigen::MatrixXd(W), -Eigen::MatrixXd(Eigen::Vector4d::Unit(1)));
  EXPECT_EQ(contact_directions({}, 4).cols(), 0);
}

TEST(DelassusMatrix, MatchesTheDenseInverse) {
  std::mt19937 random(7);
  for (int size : {1, 4, 9}) {
    const Eigen::MatrixXd B = random_matrix(size, size, random);
    const Eigen::MatrixXd M = B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size);
    Problem problem;
    problem.edit_structure([&](Structure& s) {
      s.mass = sparse(M);
      s.damping = s.stiffness = SparseMatrix(size, size);
    });
    Eigen::MatrixXd W = random_matrix(size, 3, random);
    for (int j = 0; j < 3; ++j) {
      problem.contacts.emplace_back();
      for (int i = 0; i < size; ++i) problem.contacts.back().normal.emplace_back(i, W(i, j));
    }

    const Eigen::MatrixXd expected = W.transpose() * LuFactors(M).inverse() * W;
    EXPECT_LE((delassus_matrix(problem) - expected).norm(), 1e-12 * expected.norm()) << "size " << size;
  }
}

TEST(DelassusMatrix, RefusesASingularMass) {
  EXPECT_THROW(delassus_matrix(massless_tip()), std::invalid_argument);
}

TEST(DelassusMatrix, IsEmptyWithoutContacts) {
  Problem problem = three_masses();
  problem.contacts.clear();
  EXPECT_EQ(delassus_matrix(problem).size(), 0);
}

TEST(ContactStiffnessScale, IsTheStiffnessOfTheCoordinate) {
  Problem problem = three_masses();
  problem.contacts.push_back({.normal = {{0, -2.0}}, .gap = 0.1});

  // 40 at the free end; at mass 0: K = 30, w = -2, so 30 * 4 / 16.
  EXPECT_EQ(contact_stiffness_scale(problem), Eigen::Vector2d(40.0, 7.5));
}

TEST(ContactStiffnessScale, FallsBackOnInertiaThenOnDamping) {
  Problem free_mass = chain_problem({.masses = {3.0}, .dampers = {0.5}, .springs = {0.0}});
  free_mass.contacts = {{.normal = {{0, 1.0}}, .gap = 0.0}};
  EXPECT_DOUBLE_EQ(contact_stiffness_scale(free_mass)(0), 2.0 * 2.0 * 3.0);

  Problem damper_tip = chain_problem({.masses = {1.0, 0.0}, .dampers = {0.0, 0.5}, .springs = {1.0, 0.0}});
  damper_tip.contacts = {{.normal = {{1, 1.0}}, .gap = 0.0}};
  EXPECT_DOUBLE_EQ(contact_stiffness_scale(damper_tip)(0), 2.0 * 0.5);
}

TEST(ContactsWithMass, MeetACoordinateThatHasSome) {
  EXPECT_EQ(contacts_with_mass(massless_tip()), std::vector<bool>{false});
  Problem both = massless_tip();
  both.contacts.push_back({.normal = {{0, 1.0}}, .gap = 0.1});
  EXPECT_EQ(contacts_with_mass(both), (std::vector<bool>{false, true}));
}

TEST(Contacts, HangTogetherByTheCoordinatesTheyShare) {
  // 0 and 3 by coordinate 7, 1 and 4 by way of 2, whose coefficient of 7 is none.
  const std::vector<Contact> contacts{{.normal = {{7, 1.0}}},
                                      {.normal = {{1, 1.0}}},
                                      {.normal = {{7, 0.0}, {4, 1.0}, {1, -1.0}}},
                                      {.normal = {{9, 1.0}, {7, -1.0}}},
                                      {.normal = {{4, 2.0}}},
                                      {.normal = {{5, 1.0}}}};
  EXPECT_EQ(contact_groups(contacts), (std::vector<std::vector<int>>{{0, 3}, {1, 2, 4}, {5}}));
  EXPECT_EQ(contact_coordinates(contacts), (std::vector<int>{1, 4, 5, 7, 9}));
  EXPECT_TRUE(contact_groups({}).empty());
}

}  // namespace
}  // namespace signorini::problem_test
