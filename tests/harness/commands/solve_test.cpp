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

// The judgement may take its time, and may find otherwise.
TEST(CommandSolve, PrintsTheAnswerBeforeItIsJudgedAndThenTheVerdict) {
  const Outcome outcome = run("solve sdof-stop-e0 --method hat-lcp --set samples=512 --set plain=true");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("sdof-stop-e0/hat-lcp[samples=512,plain=true]: converged", 0), 0U)
      << outcome.out;
  const std::size_t verdict = outcome.out.find("\nverdict               inaccurate: ");
  ASSERT_NE(verdict, std::string::npos) << outcome.out;
  EXPECT_LT(verdict, outcome.out.find("error of x"));
}

TEST(CommandSolve, SaysOnceThatThereIsNoAnswer) {
  const Outcome failed = run("solve sdof-penalty-stiff --method hat-lcp --set samples=64");
  EXPECT_EQ(failed.code, 1);
  EXPECT_EQ(failed.out.find("verdict"), std::string::npos) << failed.out;
  EXPECT_EQ(failed.out.find("hat-lcp[samples=64]"), failed.out.rfind("hat-lcp[samples=64]")) << failed.out;
}

// Its motion from rest is not kept, and takes a minute to march to.
TEST(CommandSolve, SearchesNoReferenceUnlessAsked) {
  const auto folder = test::fresh_folder("solve-chaotic");
  std::ofstream(folder / "scene.toml")
      << "schema = 1\nname = \"wild\"\n[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.1187\nstiffness = "
         "1.0\n"
         "[forcing]\nfrequency = 2.841\n[[forcing.term]]\ndof = 0\ncos = 1.0\n[[contact]]\ndof = 0\n"
         "gap = 0.1136\n[law]\nrestitution = 0.5\n";
  const Outcome outcome = run("solve " + (folder / "scene.toml").string() + " --method hat-lcp");
  EXPECT_NE(outcome.out.find("no reference: not searched for"), std::string::npos)
      << outcome.out << outcome.err;
}

}  // namespace
}  // namespace signorini
