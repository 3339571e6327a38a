// Orbits of several coordinates with one impact a period, against their closed form.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/methods/orbit/impulsive_oracle.hpp"
#include "tests/support/exact_scenes.hpp"

namespace signorini::impulsive_orbits_test {
namespace {

using test::cold_orbit;
using test::ImpulsiveOracle;

constexpr double kAccuracy = 1e-10;  // relative to lengths, speeds and forces of order one

TEST(ImpulsiveOrbits, OfSeveralCoordinatesAreTheClosedForm) {
  int compared = 0;
  for (const double e : {1.0, 0.6, 0.0}) {
    for (Problem problem :
         {test::stopped_chain(2, e), test::stopped_chain(2, e, 1, 1.1), test::stopped_chain(2, e, 1, 2.1),
          test::stopped_chain(3, e, 1, 1.3), test::stopped_chain(3, e, 1, 2.3),
          test::stopped_chain(4, e, 1, 1.7), test::stopped_chain(5, e, 1, 2.1), test::skew_damped_pair(e),
          test::skew_damped_pair(e, 1.9)}) {
      if (problem.name == "skew-damped-pair") problem.force.resize(1);  // one harmonic
      SCOPED_TRACE(testing::Message() << problem.size() << " masses, e = " << e);
      const auto found = cold_orbit(problem);
      ASSERT_TRUE(found.orbit) << found.solution.message;
      const auto impulses = found.orbit->impulses();
      if (impulses.size() != 1 || found.orbit->orbit().events.size() != 1) continue;
      const ImpulsiveOracle oracle(problem, e);
      std::size_t match = oracle.times.size();
      for (std::size_t k = 0; k < oracle.times.size(); ++k) {
        if (std::abs(std::remainder(oracle.times[k] - impulses[0].time, problem.period())) < 1e-6) match = k;
      }
      ASSERT_LT(match, oracle.times.size());
      EXPECT_NEAR(std::remainder(oracle.times[match] - impulses[0].time, problem.period()), 0.0, kAccuracy);
      EXPECT_NEAR(oracle.impulses[match], -impulses[0].value, kAccuracy);
      EXPECT_NEAR(oracle.multipliers[match].cwiseAbs().maxCoeff(),
                  found.orbit->quality().multipliers.cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_LT(std::abs(oracle.multipliers[match].sum() - found.orbit->quality().multipliers.sum()), 1e-9);
      ++compared;
    }
  }
  EXPECT_GE(compared, 8) << "scenes with one impact";
}

}  // namespace
}  // namespace signorini::impulsive_orbits_test
