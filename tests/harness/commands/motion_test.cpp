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

// Two free bodies with a stop between them are one mass on the relative coordinate: m1 m2 / (m1 + m2), half
// the load. Their common flight is neither a torus nor part of the exponents; "at rest" are they only
// together.
TEST(CommandMotion, OfTwoFreeBodiesIsThatOfTheirRelativeCoordinate) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("signorini-pair-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string pair =
      "schema = 1\nsystem = { kind = \"chain\", masses = [1.0, 1.0], dampers = [0.0, 0.0], springs = [0.0, "
      "0.0] }\n"
      "contact = [{ between = [0, 1], gap = 0.2, restitution = 0.5 }]\nname = ";
  const std::string load = "forcing = { frequency = 2.2, term = [{ dof = 0, cos = ",
                    mean = "dof = 0, harmonic = 0, cos = 0.3 }";
  std::ofstream(folder / "pair.toml")
      << pair << "\"pair\"\n"
      << load << "1.0 }, { " << mean << ", { dof = 1, harmonic = 0, cos = -0.3 }] }\n";
  std::ofstream(folder / "pressed.toml")
      << pair << "\"pressed\"\n"
      << load << "0.3 }, { " << mean << ", { dof = 1, harmonic = 0, cos = -0.3 }] }\n";
  std::ofstream(folder / "one.toml")
      << "schema = 1\nname = \"one\"\nsystem = { kind = \"sdof\", mass = 0.5, damping = "
         "0.0, stiffness = 0.0 }\n"
      << load << "0.5 }, { " << mean << "] }\ncontact = [{ dof = 0, gap = 0.2, restitution = 0.5 }]\n";
  const auto told = [&](const std::string& name) {
    const Outcome outcome = run("motion --json " + (folder / (name + ".toml")).string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  };
  const Json one = told("one"), both = told("pair");
  EXPECT_EQ(both["verdict"], "periodic");
  EXPECT_EQ(both["order"], 2);
  EXPECT_EQ(both["orbit"]["orbit"], one["orbit"]["orbit"]);
  ASSERT_EQ(both["lyapunov"].size(), one["lyapunov"].size());
  EXPECT_NEAR(both["lyapunov"][0]["value"].get<double>(), one["lyapunov"][0]["value"].get<double>(), 1e-9);
  EXPECT_EQ(told("pressed")["verdict"], "periodic") << "together they swing with the load";
  std::filesystem::remove_all(folder);
}

// The face of a damped stop rests on its rigid end while it is pressed: the work of the force there is not
// that of the damper.
TEST(CommandMotion, KnowsNoPowerOfADampedStop) {
  const Outcome outcome = run("motion sdof-damped-stop --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(Json::parse(outcome.out)["contacts"][0]["power"].is_null());
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
