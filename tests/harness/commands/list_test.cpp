// `signorini list`.

#include <gtest/gtest.h>

#include <string>

#include "tests/harness/program.hpp"

namespace signorini {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandList, ListsMethodsScenesAndSuites) {
  EXPECT_NE(run("list methods").out.find("fourier-lipschitz"), std::string::npos);
  EXPECT_NE(run("list scenes").out.find("sdof-stop"), std::string::npos);
  EXPECT_NE(run("list suites").out.find("quick"), std::string::npos);
  const Outcome all = run("list");
  EXPECT_EQ(all.code, 0);
  for (const char* name : {"hat-lcp", "sdof-stop", "smoke"}) EXPECT_NE(all.out.find(name), std::string::npos);
}

}  // namespace
}  // namespace signorini
