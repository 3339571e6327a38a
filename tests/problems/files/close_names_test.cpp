#include "problems/files/close_names.hpp"

#include <gtest/gtest.h>

namespace signorini::close_names_test {
namespace {

using Names = std::vector<std::string>;

TEST(CloseNames, AreThoseAFewEditsAwayNearestFirst) {
  const Names known{"abcd", "abce", "bcde", "xyz", "abcdefgh"};
  EXPECT_EQ(close_names("abcd", known), (Names{"abcd", "abce", "bcde"}));
  EXPECT_EQ(close_names("xz", known), (Names{"xyz"}));
  EXPECT_EQ(close_names("abcdfgh", known), (Names{"abcdefgh"}));
}

TEST(CloseNames, AllowAQuarterOfALongWord) {
  const Names known{"event-driven-flow"};
  EXPECT_EQ(close_names("vent-drven-flw", known), known);  // 3 of 14
  EXPECT_TRUE(close_names("vnt-drvn-flw", known).empty());
}

TEST(CloseNames, AreNoneOfWordsThatShareNothing) {
  EXPECT_TRUE(close_names("", Names{"a", "ab"}).empty());
  EXPECT_TRUE(close_names("c", Names{"a", "ab"}).empty()) << "one edit makes any letter of any other";
  EXPECT_TRUE(close_names(std::string(1'000'000, 'a'), Names(1, std::string(1'000'000, 'a'))).empty());
}

TEST(Suggestion, IsTheEndOfARefusal) {
  EXPECT_EQ(suggestion("run", Names{"runn", "ran"}), "; did you mean ran, runn?");
  EXPECT_EQ(suggestion("run", Names{"solve"}), "");
}

}  // namespace
}  // namespace signorini::close_names_test
