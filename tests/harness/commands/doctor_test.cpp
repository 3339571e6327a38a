// `signorini doctor`.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/harness/program.hpp"

namespace signorini::doctor_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandDoctor, ExaminesTheMachine) {
  const Outcome outcome = run("doctor --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const Json& finding : Json::parse(outcome.out)) {
    EXPECT_TRUE(finding.contains("name") && finding.contains("value") && finding.contains("good")) << finding;
    EXPECT_EQ(finding["good"].get<bool>(), !finding.contains("advice")) << finding;
  }
}

}  // namespace
}  // namespace signorini::doctor_test
