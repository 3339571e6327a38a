#include "problems/assembly/chain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <random>

#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini::chain_test {
namespace {

TEST(AssembleChain, OfOneMassIsTheOscillator) {
  const Structure oscillator = assemble(Chain{.masses = {2.0}, .dampers = {0.3}, .springs = {5.0}});

  EXPECT_EQ(oscillator.mass.coeff(0, 0), 2.0);
  EXPECT_EQ(oscillator.damping.coeff(0, 0), 0.3);
  EXPECT_EQ(oscillator.stiffness.coeff(0, 0), 5.0);
  EXPECT_EQ(oscillator.mass.rows(), 1);
}

TEST(AssembleChain, MatchesMatricesWrittenByHand) {
  const Structure chain =
      assemble(Chain{.masses = {1.0, 2.0, 3.0}, .dampers = {0.1, 0.2, 0.4}, .springs = {10.0, 20.0, 40.0}});

  Eigen::Matrix3d M;
  M << 1, 0, 0, 0, 2, 0, 0, 0, 3;
  Eigen::Matrix3d D;
  D << 0.3, -0.2, 0, -0.2, 0.6, -0.4, 0, -0.4, 0.4;
  Eigen::Matrix3d K;
  K << 30, -20, 0, -20, 60, -40, 0, -40, 40;
  EXPECT_EQ(Eigen::Matrix3d(chain.mass), M);
  EXPECT_LE((Eigen::Matrix3d(chain.damping) - D).cwiseAbs().maxCoeff(), 1e-15 * D.cwiseAbs().maxCoeff());
  EXPECT_EQ(Eigen::Matrix3d(chain.stiffness), K);
}

TEST(AssembleChain, StoresTheEnergyOfItsSprings) {
  std::mt19937 random(20240611);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  constexpr int kSize = 7;
  Chain chain;
  Eigen::VectorXd u(kSize);
  for (int i = 0; i < kSize; ++i) {
    chain.masses.push_back(1.0);
    chain.dampers.push_back(1.0 + uniform(random));
    chain.springs.push_back(1.0 + uniform(random));
    u(i) = uniform(random);
  }

  const Structure structure = assemble(chain);

  double springs = 0.0;
  double dampers = 0.0;
  for (int i = 0; i < kSize; ++i) {
    const double stretch = u(i) - (i == 0 ? 0.0 : u(i - 1));
    springs += chain.springs[static_cast<std::size_t>(i)] * stretch * stretch;
    dampers += chain.dampers[static_cast<std::size_t>(i)] * stretch * stretch;
  }
  EXPECT_NEAR(u.dot(structure.stiffness * u), springs, 1e-13 * springs);
  EXPECT_NEAR(u.dot(structure.damping * u), dampers, 1e-13 * dampers);
}

TEST(AssembleChain, HoldsMassesToTheGroundAndToEachOther) {
  const Structure net = assemble(Chain{.masses = {1.0, 1.0, 1.0},
                                       .dampers = {0.0, 0.0, 0.0},
                                       .springs = {0.0, 10.0, 0.0},
                                       .ground_dampers = {0.1, 0.0, 0.4},
                                       .ground_springs = {1.0, 2.0, 4.0},
                                       .links = {{.first = 2, .second = 0, .spring = 5.0, .damper = 0.2},
                                                 {.first = 0, .second = 1, .spring = 7.0, .damper = 0.0}}});
  Eigen::Matrix3d K;
  K << 23, -17, -5, -17, 19, 0, -5, 0, 9;
  Eigen::Matrix3d D;
  D << 0.3, 0, -0.2, 0, 0, 0, -0.2, 0, 0.6;
  EXPECT_EQ(Eigen::Matrix3d(net.stiffness), K);
  EXPECT_LE((Eigen::Matrix3d(net.damping) - D).cwiseAbs().maxCoeff(), 1e-15);
}

// w_k = 2 sqrt(k / m) sin(pi k / n): the ring has no beginning.
TEST(AssembleChain, ClosedToARingHasTheFrequenciesOfTheRing) {
  constexpr int kSize = 7;
  std::vector<double> springs(kSize, 3.0);
  springs[0] = 0.0;
  const Structure ring = assemble(Chain{.masses = std::vector<double>(kSize, 2.0),
                                        .dampers = std::vector<double>(kSize, 0.0),
                                        .springs = springs,
                                        .links = {{.first = kSize - 1, .second = 0, .spring = 3.0}}});
  const Eigen::VectorXd squares = symmetric_eigenvalues(Eigen::MatrixXd(ring.stiffness) / 2.0);
  for (int i = 0; i < kSize; ++i) {
    const int waves = (i + 1) / 2;  // each but the first and the last in two phases
    const double sine = std::sin(std::numbers::pi * waves / kSize);
    EXPECT_NEAR(squares(i), 4.0 * 1.5 * sine * sine, 1e-14 * 6.0);
  }
}

// Masses may be named in any order if links alone join them.
TEST(AssembleChain, OfLinksDoesNotDependOnTheOrderOfMasses) {
  const auto star = [](const std::vector<int>& place) {
    Chain chain{.masses = std::vector<double>(4),
                .dampers = std::vector<double>(4, 0.0),
                .springs = std::vector<double>(4, 0.0),
                .ground_springs = std::vector<double>(4)};
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(place[static_cast<std::size_t>(i)]);
      chain.masses[at] = 1.0 + i;
      chain.ground_springs[at] = 0.5 * i;
      if (i > 0)
        chain.links.push_back({.first = place[0], .second = static_cast<int>(at), .spring = 2.0 * i});
    }
    return assemble(chain);
  };
  const std::vector<int> order{2, 0, 3, 1};
  const Structure straight = star({0, 1, 2, 3});
  const Structure mixed = star(order);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const int a = order[static_cast<std::size_t>(i)];
      const int b = order[static_cast<std::size_t>(j)];
      EXPECT_EQ(mixed.stiffness.coeff(a, b), straight.stiffness.coeff(i, j));
      EXPECT_EQ(mixed.mass.coeff(a, b), straight.mass.coeff(i, j));
    }
  }
}

TEST(AssembleChain, StaysTridiagonalForManyMasses) {
  constexpr int kSize = 100000;
  const std::vector<double> ones(kSize, 1.0);

  const Structure structure = assemble(Chain{.masses = ones, .dampers = ones, .springs = ones});

  EXPECT_EQ(structure.stiffness.nonZeros(), 3 * kSize - 2);
  EXPECT_EQ(structure.stiffness.coeff(kSize - 1, kSize - 1), 1.0) << "the last mass is free";
  EXPECT_EQ(structure.stiffness.coeff(kSize - 2, kSize - 2), 2.0);
}

TEST(AssembleChain, RefusesListsOfDifferentLengths) {
  EXPECT_THROW(assemble(Chain{.masses = {1.0, 1.0}, .dampers = {0.1}, .springs = {1.0, 1.0}}),
               std::invalid_argument);
  EXPECT_THROW(assemble(Chain{.masses = {1.0}, .dampers = {0.1}, .springs = {}}), std::invalid_argument);
  EXPECT_THROW(
      assemble(Chain{.masses = {1.0}, .dampers = {0.1}, .springs = {1.0}, .ground_springs = {1.0, 1.0}}),
      std::invalid_argument);
}

}  // namespace
}  // namespace signorini::chain_test
