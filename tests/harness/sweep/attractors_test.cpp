// Where trajectories go, against exact orbits and a motion known to be irregular.

#include "harness/sweep/attractors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "harness/plan/plan.hpp"
#include "harness/sweep/branch_json.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::attractors_test {
namespace {

using Json = nlohmann::ordered_json;

// sdof-stop-e08: the exact orbit has the amplitude 0.431238 (cases of the certificates).
TEST(Attractors, AreThePeriodicMotionThatEveryStartReaches) {
  const Problem problem = read_scene(find_scene("sdof-stop-e08")).problem;
  int done = 0;
  const std::vector<AttractorsAt> found = attractors_over(over_frequency(problem, 2.0, 2.4), {2.2, 2.3},
                                                          {.starts = 3, .jobs = 2}, [&] { ++done; });
  EXPECT_EQ(done, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].value, 2.3);
  const AttractorsAt& at = found[0];
  EXPECT_EQ(at.failure, "");
  EXPECT_EQ(at.starts, 3);
  ASSERT_EQ(at.attractors.size(), 1U);
  EXPECT_EQ(at.attractors[0].verdict, LongRun::periodic);
  EXPECT_EQ(at.attractors[0].order, 1);
  EXPECT_EQ(at.attractors[0].starts, 3);
  EXPECT_TRUE(at.attractors[0].from_rest);
  EXPECT_NEAR(at.attractors[0].amplitude(), 0.431238, 1e-6);
  EXPECT_EQ(at.attractors[0].once_a_period.size(), 1U);
}

TEST(Attractors, TellWhatRestGoesToInTheWidestPartsFirst) {
  const Problem problem = read_scene(find_scene("sdof-stop-e08")).problem;
  const std::vector<std::string> lines =
      motions_from_rest(over_frequency(problem, 2.0, 2.6), {{2.5, 2.501}, {2.1, 2.3}}, "rad/s", 10.0);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "at 2.2 rad/s the motion from rest settles to a motion of 1 period with 1 event");
  EXPECT_TRUE(lines[1].starts_with("at 2.5005 rad/s the motion from rest ")) << lines[1];
}

TEST(Attractors, TellWhatIsWhereTheBranchesOfASweepLeaveOut) {
  const test::Outcome outcome = test::run_program(
      "sweep sdof-stop-e08 --methods exact-orbit --from 1.8 --to 2.6 --max-branches 1 --format json");
  EXPECT_EQ(outcome.code, 6) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  ASSERT_FALSE(answer["incomplete"].empty());
  EXPECT_TRUE(std::ranges::any_of(answer["notes"], [](const Json& note) {
    return note.get<std::string>().find(" the motion from rest ") != std::string::npos;
  })) << answer["notes"];
}

// The stop is at 0: what one motion reaches there, 1e-16, is not told from what another does, 0.
TEST(Attractors, AreOneWhereTheyDifferByRoundingAtAStopAtTheOrigin) {
  const auto file = test::fresh_folder("attractors-origin") / "origin.toml";
  std::ofstream(file)
      << "schema = 1\nname = \"origin\"\nsystem = { kind = \"sdof\", mass = 1.0, damping = 0.05, stiffness = "
         "1.0 }\nforcing = { frequency = 2.6, term = [{ dof = 0, cos = 1.0 }] }\n"
         "contact = [{ dof = 0, gap = 0.0 }]\nlaw = { restitution = 0.7 }\n";
  const test::Outcome outcome = test::run_program(
      "sweep --attractors 3 --from 2.6 --to 2.64 --points 2 --format json " + file.string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const auto& at : nlohmann::json::parse(outcome.out)["attractors"])
    EXPECT_EQ(at["attractors"].size(), 1U) << at;
}

// Marches end where they come back to some 1e-6: the slower a motion is reached, the further they are off.
TEST(Attractors, AreOneWhereStartsSettleSlowly) {
  const auto file = test::fresh_folder("attractors-slow") / "slow.toml";
  std::ofstream(file) << "schema = 1\nname = \"slow\"\nsystem = { kind = \"sdof\", mass = 1.0, damping = "
                         "0.0683872, stiffness = "
                         "1.0 }\nforcing = { frequency = 0.85, term = [{ dof = 0, cos = 1.0 }] }\n"
                         "contact = [{ dof = 0, gap = 0.828045 }]\nlaw = { restitution = 0.8 }\n";
  const test::Outcome outcome = test::run_program(
      "sweep --attractors 24 --from 0.847805 --to 0.848652805 --points 2 --format json " + file.string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const auto& at : nlohmann::json::parse(outcome.out)["attractors"])
    EXPECT_EQ(at["attractors"].size(), 1U) << at;
}

