#include "harness/extend/scaffold/templates.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace {

TEST(Filled, ReplacesEveryPlaceAndEndsWithOneLineBreak) {
  const Places places{{"name", "my-method"}, {"Class", "MyMethod"}, {"entry", ""}};
  EXPECT_EQ(filled("{{name}}: {{Class}}, {{name}}\n{{entry}}\n", places), "my-method: MyMethod, my-method\n");
  EXPECT_EQ(filled("nothing to fill\n", places), "nothing to fill\n");
}

TEST(Filled, LeavesSingleBracesAlone) {
  EXPECT_EQ(filled("struct {{Class}} { int i{}; };\n", {{"Class", "A"}}), "struct A { int i{}; };\n");
}

}  // namespace
}  // namespace signorini
