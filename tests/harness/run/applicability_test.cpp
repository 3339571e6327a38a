#include "harness/run/applicability.hpp"

#include <gtest/gtest.h>

#include "tests/harness/fake_method.hpp"

namespace signorini::applicability_test {
namespace {

constexpr int kMemory = 256;  // MiB

TEST(AskApplicability, AnswersForEveryCaseAlsoBehindOneThatCrashes) {
  const Scene scene = test::one_mass_scene();
  const Case first = test::fake_case(scene, "good");
  const Case second = test::fake_case(scene, "crash_when_asked");
  const Case third = test::fake_case(scene, "unsupported");
  const Case* const cases[] = {&first, &second, &third};
  const std::vector<Applicability> answers = ask_applicability(scene, cases, kMemory);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_TRUE(answers[0].applies);
  EXPECT_TRUE(answers[0].law.has_value());
  EXPECT_FALSE(answers[1].applies);
  ASSERT_TRUE(answers[1].failure.has_value());
  EXPECT_EQ(answers[1].failure->kind, ChildEnd::Kind::signalled);
  EXPECT_FALSE(answers[2].applies);
  EXPECT_EQ(answers[2].reason, "it is Tuesday");
  EXPECT_FALSE(answers[2].failure.has_value());
}

TEST(AskApplicability, OfNoCaseIsNoAnswer) {
  EXPECT_TRUE(ask_applicability(test::one_mass_scene(), {}, kMemory).empty());
}

}  // namespace
}  // namespace signorini::applicability_test
