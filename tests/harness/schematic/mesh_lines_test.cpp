#include "harness/schematic/mesh_lines.hpp"

#include <gtest/gtest.h>

namespace signorini::mesh_lines_test {
namespace {

TEST(MeshLines, AreAllInnerNodesOfCoarseMeshesAndNeverMoreThanForty) {
  EXPECT_EQ(mesh_lines(4), (std::vector{0.25, 0.5, 0.75}));
  EXPECT_TRUE(mesh_lines(1).empty());
  for (const int elements : {41, 200, 10000, 99999}) {
    const auto lines = mesh_lines(elements);
    EXPECT_LE(lines.size(), 40U) << elements;
    EXPECT_GE(lines.size(), 19U) << elements;
    EXPECT_LT(lines.back(), 1.0);
  }
}

TEST(ElementsText, TellsWhatIsLeftOut) {
  EXPECT_EQ(elements_text(1), "1 element");
  EXPECT_EQ(elements_text(40), "40 elements");
  EXPECT_EQ(elements_text(10000), "10000 elements (a line every 250)");
}

}  // namespace
}  // namespace signorini::mesh_lines_test
