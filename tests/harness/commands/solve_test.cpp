// `signorini solve`.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::solve_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandSolve, SolvesAndPrintsOneRecordThatStartsAnotherSolve) {
  const Outcome first =
      run("solve sdof-stop --method fourier-lipschitz --set harmonics=40 --json --samples 64");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 1);
  const Json json = Json::parse(first.out);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["options"]["harmonics"], 40);
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

// What the projected equations are worth by themselves, and with the law of impact asked of all harmonics.
TEST(CommandSolve, TellsTheErrorsOfHarmonicBalanceByItsOwnEquationsAndWithImpactsClosed) {
  const auto error = [](const std::string& method) {
    const Outcome outcome = run("solve sdof-stop --json --set harmonics=20 --method " + method);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out)["errors"]["x_l2"].get<double>();
  };
  EXPECT_NEAR(error("fourier-lipschitz"), 0.1447807, 1e-7);
  EXPECT_NEAR(error("closed-hbm"), 0.0018078586759211867, 1e-12);
}

// A contact much shorter than a step of the samples: the mass, at the speed v, presses a spring by v / sqrt(k
// / m).
TEST(CommandSolve, TellsHowFarAStiffStopIsPressed) {
  const auto file = test::fresh_folder("stiff") / "stiff.toml";
  std::ofstream(file)
      << "schema = 1\nname = \"stiff\"\nsystem = { kind = \"sdof\", mass = 1.0, damping = 0.1, stiffness = "
         "1.0 }\nforcing = { frequency = 2.2, term = [{ dof = 0, cos = 1.0 }] }\n"
         "contact = [{ dof = 0, gap = 0.0, penalty = 1e9 }]\n";
  const Outcome outcome = run("solve --json --method exact-orbit " + file.string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json motion = Json::parse(outcome.out)["motion"];
  const double impulse = motion["contact_phases"][0]["impulse"].get<double>();  // 2 m v
  EXPECT_NEAR(motion["x"][0]["max"].get<double>(), -0.5 * impulse / std::sqrt(1e9), 2e-8);
}

TEST(CommandSolve, NamesTheMethodThatHasAnOptionWhichIsNoLongerOneOfThisMethod) {
  for (const std::string method : {"fourier-lipschitz", "penalty-hbm", "aft-hbm", "augmented-lagrangian"}) {
    const Outcome outcome = run("solve sdof-stop --set compensate=true --method " + method);
    EXPECT_EQ(outcome.code, 2) << method;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("closed-hbm"), std::string::npos) << outcome.err;
  }
}

TEST(CommandSolve, ReportsASolveInWords) {
  const Outcome outcome = run("solve sdof-stop --method hat-lcp");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("sdof-stop/hat-lcp: converged", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("error of x"), std::string::npos);
}

