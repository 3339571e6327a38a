#include "harness/plan/case_name.hpp"

#include <gtest/gtest.h>

namespace signorini::case_name_test {
namespace {

TEST(CaseName, TakesASceneAMethodAndItsSettingsApart) {
  const CaseName name = parse_case_name("grazing@0.01/event-driven[flow=cvode,tolerance=1e-6]");
  EXPECT_EQ(name.scene, "grazing@0.01");
  EXPECT_EQ(name.method, "event-driven");
  EXPECT_EQ(name.settings, (Settings{{"flow", "cvode"}, {"tolerance", "1e-6"}}));
}

TEST(CaseName, HasNoSettingsWithoutBrackets) {
  EXPECT_EQ(parse_case_name("sdof-stop/hat-lcp").method, "hat-lcp");
  EXPECT_TRUE(parse_case_name("sdof-stop/hat-lcp").settings.empty());
  EXPECT_TRUE(parse_case_name("hat-lcp").scene.empty());
  EXPECT_EQ(parse_case_name("hat-lcp").method, "hat-lcp");
  EXPECT_TRUE(parse_case_name("").method.empty());
}

TEST(CaseName, IsPrintedAsItWasRead) {
  for (const char* label :
       {"hat-lcp", "hat-lcp[samples=64]", "penalty-hbm[penalty=100x,plain=true,harmonics=5]"}) {
    const CaseName name = parse_method_label(label);
    EXPECT_EQ(method_label(name.method, name.settings), label);
  }
}

TEST(CaseName, TellsTheLiteraturesFormsFromOurs) {
  EXPECT_TRUE(is_plain(parse_method_label("hat-lcp[samples=64,plain=true]").settings));
  EXPECT_FALSE(is_plain(parse_method_label("hat-lcp[samples=64,plain=false]").settings));
  EXPECT_FALSE(is_plain({}));
}

TEST(CaseName, SurvivesNamesThatNoProgramWrote) {
  EXPECT_EQ(parse_method_label("m[word").settings, (Settings{{"word", ""}}));
  EXPECT_EQ(parse_method_label("m[]").settings, Settings{});
  EXPECT_EQ(parse_method_label("m[=]").settings, (Settings{{"", ""}}));
  EXPECT_EQ(parse_method_label("m[a=b=c]").settings, (Settings{{"a", "b=c"}}));
}

}  // namespace
}  // namespace signorini::case_name_test
