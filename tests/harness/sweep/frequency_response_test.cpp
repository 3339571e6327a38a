// Frequency responses against the closed form of a linear oscillator, and up and down over a fold.
#include "harness/sweep/frequency_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::frequency_response_test {

namespace {

double receptance(double w) { return std::abs(1.0 / std::complex<double>(1.0 - w * w, 0.1 * w)); }

TEST(SweepFrequencies, AreEquallySpacedOrInEqualRatiosAndMeetTheEnds) {
  const std::vector<double> linear = sweep_frequencies({.from = 3.0, .to = 1.0, .points = 5});
  EXPECT_EQ(linear, (std::vector<double>{3.0, 2.5, 2.0, 1.5, 1.0}));
  const std::vector<double> ratios =
      sweep_frequencies({.from = 0.1, .to = 10.0, .points = 3, .logarithmic = true});
  ASSERT_EQ(ratios.size(), 3U);
  EXPECT_NEAR(ratios[1], 1.0, 1e-15);
  EXPECT_EQ(ratios[2], 10.0);
}

TEST(SweepFrequencies, RefuseARangeThatIsNone) {
  const double nan = std::nan("");
  for (const SweepRange& range : {SweepRange{.from = 0.0, .to = 1.0}, SweepRange{.from = 1.0, .to = nan},
                                  SweepRange{.from = 1.0, .to = -2.0}, SweepRange{.from = 2.0, .to = 2.0},
                                  SweepRange{.from = 1.0, .to = 2.0, .points = 1}})
    EXPECT_THROW((void)sweep_frequencies(range), UsageError);
}

TEST(FrequencyResponse, OfALinearOscillatorIsItsReceptance) {
  const Scene scene{.problem = test::one_mass(100.0)};
  const MethodChoice method{&find_method("penalty-hbm"), {{"harmonics", "3"}}};
  const auto points = frequency_response(scene, method, {.from = 0.5, .to = 1.5, .points = 11}, {});
  ASSERT_EQ(points.size(), 11U);
  for (const SweepPoint& point : points) {
    ASSERT_EQ(point.status, Status::converged) << point.message;
    EXPECT_NEAR(point.amplitude.at(0), receptance(point.frequency), 2e-6 * receptance(point.frequency));
    EXPECT_NEAR(point.x_max.at(0), receptance(point.frequency), 2e-6 * receptance(point.frequency));
    EXPECT_EQ(point.contact_ratio.value_or(0.0), 0.0);
    EXPECT_FALSE(point.stable);  // not asked for
  }
}

// A stop stiffens the oscillator: above its eigenfrequency the motion against the stop and the free one
// coexist, and which is found depends on where the sweep comes from.
TEST(FrequencyResponse, UpAndDownDifferWhereMotionsCoexist) {
  Problem problem = test::one_mass(1.0, 0.9);
  const Scene scene{.problem = problem};
  const MethodChoice method{&find_method("event-driven"), {{"flow", "modal"}}};
  const auto points = frequency_response(scene, method, {.from = 0.9, .to = 2.2, .points = 14, .back = true},
                                         {.timeout = 20.0, .certified = true});
  ASSERT_EQ(points.size(), 28U);
  double farthest = 0.0;
  int at_stop = 0;
  for (std::size_t i = 0; i < 14; ++i) {
    const SweepPoint &up = points[i], &down = points[27 - i];
    EXPECT_EQ(up.frequency, down.frequency);
    EXPECT_TRUE(down.down && !up.down);
    ASSERT_EQ(up.status, Status::converged) << up.frequency << ": " << up.message;
    ASSERT_EQ(down.status, Status::converged) << down.frequency << ": " << down.message;
    EXPECT_EQ(up.stable, std::optional<bool>(true)) << up.frequency;
    // Exact, not the largest of samples: a mass that hits its stop has been up.
    if (up.x_max.at(0) > 0.999) {
      EXPECT_NEAR(up.x_max.at(0), 1.0, 1e-9);
      ++at_stop;
    }
    farthest = std::max(farthest, up.amplitude.at(0) - down.amplitude.at(0));
  }
  EXPECT_GT(farthest, 0.2);
  EXPECT_GE(at_stop, 3);
}

// What was set up serves one frequency after another; where that process dies, the next one is set up anew.
TEST(FrequencyResponse, SetsUpOnceWhatServesSeveralFrequencies) {
  const Scene scene = test::one_mass_scene();
  const MethodChoice method{&test::fake_catalogue().front(), {{"behaviour", "carry_on"}}};
  std::vector<double> taken;
  const auto points = frequency_response(scene, method, {.from = 2.0, .to = 3.0, .points = 5}, {},
                                         [&](const SweepPoint& point) { taken.push_back(point.frequency); });
  EXPECT_EQ(taken, (std::vector<double>{2.0, 2.25, test::kFatalFrequency, 2.75, 3.0}));
  ASSERT_EQ(points.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(points[i].frequency, taken[i]);
    if (i == 2) continue;
    ASSERT_EQ(points[i].status, Status::converged) << points[i].message;
    EXPECT_EQ(points[i].message, i < 2 ? "set up for 2.000000" : "set up for 2.750000");
    EXPECT_NEAR(points[i].amplitude.at(0), receptance(taken[i]), 2e-6 * receptance(taken[i]));
  }
  EXPECT_EQ(points[2].status, Status::crashed);
}

TEST(FrequencyResponse, TakesEachPointOnceWhereAProcessServesOneAlone) {
  const Scene scene = test::one_mass_scene();
  for (const char* behaviour : {"good", "segfault"}) {
    const MethodChoice method{&test::fake_catalogue().front(), {{"behaviour", behaviour}}};
    const auto points = frequency_response(scene, method, {.from = 2.0, .to = 3.0, .points = 3}, {});
    ASSERT_EQ(points.size(), 3U);
    for (const SweepPoint& point : points)
      EXPECT_EQ(point.status, behaviour == std::string("good") ? Status::converged : Status::crashed);
  }
}

TEST(CommandSweep, PrintsATableCsvOrJsonAndExitsOneWhereAPointFails) {
  const std::string command =
      "sweep sdof-stop --method hat-lcp --set samples=64 --from 2 --to 2.4 --points 3";
  const test::Outcome csv = test::run_program(command + " --format csv");
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 4) << csv.out;
  const test::Outcome json = test::run_program(command + " --down --format json");
  const auto list = nlohmann::ordered_json::parse(json.out);
  ASSERT_EQ(list.size(), 6U);
  EXPECT_EQ(list[5]["way"], "down");
  EXPECT_EQ(list[5]["frequency"], 2.0);
  const test::Outcome failing = test::run_program(command + " --set solver=newton --set max_iterations=1");
  EXPECT_EQ(failing.code, 1);
  EXPECT_NE(failing.out.find("not-converged"), std::string::npos) << failing.out;
}

