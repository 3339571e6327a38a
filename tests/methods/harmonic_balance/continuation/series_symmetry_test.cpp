// Pitchforks of symmetric motions between two stops: a block of the Jacobian that holds nothing else.

#include "methods/harmonic_balance/continuation/series_symmetry.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "methods/continuation/arc_length.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/structure/periodic_response.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::series_symmetry_test {
namespace {

constexpr double kFrom = 0.8, kTo = 2.0;

Problem two_stops() {
  Problem problem = load_scene(find_scene("sdof-two-sided"));
  problem.frequency = kFrom;
  return problem;
}

SeriesFamily lipschitz_family(const Problem& problem, int harmonics) {
  SeriesFamily family{curve_family(problem, kFrom, kTo)};
  family.harmonics = harmonics;
  family.samples = 16 * harmonics;
  family.law_at = [problem](const ContactReceptance& receptance) {
    return lipschitz_law(problem, {}, receptance);
  };
  family.opposite = opposite_contacts(problem);
  return family;
}

// A motion of the method at the lower end of the interval, on the curve.
bool lead_to_answer(SeriesCurve& curve, const Problem& problem) {
  FourierLipschitz::Options options;
  options.common.harmonics = curve.harmonics();
  const Solution solution = FourierLipschitz(options).prepare(problem)->solve({});
  if (!solution.trajectory) return false;
  const Eigen::VectorXd x =
      curve.unknowns(force_spectrum(*solution.trajectory, curve.harmonics()), problem.frequency);
  return correct_at_parameter(curve, x).has_value();
}

TEST(OppositeContacts, AreThoseOfStopsAtEqualDistanceUnderOddLoads) {
  const Problem problem = two_stops();
  EXPECT_EQ(opposite_contacts(problem), (std::vector<Eigen::Index>{1, 0}));
  Problem uneven = problem;
  uneven.contacts[1].gap *= 1.0 + 1e-6;
  EXPECT_TRUE(opposite_contacts(uneven).empty());
  Problem even = problem;
  even.force.push_back({.dof = 0, .harmonic = 2, .cos = 1e-3, .sin = 0.0});
  EXPECT_TRUE(opposite_contacts(even).empty());
  Problem third = problem;
  third.force.push_back({.dof = 0, .harmonic = 3, .cos = 0.1, .sin = 0.2});
  EXPECT_FALSE(opposite_contacts(third).empty());
  Problem one_side = problem;
  one_side.contacts[1].normal = one_side.contacts[0].normal;
  EXPECT_TRUE(opposite_contacts(one_side).empty());
  EXPECT_TRUE(opposite_contacts(with_subharmonic(problem, 2)).empty());
}

// R(S x) = S R(x) at any x, and det R_x of the force is that of its two blocks where S x = x.
TEST(AntisymmetricBlock, IsABlockOfTheJacobian) {
  const Problem problem = two_stops();
  const SeriesFamily family = lipschitz_family(problem, 8);
  SeriesCurve curve(family, 1);
  Eigen::VectorXd x = 0.1 * Eigen::VectorXd::Random(curve.size() + 1);
  x[curve.size()] = 1.1 / family.frequency_unit;
  ASSERT_TRUE(curve.evaluate(x));
  Eigen::VectorXd expected(curve.size() + 1);
  expected << curve.residual(), 0.0;
  expected = mirrored(curve, expected);
  ASSERT_TRUE(curve.evaluate(mirrored(curve, x)));
  EXPECT_LT((curve.residual() - expected.head(curve.size())).norm(), 1e-11 * expected.norm());

  ASSERT_TRUE(lead_to_answer(curve, problem));
  ASSERT_TRUE(is_symmetric(curve, curve.x()));
  const Eigen::MatrixXd J = curve.jacobian().leftCols(curve.size()), block = antisymmetric_block(curve);
  ASSERT_EQ(2 * block.rows(), curve.size());
  // An antisymmetric change of a symmetric motion stays one, and is what the block says.
  const SeriesStart start = pitchfork_branches(curve, Eigen::VectorXd::Unit(x.size(), x.size() - 1)).front();
  EXPECT_LT((mirrored(curve, start.tangent) + start.tangent).norm(), 1e-13);
  EXPECT_NEAR(start.tangent.norm(), 1.0, 1e-13);
  const double least = Eigen::JacobiSVD<Eigen::MatrixXd>(block).singularValues().tail(1)[0];
  EXPECT_NEAR((J * start.tangent.head(curve.size())).norm(), least, 1e-10);
  EXPECT_NEAR(std::abs(pitchfork_test(curve)), least, 1e-12);
}

// The exact orbits have this branch point at 1.0049574578 rad/s; truncation leaves O(1/H).
TEST(Pitchforks, OfTwoStopsAreMetAtEveryResolution) {
  constexpr double kExact = 1.0049574578;
  double before = 0.0;
  for (const int harmonics : {10, 20, 30, 40, 60}) {
    const Problem problem = two_stops();
    FourierLipschitz::Options options;
    options.common.harmonics = harmonics;
    const BranchDiagram diagram = FourierLipschitz(options).follow(over_frequency(problem, kFrom, 1.03),
                                                                   {.max_order = 1, .max_branches = 3});
    double found = 0.0;
    std::size_t left = 0;
    for (const Branch& branch : diagram.branches) {
      left += branch.began.starts_with("branch point") ? 1U : 0U;
      for (const SpecialPoint& special : branch.special)
        if (special.kind == SpecialKind::branch_point) found = special.point.parameter;
    }
    EXPECT_GE(left, 1U) << harmonics;
    EXPECT_GT(found, before) << harmonics;
    EXPECT_LT(kExact - found, 0.8 / harmonics) << harmonics;
    EXPECT_GT(kExact - found, 0.3 / harmonics) << harmonics;
    before = found;
  }
}

}  // namespace
}  // namespace signorini::series_symmetry_test
