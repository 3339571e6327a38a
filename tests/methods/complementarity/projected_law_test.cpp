#include "methods/complementarity/projected_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <variant>
#include <vector>

#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"
#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::projected_law_test {
namespace {

TEST(HighestDynamicStiffness, OfOneMassIsItsInertiaAtThreeQuartersOfTheHighestHarmonics) {
  const Problem problem = test::to_problem({.mass = 2.0, .frequency = 3.0, .gap = 0.1});
  const double scale = highest_dynamic_stiffness(fourier_receptance(problem, 40))[0];
  // Mean of 1/(m n^2 w^2) over n from 20 to 40 is close to 1/(m w^2 20 40).
  EXPECT_NEAR(scale / (2.0 * 9.0 * 20 * 40), 1.0, 0.05);
}

TEST(LipschitzLaw, OfASpringStopWeighsTheMultiplierByItsCompliance) {
  Problem problem = test::to_problem({.stiffness = 4.0, .frequency = 3.0, .gap = 0.1});
  problem.set_law(Penalty{{100.0}});
  const ProjectedLaw law = lipschitz_law(problem, 10.0, fourier_receptance(problem, 3));
  EXPECT_DOUBLE_EQ(law.constant[0], 40.0);
  EXPECT_DOUBLE_EQ(law.multiplier_weight[0], 1.0 - 40.0 / 100.0);
}

// With c0 = 4 times the highest dynamic stiffness 1/c = 1/c0 + 1/k_p.
TEST(LipschitzLaw, OfASpringStopHasAConstantInSeriesWithTheSpring) {
  Problem problem = test::to_problem({.stiffness = 4.0, .frequency = 3.0, .gap = 0.1});
  const ContactReceptance receptance = fourier_receptance(problem, 20);
  const double c0 = lipschitz_law(problem, {}, receptance).constant[0];
  EXPECT_DOUBLE_EQ(c0, 4.0 * highest_dynamic_stiffness(receptance)[0]);
  for (const double spring : {1e-6, 1.0, 1e6}) {
    problem.set_law(Penalty{{spring * c0}});
    const ProjectedLaw law = lipschitz_law(problem, {}, receptance);
    EXPECT_NEAR(law.constant[0] * (1.0 / c0 + 1.0 / (spring * c0)), 1.0, 1e-14);
    // In contact -lambda = c (x - g) - alpha lambda is the spring.
    EXPECT_NEAR(law.constant[0] / (1.0 - law.multiplier_weight[0]) / (spring * c0), 1.0, 1e-9);
  }
}

TEST(PenaltyLaw, IsTheScenesSpringOrTheStiffnessAskedFor) {
  Problem problem = test::to_problem({.stiffness = 4.0, .frequency = 3.0, .gap = 0.1});
  const ContactReceptance receptance = fourier_receptance(problem, 3);
  EXPECT_DOUBLE_EQ(penalty_law(problem, {.asked = Scaled{10.0, true}}, receptance).constant[0], 40.0);
  EXPECT_DOUBLE_EQ(penalty_law(problem, {.asked = Scaled{10.0, false}}, receptance).constant[0], 10.0);
  EXPECT_DOUBLE_EQ(penalty_law(problem, {}, receptance).constant[0],
                   8.0 * highest_dynamic_stiffness(receptance)[0]);
  problem.set_law(Penalty{{100.0}});
  const ProjectedLaw law = penalty_law(problem, {.rigid = Scaled{7.0, true}}, receptance);
  EXPECT_DOUBLE_EQ(law.constant[0], 100.0) << "what takes the place of rigid stops does not of springs";
  EXPECT_DOUBLE_EQ(law.multiplier_weight[0], 0.0);
}

TEST(StiffnessFactor, KeepsTheLawOfASpringStop) {
  // c = k_p, alpha = 0 is the spring; with any other constant lambda = -k_p (x - g) in contact still:
  // -lambda = c (x - g) - alpha lambda gives (1 - alpha) lambda = -c (x - g).
  const ProjectedLaw spring{Eigen::VectorXd::Constant(1, 300.0), Eigen::VectorXd::Zero(1)};
  const ProjectedLaw soft = with_stiffness_factor(spring, 0.25);
  EXPECT_DOUBLE_EQ(soft.constant[0], 75.0);
  EXPECT_DOUBLE_EQ(soft.constant[0] / (1.0 - soft.multiplier_weight[0]), 300.0);
  const ProjectedLaw rigid{Eigen::VectorXd::Constant(1, 8.0), Eigen::VectorXd::Ones(1)};
  EXPECT_DOUBLE_EQ(with_stiffness_factor(rigid, 0.5).multiplier_weight[0], 1.0);
}

// In contact the force per penetration is c / (1 - alpha): that of the stop and the spring in series.
TEST(OnSprings, PutsTheSpringInSeriesWithTheStop) {
  const ProjectedLaw law{Eigen::Vector2d(8.0, 75.0),
                         Eigen::Vector2d(1.0, 0.75)};  // rigid, and a spring of 300
  const ProjectedLaw soft = on_springs(law, 2.0);
  EXPECT_NEAR(soft.constant[0] / (1.0 - soft.multiplier_weight[0]), 16.0, 1e-13);
  EXPECT_NEAR(soft.constant[1] / (1.0 - soft.multiplier_weight[1]), 1.0 / (1.0 / 300.0 + 1.0 / 150.0), 1e-12);
}

// A contact has its own law whatever the laws of the others.
TEST(ProjectedLaws, OfMixturesAreThoseOfEachContact) {
  const Problem rigid =
      test::to_problem({.stiffness = 4.0, .frequency = 3.0, .gap = 0.1, .restitution = 0.3});
  const auto with = [&rigid](const std::vector<ContactLaw>& laws) {
    Problem problem = rigid;
    problem.contacts.assign(laws.size(), rigid.contacts.front());
    problem.set_law(common_law(laws));
    return problem;
  };
  const Problem mixed = with({Restitution{0.3}, Spring{70.0}});
  const ContactReceptance both = fourier_receptance(mixed, 3);
  const auto expect_each = [&](const auto& law_of) {
    const ProjectedLaw law = law_of(mixed, both);
    const ProjectedLaw first = law_of(with({Restitution{0.3}, Restitution{0.3}}), both);
    const ProjectedLaw second = law_of(with({Spring{70.0}, Spring{70.0}}), both);
    EXPECT_EQ(law.constant, Eigen::Vector2d(first.constant[0], second.constant[1]));
    EXPECT_EQ(law.multiplier_weight,
              Eigen::Vector2d(first.multiplier_weight[0], second.multiplier_weight[1]));
  };
  expect_each([](const Problem& p, const ContactReceptance& r) { return lipschitz_law(p, {}, r); });
  expect_each([](const Problem& p, const ContactReceptance& r) {
    return penalty_law(p, {.rigid = Scaled{100.0, true}}, r);
  });
  expect_each([](const Problem& p, const ContactReceptance& r) { return augmented_law(p, {}, r); });
  const MixedLaws represented = std::get<MixedLaws>(projected_method_law(mixed));
  EXPECT_EQ(represented.laws, (std::vector<ContactLaw>{Restitution{1.0}, Spring{70.0}}));
  EXPECT_EQ(std::get<MixedLaws>(projected_method_law(mixed, Scaled{7.0, false})).laws[1],
            ContactLaw(Spring{7.0}));
  EXPECT_EQ(std::get<Restitution>(projected_method_law(with({Restitution{0.3}, Restitution{0.8}}))).e, 1.0);
}

TEST(ProjectedMethodLaw, IsConservativeWhereTheStopIsRigid) {
  Problem problem = test::to_problem({.frequency = 3.0, .gap = 0.1, .restitution = 0.3});
  EXPECT_EQ(std::get<Restitution>(projected_method_law(problem)).e, 1.0);
  problem.set_law(Penalty{{100.0}});
  EXPECT_EQ(std::get<Penalty>(projected_method_law(problem)).stiffness.front(), 100.0);
  EXPECT_EQ(std::get<Penalty>(projected_method_law(problem, Scaled{7.0, false})).stiffness.front(), 7.0);
}

using Complex = std::complex<double>;

/// Two masses of stiffness 1 and 2 coupled by 0.5, damping ratio about 0.05, driven at 1.3.
ContactReceptance two_masses(int harmonics) {
  ContactReceptance receptance;
  receptance.period = 1.0;
  for (int n = 0; n <= harmonics; ++n) {
    const double w = 1.3 * n;
    Eigen::Matrix2cd Z;
    Z << Complex(1.5 - w * w, 0.1 * w), -0.5, -0.5, Complex(2.5 - w * w, 0.1 * w);
    receptance.receptance.emplace_back(Z.inverse());
  }
  receptance.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, 2);
  return receptance;
}

