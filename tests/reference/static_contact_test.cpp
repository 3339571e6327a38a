// Loads that do not change, or change slowly: the static contact problem, found by trying all active sets.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "methods/catalogue.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini {
namespace {

std::vector<int> all_coordinates(const Problem& problem) {
  std::vector<int> all(static_cast<std::size_t>(problem.size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Static response of the whole structure at one instant, inertia and damping left out.
test::StaticContact static_response(const Problem& problem, double time) {
  return test::static_contact(problem, all_coordinates(problem), time, Eigen::VectorXd());
}

TEST(ConstantLoad, EveryMethodReturnsTheStaticContactProblem) {
  int solved = 0, closed = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Problem problem = test::coupled_massless_scene(seed);
    std::erase_if(problem.force, [](const ForceTerm& term) { return term.harmonic != 1; });
    for (ForceTerm& term : problem.force) term = {.dof = term.dof, .harmonic = 0, .cos = 2.0 * term.cos};
    ASSERT_NO_THROW(validate(problem));
    const test::StaticContact expected = static_response(problem, 0.0);
    closed += static_cast<int>((expected.lambda.array() < 0.0).count());
    for (const MethodEntry& entry : method_catalogue()) {
      const std::unique_ptr<Method> method = entry.make({});
      // A spring in place of the stop is another static problem.
      if (!method->supports(problem).ok || entry.name == "penalty-hbm") continue;
      SCOPED_TRACE(testing::Message() << entry.name << ", seed " << seed);
      const Solution solution = method->prepare(problem)->solve({});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      const Samples samples = solution.trajectory->sample(64);
      const double x = expected.x.norm(), force = load_at(problem, 0.0).norm();
      for (int i = 0; i < 64; ++i) {
        EXPECT_LT((samples.x.row(i).transpose() - expected.x).norm(), 1e-7 * x);
        EXPECT_LT((samples.force.row(i).transpose() - expected.lambda).norm(), 1e-6 * force);
      }
      ++solved;
    }
  }
  EXPECT_GT(closed, 1);
  EXPECT_GE(solved, 15);  // five methods
}

// Oracle 1g: u tends to the static response; the damping force, of order omega, is what is left.
TEST(SlowLoad, MotionTendsToTheStaticResponseWithTheFrequency) {
  std::vector<double> rates, errors;
  for (const double frequency : {0.04, 0.02, 0.01, 0.005}) {
    Problem problem = test::coupled_massless_scene(2);
    problem.frequency = frequency;
    const Solution solution =
        test::solve<EventDriven>(problem, {.tolerance = 1e-8, .flow = Integrator::modal});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    constexpr int kInstants = 200;
    const Samples samples = solution.trajectory->sample(kInstants);
    double error = 0.0, size = 0.0;
    for (int i = 0; i < kInstants; ++i) {
      const test::StaticContact expected =
          static_response(problem, solution.trajectory->period() * i / kInstants);
      error = std::max(error, (samples.x.row(i).transpose() - expected.x).norm());
      size = std::max(size, expected.x.norm());
    }
    rates.push_back(frequency);
    errors.push_back(error / size);
  }
  EXPECT_LT(errors.back(), 2e-2);
  EXPECT_NEAR(test::observed_order(rates, errors), 1.0, 0.2);
}

}  // namespace
}  // namespace signorini
