// `signorini orbits`.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/harness/program.hpp"

namespace signorini::orbits_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandOrbits, ListsTheOrbitsOfAScene) {
  const Outcome table = run("orbits sdof-subharmonic --starts 8 --subharmonics 2");
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_EQ(table.out.rfind("orbit ", 0), 0U) << table.out;
  EXPECT_NE(table.out.find("\n* the motion reached from rest\n"), std::string::npos) << table.out;
  std::istringstream lines(table.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_NE(table.out.find("unstable"), std::string::npos) << table.out;
  const Outcome outcome = run("orbits sdof-subharmonic --starts 8 --subharmonics 2 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json orbits = Json::parse(outcome.out);
  ASSERT_GE(orbits.size(), 2U);
  for (const char* key : {"orbit", "order", "period", "amplitude", "impacts", "error_bar", "floquet",
                          "stable", "events", "found_by", "starts", "from_rest"}) {
    EXPECT_TRUE(orbits[0].contains(key)) << key;
  }
  EXPECT_EQ(orbits[0]["order"], 1);
}

// Between two stops at 0.5 m that are both met the amplitude is 0.5 m, whatever the samples.
TEST(CommandOrbits, HasExactAmplitudes) {
  const Outcome outcome = run("orbits sdof-two-sided --starts 0 --subharmonics 1 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(Json::parse(outcome.out)[0]["amplitude"].get<double>(), 0.5, 1e-11);
}

TEST(CommandOrbits, ExitsWithOneWhereNoOrbitIsFound) {
  const Outcome outcome = run("orbits sdof-stop --starts 0 --timeout 1e-9");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("no certified orbit"), std::string::npos) << outcome.err;
  EXPECT_NE(
      outcome.err.find("no stable motion of order <= 3 was found among 0 starts: signorini motion sdof-stop"),
      std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace signorini::orbits_test