ContactSymbol rigid_symbol(int harmonics) {
  const double constant = 4.0 * std::pow(1.3 * harmonics, 2);
  return {two_masses(harmonics), {Eigen::Vector2d(constant, 2.0 * constant), Eigen::Vector2d::Ones()}};
}

/// v + P chi B v with contact c closed on [begin[c], begin[c] + length[c]] of the period.
Eigen::VectorXd jacobian_product(const ContactSymbol& symbol, const Eigen::Vector2d& begin,
                                 const Eigen::Vector2d& length, const Eigen::VectorXd& v) {
  Eigen::MatrixXcd rate = symbol.rate(v);
  for (int c = 0; c < 2; ++c) {
    const ContactIndicator chi({{begin[c], begin[c] + length[c]}}, symbol.harmonics());
    rate.col(c) = chi.restrict(rate.col(c));
  }
  return v + pack_harmonics(rate);
}

Eigen::VectorXd some_vector(int size) {
  Eigen::VectorXd v(size);
  for (int i = 0; i < size; ++i) v[i] = std::sin(1.0 + i * i);
  return v;
}

TEST(ContactSymbol, MultipliesHarmonicByHarmonicInUnitsOfTheConstant) {
  const ContactReceptance receptance = two_masses(3);
  const ProjectedLaw law{Eigen::Vector2d(4.0, 9.0), Eigen::Vector2d(1.0, 0.25)};
  const ContactSymbol symbol(receptance, law);
  Eigen::MatrixXcd spectrum = Eigen::MatrixXcd::Zero(4, 2);
  spectrum(2, 1) = Complex(0.3, -0.7);
  const Eigen::MatrixXcd rate = symbol.rate(pack_harmonics(spectrum));
  const Eigen::MatrixXcd& C = receptance.receptance[2];
  EXPECT_LE(std::abs(rate(2, 0) - 2.0 * C(0, 1) * 3.0 * spectrum(2, 1)), 1e-15);
  EXPECT_LE(std::abs(rate(2, 1) - (9.0 * C(1, 1) - 0.25) * spectrum(2, 1)), 1e-14);
  EXPECT_EQ(rate.row(0).norm() + rate.row(1).norm() + rate.row(3).norm(), 0.0);
}

