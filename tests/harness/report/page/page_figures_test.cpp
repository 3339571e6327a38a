#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/report/page/page_parts.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::page_figures_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(WorkPrecisionData, HasOneMarkForEachRunThatHasErrorAndTime) {
  std::vector<Record> records{
      test::good_record("s", "m", "n=1", 0.1, 1.0), test::good_record("s", "m", "n=2", 0.01, 2.0),
      test::good_record("s", "m", "n=3", 0.02, 3.0), test::good_record("s", "m", "n=4", 0.5, 4.0)};
  records.back().status = Status::timeout;
  const Evaluation evaluation(records);
  const Json data = work_precision_data(evaluation, "s");
  ASSERT_EQ(data["own"].size(), 1U);
  const Json& study = data["own"][0];
  EXPECT_EQ(study["label"], "m");
  ASSERT_EQ(study["marks"].size(), 3U);
  // The third is slower and worse than the second: a mark, but not on the curve.
  EXPECT_EQ(study["curve"], Json({0, 1}));
  for (const Json& mark : study["marks"]) {
    const Record record = evaluation.record_of(evaluation.results().at(mark[2].get<std::size_t>()));
    EXPECT_EQ(mark[4], resolution_of(record));
    EXPECT_DOUBLE_EQ(mark[0].get<double>(), record.seconds->median);
    EXPECT_DOUBLE_EQ(mark[1].get<double>(), *record.errors.x_l2);
  }
}

TEST(WorkPrecisionData, SetsOtherLawsApart) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.1, 1.0),
                              test::good_record("s", "o", "n=1", 0.2, 1.0)};
  records.back().law_matches_scene = false;
  const Json data = work_precision_data(Evaluation(records), "s");
  ASSERT_EQ(data["other"].size(), 1U);
  EXPECT_EQ(data["other"][0]["label"], "o (e = 1)");
  EXPECT_EQ(data["own"].size(), 1U);
  EXPECT_TRUE(work_precision_data(Evaluation(records), "nowhere").is_null());
}

/// One period of cos(t) - half of cos(t/2) shifted by `delay`: a motion over two periods of its load.
Waveform motion_with_delay(double delay, bool with_jump) {
  constexpr double kPeriod = 4.0 * std::numbers::pi;
  Waveform motion{.t = {}, .x = {{}}, .velocity = {{}}, .force = {{}}, .impulse = {{}}};
  constexpr int kInstants = 400;
  const double jump = std::fmod(3.0 + delay, kPeriod);
  double given = 0.0;
  const auto add = [&](double t, double velocity) {
    motion.t.push_back(t);
    motion.x[0].push_back(std::cos(t - delay) - 0.5 * std::cos((t - delay) / 2.0));
    motion.velocity[0].push_back(velocity);
    motion.force[0].push_back(0.0);
    motion.impulse[0].push_back(given);
  };
  for (int i = 0; i <= kInstants; ++i) {
    const double t = kPeriod * i / kInstants, before = kPeriod * (i - 1) / kInstants;
    if (with_jump && before < jump && jump <= t) {
      add(jump, 3.0);
      given = -2.0;
      add(jump, -3.0);
    }
    add(t, std::sin(t - delay));
  }
  return motion;
}

Record kept_record(const std::string& resolution, double delay) {
  Record record = test::good_record("s", "m" + resolution, resolution, 0.1, 1.0);
  record.certificate.order = 2;
  record.waveforms = Waveforms{
      .contacts = {3}, .answer = motion_with_delay(delay, true), .orbit = motion_with_delay(delay, true)};
  return record;
}

TEST(MotionData, ShiftsAnAnswerToThePeriodOfTheLoadInWhichTheOrbitIsDrawn) {
  const double period = 2.0 * std::numbers::pi;
  const Evaluation evaluation({kept_record("n=1", 0.0), kept_record("n=2", period)});
  const Json data = motion_data(evaluation, "s");
  EXPECT_EQ(data["contact"], 3);
  EXPECT_EQ(data["stop"], 1.5);  // where the orbit turns at the rigid stop
  ASSERT_EQ(data["answers"].size(), 2U);
  for (const Json& answer : data["answers"]) {
    const auto t = answer["t"].get<std::vector<double>>(), x = answer["x"].get<std::vector<double>>(),
               impulse = answer["p"].get<std::vector<double>>();
    EXPECT_NEAR(t.back(), 2.0 * period, 5e-3);  // four digits
    EXPECT_TRUE(std::ranges::is_sorted(t));
    double deviation = 0.0;
    for (std::size_t i = 0; i < t.size(); ++i)
      deviation = std::max(deviation, std::abs(x[i] - std::cos(t[i]) + 0.5 * std::cos(t[i] / 2.0)));
    EXPECT_LT(deviation, 5e-3) << answer["label"];  // four digits of t and x, and polylines
    // The impact is one jump, at 3 s, and the impulse counts from the beginning.
    EXPECT_EQ(impulse.front(), 0.0);
    EXPECT_EQ(impulse.back(), -2.0);
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (std::abs(t[i] - 3.0) > 1e-2) {
        EXPECT_EQ(impulse[i], t[i] < 3.0 ? 0.0 : -2.0) << t[i];
      }
    }
    const auto velocity = answer["v"].get<std::vector<double>>();
    EXPECT_EQ(std::ranges::count(velocity, 3.0), 1) << "the jump lost a side";
    EXPECT_EQ(std::ranges::count(velocity, -3.0), 1) << "the jump lost a side";
  }
}

TEST(MotionData, IsNullWhereRecordsKeepNoMotion) {
  EXPECT_TRUE(motion_data(Evaluation(test::records_of_two_methods()), "s1").is_null());
}

TEST(SchematicData, IsThePictureOfTheSceneOfTheRecordsAndOfNoOther) {
  Record record = test::good_record("sdof-stop", "m", "n=1", 0.1, 1.0);
  record.scene_sha256 = read_scene(find_scene("sdof-stop")).sha256;
  const Json picture = schematic_data(Evaluation({record}), "sdof-stop");
  ASSERT_TRUE(picture.is_string());
  EXPECT_EQ(picture.get<std::string>().rfind("<svg", 0), 0U);
  record.scene_sha256 = "of another scene of this name";
  EXPECT_TRUE(schematic_data(Evaluation({record}), "sdof-stop").is_null());
  for (const char* scene :
       {"no-scene-of-the-catalogue", "../sdof-stop.toml", "/etc/hostname", "sdof-stop.toml"}) {
    record.scene = scene;
    EXPECT_TRUE(schematic_data(Evaluation({record}), scene).is_null()) << scene;
  }
}

TEST(ProfileData, EndsEachCurveAtTheShareOfScenesThatAreSolved) {
  const Evaluation evaluation(test::records_of_two_methods());
  const Json panels = profile_data(evaluation, 0);
  ASSERT_EQ(panels.size(), kProfileErrors.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    EXPECT_EQ(panels[p]["error"], kProfileErrors[p]);
    const Costs costs = costs_to_error(evaluation.groups()[0], time_axis(), kProfileErrors[p]);
    for (const Json& curve : panels[p]["curves"]) {
      const auto& row = costs[curve["c"].get<std::size_t>()];
      const double solved = static_cast<double>(solved_count(row)) / static_cast<double>(row.size());
      EXPECT_NEAR(curve["steps"].back()[1].get<double>(), solved, 1e-4);
      EXPECT_GE(curve["steps"][0][0].get<double>(), 1.0);
    }
  }
}

}  // namespace
}  // namespace signorini::page_figures_test
