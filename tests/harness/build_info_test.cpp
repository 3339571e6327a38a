#include "harness/build_info.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "methods/catalogue.hpp"

namespace signorini::build_info_test {
namespace {

TEST(BuildInfo, NamesCompilerFlagsAndLibraries) {
  const BuildInfo& info = build_info();
  EXPECT_FALSE(info.version.empty());
  EXPECT_NE(info.compiler.find(' '), std::string_view::npos) << "name and version";
  ASSERT_FALSE(info.libraries.empty());
  for (const auto& [name, version] : info.libraries) EXPECT_FALSE(version.empty()) << name;
}

// Two lists of methods, that of the catalogue and that of the folders built, must agree: a method whose
// folder is not found would keep its old records when its code changes.
TEST(BuildInfo, HashesTheSourcesOfEveryMethodOfTheCatalogueApart) {
  std::set<std::string> folders;
  for (const auto& [folder, hash] : build_info().sources) {
    EXPECT_EQ(hash.size(), 64U) << folder;
    folders.insert(std::string(folder));
  }
  std::set<std::string> expected{""};
  for (const MethodEntry& entry : method_catalogue()) {
    std::string folder = entry.name;
    std::replace(folder.begin(), folder.end(), '-', '_');
    expected.insert(folder);
  }
  EXPECT_EQ(folders, expected);
}

TEST(CodeVersion, TellsTheCodeOfTwoMethodsApartAndKnowsTheCommonCodeOfAPlugin) {
  EXPECT_NE(code_version("hat-lcp"), code_version("penalty-hbm"));
  EXPECT_NE(code_version("hat-lcp"), code_version("no-method-of-the-tree"));
  EXPECT_EQ(code_version("no-method-of-the-tree"), code_version("another"));
  EXPECT_EQ(code_version("hat-lcp").size(), 16U);
}

}  // namespace
}  // namespace signorini::build_info_test