TEST(Attractors, CommandTellsIrregularMotionsAndTheirShare) {
  const test::Outcome outcome =
      test::run_program("sweep chaos@2.97 --attractors 2 --at 2.97 --format json --timeout 20");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["parameter"], "forcing.frequency");
  EXPECT_TRUE(json["branches"].empty());
  ASSERT_EQ(json["attractors"].size(), 1U);
  const Json& at = json["attractors"][0];
  EXPECT_EQ(at["value"], 2.97);
  ASSERT_EQ(at["attractors"].size(), 1U);
  EXPECT_EQ(at["attractors"][0]["verdict"], "irregular");
  EXPECT_TRUE(at["attractors"][0]["order"].is_null());
  EXPECT_EQ(at["attractors"][0]["share"], 1.0);
}

// A motion of three periods with one landing, which most starts reach from 3.57 to 3.98 rad/s; time marching
// and continuation share no way to it.
TEST(Attractors, OfThreePeriodsLieOnABranchOfDefaultOptions) {
  const Problem problem = read_scene(find_scene("sdof-stop-e0")).problem;
  std::vector<AttractorsAt> found =
      attractors_over(over_frequency(problem, 3.7, 3.9), {3.8}, {.starts = 4, .jobs = 1});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(std::ranges::count(found[0].attractors, 3, &Attractor::order), 1);
  const test::Outcome outcome =
      test::run_program("sweep sdof-stop-e0 --methods exact-orbit --from 1.5 --to 4 --at 3.8 --format jsonl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<Branch> branches;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) branches.push_back(branch_from_json(Json::parse(line)));
  EXPECT_TRUE(off_branches(found, branches, "rad/s", 6).empty());
  for (const Attractor& one : found[0].attractors) EXPECT_TRUE(one.on_branch.value()) << one.order;
}

// Five impacts in three periods: no answer, no orbit of one impact and no other branch leads to it.
TEST(Attractors, AreBeginningsOfBranches) {
  const test::TemporaryFolder folder;
  const std::string scene = folder
                                .write("isolated.toml", R"(schema = 1
name = "isolated"
system = { kind = "sdof", mass = 1.0, damping = 0.14429, stiffness = 1.0 }
forcing = { frequency = 1.35, term = [{ dof = 0, cos = 1.0 }] }
contact = [{ dof = 0, gap = -0.26994 }]
law = { restitution = 0.756 }
)")
                                .string();
  const std::string sweep =
      "sweep " + scene + " --methods exact-orbit --from 1.34 --to 1.36 --at 1.35 --format json";
  const auto of_three_periods = [](const std::string& out) {
    const Json branches = Json::parse(out).at("branches");
    return std::ranges::count_if(branches, [](const Json& branch) {
      return !branch["points"].empty() && branch["points"][0]["order"] == 3;
    });
  };
  EXPECT_EQ(of_three_periods(test::run_program(sweep).out), 0);
  const test::Outcome begun = test::run_program(sweep + " --attractors 3");
  EXPECT_EQ(begun.code, 0) << begun.err;
  EXPECT_GE(of_three_periods(begun.out), 1);
  const Json json = Json::parse(begun.out);
  EXPECT_TRUE(json["off_branches"].empty());
  EXPECT_EQ(json["attractors"][0]["attractors"][0]["order"], 3);
  EXPECT_EQ(json["attractors"][0]["attractors"][0]["on_branch"], true);
}

TEST(Attractors, ThatLieOnNoBranchAreTold) {
  Attractor one{.verdict = LongRun::periodic, .order = 3, .starts = 5, .least = {-0.5}, .largest = {0.2}};
  std::vector<AttractorsAt> all{{.value = 2.31, .starts = 24, .attractors = {one}}};
  const auto branch = [](double amplitude, int order) {
    return Branch{.points = {{.parameter = 2.31, .order = order, .x_max = {0.2}, .amplitude = {amplitude}}}};
  };
  EXPECT_TRUE(off_branches(all, {branch(0.35, 3)}, "rad/s", 6).empty());
  for (const Branch& other : {branch(0.3501, 3), branch(0.35, 1)}) {
    EXPECT_EQ(off_branches(all, {other}, "rad/s", 6),
              std::vector<std::string>{
                  "at 2.31 rad/s 5 of 24 starts settle to a motion of 3 periods that lies on no branch"});
  }
}

TEST(Attractors, CommandRefusesWhatGoesWithoutThem) {
  for (const char* more : {"--method exact-orbit", "--natural", "--out folder", "--attractors 0"}) {
    const test::Outcome outcome =
        test::run_program(std::string("sweep sdof-stop --attractors 2 --from 2 --to 3 ") + more);
    EXPECT_EQ(outcome.code, 2) << more << outcome.out;
    EXPECT_NE(outcome.err, "");
  }
  EXPECT_EQ(test::run_program("sweep sdof-stop --attractors 2").code, 2);
}

}  // namespace
}  // namespace signorini::attractors_test