TEST(FrequencyResponse, OfASweepDownSaysSo) {
  const Scene scene{.problem = test::one_mass(100.0)};
  const MethodChoice method{&find_method("penalty-hbm"), {{"harmonics", "3"}}};
  const auto points =
      frequency_response(scene, method, {.from = 1.5, .to = 1.0, .points = 2, .back = true}, {});
  ASSERT_EQ(points.size(), 4U);
  EXPECT_TRUE(points[0].down && points[1].down);
  EXPECT_FALSE(points[2].down || points[3].down);
}

TEST(ResponseTable, HasARowPerPointAndTheColumnOfStabilityIfAskedFor) {
  const std::vector<SweepPoint> points{{.frequency = 1.5, .status = Status::converged, .x_max = {0.1, 0.2}},
                                       {.frequency = 1.0, .down = true, .status = Status::timeout}};
  const Table table = response_table(points, true);
  EXPECT_EQ(table.header.size(), 7U);
  EXPECT_EQ(response_table(points, false).header.size(), 6U);
  EXPECT_EQ(to_csv(response_table(points, false)),
            "omega [rad/s],way,status,x max [m],amplitude [m],contact ratio\n"
            "1.5,up,converged,0.2,-,-\n1,down,timeout,-,-,-\n");
  EXPECT_EQ(to_json(points[1]).dump(), R"({"frequency":1.0,"way":"down","status":"timeout"})");
}

}  // namespace

}  // namespace signorini::frequency_response_test
