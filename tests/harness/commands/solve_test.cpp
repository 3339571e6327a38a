// `signorini solve`.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandSolve, SolvesAndPrintsOneRecordThatStartsAnotherSolve) {
  const Outcome first =
      run("solve sdof-stop --method fourier-lipschitz --set harmonics=10 --json --samples 64");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 1);
  const Json json = Json::parse(first.out);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["options"]["harmonics"], 10);
  EXPECT_EQ(json["trajectory"]["t"].size(), 64U);
  EXPECT_EQ(json["trajectory"]["x"][0].size(), 64U);
  EXPECT_EQ(json["certificate"]["status"], "certified");
  EXPECT_LT(json["errors"]["x_l2"].get<double>(), 0.5);
  const auto file = test::fresh_folder("start") / "first.json";
  std::ofstream(file) << first.out;
  const Outcome second =
      run("solve sdof-stop --method event-driven --set steady=shooting --json --start " + file.string());
  ASSERT_EQ(second.code, 0) << second.err << second.out;
  EXPECT_LT(Json::parse(second.out)["errors"]["x_l2"].get<double>(), 1e-6);
}

TEST(CommandSolve, ReportsASolveInWords) {
  const Outcome outcome = run("solve sdof-stop --method hat-lcp");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("sdof-stop/hat-lcp: converged", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("error of x"), std::string::npos);
}

}  // namespace
}  // namespace signorini
