// Points of branches at values asked for, branches line by line, special points over a second number.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <tuple>

#include "harness/failure.hpp"
#include "harness/sweep/bifurcation_response.hpp"
#include "tests/harness/program.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::sweep_points_test {
namespace {

nlohmann::json branches_at(const std::string& methods, const std::string& values) {
  const test::Outcome outcome = test::run_program("sweep sdof-stop --methods " + methods +
                                                  " --from 1.5 --to 4.5 --format json --at " + values);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out)["branches"];
}

// At 3.0 one motion is free of contact and two hit once in two periods; their speeds are those of the closed
// form, their amplitudes larger than nothing.
TEST(CommandSweep, HasPointsExactlyAtTheValuesAskedFor) {
  int free = 0, impacting = 0;
  for (const auto& branch : branches_at("exact-orbit", "2.2,3.0")) {
    for (const auto& point : branch["points"]) {
      const double w = point["omega"];
      EXPECT_LT(std::min(std::abs(w - 2.2), std::abs(w - 3.0)), 1e-12);
      if (std::abs(w - 3.0) > 1e-9) continue;
      if (point["impacts"] == 0) {
        ++free;
        EXPECT_NEAR(point["amplitude"][0], std::abs(1.0 / std::complex<double>(1.0 - 9.0, 0.3)), 1e-12);
      }
      if (point["order"] == 2 && point["impacts"] == 1) ++impacting;
    }
  }
  EXPECT_EQ(free, 1);
  EXPECT_EQ(impacting, 2);
}

// The branch of two impacts in two periods turns at 0.44061 (fold) and passes the value before and after.
TEST(CommandSweep, HasThePointsOnBothSidesOfAFoldBesideAValue) {
  const test::Outcome outcome = test::run_program(
      "sweep sdof-stop-e08 --methods exact-orbit --parameter contact[0].gap --from 0.5713259483349847 "
      "--to 0.2671529230327454 --at 0.44048706933669846 --format json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  int of_two_impacts = 0;
  const auto branches = nlohmann::json::parse(outcome.out)["branches"];
  for (const auto& branch : branches)
    for (const auto& point : branch["points"]) of_two_impacts += point["impacts"] == 2 ? 1 : 0;
  EXPECT_EQ(of_two_impacts, 2);
}

// A peak of hundreds of units is on the curve. Of a bilinear oscillator, half waves of 10 and of 100.499
// rad/s, what the load puts in and the damper takes out are equal at a speed of F a / d, a = 0.8964297 the
// first harmonic of that motion: an amplitude of 4.9281e-4 m, to the order of the damping, though 2.1e-6 m
// where the interval begins.
TEST(CommandSweep, GoesOverAPeakOfHundredsOfUnits) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("peak.toml", R"(schema = 1
name = "peak"
title = "code_aster V5.01.101 near its resonance"
system = { kind = "sdof", mass = 100.0, damping = 1.0, stiffness = 1e4 }
forcing = { frequency = 18.19006, term = [{ dof = 0, cos = 0.01 }] }
contact = [{ dof = 0, gap = 0.0 }]
law = { penalty = 1e6 }
)");
  for (const char* method : {"exact-orbit", "penalty-hbm"}) {
    const test::Outcome outcome = test::run_program("sweep " + file.string() + " --methods " + method +
                                                    " --from 17 --to 19 --format json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto branches = nlohmann::json::parse(outcome.out)["branches"];
    ASSERT_EQ(branches.size(), 1U) << method;
    double largest = 0.0;
    for (const auto& point : branches[0]["points"])
      largest = std::max(largest, point["amplitude"][0].get<double>());
    EXPECT_NEAR(largest, 4.9281e-4, 0.01 * 4.9281e-4) << method;
  }
}

TEST(CommandSweep, HasSuchPointsOfTheCurvesOfMethodsToo) {
  for (const char* method : {"fourier-lipschitz", "hat-lcp", "aft-hbm"}) {
    int points = 0;
    for (const auto& branch : branches_at(method, "2.9,3.0,4.0")) {
      for (const auto& point : branch["points"]) {
        const double w = point["omega"];
        EXPECT_LT(std::min({std::abs(w - 2.9), std::abs(w - 3.0), std::abs(w - 4.0)}), 1e-10) << method;
        ++points;
      }
    }
    EXPECT_GE(points, 3) << method;  // contact-free motions at least
  }
}

TEST(CommandSweep, TakesHertz) {
  const std::string sweep = "sweep sdof-stop --method exact-orbit --format json ";
  const test::Outcome outcome = test::run_program(sweep + "--hz --from 0.5 --to 0.6 --points 2");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto points = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0]["frequency"], std::numbers::pi, 1e-15);
  EXPECT_NEAR(points[1]["frequency"], 1.2 * std::numbers::pi, 1e-15);
  EXPECT_EQ(nlohmann::json::parse(test::run_program(sweep + "--hz --at 0.5").out)[0]["frequency"],
            points[0]["frequency"]);
  const test::Outcome refused = test::run_program(
      "sweep sdof-stop --methods exact-orbit --hz --parameter contact[0].gap --from 1 --to 2");
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err, "hz (must be left out with --parameter contact[0].gap)\n");
}

