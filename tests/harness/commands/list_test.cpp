// `signorini list`.

#include <gtest/gtest.h>

#include <string>

#include "tests/harness/program.hpp"

namespace signorini::list_test {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandList, ListsMethodsScenesAndSuites) {
  EXPECT_NE(run("list methods").out.find("fourier-lipschitz"), std::string::npos);
  EXPECT_NE(run("list scenes").out.find("sdof-stop"), std::string::npos);
  EXPECT_NE(run("list suites").out.find("quick"), std::string::npos);
  EXPECT_NE(run("list methods").out.find("\n  limits              First order in the step"),
            std::string::npos)
      << run("list methods").out;
  const Outcome all = run("list");
  EXPECT_EQ(all.code, 0);
  for (const char* name : {"hat-lcp", "sdof-stop", "smoke"}) EXPECT_NE(all.out.find(name), std::string::npos);
}

TEST(CommandList, ShowsScenesByNameOrTag) {
  const std::string beams = run("list scenes 'beam*'").out;
  EXPECT_EQ(beams.rfind("beam", 0), 0U) << beams;
  EXPECT_EQ(beams.find("\nsdof"), std::string::npos);
  EXPECT_NE(run("list scenes chain").out.find("chain3-stop"), std::string::npos);  // a tag
  EXPECT_EQ(run("list scenes chain").out.find("sdof-stop"), std::string::npos);
  const Outcome none = run("list scenes no-such-thing"), methods = run("list methods 'hat*'");
  EXPECT_EQ(none.code, 3) << none.err;
  EXPECT_EQ(methods.code, 2) << methods.err;
}

}  // namespace
}  // namespace signorini::list_test
