// The steady states of tests/data/siconos, computed by independent codes: every case at a stated tolerance.

#include "tests/methods/periodic_motion/steady_state_cases.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <memory>
#include <ostream>
#include <vector>

#include "methods/orbit/exact_orbit.hpp"
#include "tests/methods/event_driven/scenes.hpp"

namespace signorini::test::steady_state_cases_test {

void PrintTo(const SteadyStateCase& entry, std::ostream* out) { *out << entry.name; }

namespace {

class SteadyState : public testing::TestWithParam<SteadyStateCase> {};

std::string test_name(const testing::TestParamInfo<SteadyStateCase>& info) {
  std::string name = info.param.name;
  for (char& letter : name) {
    if (letter == '.') letter = 'p';
  }
  return name;
}

int count_type(const std::vector<ExpectedEvent>& events, int type) {
  int count = 0;
  for (const ExpectedEvent& event : events) count += event.type == type ? 1 : 0;
  return count;
}

// From rest this one is chaotic for some two thousand periods and ends, by chance, on the impacting motion or
// on the one that is free of contact, both stable: what is polished begins at the motion expected, whose
// block of samples ends where it began, at a maximum of the load.
std::shared_ptr<const Trajectory> start_of(const SteadyStateCase& expected) {
  if (expected.name != "chainB_w2_e0.9") return nullptr;
  const std::vector<double>& end = expected.samples.back();
  Eigen::VectorXd u(2), v(2);
  for (Eigen::Index j = 0; j < 2; ++j) {
    u[j] = end[static_cast<std::size_t>(1 + 2 * j)];
    v[j] = end[static_cast<std::size_t>(2 + 2 * j)];
  }
  return guess_from(expected.problem, u, v);
}

// Ours is accurate to a few 1e-9 at tolerance 1e-9; the bars' own reference to 1e-8 in the state, which
// its 40 impacts a period carry into the impulses.
TEST_P(SteadyState, AgreesWithTheIndependentCode) {
  const SteadyStateCase& expected = GetParam();
  const bool bar = expected.name.starts_with("bar");
  const Solution solution = solve(expected.problem, {.tolerance = 1e-9});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const double forcing_period = expected.problem.period();
  EXPECT_NEAR(solution.trajectory->period() / forcing_period, expected.order, 1e-12);

  constexpr double kCounted = 3e-5;  // slower impacts are past the ends of both codes' chatters
  const SteadyStateDifference found = difference(expected, *solution.trajectory, kCounted);
  EXPECT_LT(found.x, bar ? 5e-8 : 1e-8);
  EXPECT_LT(found.impact_time, bar ? 1e-8 : 3e-9);
  EXPECT_LT(found.impulse, bar ? 3e-7 : 1e-8);
  EXPECT_EQ(found.found_impacts, found.expected_impacts);

  int closings = 0, openings = 0;
  for (const ContactEvent& event : events_of(solution)) {
    closings += event.kind == ContactEvent::Kind::close ? 1 : 0;
    openings += event.kind == ContactEvent::Kind::open ? 1 : 0;
  }
  EXPECT_EQ(openings, count_type(expected.events, 2));
  // A phase of sticking across the block's end is listed by one of its ends only; a period has as many of
  // each.
  EXPECT_EQ(closings, openings);
}

TEST_P(SteadyState, IsPolishedToAnExactOrbitThatAgreesToo) {
  const SteadyStateCase& expected = GetParam();
  const bool bar = expected.name.starts_with("bar");
  const Solution marched =
      solve(expected.problem, {.tolerance = 1e-8, .flow = Integrator::modal}, start_of(expected));
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  Problem problem = expected.problem;
  problem.subharmonic = expected.order;
  const ExactOrbit orbit = OrbitFinder(problem).find(*marched.trajectory).orbit;
  ASSERT_TRUE(orbit.certified()) << describe(orbit.outcome) << ": " << orbit.reason;
  constexpr double kResolved = 1e-3;  // slower impacts may be summed into the rest of a chatter
  const SteadyStateDifference found = difference(expected, *orbit.trajectory, kResolved);
  EXPECT_LT(found.x, bar ? 5e-8 : 1e-8);
  EXPECT_LT(found.impulse, bar ? 3e-7 : 1e-8);
  EXPECT_EQ(found.found_impacts, found.expected_impacts);
}

INSTANTIATE_TEST_SUITE_P(OneMass, SteadyState, testing::ValuesIn(steady_state_cases("sdof")), test_name);
INSTANTIATE_TEST_SUITE_P(TwoMasses, SteadyState, testing::ValuesIn(steady_state_cases("chain")), test_name);
INSTANTIATE_TEST_SUITE_P(Bar, SteadyState, testing::ValuesIn(steady_state_cases("bar")), test_name);

}  // namespace
}  // namespace signorini::test::steady_state_cases_test