// A line per branch; the branches are those of the JSON answer.
TEST(CommandSweep, PrintsBranchesLineByLine) {
  const std::string command =
      "sweep sdof-stop --methods exact-orbit:hat-lcp --set samples=64 --from 2.3 --to 3 ";
  const test::Outcome whole = test::run_program(command + "--format json");
  const test::Outcome lines = test::run_program(command + "--format jsonl");
  ASSERT_EQ(lines.code, whole.code) << lines.err;
  auto branches = nlohmann::json::array();
  std::istringstream in(lines.out);
  for (std::string line; std::getline(in, line);) branches.push_back(nlohmann::json::parse(line));
  EXPECT_EQ(branches, nlohmann::json::parse(whole.out)["branches"]);
}

TEST(CommandSweep, PrintsStepsLineByLineAtTheFrequenciesAskedFor) {
  const test::Outcome outcome =
      test::run_program("sweep sdof-stop --method exact-orbit --at 3.1,3,3.3 --format jsonl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream in(outcome.out);
  std::vector<double> frequencies;
  for (std::string line; std::getline(in, line);) {
    const auto step = nlohmann::json::parse(line);
    EXPECT_EQ(step["method"], "exact-orbit");
    frequencies.push_back(step["frequency"]);
  }
  EXPECT_EQ(frequencies, (std::vector<double>{3.1, 3.0, 3.3}));
}

TEST(CommandSweep, FollowsFoldsOverASecondNumber) {
  const test::Outcome outcome = test::run_program(
      "sweep sdof-stop --methods exact-orbit --from 1.5 --to 4.5 --follow fold --second law.restitution "
      "--second-from 1 --second-to 0.5 --format json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto response = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(response["second"], "law.restitution");
  double nearest = 1e300;
  for (const auto& curve : response["curves"]) {
    EXPECT_EQ(curve["kind"], "fold");
    const auto& last = curve["points"].back();
    if (std::abs(last["second"].get<double>() - 0.5) < 1e-12)
      nearest = std::min(nearest, std::abs(last["omega"].get<double>() - 3.4543608376498));
  }
  EXPECT_LT(nearest, 1e-9);
}

// At the whole load it ends where the forced response has its phase resonance located.
TEST(CommandSweep, FollowsTheBackboneToThePeakOfTheResponse) {
  const test::Outcome outcome = test::run_program("sweep sdof-penalty-soft --backbone --format json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto backbone = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(backbone["second"], "load-factor");
  ASSERT_EQ(backbone["curves"].size(), 2U);
  const auto& first = backbone["curves"][0]["points"][0];
  EXPECT_NEAR(first["second"].get<double>(), 0.01, 1e-15);
  EXPECT_NEAR(first["omega"].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(first["damping_ratio"].get<double>(), 0.05, 1e-13);
  EXPECT_EQ(first["stability"], "stable");
  const auto& end = backbone["curves"][1]["points"].back();
  EXPECT_NEAR(end["second"].get<double>(), 1.0, 1e-12);
  const test::Outcome forced = test::run_program(
      "sweep sdof-penalty-soft --methods exact-orbit --from 0.95 --to 2 --max-order 1 --format json");
  const auto response = nlohmann::json::parse(forced.out);
  double nearest = 1e300;
  for (const auto& branch : response["branches"]) {
    for (const auto& special : branch["special"]) {
      if (special["kind"] == "phase-resonance")
        nearest = std::min(nearest, std::abs(special["omega"].get<double>() - end["omega"].get<double>()) +
                                        std::abs(special["damping_ratio"].get<double>() -
                                                 end["damping_ratio"].get<double>()));
    }
  }
  EXPECT_LT(nearest, 1e-9);
}

// Exit code 1 and one line where nothing is found, 2 where nothing can be, 6 where a limit ends a curve.
TEST(CommandSweep, SaysWhyThereIsNoBackbone) {
  for (const auto& [arguments, code, words] :
       {std::tuple("sdof-two-harmonics --from 0.9 --to 1.1", 1, "the load has more than one harmonic"),
        std::tuple("sdof-penalty-soft --from 2.5 --to 3", 1, "no phase-resonance at load-factor = 0.01"),
        std::tuple("sdof-penalty-soft --max-points 5", 6, "INCOMPLETE: "),
        std::tuple("sdof-contact-free", 2, "--from and --to are required"),
        std::tuple("sdof-penalty-soft --second-from -1", 2, "must be above 0"),
        std::tuple("sdof-penalty-soft --follow fold", 2, "must stand without --follow")}) {
    const test::Outcome outcome = test::run_program(std::string("sweep --backbone ") + arguments);
    EXPECT_EQ(outcome.code, code) << arguments << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << arguments << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << outcome.err;
  }
}

TEST(CommandSweep, RefusesValuesAndSecondNumbersThatAreNoneInOneLine) {
  const std::string branches = "sweep sdof-stop --methods exact-orbit ", range = "--from 1.5 --to 4.5 ";
  for (const std::string& arguments :
       {branches + "--from 2 --to 3 --at 4", branches + "--from 2", branches + "--at 2.2",
        branches + "--at -1,2", branches + "--at x",
        branches + range + "--follow cusp --second law.restitution", branches + range + "--follow fold",
        branches + range + "--follow fold --second law.none --second-from 1 --second-to 0.5",
        branches + range + "--follow fold --second law.restitution --second-from 1 --second-to 1",
        branches + range + "--follow fold --second law.restitution --second-from 1 --second-to 2",
        branches + range + "--follow fold --second forcing.frequency --second-from 1 --second-to 2",
        std::string(
            "sweep sdof-stop --methods hat-lcp --from 1 --to 2 --follow fold --second law.restitution "
            "--second-from 1 --second-to 0.5")}) {
    const test::Outcome outcome = test::run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << outcome.err;
  }
}

// Figure 17 of Vadcard, Batailly and Thouverez (2022) as others have computed it again: harmonic balance with
// 20 harmonics.
TEST(ExactBranches, FoldWhereThePublishedRodDoes) {
  struct Published {
    const char* scene;
    double upper, lower, tolerance;  // [rad/s]
  };
  for (const Published& rod : {Published{"rod-penalty@0.4", 64892.9, 63848.3, 1.0},
                               Published{"rod-penalty@4", 69450.2, 63876.8, 30.0}}) {
    const Problem problem = read_scene(find_scene(rod.scene)).problem;
    const BranchDiagram diagram =
        branches_of(over_frequency(problem, 57000.0, 75000.0), {.entry = &exact_method()}, {}).value();
    for (const double fold : {rod.upper, rod.lower}) {
      double nearest = 1e300;
      for (const Branch& branch : diagram.branches) {
        for (const SpecialPoint& special : branch.special) {
          if (special.kind == SpecialKind::fold)
            nearest = std::min(nearest, std::abs(special.point.frequency - fold));
        }
      }
      EXPECT_LT(nearest, rod.tolerance) << rod.scene;
    }
    EXPECT_EQ(diagram.unfinished, "");
  }
}

}  // namespace
}  // namespace signorini::sweep_points_test