TEST(LastingContactInverse, InvertsTheJacobianOfPermanentContact) {
  const ContactSymbol symbol = rigid_symbol(12);
  const Eigen::VectorXd v = some_vector(symbol.unknowns());
  for (const Eigen::Vector2d& closed :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(1.0, 1.0)}) {
    const LastingContactInverse inverse(symbol, closed);
    const Eigen::VectorXd back = inverse * jacobian_product(symbol, Eigen::Vector2d::Zero(), closed, v);
    EXPECT_LE((back - v).norm(), 1e-12 * v.norm()) << closed.transpose();
  }
}

/// Products that GMRES takes to 1e-12 where contact c is closed for length[c] of the period.
int products_needed(int harmonics, const Eigen::Vector2d& length) {
  const ContactSymbol symbol = rigid_symbol(harmonics);
  const Eigen::Vector2d begin(0.1, 0.4);
  const LastingContactInverse inverse(symbol, length);
  int products = 0;
  const auto product = [&](const Eigen::VectorXd& v) {
    ++products;
    return jacobian_product(symbol, begin, length, v);
  };
  const Eigen::VectorXd b = jacobian_product(symbol, begin, length, some_vector(symbol.unknowns()));
  const Eigen::VectorXd x = solve_by_gmres(
                                product, [&](const Eigen::VectorXd& v) { return inverse * v; }, b, 1e-12)
                                .x;
  EXPECT_EQ(x.size(), b.size());
  return products;
}

TEST(LastingContactInverse, LeavesGmresAsManyStepsForImpactsAtAnyNumberOfHarmonics) {
  // After projection an impact is closed for about 1 / H of the period.
  for (const int harmonics : {20, 80, 320}) {
    EXPECT_LE(products_needed(harmonics, Eigen::Vector2d(0.8, 0.6) / harmonics), 15) << harmonics;
  }
}

TEST(LastingContactInverse, LeavesGmresFarFewerStepsThanUnknownsWhereContactLasts) {
  for (const int harmonics : {80, 320}) {
    EXPECT_LE(products_needed(harmonics, {0.9, 0.8 / harmonics}), 2 * (2 * harmonics + 1) / 8) << harmonics;
  }
}

}  // namespace
}  // namespace signorini::projected_law_test
