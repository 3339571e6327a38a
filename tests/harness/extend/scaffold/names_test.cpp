#include "harness/extend/scaffold/names.hpp"

#include <gtest/gtest.h>

#include "harness/failure.hpp"

namespace signorini {
namespace {

std::string refusal(const std::string& name) {
  try {
    static_cast<void>(spellings_of(name));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Spellings, OfANameAreItsFolderAndItsClass) {
  const Spellings spellings = spellings_of("my-2nd-method");
  EXPECT_EQ(spellings.folder, "my_2nd_method");
  EXPECT_EQ(spellings.type, "My2ndMethod");
}

TEST(Spellings, RefuseWhatIsNoKebabCase) {
  for (const char* name : {"", "-a", "a-", "a--b", "A", "a_b", "2a", "a b", "a/b", "..", "é"})
    EXPECT_NE(refusal(name).find("must be lower-kebab-case"), std::string::npos) << name;
  EXPECT_NE(refusal(std::string(61, 'a')).find("at most 60"), std::string::npos);
}

TEST(Spellings, TakeTheLongestName) { EXPECT_EQ(refusal(std::string(60, 'a')), "accepted"); }

}  // namespace
}  // namespace signorini
