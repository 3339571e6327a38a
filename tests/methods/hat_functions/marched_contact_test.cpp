#include "methods/hat_functions/marched_contact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "methods/hat_functions/hat_contact.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::marched_contact_test {
namespace {

constexpr ProportionalDamping kStiff{.alpha = 0.2, .beta = 0.005};

HatSettings second_order(int samples, ComplementaritySolver solver = ComplementaritySolver::automatic) {
  return {.samples = samples, .scheme = HatScheme::bdf2, .solver = solver};
}

Samples nodes_of(const Solution& solution, int samples) { return solution.trajectory->sample(samples); }

Problem sprung_bar() {
  Problem problem = test::massless_bar(kStiff, 30);
  problem.set_law(Penalty{{50.0}});
  return problem;
}

Problem two_periods() {
  Problem problem = test::massless_bar(kStiff, 30);
  problem.subharmonic = 2;
  return problem;
}

struct MarchedCase {
  const char* name;
  Problem problem;
};
void PrintTo(const MarchedCase& scene, std::ostream* out) { *out << scene.name; }

class MarchedContact : public testing::TestWithParam<MarchedCase> {};

// The oracle: the same discrete problem as one of complementarity over the whole period, by pivoting, from
// receptances of the whole structure.
TEST_P(MarchedContact, IsTheProblemOfTheWholePeriod) {
  constexpr int kNodes = 96;
  const Problem& problem = GetParam().problem;
  const Solution marched = hat_contact(problem, second_order(kNodes), {})->solve({});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  EXPECT_FALSE(marched.work.pivots);
  EXPECT_EQ(marched.work.unknowns, kNodes * problem.contact_count());
  const Solution pivoted =
      hat_contact(problem, second_order(kNodes, ComplementaritySolver::pivoting), {})->solve({});
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  const Samples a = nodes_of(marched, kNodes), b = nodes_of(pivoted, kNodes);
  ASSERT_LT(b.force.minCoeff(), 0.0);
  EXPECT_LE((a.x - b.x).norm(), 1e-8 * b.x.norm());
  EXPECT_LE((a.force - b.force).norm(), 1e-6 * b.force.norm());
}

INSTANTIATE_TEST_SUITE_P(Scenes, MarchedContact,
                         testing::Values(MarchedCase{"bar", test::massless_bar(kStiff, 30)},
                                         MarchedCase{"bar that does not relax",
                                                     test::massless_bar({.alpha = 0.3}, 30)},
                                         MarchedCase{"two periods of the load", two_periods()},
                                         MarchedCase{"spring stop", sprung_bar()}));

TEST(MarchedContact, ConvergesWithOrderTwo) {
  const Problem problem = test::massless_bar(kStiff, 30);
  constexpr int kFinest = 16384;
  const auto reduction = marched_reduction(problem);
  ASSERT_TRUE(reduction);
  const auto motion = [&](int samples) {
    return nodes_of(marched_contact(problem, samples, 1e-11, reduction)->solve({}), samples).x;
  };
  const Eigen::MatrixXd exact = motion(kFinest);
  std::vector<double> steps, errors;
  for (const int samples : {256, 512, 1024, 2048}) {
    const Eigen::MatrixXd x = motion(samples);
    double error = 0.0;
    for (int k = 0; k < samples; ++k)
      error = std::max(error, (x.row(k) - exact.row(k * (kFinest / samples))).cwiseAbs().maxCoeff());
    steps.push_back(1.0 / samples);
    errors.push_back(error);
  }
  const double order = test::observed_order(steps, errors);
  EXPECT_GE(order, 1.5);
  EXPECT_LE(order, 2.3);
}

// The catalogue's block-nine-contacts pressed against its pad: closed for most of the period, where the path
// of pivots has thousands of steps on 64 nodes and does not end on 256.
TEST(MarchedContact, SolvesWhereContactsStayClosed) {
  Problem problem = test::padded_block_problem({});
  const double amplitude = 2.0 * fourier_receptance(problem, 1).free_response.row(1).cwiseAbs().maxCoeff();
  const Eigen::VectorXd deflection = fourier_receptance(problem, 0).receptance.front().real().rowwise().sum();
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    problem.contacts[c].gap =
        -0.5 * amplitude * deflection[static_cast<Eigen::Index>(c)] / deflection.maxCoeff();
  }
  for (const int samples : {256, 1024}) {
    const Solution solution = hat_contact(problem, second_order(samples), {})->solve({});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples nodes = nodes_of(solution, samples);
    const double closed = (nodes.force.array() < 0.0).cast<double>().mean();
    EXPECT_GT(closed, 0.5);
    EXPECT_LT(closed, 1.0);
    EXPECT_LE(*solution.work.iterations, 10);
  }
}

TEST(MarchedReduction, IsEmptyWhereNothingCanBeMarched) {
  EXPECT_FALSE(marched_reduction(test::stopped_chain(3, 0.5, 1)));
  Problem damped = test::massless_bar(kStiff, 10);
  damped.edit_structure([](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  EXPECT_FALSE(marched_reduction(damped));
  // The grid is still solved, by pivoting.
  const Solution solution = hat_contact(damped, second_order(64), {})->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_TRUE(solution.work.pivots);
  Problem alone = damped;
  alone.contacts.clear();
  alone.set_law(std::monostate{});
  EXPECT_FALSE(marched_reduction(alone));
}

}  // namespace
}  // namespace signorini::marched_contact_test
