// Where trajectories go, against exact orbits and a motion known to be irregular.

#include "harness/sweep/attractors.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/plan/plan.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/program.hpp"

namespace signorini::attractors_test {
namespace {

using Json = nlohmann::ordered_json;

// sdof-stop-e08: the exact orbit has the amplitude 0.431238 (cases of the certificates).
TEST(Attractors, AreThePeriodicMotionThatEveryStartReaches) {
  const Problem problem = read_scene(find_scene("sdof-stop-e08")).problem;
  int done = 0;
  const std::vector<AttractorsAt> found = attractors_over(over_frequency(problem, 2.0, 2.4), {2.2, 2.3},
                                                          {.starts = 3, .jobs = 2}, [&] { ++done; });
  EXPECT_EQ(done, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].value, 2.3);
  const AttractorsAt& at = found[0];
  EXPECT_EQ(at.failure, "");
  EXPECT_EQ(at.starts, 3);
  ASSERT_EQ(at.attractors.size(), 1U);
  EXPECT_EQ(at.attractors[0].verdict, LongRun::periodic);
  EXPECT_EQ(at.attractors[0].order, 1);
  EXPECT_EQ(at.attractors[0].starts, 3);
  EXPECT_TRUE(at.attractors[0].from_rest);
  EXPECT_NEAR(at.attractors[0].amplitude(), 0.431238, 1e-6);
  EXPECT_EQ(at.attractors[0].once_a_period.size(), 1U);
}

TEST(Attractors, CommandTellsIrregularMotionsAndTheirShare) {
  const test::Outcome outcome =
      test::run_program("sweep chaos@2.97 --attractors 2 --at 2.97 --format json --timeout 20");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["parameter"], "forcing.frequency");
  EXPECT_TRUE(json["branches"].empty());
  ASSERT_EQ(json["attractors"].size(), 1U);
  const Json& at = json["attractors"][0];
  EXPECT_EQ(at["value"], 2.97);
  ASSERT_EQ(at["attractors"].size(), 1U);
  EXPECT_EQ(at["attractors"][0]["verdict"], "irregular");
  EXPECT_TRUE(at["attractors"][0]["order"].is_null());
  EXPECT_EQ(at["attractors"][0]["share"], 1.0);
}

TEST(Attractors, CommandRefusesWhatGoesWithoutThem) {
  for (const char* more : {"--method exact-orbit", "--natural", "--out folder", "--attractors 0"}) {
    const test::Outcome outcome =
        test::run_program(std::string("sweep sdof-stop --attractors 2 --from 2 --to 3 ") + more);
    EXPECT_EQ(outcome.code, 2) << more << outcome.out;
    EXPECT_NE(outcome.err, "");
  }
  EXPECT_EQ(test::run_program("sweep sdof-stop --attractors 2").code, 2);
}

}  // namespace
}  // namespace signorini::attractors_test
