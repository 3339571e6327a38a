#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/assembly/beam.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/validation.hpp"

namespace signorini::bar_test {
namespace {

constexpr double kPi = std::numbers::pi;

Bar steel_bar(int elements, ContactMass contact_mass = ContactMass::consistent) {
  return {.elements = elements,
          .length = 2.0,
          .area = 3e-4,
          .young = 2.1e11,
          .density = 7850.0,
          .contact_mass = contact_mass};
}

double wave_speed(const Bar& bar) { return std::sqrt(bar.young / bar.density); }

// Rising, [rad/s].
Eigen::VectorXd frequencies(const Structure& structure) {
  return generalised_eigen(structure.stiffness, structure.mass).values.cwiseSqrt();
}

// w_k of the continuous clamped-free bar, k from 1.
double exact_frequency(const Bar& bar, int k) {
  return (2 * k - 1) * kPi / 2.0 * wave_speed(bar) / bar.length;
}

TEST(AssembleBar, OfOneElementIsWrittenByHand) {
  const Bar bar = steel_bar(1);
  const Structure structure = assemble(bar);

  EXPECT_DOUBLE_EQ(structure.stiffness.coeff(0, 0), 2.1e11 * 3e-4 / 2.0);
  EXPECT_DOUBLE_EQ(structure.mass.coeff(0, 0), 7850.0 * 3e-4 * 2.0 / 3.0);
  EXPECT_EQ(structure.damping.nonZeros(), 0);
  EXPECT_DOUBLE_EQ(assemble(steel_bar(1, ContactMass::lumped)).mass.coeff(0, 0), 7850.0 * 3e-4 * 2.0 / 2.0);
}

// Both mass matrices of a uniform mesh have the modes sin(b i), b = (2 k - 1) pi / (2 n).
TEST(AssembleBar, HasTheFrequenciesOfItsDifferenceEquation) {
  constexpr int kElements = 12;
  for (const ContactMass kind : {ContactMass::consistent, ContactMass::lumped}) {
    const Bar bar = steel_bar(kElements, kind);
    const Eigen::VectorXd found = frequencies(assemble(bar));
    const double scale = wave_speed(bar) * kElements / bar.length;
    for (int k = 1; k <= kElements; ++k) {
      const double c = std::cos((2 * k - 1) * kPi / (2.0 * kElements));
      const double square = kind == ContactMass::lumped ? 2.0 * (1.0 - c) : 6.0 * (1.0 - c) / (2.0 + c);
      EXPECT_NEAR(found(k - 1), scale * std::sqrt(square), 1e-11 * found(kElements - 1)) << "mode " << k;
    }
  }
}

// w_k over that of the continuous bar, less 1. A massless tip hangs on one spring and moves along: it is
// dropped.
double frequency_error(int elements, ContactMass kind, int k) {
  Bar bar = steel_bar(elements, kind);
  bar.contacts = {elements - 1};
  Structure structure = assemble(bar);
  if (kind == ContactMass::massless) {
    const int left = elements - 1;
    const double spring = bar.young * bar.area * elements / bar.length;
    structure.mass = SparseMatrix(structure.mass.topLeftCorner(left, left));
    structure.stiffness = SparseMatrix(structure.stiffness.topLeftCorner(left, left));
    structure.stiffness.coeffRef(left - 1, left - 1) -= spring;
  }
  return frequencies(structure)(k - 1) / exact_frequency(bar, k) - 1.0;
}

TEST(AssembleBar, ApproachesTheContinuousBarAtOrderTwo) {
  for (const ContactMass kind : {ContactMass::consistent, ContactMass::lumped}) {
    for (int k = 1; k <= 3; ++k) {
      const double coarse = frequency_error(40, kind, k);
      const double fine = frequency_error(80, kind, k);
      EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05) << "mode " << k;
      EXPECT_LT(std::abs(fine), 2e-3) << "mode " << k;
    }
  }
}

TEST(AssembleBar, ChangesFrequenciesAtOrderThreeOnlyByAMasslessTip) {
  for (int k = 1; k <= 3; ++k) {
    const auto change = [&](int elements) {
      return frequency_error(elements, ContactMass::massless, k) -
             frequency_error(elements, ContactMass::consistent, k);
    };
    EXPECT_NEAR(std::log2(change(40) / change(80)), 3.0, 0.15) << "mode " << k;
    EXPECT_LT(std::abs(change(80)), 1e-3) << "mode " << k;
  }
}

TEST(AssembleBar, StretchesAsHookeSaysAtEveryNode) {
  constexpr int kElements = 7;
  const Bar bar = steel_bar(kElements);
  const Structure structure = assemble(bar);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(kElements);
  load(kElements - 1) = 500.0;

  const Eigen::VectorXd u = ldlt_solve(structure.stiffness, load);

  const double tip = 500.0 * bar.length / (bar.young * bar.area);
  for (int i = 0; i < kElements; ++i) EXPECT_NEAR(u(i), tip * (i + 1) / kElements, 1e-12 * tip);
}

// Total mass, first and second moments about x = 0 of a mass matrix over all nodes.
Eigen::Vector3d moments(const SparseMatrix& mass, const Eigen::VectorXd& x) {
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(x.size());
  return {one.dot(mass * one), one.dot(mass * x), x.dot(mass * x)};
}

TEST(AssembleBar, KeepsMassAndMomentsWithoutMassAtContacts) {
  constexpr int kElements = 9;
  const std::vector<std::vector<int>> patterns{{8}, {3}, {0}, {7, 8}, {2, 3, 4, 8}, {0, 1, 2, 3, 4, 5, 6, 7}};
  for (const std::vector<int>& contacts : patterns) {
    Bar bar = steel_bar(kElements, ContactMass::massless);
    bar.contacts = contacts;
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(kElements + 1, 0.0, bar.length);
    const double m = bar.density * bar.area * bar.length;
    const Eigen::Vector3d exact(m, m * bar.length / 2.0, m * bar.length * bar.length / 3.0);

    const Eigen::Vector3d kept = moments(unclamped_mass(bar), x);
    const Structure structure = assemble(bar);

    EXPECT_LT((kept - exact).cwiseAbs().maxCoeff(), 1e-13 * exact.maxCoeff());
    EXPECT_TRUE(is_semidefinite(structure.mass));
    for (int i = 0; i < kElements; ++i) {
      const bool touched = std::find(contacts.begin(), contacts.end(), i) != contacts.end();
      const double row = Eigen::VectorXd(structure.mass.row(i).transpose()).cwiseAbs().sum();
      EXPECT_EQ(row == 0.0, touched) << "coordinate " << i;
    }
    EXPECT_EQ(PivotedQr(structure.mass).rank(), kElements - static_cast<int>(contacts.size()))
        << "no other mass is lost";
  }
}

TEST(AssembleBar, WithoutContactsIsConsistent) {
  const Structure consistent = assemble(steel_bar(5));
  const Structure massless = assemble(steel_bar(5, ContactMass::massless));
  EXPECT_EQ(Eigen::MatrixXd(consistent.mass), Eigen::MatrixXd(massless.mass));
}

TEST(AssembleBar, RefusesToLoseAllItsMass) {
  Bar bar = steel_bar(3, ContactMass::massless);
  bar.contacts = {0, 1, 2};
  EXPECT_THROW(assemble(bar), InvalidProblem);
  bar.contacts = {0, 2};
  EXPECT_NO_THROW(assemble(bar));
}

TEST(AssembleBar, StaysSparseForManyElements) {
  Bar bar = steel_bar(100000, ContactMass::massless);
  bar.contacts = {99999};
  const Structure structure = assemble(bar);
  EXPECT_LE(structure.mass.nonZeros(), 3 * 100000);
  EXPECT_EQ(structure.stiffness.nonZeros(), 3 * 100000 - 2);
}

}  // namespace
}  // namespace signorini::bar_test
