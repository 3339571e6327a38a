#include "harness/conformance/checked_method.hpp"

#include <gtest/gtest.h>

#include "harness/plan/plan.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/conformance/flawed_method.hpp"

namespace signorini::checked_method_test {
namespace {

using test::Flaw;

std::string setting(const Settings& settings, const std::string& name) {
  for (const OptionSetting& one : settings) {
    if (one.first == name) return one.second;
  }
  return {};
}

TEST(UsableLadder, IsTheDefaultsAloneWhereTheMethodRefusesItsOwnLadder) {
  EXPECT_EQ(usable_ladder(test::flawed_method(Flaw::none)).size(), 2U);
  const std::vector<Settings> ladder = usable_ladder(test::flawed_method(Flaw::has_a_ladder_that_it_refuses));
  ASSERT_EQ(ladder.size(), 1U);
  EXPECT_TRUE(ladder.front().empty());
}

// A delay by whole steps can be compared exactly only on a grid that both solves share.
TEST(CheckSettingsOf, FixTheGridOfAMethodThatChoosesIt) {
  const CheckSettings settings = check_settings_of(test::flawed_method(Flaw::none));
  EXPECT_EQ(setting(settings.resolution, "harmonics"), "10");
  EXPECT_EQ(setting(settings.resolution, "samples"), std::to_string(settings.grid));
}

TEST(CheckSettingsOf, TakeTheGridThatTheMethodNames) {
  const CheckSettings settings = check_settings_of(find_method("hat-lcp"));
  EXPECT_EQ(setting(settings.resolution, "samples"), std::to_string(settings.grid));
}

TEST(CheckedMethod, ComputesItsAnswerOnceAndWithinItsScene) {
  const MethodEntry entry =
      test::flawed_method(Flaw::drifts);  // each solve of one set-up gives another answer
  const CheckedMethod checked(entry, read_scene(find_scene("sdof-stop")).problem, check_settings_of(entry));
  ASSERT_TRUE(checked.support().ok);
  const Trajectory* first = checked.answer().trajectory.get();
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(checked.answer().trajectory.get(), first);
}

TEST(CheckedMethod, SaysWhyThereIsNothingToCheck) {
  const MethodEntry silent = test::flawed_method(Flaw::gives_up);
  const Problem problem = read_scene(find_scene("sdof-stop")).problem;
  const CheckedMethod checked(silent, problem, check_settings_of(silent));
  EXPECT_FALSE(unless_supported(checked));
  ASSERT_TRUE(unless_answered(checked));
  EXPECT_EQ(unless_answered(checked)->outcome, CheckOutcome::not_applicable);
  EXPECT_EQ(unless_answered(checked)->why, "there is no answer: it is too hard");
  const MethodEntry refusing = test::flawed_method(Flaw::refuses_without_reason);
  EXPECT_TRUE(unless_supported(CheckedMethod(refusing, problem, check_settings_of(refusing))));
}

// The largest of |x| = 0.3 and the gap, and the amplitude of the largest harmonic of the load.
TEST(Scales, AreThoseOfTheSceneAndOfTheAnswer) {
  Problem problem;
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = -0.2}};
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 3.0, .sin = 4.0}, {.dof = 0, .harmonic = 3, .cos = 1.0}};
  Samples samples;
  samples.x = Eigen::MatrixXd::Constant(1, 1, -0.3);
  EXPECT_DOUBLE_EQ(displacement_scale(problem, samples), 0.3);
  samples.x *= 0.1;
  EXPECT_DOUBLE_EQ(displacement_scale(problem, samples), 0.2);
  EXPECT_DOUBLE_EQ(load_scale(problem), 5.0);
}

}  // namespace
}  // namespace signorini::checked_method_test
