#include "problems/assembly/beam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/validation.hpp"

namespace signorini::beam_test {
namespace {

Beam steel_beam(int elements, ContactMass contact_mass = ContactMass::consistent) {
  return {.elements = elements,
          .length = 1.5,
          .area = 2e-4,
          .inertia = 1.7e-9,
          .young = 2.1e11,
          .density = 7850.0,
          .contact_mass = contact_mass};
}

// (w_k / w_unit)^(1/2), w_unit = sqrt(E I / (rho A L^4)): the roots of cos(b) cosh(b) = -1 if exact.
double root(const Beam& beam, const Structure& structure, int k) {
  const Eigen::VectorXd squares = generalised_eigen(structure.stiffness, structure.mass).values;
  const double unit = beam.young * beam.inertia / (beam.density * beam.area * std::pow(beam.length, 4));
  return std::pow(squares(k - 1) / unit, 0.25);
}

TEST(AssembleBeam, HasTheTabulatedFrequenciesOfACantilever) {
  const Beam beam = steel_beam(24);
  const Structure structure = assemble(beam);

  EXPECT_NEAR(root(beam, structure, 1), 1.8751, 1e-4);
  EXPECT_NEAR(root(beam, structure, 2), 4.6941, 1e-4);
  EXPECT_NEAR(root(beam, structure, 3), 7.8548, 1e-4);
}

TEST(AssembleBeam, ApproachesTheContinuousBeamAtOrderFourAndTwo) {
  constexpr double kRoots[] = {1.8751040687119611, 4.6940911329741746, 7.8547574382376126};
  for (int k = 1; k <= 3; ++k) {
    const auto error = [&](int elements, ContactMass kind) {
      const Beam beam = steel_beam(elements, kind);
      return std::abs(root(beam, assemble(beam), k) / kRoots[k - 1] - 1.0);
    };
    const int coarse = 4 * k;
    EXPECT_NEAR(
        std::log2(error(coarse, ContactMass::consistent) / error(2 * coarse, ContactMass::consistent)), 4.0,
        0.3)
        << "mode " << k;
    EXPECT_NEAR(std::log2(error(2 * coarse, ContactMass::lumped) / error(4 * coarse, ContactMass::lumped)),
                2.0, 0.3)
        << "mode " << k;
  }
}

TEST(AssembleBeam, BendsExactlyUnderTipLoads) {
  constexpr int kElements = 5;
  const Beam beam = steel_beam(kElements);
  const Eigen::MatrixXd K = assemble(beam).stiffness;
  const double EI = beam.young * beam.inertia;
  const double L = beam.length;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * kElements);
  force(2 * kElements - 2) = 100.0;  // P = 100 N
  Eigen::VectorXd couple = Eigen::VectorXd::Zero(2 * kElements);
  couple(2 * kElements - 1) = 10.0;  // 10 N m

  const Eigen::VectorXd bent = ldlt_solve(K, force);
  const Eigen::VectorXd turned = ldlt_solve(K, couple);

