#include "harness/sweep/branch_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"

namespace signorini::branch_json_test {
namespace {

using Json = nlohmann::ordered_json;

Branch whole_branch() {
  SolutionPoint point{.parameter = 0.25,
                      .frequency = 2.0,
                      .order = 2,
                      .x_max = {0.1, std::nextafter(0.2, 1.0)},
                      .amplitude = {0.3, 0.4},
                      .impacts = 3,
                      .energy = 1.5,
                      .damping_ratio = 0.05,
                      .stability = OrbitStability::elliptic};
  point.multipliers = Eigen::Vector2cd(std::complex<double>(0.6, 0.8), std::complex<double>(0.6, -0.8));
  point.motion = Eigen::MatrixXd::Constant(4, 2, 1.0 / 3.0);
  Branch branch{.sequence = "order 2, events I0", .began = "start at 1", .ended = "end of the interval"};
  branch.points = {point, point};
  branch.points[1].stability = OrbitStability::unstable;
  branch.points[1].energy.reset();
  branch.points[1].damping_ratio.reset();
  branch.points[0].undefined = "depends";
  branch.special = {{.kind = SpecialKind::neimark_sacker, .point = point, .text = "x", .after = 2}};
  return branch;
}

TEST(BranchJson, ComesBackButForTheOrbits) {
  const Json json = to_json(whole_branch(), "m");
  const Branch back = branch_from_json(Json::parse(json_line(json)));
  EXPECT_EQ(to_json(back, "m"), json);
  EXPECT_EQ(back.points[0].parameter, 0.25);
  EXPECT_EQ(back.points[0].x_max[1], std::nextafter(0.2, 1.0));
  EXPECT_EQ(back.points[0].motion, whole_branch().points[0].motion);
  EXPECT_EQ(back.points[1].stability, OrbitStability::unstable);
  EXPECT_EQ(back.points[0].damping_ratio, 0.05);
  EXPECT_FALSE(back.points[1].damping_ratio);
  EXPECT_EQ(back.special[0].kind, SpecialKind::neimark_sacker);
  EXPECT_EQ(back.special[0].after, 2U);
  EXPECT_TRUE(json["points"][0]["stable"].is_null());
  EXPECT_EQ(json["points"][1]["stable"], false);
  EXPECT_EQ(json["points"][0]["stability_reason"], "depends");
  EXPECT_FALSE(json["points"][1].contains("stability_reason"));
}

TEST(BranchJson, HasNoValueOfItsOwnWhereTheParameterIsTheFrequency) {
  Branch branch = whole_branch();
  branch.points[0].parameter = branch.points[0].frequency;
  const Json json = to_json(branch, "m");
  EXPECT_FALSE(json["points"][0].contains("value"));
  EXPECT_EQ(branch_from_json(json).points[0].parameter, 2.0);
}

TEST(BranchJson, ReadsWhatWasNotFiniteAsNotANumber) {
  Branch branch = whole_branch();
  branch.points[0].amplitude[0] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(
      std::isnan(branch_from_json(Json::parse(json_line(to_json(branch, "m")))).points[0].amplitude[0]));
}

TEST(BranchJson, RefusesWhatSweepDoesNotWrite) {
  const auto refuses = [](const char* pointer, const Json& value) {
    Json json = to_json(whole_branch(), "m");
    json[Json::json_pointer(pointer)] = value;
    EXPECT_THROW((void)branch_from_json(json), BadRecord) << pointer << value;
  };
  refuses("/points", 3);
  refuses("/points/0", 3);
  refuses("/points/0/order", 0);
  refuses("/points/0/order", 1e30);
  refuses("/points/0/order", 2.5);
  refuses("/points/0/impacts", -1);
  refuses("/points/0/omega", "2");
  refuses("/points/0/amplitude", Json::array({0.1, 0.2, 0.3}));  // contacts of the motion
  refuses("/points/0/stability", "fair");
  refuses("/points/0/multipliers", Json::array({1.0}));
  refuses("/special/0/after", 3);
  refuses("/special/0/kind", "turn");
  refuses("/ended", "a\x1b[2J");
  Json without = to_json(whole_branch(), "m");
  without.erase("ended");
  EXPECT_THROW((void)branch_from_json(without), BadRecord);
  EXPECT_THROW((void)branch_from_json(Json::array()), BadRecord);
}

TEST(StepJson, ComesBackButForMotionAndTime) {
  const SweepPoint step{.frequency = 2.0,
                        .down = true,
                        .status = Status::inaccurate,
                        .message = "far",
                        .x_max = {0.1},
                        .amplitude = {0.2},
                        .contact_ratio = 0.3,
                        .stable = true};
  const Json json = to_json(step, "m");
  EXPECT_EQ(json["method"], "m");
  const SweepPoint back = step_from_json(Json::parse(json_line(json)));
  EXPECT_EQ(to_json(back, "m"), json);
  EXPECT_TRUE(back.down);
  EXPECT_EQ(back.status, Status::inaccurate);
  Json other = json;
  other["status"] = "fine";
  EXPECT_THROW((void)step_from_json(other), BadRecord);
  EXPECT_THROW((void)step_from_json(Json::object()), BadRecord);
}

}  // namespace
}  // namespace signorini::branch_json_test