// The stop is at 0.2 m, and no sample meets the impact.
TEST(CommandSolve, TellsWhatTheMotionDoes) {
  const Outcome outcome = run("solve sdof-stop --method exact-orbit --dofs 0 --samples 16 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out), &motion = json["motion"];
  EXPECT_NEAR(motion["x"][0]["max"].get<double>(), 0.2, 1e-12);
  EXPECT_EQ(motion["x"][0]["harmonics"].size(), 5U);
  ASSERT_EQ(motion["impacts"].size(), 1U);
  const Json& impact = motion["impacts"][0];
  EXPECT_EQ(impact["time"], json["certificate"]["events"][0]["time"]);
  EXPECT_NEAR(impact["speed_after"].get<double>(), -impact["speed_before"].get<double>(), 1e-5);  // e = 1
  // m = 1 kg: the impulse is the jump of momentum.
  EXPECT_NEAR(impact["impulse"].get<double>(), -2.0 * impact["speed_before"].get<double>(), 1e-5);
  EXPECT_TRUE(motion["contact_phases"].empty());
  EXPECT_NEAR(motion["u"][0]["max"].get<double>(), 0.2, 1e-7) << "the coordinate is the contact";
  EXPECT_NEAR(motion["u"][0]["min"].get<double>(), motion["x"][0]["min"].get<double>(), 1e-7);
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_NEAR(json["trajectory"]["u"][0][i].get<double>(), json["trajectory"]["x"][0][i].get<double>(),
                1e-7);
}

// Every method's coordinate at the contact is its contact displacement.
TEST(CommandSolve, TellsTheMotionOfCoordinatesByEveryMethod) {
  for (const std::string method : {"exact-orbit", "event-driven", "closed-hbm", "hat-lcp"}) {
    const Outcome outcome = run("solve chain3-stop --method " + method + " --dofs 2,0 --harmonics 2 --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out), &motion = json["motion"];
    ASSERT_EQ(motion["u"].size(), 2U);
    EXPECT_EQ(motion["u"][1]["dof"], 0);
    const double amplitude = motion["x"][0]["amplitude"];
    for (const char* key : {"min", "max", "mean"}) {
      EXPECT_NEAR(motion["u"][0][key].get<double>(), motion["x"][0][key].get<double>(), 0.02 * amplitude)
          << method << " " << key;
    }
    // Series of few harmonics round the corner of an impact off.
    const bool resolved = method == "exact-orbit" || method == "event-driven";
    EXPECT_NEAR(motion["x"][0]["max"].get<double>(), 0.5, (resolved ? 1e-9 : 0.1) * amplitude) << method;
  }
}

TEST(CommandSolve, RefusesCoordinatesThatTheSceneHasNot) {
  const Outcome outcome = run("solve sdof-stop --method exact-orbit --dofs 0,1");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "dofs = 1 (must be coordinates of the scene, 0 to 0)\n");
}

TEST(CommandSolve, PrintsTheMotionThenTheJudgementOnOneScreen) {
  for (const std::string scene : {"sdof-stop", "chain10-stops", "sdof-chatter"}) {
    const Outcome outcome = run("solve " + scene + " --method exact-orbit");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 40) << outcome.out;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
    std::size_t last = 0;
    for (const char* part :
         {"converged\nstability             stable, largest Floquet multiplier ", "\ndisplacement ",
          "\nimpacts ", "\ncontact phases ", "\nharmonics ", "\ncertified by orbit ", "\nerror of x "}) {
      const std::size_t at = outcome.out.find(part);
      ASSERT_NE(at, std::string::npos) << part << outcome.out;
      EXPECT_GT(at, last) << part;
      last = at;
    }
  }
}

// A method that converges may be judged otherwise.
TEST(CommandSolve, SaysInTheFirstLinesWhatTheJudgementIs) {
  const Outcome outcome = run("solve sdof-stop-e0 --method hat-lcp --set samples=512 --set plain=true");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("sdof-stop-e0/hat-lcp[samples=512,plain=true]: inaccurate\n  ", 0), 0U)
      << outcome.out;
  EXPECT_NE(outcome.out.find("\nerror of x "), std::string::npos) << outcome.out;
}

TEST(CommandSolve, TellsAnUnstableMotionWhereItBegins) {
  const Outcome outcome = run("solve chaos@2.97 --method exact-orbit");
  EXPECT_EQ(outcome.out.rfind("chaos@2.97/exact-orbit: converged\nstability             unstable, largest "
                              "Floquet multiplier 4.369 (modulus); ",
                              0),
            0U)
      << outcome.out;
}

TEST(CommandSolve, TakesALimitOfTime) {
  EXPECT_EQ(run("solve sdof-stop --method exact-orbit --timeout 5").code, 0);
  const Outcome refused = run("solve sdof-stop --method exact-orbit --timeout 0");
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
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
  EXPECT_NE(outcome.out.find("from rest: not checked, see --reference)"), std::string::npos)
      << outcome.out << outcome.err;
}

}  // namespace
}  // namespace signorini::solve_test
