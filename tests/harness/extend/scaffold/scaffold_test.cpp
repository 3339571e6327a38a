// What `signorini new` writes, and what it refuses to write over.
#include "harness/extend/scaffold/scaffold.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/plan/plan.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::scaffold_test {

namespace {

namespace fs = std::filesystem;

constexpr const char* kCatalogue =
    "#include \"methods/catalogue.hpp\"\n\n"
    "#include \"methods/aft_hbm/aft_hbm.hpp\"\n"
    "#include \"methods/penalty_hbm/penalty_hbm.hpp\"\n\n"
    "      method_entry<AftHbm>(),\n"
    "      method_entry<PenaltyHbm>(),\n"
    "  };\n";

/// A folder that looks like a source tree.
fs::path small_tree(const std::string& name) {
  const fs::path tree = test::fresh_folder(name);
  fs::create_directories(tree / "methods" / "solvers");
  fs::create_directories(tree / "problems" / "catalogue");
  std::ofstream(tree / "methods" / "catalogue.cpp") << kCatalogue;
  std::ofstream(tree / "methods" / "solution.hpp") << "class Trajectory {\n};\nstruct Samples;\n";
  return tree;
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

std::size_t files_below(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file() ? 1 : 0;
  return count;
}

TEST(NewMethod, WritesItsFolderThatOfItsTestsAndTwoLinesElsewhere) {
  const fs::path tree = small_tree("new-method");
  const std::size_t before = files_below(tree);
  write_scaffold(method_in_tree("my-method", tree));
  EXPECT_EQ(files_below(tree), before + 6);
  for (const char* file :
       {"methods/my_method/my_method.hpp", "methods/my_method/my_method.cpp",
        "methods/my_method/CMakeLists.txt", "methods/my_method/README.md",
        "tests/methods/my_method/my_method_test.cpp", "tests/methods/my_method/CMakeLists.txt"}) {
    const std::string text = read_file(tree / file);
    EXPECT_EQ(text.find("{{"), std::string::npos) << file;
    EXPECT_TRUE(text.ends_with('\n') && !text.ends_with("\n\n")) << file;
    EXPECT_EQ(text.find("plugin"), std::string::npos) << file;
  }
  const std::string catalogue = read_file(tree / "methods" / "catalogue.cpp");
  EXPECT_EQ(std::count(catalogue.begin(), catalogue.end(), '\n'), 8 + 2);
}

/// Text of a CMakeLists.txt with the name of its method replaced by NAME.
std::string build_of(const fs::path& tree, const std::string& folder, const std::string& method) {
  std::string text = read_file(tree / folder / method / "CMakeLists.txt");
  for (std::size_t at = text.find(method); at != std::string::npos; at = text.find(method))
    text.replace(at, method.size(), "NAME");
  return text;
}

TEST(NewMethod, IsBuiltAsTheShippedMethodsAre) {
  const fs::path tree = small_tree("as-shipped"), shipped = SIGNORINI_SOURCE_TREE;
  write_scaffold(method_in_tree("my-method", tree));
  for (const char* folder : {"methods", "tests/methods"})
    EXPECT_EQ(build_of(tree, folder, "my_method"), build_of(shipped, folder, "hat_lcp")) << folder;
}

TEST(NewMethod, RefusesWhatIsTakenAndWritesNothing) {
  const fs::path tree = small_tree("taken");
  const std::size_t before = files_below(tree);
  const auto refused = [&](const char* name) {
    return refusal([&] { write_scaffold(method_in_tree(name, tree)); });
  };
  EXPECT_NE(refused("solvers").find("solvers is there already"), std::string::npos);
  EXPECT_NE(refused("trajectory").find("methods/solution.hpp declares Trajectory"), std::string::npos);
  EXPECT_NE(refused("hat-lcp").find("a method has this name"), std::string::npos);
  EXPECT_NE(refused("Bad").find("lower-kebab-case"), std::string::npos);
  EXPECT_EQ(files_below(tree), before);
  EXPECT_EQ(read_file(tree / "methods" / "catalogue.cpp"), kCatalogue);
}

TEST(NewMethod, TakesBackWhatItWroteIfTheListCannotBeChanged) {
  const fs::path tree = small_tree("half");
  Scaffold scaffold = method_in_tree("my-method", tree);
  scaffold.changed.front().path = tree / "no-such-folder" / "catalogue.cpp";
  EXPECT_NE(refusal([&] { write_scaffold(scaffold); }), "accepted");
  EXPECT_FALSE(fs::exists(tree / "methods" / "my_method"));
  EXPECT_FALSE(fs::exists(tree / "tests"));
}

TEST(NewMethod, InPythonIsAFunctionWithItsDescription) {
  const fs::path folder = test::fresh_folder("new-python-method");
  write_scaffold(method_in_python("my-method", folder));
  const std::string description = read_file(folder / "my-method" / "my-method.toml");
  EXPECT_NE(description.find("\"my_method.py\", \"solve\"]"), std::string::npos) << description;
  EXPECT_NE(read_file(folder / "my-method" / "my_method.py").find("name=\"my-method\""), std::string::npos);
  EXPECT_EQ(files_below(folder), 3U);
  EXPECT_NE(refusal([&] { (void)method_in_python("my-method", folder); }).find("is there already"),
            std::string::npos);
  EXPECT_NE(refusal([&] { (void)method_in_python("hat-lcp", folder); }).find("a method has this name"),
            std::string::npos);
}

TEST(NewMethod, OutOfTreeIsAPluginThatFindsAnInstalledSignorini) {
  const fs::path folder = test::fresh_folder("plugin");
  write_scaffold(method_out_of_tree("my-method", folder));
  const std::string build = read_file(folder / "my-method" / "CMakeLists.txt");
  EXPECT_NE(build.find("find_package(signorini REQUIRED)\n"
                       "signorini_add_plugin(my-method SOURCES my_method.cpp)\n"),
            std::string::npos)
      << build;
  const std::string source = read_file(folder / "my-method" / "my_method.cpp");
  EXPECT_TRUE(source.starts_with("#include \"my_method.hpp\"\n"));
  EXPECT_NE(source.find("#include \"methods/plugin/plugin.hpp\"\n"), std::string::npos);
  EXPECT_TRUE(source.ends_with("\nSIGNORINI_PLUGIN(signorini::MyMethod)\n"));
  EXPECT_NE(refusal([&] { (void)method_out_of_tree("my-method", folder); }).find("is there already"),
            std::string::npos);
}

TEST(NewScene, IsValidAndSaysWhatItsKeysAre) {
  const fs::path folder = test::fresh_folder("scene");
  write_scaffold(scene_out_of_tree("my-scene", folder));
  const Scene scene = read_scene(folder / "my-scene.toml");
  EXPECT_EQ(scene.problem.name, "my-scene");
  EXPECT_EQ(scene.problem.contact_count(), 1);
}

TEST(NewScene, GoesToTheCatalogueOfATreeUnlessItsNameIsTaken) {
  const fs::path tree = small_tree("scenes");
  write_scaffold(scene_in_tree("my-scene", tree));
  EXPECT_TRUE(fs::exists(tree / "problems" / "catalogue" / "my-scene.toml"));
  EXPECT_NE(refusal([&] { (void)scene_in_tree("my-scene", tree); }).find("is there already"),
            std::string::npos);
  fs::create_directories(tree / "problems" / "families");
  std::ofstream(tree / "problems" / "families" / "grazing.toml");
  EXPECT_NE(refusal([&] { (void)scene_in_tree("grazing", tree); }).find("is there already"),
            std::string::npos);
  EXPECT_NE(refusal([&] { (void)scene_in_tree("hat-lcp", tree); }).find("a method has this name"),
            std::string::npos);
}

TEST(CommandNew, FindsTheTreeAboveAndTellsWhatItDid) {
  const fs::path tree = small_tree("above");
  const test::Outcome outcome =
      test::run_program("new method my-method", (tree / "methods" / "solvers").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("my_method.hpp"), std::string::npos);
  EXPECT_NE(outcome.out.find("signorini check my-method"), std::string::npos);
  EXPECT_TRUE(fs::exists(tree / "methods" / "my_method" / "my_method.hpp"));
}

TEST(CommandNew, RefusesAMethodWhereThereIsNoTreeInOneLine) {
  const fs::path folder = test::fresh_folder("no-tree");
  const test::Outcome outcome = test::run_program("new method my-method", folder.string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(outcome.err.starts_with("tree = missing (must be")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(CommandNew, MakesASceneThatIsShownAndSolved) {
  const fs::path folder = test::fresh_folder("own-scene");
  ASSERT_EQ(test::run_program("new scene my-scene", folder.string()).code, 0);
  EXPECT_EQ(test::run_program("show ./my-scene.toml", folder.string()).code, 0);
  EXPECT_EQ(test::run_program("solve ./my-scene.toml --method exact-orbit", folder.string()).code, 0);
}

TEST(Filled, ReplacesEveryPlaceAndEndsWithOneLineBreak) {
  const Places places{{"name", "my-method"}, {"Class", "MyMethod"}, {"entry", ""}};
  EXPECT_EQ(filled("{{name}}: {{Class}}, {{name}}\n{{entry}}\n", places), "my-method: MyMethod, my-method\n");
  EXPECT_EQ(filled("nothing to fill\n", places), "nothing to fill\n");
}

TEST(Filled, LeavesSingleBracesAlone) {
  EXPECT_EQ(filled("struct {{Class}} { int i{}; };\n", {{"Class", "A"}}), "struct A { int i{}; };\n");
}

TEST(Spellings, OfANameAreItsFolderAndItsClass) {
  const Spellings spellings = spellings_of("my-2nd-method");
  EXPECT_EQ(spellings.folder, "my_2nd_method");
  EXPECT_EQ(spellings.type, "My2ndMethod");
}

TEST(Spellings, RefuseWhatIsNoKebabCase) {
  for (const char* name : {"", "-a", "a-", "a--b", "A", "a_b", "2a", "a b", "a/b", "..", "é"})
    EXPECT_NE(refusal([&] { (void)spellings_of(name); }).find("must be lower-kebab-case"), std::string::npos)
        << name;
  EXPECT_NE(refusal([] { (void)spellings_of(std::string(61, 'a')); }).find("at most 60"), std::string::npos);
}

TEST(Spellings, TakeTheLongestName) {
  EXPECT_EQ(refusal([] { (void)spellings_of(std::string(60, 'a')); }), "accepted");
}

}  // namespace

}  // namespace signorini::scaffold_test
