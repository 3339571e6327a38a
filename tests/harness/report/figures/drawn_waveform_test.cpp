#include "harness/report/figures/drawn_waveform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/harness/sample_records.hpp"

namespace signorini::drawn_waveform_test {
namespace {

/// x = cos(t / 2 - phase) over 4 pi, two periods of a load of period 2 pi, with an impulse that jumps at t
/// = 3.
Waveform half_frequency(double phase) {
  Waveform waveform{.x = {{}}, .velocity = {{}}, .force = {{}}, .impulse = {{}}};
  constexpr int kPoints = 200;
  for (int i = 0; i <= kPoints; ++i) {
    const double t = 4.0 * std::numbers::pi * i / kPoints;
    waveform.t.push_back(t);
    waveform.x[0].push_back(std::cos(0.5 * t - phase));
    waveform.velocity[0].push_back(-0.5 * std::sin(0.5 * t - phase));
    waveform.force[0].push_back(0.0);
    waveform.impulse[0].push_back(t > 3.0 ? -1.0 : 0.0);
  }
  return waveform;
}

TEST(Delayed, BeginsLaterAndKeepsTheWholeImpulse) {
  const Waveform later = delayed(half_frequency(0.0), 2.0 * std::numbers::pi);
  ASSERT_EQ(later.t.size(), later.x[0].size());
  for (std::size_t i = 0; i < later.t.size(); ++i) {
    EXPECT_NEAR(later.x[0][i], -std::cos(0.5 * later.t[i]), 1e-3) << later.t[i];
    EXPECT_GE(later.t[i], later.t[i == 0 ? 0 : i - 1]);
  }
  EXPECT_EQ(later.t.back(), half_frequency(0.0).t.back());
  EXPECT_NEAR(later.impulse[0].front(), 0.0, 1e-12);
  EXPECT_NEAR(later.impulse[0].back(), -1.0, 1e-12);
  EXPECT_NEAR(later.impulse[0][later.impulse[0].size() / 2], 0.0, 1e-12);  // before its impact
}

TEST(InPhaseWith, ShiftsBySomeWholePeriodsOfTheLoad) {
  const Waveform leader = half_frequency(0.0);
  const Waveforms beside{.contacts = {0},
                         .answer = half_frequency(std::numbers::pi + 0.1),
                         .orbit = half_frequency(std::numbers::pi)};
  const Waveform shifted = in_phase_with(leader, 0, beside, 0, 2);
  EXPECT_NEAR(shifted.x[0].front(), std::cos(0.1), 1e-3);                      // its own error is kept
  EXPECT_EQ(in_phase_with(leader, 0, beside, 0, 1).x[0], beside.answer.x[0]);  // nothing to shift by
  const Waveforms there{.contacts = {0}, .answer = half_frequency(0.1), .orbit = leader};
  EXPECT_EQ(in_phase_with(leader, 0, there, 0, 2).x[0], there.answer.x[0]);
}

TEST(PortraitLines, FollowACircleBetweenSamples) {
  Waveform circle{.x = {{}}, .velocity = {{}}};
  for (int i = 0; i <= 8; ++i) {
    circle.t.push_back(i * std::numbers::pi / 4.0);
    circle.x[0].push_back(std::cos(circle.t.back()));
    circle.velocity[0].push_back(-std::sin(circle.t.back()));
  }
  std::istringstream lines(portrait_lines(circle, 0));
  int points = 0;
  for (double x = 0.0, v = 0.0; lines >> x >> v; ++points) EXPECT_NEAR(std::hypot(x, v), 1.0, 0.01);
  EXPECT_EQ(points, 65);  // a polygon of 8 corners comes as near as 0.92
}

TEST(PortraitLines, JumpAtAnImpact) {
  const Waveform impact{
      .t = {0.0, 1.0, 1.0, 2.0}, .x = {{0.0, 1.0, 1.0, 0.0}}, .velocity = {{1.0, 1.0, -1.0, -1.0}}};
  const std::string lines = portrait_lines(impact, 0);
  EXPECT_NE(lines.find("\n1 1\n1 -1\n"), std::string::npos) << lines;
}

TEST(PortraitLines, StayBetweenTheVelocitiesBesideAnImpact) {
  // As records keep it: few digits, one instant before the impact and one after it.
  const Waveform impact{.t = {0.9, 1.2, 1.379, 1.38, 1.381, 1.5, 1.7},
                        .x = {{-0.02, 0.12, 0.1995, 0.2, 0.2, 0.15, 0.06}},
                        .velocity = {{0.62, 0.5, 0.413, 0.4117, -0.4117, -0.45, -0.5}}};
  std::istringstream lines(portrait_lines(impact, 0));
  for (double x = 0.0, v = 0.0; lines >> x >> v;) {
    EXPECT_LT(x, 0.2 + 1e-6) << v;
    if (x > 0.15) {
      EXPECT_LT(std::abs(v), 0.5) << x;
    }
  }
}

TEST(PortraitLines, AreNotMovedByTheRoundingOfTimes) {
  // A quarter of a circle at uneven instants that have lost their digits.
  Waveform arc{.x = {{}}, .velocity = {{}}};
  for (const double t : {0.0, 0.1, 0.13, 0.4, 0.44, 0.9, 1.2, 1.25, 1.57}) {
    arc.t.push_back(std::round(10.0 * t) / 10.0);
    arc.x[0].push_back(std::sin(t));
    arc.velocity[0].push_back(std::cos(t));
  }
  std::istringstream lines(portrait_lines(arc, 0));
  // Straight lines between these samples come as near as 0.973.
  for (double x = 0.0, v = 0.0; lines >> x >> v;) EXPECT_NEAR(std::hypot(x, v), 1.0, 0.015) << x;
}

TEST(StopPosition, IsWhereTheContactCloses) {
  Record record = test::full_record();
  EXPECT_EQ(stop_position(record, 0), 0.5);
  record.law = Penalty{{10.0}};
  record.certificate.events = {{.time = 1.0, .contact = 0, .kind = ContactEvent::Kind::close}};
  record.waveforms->orbit->x = {{0.25, 0.75}};
  EXPECT_EQ(stop_position(record, 0), 0.5);  // between the two samples
  record.waveforms->orbit->impulse = {{0.0, 0.0}};
  EXPECT_EQ(stop_position(record, 0), std::nullopt);
}
/// x = cos(t / 2 - phase) over two periods 2 pi of the load, with an impulse at its end.
Waveform half_frequency(double phase, double impulse) {
  Waveform waveform{.x = {{}}, .velocity = {{}}, .force = {{}}, .impulse = {{}}};
  constexpr int kPoints = 200;
  for (int i = 0; i <= kPoints; ++i) {
    const double t = 4.0 * std::numbers::pi * i / kPoints;
    waveform.t.push_back(t);
    waveform.x[0].push_back(std::cos(0.5 * t - phase));
    waveform.velocity[0].push_back(-0.5 * std::sin(0.5 * t - phase));
    waveform.force[0].push_back(0.0);
    waveform.impulse[0].push_back(i == kPoints ? impulse : 0.0);
  }
  return waveform;
}

/// One contact after another, as the kept motion of a structure has them.
Waveform beside(Waveform first, const Waveform& second) {
  first.x.push_back(second.x[0]);
  first.velocity.push_back(second.velocity[0]);
  first.force.push_back(second.force[0]);
  first.impulse.push_back(second.impulse[0]);
  return first;
}

TEST(KeptMotions, AreNoneWhereRecordsKeepNone) {
  const std::vector<Record> records = test::records_of_two_methods();
  const Evaluation evaluation(records);
  EXPECT_FALSE(kept_motions(evaluation, "s1").leader.has_value());
  EXPECT_TRUE(kept_motions(evaluation, "s1").answers.empty());
  EXPECT_TRUE(kept_motions(evaluation, "no such scene").answers.empty());
}

TEST(KeptMotions, AreThoseOfTheBusiestContactInPhase) {
  std::vector<Record> records = test::records_of_two_methods();
  const Waveform early = half_frequency(0.0, -1.0), late = half_frequency(std::numbers::pi, -1.0);
  const Waveform quiet = half_frequency(0.5, -0.1);
  for (Record& record : records) {
    record.certificate.order = 2;
    const bool first = record.method == records.front().method;
    // The second method keeps the contacts in another order, on the orbit that begins a period later.
    record.waveforms =
        first ? Waveforms{.contacts = {4, 7}, .answer = beside(quiet, early), .orbit = beside(quiet, early)}
              : Waveforms{.contacts = {7, 4}, .answer = beside(late, quiet), .orbit = beside(late, quiet)};
  }
  const Evaluation evaluation(records);
  const KeptMotions kept = kept_motions(evaluation, "s1");
  ASSERT_EQ(kept.answers.size(), 2U);
  EXPECT_EQ(kept.contact, 7);
  EXPECT_EQ(kept.place, 1U);
  EXPECT_EQ(kept.orbit().x[1], early.x[0]);
  EXPECT_EQ(kept.answers[0].result->case_id, kept.leader->case_id);
  EXPECT_EQ(kept.answers[1].place, 0U);
  for (std::size_t i = 0; i < early.t.size(); i += 40)
    EXPECT_NEAR(kept.answers[1].motion.x[0][i], early.x[0][i], 1e-3) << early.t[i];
}

}  // namespace
}  // namespace signorini::drawn_waveform_test
