#include "problems/files/kebab_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace signorini::kebab_case_test {
namespace {

TEST(IsLowerKebabCase, AcceptsLettersDigitsAndSingleDashesBetweenThem) {
  for (const std::string_view name : {"a", "7", "sdof-stop", "chain2-stop", "a-1-b"})
    EXPECT_TRUE(is_lower_kebab_case(name)) << name;
}

TEST(IsLowerKebabCase, RefusesEverythingElse) {
  for (const std::string_view name : {"", "-a", "a-", "a--b", "A", "a_b", "a b", "a.b", "\u00e9", "../a"})
    EXPECT_FALSE(is_lower_kebab_case(name)) << name;
}

TEST(IsLowerKebabCase, EndsAtTheLongestName) {
  EXPECT_TRUE(is_lower_kebab_case(std::string(kLongestName, 'a')));
  EXPECT_FALSE(is_lower_kebab_case(std::string(kLongestName + 1, 'a')));
}

TEST(IsSceneName, IsANameOrOneOfAFamilyWithItsLevel) {
  for (const std::string_view name : {"sdof-stop", "grazing@1e-4", "preload@-0.9", "units@1000000"})
    EXPECT_TRUE(is_scene_name(name)) << name;
  for (const std::string_view name : {"", "@1", "a@", "a@x", "a@1/2", "a@1@2", "a/b", "../a", "a'b", "A@1"})
    EXPECT_FALSE(is_scene_name(name)) << name;
}

}  // namespace
}  // namespace signorini::kebab_case_test
