#include <gtest/gtest.h>

#include <fstream>

#include "harness/extend/scaffold/scaffold.hpp"
#include "harness/failure.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::source_tree_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCatalogue =
    "#include \"methods/catalogue.hpp\"\n\n"
    "#include \"methods/aft_hbm/aft_hbm.hpp\"\n"
    "#include \"methods/penalty_hbm/penalty_hbm.hpp\"\n\n"
    "      method_entry<AftHbm>(),\n"
    "      method_entry<PenaltyHbm>(),\n"
    "  };\n";

TEST(WithEntry, AddsTwoLinesInTheirPlaces) {
  EXPECT_EQ(with_entry(kCatalogue, "my_method", "MyMethod"),
            "#include \"methods/catalogue.hpp\"\n\n"
            "#include \"methods/aft_hbm/aft_hbm.hpp\"\n"
            "#include \"methods/my_method/my_method.hpp\"\n"
            "#include \"methods/penalty_hbm/penalty_hbm.hpp\"\n\n"
            "      method_entry<AftHbm>(),\n"
            "      method_entry<PenaltyHbm>(),\n"
            "      method_entry<MyMethod>(),\n"
            "  };\n");
  const std::string last = with_entry(kCatalogue, "zz", "Zz");
  EXPECT_NE(last.find("penalty_hbm.hpp\"\n#include \"methods/zz/zz.hpp\"\n\n"), std::string::npos) << last;
}

TEST(WithEntry, RefusesACatalogueWithoutAList) {
  EXPECT_THROW(static_cast<void>(with_entry("int main() {}\n", "my_method", "MyMethod")), UsageError);
}

TEST(FindTree, IsTheNearestFolderAboveThatHoldsTheList) {
  const fs::path tree = test::fresh_folder("find-tree");
  fs::create_directories(tree / "methods" / "solvers");
  EXPECT_FALSE(find_tree(tree / "methods" / "solvers").has_value());
  std::ofstream(tree / "methods" / "catalogue.cpp") << kCatalogue;
  EXPECT_EQ(find_tree(tree / "methods" / "solvers"), tree);
  EXPECT_EQ(find_tree(tree), tree);
}

TEST(HeaderDeclaring, FindsClassesStructsAndAliasesByTheirWholeName) {
  const fs::path tree = test::fresh_folder("declares");
  fs::create_directories(tree / "methods");
  std::ofstream(tree / "methods" / "some.hpp") << "class Motion;\nstruct Orbit {};\nusing Law = int;\n";
  std::ofstream(tree / "methods" / "some.cpp") << "class Hidden {};\n";
  for (const char* type : {"Motion", "Orbit", "Law"})
    EXPECT_EQ(header_declaring(tree, type), "methods/some.hpp") << type;
  for (const char* type : {"Mot", "Orbits", "Hidden"})
    EXPECT_FALSE(header_declaring(tree, type).has_value()) << type;
}

}  // namespace
}  // namespace signorini::source_tree_test
