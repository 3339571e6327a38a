#include "methods/harmonic_balance/distinct_stops.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "methods/catalogue.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::distinct_stops_test {
namespace {

Problem with_copies(const char* scene, int copies) {
  Problem problem = load_scene(find_scene(scene));
  const Contact stop = problem.contacts.front();
  for (int i = 1; i < copies; ++i) problem.contacts.push_back(stop);
  return problem;
}

Solution solve(const Problem& problem, const std::string& method, const Start& start = {},
               const std::vector<OptionSetting>& options = {{"harmonics", "20"}}) {
  for (const MethodEntry& entry : method_catalogue()) {
    if (entry.name == method) return entry.make(options)->prepare(problem)->solve(start);
  }
  ADD_FAILURE() << method;
  return {};
}

TEST(DistinctStops, AreThoseWithAnotherNormalOrGap) {
  EXPECT_FALSE(distinct_stops(with_copies("sdof-stop-e08", 1)));
  Problem problem = with_copies("sdof-two-sided", 3);
  const auto stops = distinct_stops(problem);
  ASSERT_TRUE(stops);
  EXPECT_EQ(stops->problem.contact_count(), 2);
  EXPECT_EQ(stops->places, (std::vector<int>{0, 1, 0, 0}));
  problem.contacts[2].gap *= 1.5;
  EXPECT_EQ(distinct_stops(problem)->problem.contact_count(), 3);
  EXPECT_FALSE(distinct_stops(with_copies("sdof-penalty-stiff", 1)));
  Problem springs = with_copies("sdof-penalty-stiff", 2);
  springs.set_law(Penalty{{1e3, 1e3}});
  EXPECT_FALSE(distinct_stops(springs)) << "two springs are twice as stiff as one";
}

TEST(DistinctStops, ShareTheForceOfOne) {
  const Problem problem = with_copies("sdof-stop", 3);
  const DistinctStops stops = distinct_stops(problem).value();
  const auto one = solve(stops.problem, "fourier-lipschitz").trajectory;
  const auto all = on_all_contacts(one, stops);
  ASSERT_EQ(all->contact_count(), 3);
  const Samples single = one->sample(64), shared = all->sample(64);
  for (int contact = 0; contact < 3; ++contact) {
    EXPECT_EQ(shared.x.col(contact), single.x.col(0));
    EXPECT_EQ(shared.velocity.col(contact), single.velocity.col(0));
  }
  EXPECT_LE((shared.force.rowwise().sum() - single.force).norm(), 1e-14 * single.force.norm());
  EXPECT_LE((all->force_coefficients().rowwise().sum() - one->force_coefficients()).norm(),
            1e-14 * one->force_coefficients().norm());
  const Samples back = on_distinct_stops(all, stops)->sample(64);
  EXPECT_EQ(back.x, single.x);
  EXPECT_LE((back.force - single.force).norm(), 1e-14 * single.force.norm());
}

// The same stop given twice or twenty times is the same scene.
TEST(HarmonicBalance, SolvesARepeatedStopAsOne) {
  for (const char* method :
       {"fourier-lipschitz", "penalty-hbm", "aft-hbm", "augmented-lagrangian", "closed-hbm"}) {
    const Solution once = solve(with_copies("sdof-stop-e08", 1), method);
    ASSERT_EQ(once.verdict, Verdict::converged) << method;
    for (const int copies : {2, 20}) {
      const Solution repeated = solve(with_copies("sdof-stop-e08", copies), method);
      ASSERT_EQ(repeated.verdict, Verdict::converged) << method;
      EXPECT_EQ(repeated.trajectory->sample(256).x.col(copies - 1), once.trajectory->sample(256).x.col(0))
          << method;
      const Solution warm =
          solve(with_copies("sdof-stop-e08", copies), method, {.guess = repeated.trajectory});
      EXPECT_EQ(warm.verdict, Verdict::converged) << method;
    }
  }
}

// A law of the stops as they are solved, not of the list of contacts that the scene has.
TEST(HarmonicBalance, SolvesARepeatedStopByAConstantThatIsGiven) {
  const std::vector<std::pair<std::string, OptionSetting>> constants = {
      {"fourier-lipschitz", {"c", "3"}},
      {"aft-hbm", {"c", "3"}},
      {"augmented-lagrangian", {"penalty", "30"}}};
  for (const auto& [method, constant] : constants) {
    const std::vector<OptionSetting> options = {{"harmonics", "20"}, constant};
    const Solution once = solve(with_copies("sdof-stop", 1), method, {}, options);
    const Solution twice = solve(with_copies("sdof-stop", 2), method, {}, options);
    ASSERT_EQ(once.verdict, Verdict::converged) << method << ": " << once.message;
    ASSERT_EQ(twice.verdict, Verdict::converged) << method << ": " << twice.message;
    EXPECT_EQ(twice.trajectory->sample(256).x.col(1), once.trajectory->sample(256).x.col(0)) << method;
  }
}

}  // namespace
}  // namespace signorini::distinct_stops_test
