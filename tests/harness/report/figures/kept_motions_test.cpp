#include "harness/report/figures/kept_motions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/harness/sample_records.hpp"

namespace signorini::kept_motions_test {
namespace {

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
}  // namespace signorini::kept_motions_test
