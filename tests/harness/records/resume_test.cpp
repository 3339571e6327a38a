#include "harness/records/resume.hpp"

#include <gtest/gtest.h>

#include "harness/failure.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(JoinedPlan, KeepsTheCasesThatANarrowerRunLeavesOut) {
  const RunFolder before = test::part_of_a_run("a", {"n=1", "n=2"});
  RunFolder now = test::part_of_a_run("a", {"n=2"});
  ASSERT_EQ(joined_plan(before, now).size(), 2U);
  EXPECT_EQ(joined_plan(before, now)[1].case_id, "s/m[n=1]");
  now.plan[0].key = "of a changed scene";
  ASSERT_EQ(joined_plan(before, now).size(), 2U);
  EXPECT_EQ(joined_plan(before, now)[0].key, "of a changed scene");
  now.manifest["limits"]["timeout_s"] = 2.0;
  EXPECT_EQ(joined_plan(before, now).size(), 1U);
}

TEST(JoinedPlan, ForgetsCasesOfAPluginThatWasBuiltAnew) {
  RunFolder before = test::part_of_a_run("a", {"n=1", "n=2"});
  RunFolder now = test::part_of_a_run("a", {"n=2"});
  before.manifest["plugins"] = {{"mine", "1"}};
  EXPECT_EQ(joined_plan(before, now).size(), 2U);
  now.manifest["plugins"] = {{"yours", "2"}};
  EXPECT_EQ(joined_plan(before, now).size(), 2U);
  now.manifest["plugins"]["mine"] = "3";
  EXPECT_EQ(joined_plan(before, now).size(), 1U);
}

TEST(RequireSameMachine, RefusesAnotherOne) {
  const RunFolder before = test::part_of_a_run("a", {"n=1"});
  RunFolder now = before;
  now.manifest["limits"]["timeout_s"] = 2.0;
  EXPECT_NO_THROW(require_same_machine(before, now));
  now.manifest["machine"]["cpu"] = "y";
  EXPECT_THROW(require_same_machine(before, now), UsageError);
}

}  // namespace
}  // namespace signorini
