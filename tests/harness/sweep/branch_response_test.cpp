// The response by branches as users ask for it.
#include "harness/sweep/branch_response.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "harness/plan/plan.hpp"
#include "methods/exact_orbit/exact_diagram.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "tests/harness/program.hpp"
#include "tests/harness/sweep/random_scenes.hpp"
#include "tests/harness/sweep/sound_branches.hpp"

namespace signorini::branch_response_test {

namespace {

// Distance from a value to the nearest special point of a kind in the answer of the program.
double distance(const nlohmann::json& response, const std::string& kind, double omega) {
  double nearest = 1e300;
  for (const auto& branch : response["branches"]) {
    for (const auto& special : branch["special"]) {
      if (special["kind"] == kind)
        nearest = std::min(nearest, std::abs(special["omega"].get<double>() - omega));
    }
  }
  return nearest;
}

BranchDiagram exact_branches(const ParametrisedScene& scene, const CurveLimits& limits) {
  return branches_of(scene, {.entry = &exact_method()}, limits).value();
}

// x(t) = Re(e^{i w t} / (1 - w^2 + i c w)) where nothing touches; at twice the period both halves.
TEST(ExactBranches, KeepTheMotionAtEquidistantPhasesOfTheLoad) {
  const Problem problem = read_scene(find_scene("sdof-stop")).problem;
  CurveLimits limits;
  limits.phases = 16;
  const BranchDiagram diagram = exact_branches(over_frequency(problem, 3.0, 4.4), limits);
  bool free = false;
  for (const Branch& branch : diagram.branches) {
    for (const SolutionPoint& point : branch.points) {
      ASSERT_EQ(point.motion.rows(), 16 * point.order);
      EXPECT_LE(point.motion.maxCoeff(), point.x_max[0] + 1e-12);
      EXPECT_GT(point.motion.maxCoeff() - point.motion.minCoeff(), 1.8 * point.amplitude[0]);
      if (point.impacts > 0) continue;
      free = true;
      const double w = point.frequency;
      const std::complex<double> response = 1.0 / std::complex<double>(1.0 - w * w, 0.1 * w);
      for (Eigen::Index i = 0; i < point.motion.rows(); ++i) {
        const double phase = 2.0 * std::numbers::pi * static_cast<double>(i) / 16.0;
        EXPECT_NEAR(point.motion(i, 0), (response * std::polar(1.0, phase)).real(), 1e-11);
      }
    }
  }
  EXPECT_TRUE(free);
}

TEST(CommandSweep, HoldsTheSpecialPointsOfTheImpactOscillator) {
  struct Truth {
    const char* scene;
    double doubling, fold, doubling_of_two;
  };
  for (const Truth& truth : {Truth{"sdof-stop", 2.2647019400, 3.8553753210, 2.9125835787},
                             Truth{"sdof-stop-e08", 2.2652971760, 3.6934249832, 2.8875236601},
                             Truth{"sdof-stop-e05", 2.2646455610, 3.4543608376, 2.8104370993}}) {
    const test::Outcome outcome = test::run_program(
        std::string("sweep ") + truth.scene + " --methods exact-orbit --from 1.5 --to 4.5 --format json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto response = nlohmann::json::parse(outcome.out);
    EXPECT_LT(distance(response, "grazing", 2.448265181813), 1e-9) << truth.scene;
    EXPECT_LT(distance(response, "period-doubling", truth.doubling), 1e-9) << truth.scene;
    EXPECT_LT(distance(response, "fold", truth.fold), 1e-9) << truth.scene;
    EXPECT_LT(distance(response, "period-doubling", truth.doubling_of_two), 1e-9) << truth.scene;
    EXPECT_EQ(response["unfinished"], "");
    const auto short_ones = std::ranges::count_if(
        response["branches"], [](const auto& branch) { return branch["points"][0]["order"] <= 2; });
    EXPECT_EQ(short_ones, 4) << truth.scene;  // the orbit found at 1.5 lies on one of them
    for (const auto& branch : response["branches"]) {
      EXPECT_EQ(branch["method"], "exact-orbit");
      EXPECT_FALSE(branch["ended"].get<std::string>().empty());
      for (const auto& point : branch["points"]) {
        EXPECT_EQ(point["multipliers"].empty(), point["stability"] == "undefined");
        EXPECT_EQ(point["stable"].is_null(), point["stability"] == "undefined");
        EXPECT_LE(point["x_max"][0].get<double>(), 0.2 + 1e-11);
      }
    }
  }
}

TEST(CommandSweep, PutsStepsOfOtherMethodsBesideTheBranches) {
  const std::string command =
      "sweep sdof-stop --methods exact-orbit:event-driven --from 2.1 --to 2.5 --points 2 --format ";
  const test::Outcome json = test::run_program(command + "json");
  ASSERT_EQ(json.code, 0) << json.err;
  const auto branches = nlohmann::json::parse(json.out)["branches"];
  EXPECT_EQ(branches.back()["method"], "event-driven");
  EXPECT_EQ(branches.back()["points"].size(), 2U);
  const test::Outcome csv = test::run_program(command + "csv");
  ASSERT_EQ(csv.code, 0) << csv.err;
  EXPECT_NE(csv.out.find("period-doubling"), std::string::npos);
  EXPECT_NE(csv.out.find("event-driven,0,2.5,"), std::string::npos);
  const test::Outcome natural = test::run_program(command + "csv --natural");
  EXPECT_EQ(std::count(natural.out.begin(), natural.out.end(), '\n'), 5) << natural.out;
}

// The truth is that of exact orbits; the methods miss it by their truncation, and find it by their own
// equations.
TEST(CommandSweep, FollowsTheCurveOfEachMethod) {
  struct Method {
    const char* option;
    double error;  // of the fold
  };
  for (const Method& method :
       {Method{"fourier-lipschitz --set harmonics=10", 0.08}, Method{"hat-lcp --set samples=64", 0.08}}) {
    const test::Outcome outcome =
        test::run_program(std::string("sweep sdof-stop --methods ") + method.option +
                          " --from 2.0 --to 4.2 --total-time 600 --format json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto response = nlohmann::json::parse(outcome.out);
    const double fold = distance(response, "fold", 3.8553753210);
    EXPECT_LT(fold, method.error) << method.option;
    EXPECT_GT(fold, 1e-6) << "not the exact one";
    EXPECT_LT(distance(response, "grazing", 2.448265181813), 0.01) << method.option;
    EXPECT_EQ(response["unfinished"], "");
    for (const auto& branch : response["branches"]) {
      for (const auto& point : branch["points"]) {
        for (const char* key : {"omega", "order", "amplitude", "x_max", "impacts", "stable", "multipliers"})
          EXPECT_TRUE(point.contains(key)) << key;
        const bool told = point["stability"] == "stable" || point["stability"] == "unstable";
        EXPECT_NE(point["stable"].is_null(), told);
      }
    }
  }
}

TEST(CommandSweep, NamesTheLawOfAMethodWhereTheSceneHasAnother) {
  const std::string range = " --from 2.3 --to 2.4 --points 2 --orders 1";
  for (const auto& [command, words] :
       {std::pair{"sweep sdof-stop-e08 --methods 'fourier-lipschitz' --set harmonics=5",
                  "fourier-lipschitz[harmonics=5], e = 1: "},
        std::pair{"sweep sdof-stop-e08 --format csv --methods fourier-lipschitz --set harmonics=5",
                  "\"fourier-lipschitz[harmonics=5], e = 1\","},
        std::pair{"sweep sdof-stop-e08 --format json --methods fourier-lipschitz --set harmonics=5",
                  "\"other_law\":\"e = 1\""},
        std::pair{"sweep sdof-stop-e08 --method fourier-lipschitz --set harmonics=5", "e = 1\n"}}) {
    const test::Outcome outcome = test::run_program(command + range);
    EXPECT_NE(outcome.out.find(words), std::string::npos) << command << "\n" << outcome.out << outcome.err;
  }
  const test::Outcome same =
      test::run_program("sweep sdof-stop --methods fourier-lipschitz --set harmonics=5" + range);
  EXPECT_EQ(same.out.find("e = 1"), std::string::npos) << same.out;
}

TEST(CommandSweep, RefusesWhatItCannotFollowInOneLine) {
  for (const char* arguments :
       {"sweep sdof-stop --from 1 --to 2",
        "sweep sdof-stop --method hat-lcp --methods hat-lcp --from 1 --to 2",
        "sweep sdof-stop --methods exact-orbit --from 2 --to 2",
        "sweep sdof-stop --methods fourier-lipschitz --set harmonics=0 --from 1 --to 2",
        "sweep sdof-stop --methods exact-orbit:none --from 1 --to 2",
        "sweep sdof-stop --methods exact-orbit --parameter system.none --from 1 --to 2",
        "sweep sdof-stop --methods exact-orbit --parameter name --from 1 --to 2",
        "sweep sdof-stop --methods exact-orbit --parameter law.restitution --from 0.5 --to 2",
        "sweep sdof-stop --methods exact-orbit --parameter law.restitution --from 0.5 --to 0.5",
        "sweep sdof-stop --methods exact-orbit:hat-lcp --parameter law.restitution --from 0.5 --to 1",
        "sweep sdof-stop --method hat-lcp --parameter law.restitution --from 0.5 --to 1"}) {
    const test::Outcome outcome = test::run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandSweep, SaysThatEnergiesAreKeptWithoutDampingAndLoadAlone) {
  for (const char* more : {"", " --methods exact-orbit"}) {
    const test::Outcome outcome =
        test::run_program(std::string("sweep sdof-stop --parameter energy --from 0.1 --to 1") + more);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("parameter = energy (must be that of motions that keep it, without damping"),
              std::string::npos)
        << outcome.err;
  }
}

// The contact-free motion grazes where the gap is its amplitude; the load then has its own value besides.
TEST(CommandSweep, FollowsAnyNumberOfTheSceneFile) {
  const double reach = 1.0 / std::hypot(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  const std::string command = "sweep sdof-stop --methods exact-orbit --format ";
  const test::Outcome gap =
      test::run_program(command + "json --parameter contact[0].gap --from 0.05 --to 0.5");
  ASSERT_EQ(gap.code, 0) << gap.err;
  const auto response = nlohmann::json::parse(gap.out);
  EXPECT_EQ(response["parameter"], "contact[0].gap");
  double grazing = 0.0;
  for (const auto& special : response["branches"][0]["special"]) {
    if (special["kind"] == "grazing") grazing = special["value"];
    EXPECT_DOUBLE_EQ(special["omega"].get<double>(), 2.2);
  }
  EXPECT_NEAR(grazing, reach, 1e-11);
  const test::Outcome load =
      test::run_program(command + "csv --parameter forcing.term[0].cos --from 0.5 --to 1");
  ASSERT_EQ(load.code, 0) << load.err;
  EXPECT_EQ(load.out.find("method,branch,forcing.term[0].cos,"), 0U) << load.out.substr(0, 80);
  EXPECT_NE(load.out.find(fmt::format("{:.10g}", 0.2 / reach)), std::string::npos);
}

// Without it: the isolated branch of the prototype between 2.4039 and 2.5221 rad/s, of two impacts in two
// periods; its fold and doubling were located there by another program.
TEST(ExactBranches, BeginAtAllOrbitsThatASearchFinds) {
  const Problem problem = read_scene(find_scene("sdof-stop")).problem;
  const ParametrisedScene scene = over_frequency(problem, 2.42, 2.53);
  const auto distance_of = [&](int searches, SpecialKind kind, double truth) {
    double nearest = 1e300;
    for (const Branch& branch :
         exact_branches(scene, {.begin_at = searched_motions(scene, searches, 2, 300.0)}).branches) {
      for (const SpecialPoint& special : branch.special) {
        if (special.kind == kind) nearest = std::min(nearest, std::abs(special.point.parameter - truth));
      }
    }
    return nearest;
  };
  EXPECT_GT(distance_of(0, SpecialKind::fold, 2.5221253565), 1e-3);
  EXPECT_LT(distance_of(1, SpecialKind::fold, 2.5221253565), 1e-9);
  EXPECT_LT(distance_of(1, SpecialKind::period_doubling, 2.5122750311), 1e-9);
}

// There is no scene of dampers below 0: curves end at the last one that there is, and are whole.
TEST(ExactBranches, FollowADamperDownToNone) {
  const ParametrisedScene scene = over_place(find_scene("sdof-stop"), "system.damping", 0.2, 0.0);
  const BranchDiagram diagram = exact_branches(scene, {.max_order = 1});
  const auto whole = std::ranges::find_if(diagram.branches, [](const Branch& branch) {
    const auto [one, other] = std::minmax(branch.points.front().parameter, branch.points.back().parameter);
    return one == 0.0 && other == 0.2;
  });
  EXPECT_NE(whole, diagram.branches.end());
  for (const Branch& branch : diagram.branches)
    EXPECT_EQ(branch.ended.find("fails"), std::string::npos) << branch.ended;
}

// A load that is nothing in the middle of its interval is one all the same.
TEST(ExactBranches, FollowALoadThroughZero) {
  const ParametrisedScene scene = over_place(find_scene("sdof-stop"), "forcing.term[0].cos", -0.5, 0.5);
  const BranchDiagram diagram = exact_branches(scene, {});
  ASSERT_FALSE(diagram.branches.empty());
  const Branch& free = diagram.branches.front();
  EXPECT_EQ(std::abs(free.points.front().parameter - free.points.back().parameter), 1.0);
  const double reach = 1.0 / std::hypot(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  for (const SolutionPoint& point : free.points)
    EXPECT_NEAR(point.amplitude[0], std::abs(point.parameter) * reach, 1e-12);
}

TEST(ExactBranches, OfRandomScenesAreTheirOrbits) {
  std::mt19937 random(20261123);
  int compared = 0;
  for (int number = 0; number < 24; ++number) {
    SCOPED_TRACE(number);
    const Problem problem = test::random_scene(random, number);
    const ParametrisedScene scene = over_frequency(problem, 0.7, 3.0);
    compared +=
        test::expect_orbits_of(scene, exact_diagram(scene, ExactOrbitMethod({}), {.max_branches = 10}));
  }
  EXPECT_GT(compared, 1000);
}

// Energy and frequency stand beside each other, and no mode is missing between the bands of others.
TEST(BranchTable, HasTheEnergyOfFreeMotions) {
  MethodResponse response{.method = "exact-orbit", .asked = ParameterRange{.low = 1.0, .high = 9.0}};
  response.diagram.branches = {{.points = {{.parameter = 3.0, .frequency = 3.0, .energy = 0.5},
                                           {.parameter = 4.0, .frequency = 4.0, .energy = 0.75}}}};
  EXPECT_EQ(incompleteness(response), "");
  const Table table = branch_table({response});
  EXPECT_EQ(table.header.back(), "energy [J]");
  EXPECT_EQ(table.rows.at(1).back().text, "0.75");
  response.diagram.unfinished = "the time is up";
  EXPECT_NE(incompleteness(response), "");
  response.parameter = kEnergy;
  for (SolutionPoint& point : response.diagram.branches[0].points) point.parameter = *point.energy;
  const Table by_energy = branch_table({response});
  EXPECT_EQ(by_energy.header.at(2), "energy [J]");
  EXPECT_EQ(by_energy.header.back(), "omega [rad/s]");
  EXPECT_EQ(by_energy.rows.at(1).back().text, "4");
}

TEST(Incompleteness, SaysWhatIsMissingAndWhatGoesOn) {
  MethodResponse response{.method = "exact-orbit"};
  EXPECT_EQ(incompleteness(response), "");
  response.asked = {.low = 60.0, .high = 120.0};
  response.diagram.branches = {{.points = {{.parameter = 60.0}, {.parameter = 84.6}}}};
  response.diagram.unfinished = "limit of 60 branches";
  EXPECT_EQ(
      incompleteness(response),
      "exact-orbit: INCOMPLETE: no motion from 84.6 to 120: limit of 60 branches (--max-branches goes on; "
      "--attractors 4 tells what the machine does there)");
}

}  // namespace

}  // namespace signorini::branch_response_test