  const double tip = 100.0 * L * L * L / (3.0 * EI);
  for (int node = 1; node <= kElements; ++node) {
    const double x = L * node / kElements;
    EXPECT_NEAR(bent(2 * node - 2), 100.0 * x * x * (3.0 * L - x) / (6.0 * EI), 1e-10 * tip);
    EXPECT_NEAR(bent(2 * node - 1), 100.0 * x * (2.0 * L - x) / (2.0 * EI), 1e-10 * tip);
    EXPECT_NEAR(turned(2 * node - 2), 10.0 * x * x / (2.0 * EI), 1e-10 * tip);
  }
}

TEST(AssembleBeam, KeepsMassAndMomentsWithoutMassAtContacts) {
  constexpr int kElements = 6;
  const std::vector<std::vector<int>> patterns{{10}, {4}, {0}, {8, 10}, {2, 4, 6, 10}, {0, 2, 4, 6, 8, 10}};
  for (const std::vector<int>& contacts : patterns) {
    Beam beam = steel_beam(kElements, ContactMass::massless);
    beam.contacts = contacts;
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(2 * kElements + 2);
    Eigen::VectorXd turn = shift;
    for (int node = 0; node <= kElements; ++node) {
      shift(2 * node) = 1.0;
      turn(2 * node) = beam.length * node / kElements;
      turn(2 * node + 1) = 1.0;
    }
    const double m = beam.density * beam.area * beam.length;

    const SparseMatrix mass = unclamped_mass(beam);
    const Structure structure = assemble(beam);

    EXPECT_NEAR(shift.dot(mass * shift), m, 1e-13 * m);
    EXPECT_NEAR(shift.dot(mass * turn), m * beam.length / 2.0, 1e-13 * m * beam.length);
    EXPECT_NEAR(turn.dot(mass * turn), m * beam.length * beam.length / 3.0,
                1e-13 * m * beam.length * beam.length);
    EXPECT_TRUE(is_semidefinite(structure.mass));
    for (int i = 0; i < 2 * kElements; ++i) {
      const bool touched = std::find(contacts.begin(), contacts.end(), i) != contacts.end();
      const double row = Eigen::VectorXd(structure.mass.row(i).transpose()).cwiseAbs().sum();
      EXPECT_EQ(row == 0.0, touched) << "coordinate " << i;
    }
  }
}

// What a massless contact node does between its neighbours is Hermite's cubic through them.
TEST(AssembleBeam, PutsAMasslessNodeOnTheCubicOfItsNeighbours) {
  Beam beam = steel_beam(2, ContactMass::massless);
  beam.contacts = {0};
  const double h = beam.length / 2.0;
  const Eigen::Vector4d ends(0.3, -0.2, 0.7, 0.4);  // deflection and rotation of nodes 0 and 2
  const double middle = (ends(0) + ends(2)) / 2.0 + h / 4.0 * (ends(1) - ends(3));
  Eigen::VectorXd u(6);
  u << ends(0), ends(1), 99.0, 0.15, ends(2), ends(3);
  Eigen::VectorXd on_cubic = u;
  on_cubic(2) = middle;

  const double found = u.dot(unclamped_mass(beam) * u);
  const double expected = on_cubic.dot(unclamped_mass(steel_beam(2)) * on_cubic);

  EXPECT_NEAR(found, expected, 1e-13 * expected);
}

TEST(AssembleBeam, StandsBesideItsEquals) {
  Beam pair = steel_beam(3, ContactMass::massless);
  pair.count = 2;
  pair.contacts = {4, 6, 8};  // the tip of the first, two nodes of the second
  const Structure both = assemble(pair);

  ASSERT_EQ(both.mass.rows(), 12);
  for (const int b : {0, 1}) {
    Beam single = steel_beam(3, ContactMass::massless);
    single.contacts = b == 0 ? std::vector<int>{4} : std::vector<int>{0, 2};
    const Structure alone = assemble(single);
    EXPECT_EQ(Eigen::MatrixXd(both.mass).block(6 * b, 6 * b, 6, 6), Eigen::MatrixXd(alone.mass));
    EXPECT_EQ(Eigen::MatrixXd(both.stiffness).block(6 * b, 6 * b, 6, 6), Eigen::MatrixXd(alone.stiffness));
  }
  EXPECT_EQ(Eigen::MatrixXd(both.stiffness).topRightCorner(6, 6), Eigen::MatrixXd::Zero(6, 6));
  EXPECT_EQ(Eigen::MatrixXd(both.mass).topRightCorner(6, 6), Eigen::MatrixXd::Zero(6, 6));
}

TEST(AssembleBeam, RefusesMasslessRotations) {
  Beam beam = steel_beam(4, ContactMass::massless);
  beam.contacts = {6, 7};
  EXPECT_THROW(assemble(beam), InvalidProblem);
  beam.contact_mass = ContactMass::lumped;
  EXPECT_NO_THROW(assemble(beam));
}

constexpr double kPi = std::numbers::pi;

// Of unit length and bending stiffness; mass 1.
Shaft shaft(int elements, double bearing_stiffness) {
  return {.beam = {.elements = elements}, .bearing_stiffness = bearing_stiffness};
}

// Rising, [rad/s].
Eigen::VectorXd frequencies(const Structure& structure) {
  return generalised_eigen(structure.stiffness, structure.mass).values.cwiseSqrt();
}

TEST(AssembleShaft, OnStiffBearingsIsTheSimplySupportedBeamInBothPlanesAtOrderFour) {
  for (int k = 1; k <= 2; ++k) {
    const auto error = [&](int elements) {
      const Eigen::VectorXd found = frequencies(assemble(shaft(elements, 1e9)));
      EXPECT_NEAR(found(2 * k - 1), found(2 * k - 2), 1e-6 * found(2 * k - 2)) << "planes are alike";
      return found(2 * k - 2) / (k * k * kPi * kPi) - 1.0;
    };
    EXPECT_NEAR(std::log2(error(2 * k) / error(4 * k)), 4.0, 0.3) << "mode " << k;
  }
}

// Between its ends u'''' = 0 twice: F L^3 / (48 E I) at midspan, and both bearings give way.
TEST(AssembleShaft, SagsUnderItsDiscAsTheBeamDoes) {
  constexpr double kBearing = 300.0;
  const Eigen::MatrixXd K = assemble(shaft(6, kBearing)).stiffness;
  const int disc = 4 * 3;
  for (const int plane : {0, 2}) {
    const Eigen::VectorXd force = Eigen::VectorXd::Unit(K.rows(), disc + plane);
    const Eigen::VectorXd sag = ldlt_solve(K, force);
    EXPECT_NEAR(sag(disc + plane), 1.0 / 48.0 + 1.0 / (2.0 * kBearing), 1e-12);
    EXPECT_NEAR(sag(plane), 1.0 / (2.0 * kBearing), 1e-12);
    EXPECT_EQ(sag(disc + 2 - plane), 0.0) << "the other plane";
  }
}

// With y + i z of each node, forward whirl (cos, sin) is one plane whose disc has omega Omega I_p more
// stiffness against rotation, backward whirl (cos, -sin) one that has as much less.
TEST(AssembleShaft, WhirlsForwardAndBackwardAsOneComplexPlaneDoes) {
  constexpr double kFrequency = 3.0;
  constexpr int kNode = 1;
  Shaft whirling = shaft(3, 50.0);
  whirling.bearing_damping = 0.7;
  whirling.disc_mass = 2.0;
  whirling.disc_node = kNode;
  whirling.disc_inertia = 0.3;
  const Structure resting = assemble(whirling);
  whirling.polar_inertia = 0.5;
  whirling.spin = 8.0;
  const Structure structure = assemble(whirling);
  EXPECT_EQ((Eigen::MatrixXd(structure.mass) - Eigen::MatrixXd(resting.mass)).norm(), 0.0);
  const auto dynamic = [&](const Structure& s) {
    const std::complex<double> i_w(0.0, kFrequency);
    return Eigen::MatrixXcd(Eigen::MatrixXd(s.stiffness).cast<std::complex<double>>() +
                            i_w * Eigen::MatrixXd(s.damping).cast<std::complex<double>>() +
                            i_w * i_w * Eigen::MatrixXd(s.mass).cast<std::complex<double>>());
  };
  const std::vector<int> plane{0, 1, 4, 5, 8, 9, 12, 13};
  for (const double way : {1.0, -1.0}) {
    Eigen::MatrixXcd one = dynamic(resting)(plane, plane);
    one(2 * kNode + 1, 2 * kNode + 1) += way * kFrequency * 8.0 * 0.5;
    const Eigen::VectorXcd expected = lu_solve(one, Eigen::VectorXcd::Unit(8, 2 * kNode));
    Eigen::VectorXcd load = Eigen::VectorXcd::Zero(16);
    load[4 * kNode] = 1.0;
    load[4 * kNode + 2] = std::complex<double>(0.0, -way);
    const Eigen::VectorXcd found = lu_solve(dynamic(structure), load);
    EXPECT_LT((found(plane) - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST(AssembleShaft, BouncesOnSoftBearingsWithItsDisc) {
  Shaft soft = shaft(4, 1e-4);
  soft.disc_mass = 3.0;
  soft.disc_node = 2;
  const Eigen::VectorXd found = frequencies(assemble(soft));
  EXPECT_NEAR(found(0), std::sqrt(2.0 * 1e-4 / 4.0), 1e-5 * found(0));
  EXPECT_NEAR(found(1), found(0), 1e-5 * found(0));
}

TEST(AssembleShaft, IsDampedAtItsBearings) {
  Shaft damped = shaft(3, 1.0);
  damped.bearing_damping = 0.25;
  const Eigen::MatrixXd D = assemble(damped).damping;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(16, 16);
  for (const int dof : {0, 2, 12, 14}) expected(dof, dof) = 0.25;
  EXPECT_EQ(D, expected);
}

// Seen in axes turned about the shaft, nothing changes.
TEST(AssembleShaft, IsTheSameInAllDirections) {
  Shaft any = shaft(3, 50.0);
  any.disc_mass = 2.0;
  any.disc_node = 1;
  const Structure structure = assemble(any);
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(16, 16);
  for (int node = 0; node < 4; ++node) {
    for (int r = 0; r < 2; ++r) {
      const int i = 4 * node + r;
      turn(i, i) = turn(i + 2, i + 2) = c;
      turn(i, i + 2) = s;
      turn(i + 2, i) = -s;
    }
  }
  for (const SparseMatrix* A : {&structure.mass, &structure.stiffness}) {
    const Eigen::MatrixXd dense(*A);
    EXPECT_LT((turn.transpose() * dense * turn - dense).cwiseAbs().maxCoeff(),
              1e-14 * dense.cwiseAbs().maxCoeff());
  }
  EXPECT_DOUBLE_EQ(structure.mass.coeff(4, 4) - assemble(shaft(3, 50.0)).mass.coeff(4, 4), 2.0);
}

}  // namespace
}  // namespace signorini::beam_test
