#include "harness/glob.hpp"

#include <gtest/gtest.h>

namespace signorini::glob_test {
namespace {

TEST(GlobMatch, TakesStarForAnyRunAndQuestionMarkForOneCharacter) {
  EXPECT_TRUE(glob_match("*", ""));
  EXPECT_TRUE(glob_match("hat*", "hat-lcp"));
  EXPECT_TRUE(glob_match("*-hb?", "penalty-hbm"));
  EXPECT_TRUE(glob_match("*a*b*c", "xxaxbxxbxc"));
  EXPECT_TRUE(glob_match("a**", "a"));
  EXPECT_FALSE(glob_match("hat", "hat-lcp"));
  EXPECT_FALSE(glob_match("?", ""));
  EXPECT_FALSE(glob_match("*a*b*c", "xxaxbxxbx"));
}

TEST(GlobMatch, TakesBracketsLiterally) {
  EXPECT_TRUE(glob_match("sdof/x[h=1]", "sdof/x[h=1]"));
  EXPECT_FALSE(glob_match("x[ab]", "xa"));
}

TEST(GlobMatch, EndsQuicklyWhereBacktrackingWouldNot) {
  const std::string text(5000, 'a');
  EXPECT_FALSE(glob_match("*a*a*a*a*a*a*a*a*a*a*a*a*a*a*b", text));
}

TEST(SplitGlobs, SeparatesPositiveFromNegativePieces) {
  const GlobPieces pieces = split_globs("hat*:fourier*-*penalty*:x");
  EXPECT_EQ(pieces.positive, (std::vector<std::string>{"hat*", "fourier*"}));
  EXPECT_EQ(pieces.negative, (std::vector<std::string>{"*penalty*", "x"}));
}

TEST(SplitGlobs, KeepsTheDashesOfNames) {
  EXPECT_EQ(split_globs("hat-lcp:penalty-hbm").positive,
            (std::vector<std::string>{"hat-lcp", "penalty-hbm"}));
  const GlobPieces pieces = split_globs("hat-lcp:-event-driven");
  EXPECT_EQ(pieces.positive, (std::vector<std::string>{"hat-lcp"}));
  EXPECT_EQ(pieces.negative, (std::vector<std::string>{"event-driven"}));
}

TEST(SplitGlobs, NeverSplitsInsideBrackets) {
  const GlobPieces pieces = split_globs("a[t=1e-6|1e-9]:b[x=*-1]-c");
  EXPECT_EQ(pieces.positive, (std::vector<std::string>{"a[t=1e-6|1e-9]", "b[x=*-1]"}));
  EXPECT_EQ(pieces.negative, (std::vector<std::string>{"c"}));
}

TEST(FilterMatches, WithOnlyNegativePiecesMeansAllOthers) {
  EXPECT_TRUE(filter_matches("-sdof*", "chain2-stop"));
  EXPECT_FALSE(filter_matches("-sdof*", "sdof-stop"));
  EXPECT_TRUE(filter_matches("", "anything"));
  EXPECT_FALSE(filter_matches("sdof-stop*-*e05", "sdof-stop-e05"));
}

TEST(SceneFilterMatches, ALevelHoweverItIsSpelt) {
  for (const char* filter : {"grazing@1e-2", "grazing@0.01", "graz*@.01", "grazing@*", "grazing*", "-sdof*"})
    EXPECT_TRUE(scene_filter_matches(filter, "grazing@0.01")) << filter;
  for (const char* filter : {"grazing@1e-3", "grazing@", "grazing", "*-grazing@1e-2", "@0.01"})
    EXPECT_FALSE(scene_filter_matches(filter, "grazing@0.01")) << filter;
  EXPECT_TRUE(scene_filter_matches("grazing@0.0001", "grazing@1e-4"));
}

}  // namespace
}  // namespace signorini::glob_test
