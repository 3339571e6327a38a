// `signorini motion`.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/harness/program.hpp"

namespace signorini::motion_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandMotion, TellsWhereEachStartSettles) {
  const Outcome text = run("motion sdof-stop --starts 2");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(text.out.rfind("from rest: periodic, order 1, after ", 0), 0U) << text.out;
  EXPECT_NE(text.out.find("\nfrom random state 1: periodic"), std::string::npos) << text.out;
  const Outcome outcome = run("motion sdof-stop --starts 2 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json motion = Json::parse(outcome.out);
  EXPECT_EQ(motion["verdict"], "periodic");
  EXPECT_EQ(motion["order"], 1);
  EXPECT_EQ(motion["orbit"]["stable"], true);
  EXPECT_EQ(motion["starts"].size(), 3U);
  EXPECT_EQ(motion["starts"][2]["start"], "random state 1");
  EXPECT_EQ(motion["lyapunov"].size(), 2U);
  for (const char* key :
       {"x_mean", "x_rms", "x_min", "x_max", "force_rms", "force_peak", "impulse_per_second",
        "impacts_per_second", "impulse_mean", "impulse_deviation", "power"})
    EXPECT_TRUE(motion["contacts"][0].contains(key)) << key;
  EXPECT_TRUE(motion["contacts"][0]["force_peak"].is_null()) << "impacts have no width";
}

TEST(CommandMotion, TakesStatesAndWritesTheFirstPeriods) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("signorini-motion-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "states.txt") << "# u v\n0.1 0.0\n";
  std::ofstream(folder / "short.txt") << "0.1 0.0\n0.1\n";
  const std::string scene = "motion sdof-stop --from-state " + (folder / "states.txt").string();
  const Outcome outcome = run(scene + " --first 3 --waveform " + (folder / "first.csv").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("from line 2: periodic", 0), 0U) << outcome.out;
  std::ifstream csv(folder / "first.csv");
  std::string header, first;
  std::getline(csv, header);
  std::getline(csv, first);
  EXPECT_EQ(header, "t [s],x0 [m],velocity0 [m/s],force0 [N]");
  EXPECT_EQ(first.rfind("0,0.1", 0), 0U) << first;
  const Outcome bad = run("motion sdof-stop --from-state " + (folder / "short.txt").string());
  EXPECT_EQ(bad.code, 2);
  EXPECT_NE(bad.err.find("line 2 must hold 2 numbers"), std::string::npos) << bad.err;
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace signorini::motion_test
