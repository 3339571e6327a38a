#include <gtest/gtest.h>

#include <array>

#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::selection_test {
namespace {

std::unique_ptr<Method> make_none(std::span<const OptionSetting>) { return nullptr; }

const std::array<MethodEntry, 3> kEntries{{
    {.name = "hat-lcp", .title = "", .laws = "", .ladder = "samples=64|256", .make = make_none},
    {.name = "penalty-hbm",
     .title = "",
     .laws = "",
     .ladder = "harmonics=10|40,penalty=1e4|1e6",
     .make = make_none},
    {.name = "aft-hbm", .title = "", .laws = "", .ladder = "", .make = make_none},
}};

std::vector<std::string> labels(const std::string& filter) {
  std::vector<std::string> result;
  for (const MethodChoice& choice : select_methods(filter, kEntries)) result.push_back(choice.label());
  return result;
}

using Labels = std::vector<std::string>;

TEST(ExpandSettings, IsTheCrossProductOfTheAlternatives) {
  const std::vector<Settings> sets = expand_settings("harmonics=31,penalty=1e4|1e6");
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0], (Settings{{"harmonics", "31"}, {"penalty", "1e4"}}));
  EXPECT_EQ(sets[1], (Settings{{"harmonics", "31"}, {"penalty", "1e6"}}));
  EXPECT_EQ(expand_settings("a=1|2|3,b=1|2").size(), 6U);
  EXPECT_EQ(expand_settings(""), (std::vector<Settings>{{}}));
}

TEST(ExpandSettings, RefusesWhatIsNoSetting) {
  for (const char* text : {"a", "=1", "a=", "a=1|", "a=1,,b=2", "a=1,a=2", ","}) {
    EXPECT_THROW(expand_settings(text), UsageError) << text;
  }
}

TEST(ExpandSettings, RefusesMoreThanARunEverSolves) {
  std::string text = "a=1|2|3|4|5|6|7|8|9|10";
  for (const char* key : {"b", "c", "d"}) text += std::string(",") + key + text.substr(1, 21);
  EXPECT_EQ(expand_settings(text).size(), 10000U);
  EXPECT_THROW(expand_settings(text + ",e=1|2"), UsageError);
  const std::string piece = "fake-method[level=1|2|3|4|5]";
  std::string filter = piece;
  for (int i = 0; i < 2000; ++i) filter += ":" + piece;
  EXPECT_THROW(select_methods(filter, test::fake_catalogue()), UsageError);
}

TEST(MethodChoice, KeepsItsStartFromTheMethod) {
  const auto choices = select_methods("fake-method[level=2,start=0|0.5]", test::fake_catalogue());
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[1].label(), "fake-method[level=2,start=0.5]");
  EXPECT_EQ(choices[0].start(), 0.0);
  EXPECT_EQ(choices[1].start(), 0.5);
  EXPECT_EQ(choices[1].make()->options().size(), 2U);
  ASSERT_EQ(choices[1].options().size(), 3U);
  EXPECT_EQ(choices[1].options().back().name, "start");
  EXPECT_EQ(select_methods("fake-method[level=2]", test::fake_catalogue()).front().start(), std::nullopt);
}

TEST(MethodChoice, RefusesAStartThatIsNoShareOfAPeriod) {
  for (const char* late : {"1", "-0.1", "cold", "nan"}) {
    const MethodChoice choice{&test::fake_catalogue().front(), {{"start", late}}};
    EXPECT_THROW(choice.options(), InvalidOption) << late;
  }
}

TEST(SelectMethods, RunsTheLadderOfEveryMethodByDefault) {
  EXPECT_EQ(labels("*"),
            (Labels{"hat-lcp[samples=64]", "hat-lcp[samples=256]", "penalty-hbm[harmonics=10,penalty=1e4]",
                    "penalty-hbm[harmonics=10,penalty=1e6]", "penalty-hbm[harmonics=40,penalty=1e4]",
                    "penalty-hbm[harmonics=40,penalty=1e6]", "aft-hbm"}));
}

TEST(SelectMethods, TakesSettingsInBracketsInsteadOfTheLadder) {
  EXPECT_EQ(labels("*hbm[harmonics=5]"), (Labels{"penalty-hbm[harmonics=5]", "aft-hbm[harmonics=5]"}));
  EXPECT_EQ(labels("hat-lcp:aft*-*hbm"), (Labels{"hat-lcp[samples=64]", "hat-lcp[samples=256]"}));
}

TEST(SelectMethods, NamesEachCaseOnce) {
  EXPECT_EQ(labels("hat-lcp:hat*:hat-lcp[samples=64]"),
            (Labels{"hat-lcp[samples=64]", "hat-lcp[samples=256]"}));
}

TEST(SelectMethods, SaysWhichPieceMatchesNothing) {
  try {
    labels("hat-lcp:zzz*");
    FAIL() << "zzz* must match nothing";
  } catch (const NothingMatched& error) {
    EXPECT_NE(std::string(error.what()).find("zzz*"), std::string::npos);
  }
  EXPECT_THROW(labels("*-*"), NothingMatched);
}

TEST(SelectMethods, RefusesBadBrackets) {
  for (const char* text :
       {"hat-lcp[samples=64", "hat-lcp]", "[samples=64]", "hat-lcp[samples=64]x", "hat-lcp[[a=1]]"}) {
    EXPECT_THROW(labels(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace signorini::selection_test
