#include "methods/discretisation/contact_phases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace signorini::contact_phases_test {
namespace {

TEST(StopShift, CountsTimeFromItsMiddleTheShortWayRound) {
  const StopShift shift{.time = 0.9, .distance = 1.0, .speed = 10.0};
  EXPECT_NEAR(shift.since(0.95), 0.05, 1e-15);
  EXPECT_NEAR(shift.since(0.1), 0.2, 1e-15);  // across the end of the period
  EXPECT_NEAR(shift.since(0.5), -0.4, 1e-15);
  EXPECT_NEAR(shift.at(0.1), 3.0, 1e-14);
  for (int k = 0; k < 200; ++k) {
    EXPECT_LE(std::abs(shift.since(0.01 * k)), 0.5);
    if (k % 100 == 40) continue;  // half a period away, where both signs are right
    EXPECT_NEAR(shift.since(0.01 * k), shift.since(0.01 * k + 3.0), 1e-13);
  }
}

TEST(ShiftAt, IsThatOfTheContactWhoseIntervalIsNearest) {
  // The second contact lasts, from 0.4 to 0.8.
  const std::vector<StopShift> shifts{{.time = 0.1, .width = 0.0, .distance = 1.0},
                                      {.time = 0.6, .width = 0.4, .distance = 2.0}};
  EXPECT_EQ(shift_at(shifts, 0.12).distance, 1.0);
  EXPECT_EQ(shift_at(shifts, 0.45).distance, 2.0);
  EXPECT_EQ(shift_at(shifts, 0.24).distance, 1.0);  // 0.14 from the first, 0.16 from the second
  EXPECT_EQ(shift_at(shifts, 0.26).distance, 2.0);
  EXPECT_EQ(shift_at(shifts, 0.97).distance,
            1.0);  // 0.13 from the first, across the end; 0.17 from the second
}

TEST(ShiftAt, IsNoneWhereThereAreNoShifts) { EXPECT_EQ(shift_at({}, 0.3).at(0.3), 0.0); }

using Spans = std::vector<std::pair<int, int>>;

// Phases of a force that is -1 where the text has '#'.
Spans phases_of(const std::string& text, int resolution) {
  Eigen::VectorXd force(static_cast<Eigen::Index>(text.size()));
  for (std::size_t i = 0; i < text.size(); ++i) force[static_cast<Eigen::Index>(i)] = text[i] == '#' ? -1 : 0;
  Spans spans;
  for (const SampledPhase& phase : contact_phases(force, 0.5, resolution))
    spans.emplace_back(phase.first, phase.length);
  return spans;
}

TEST(SampledPhases, AreTheRunsOfPushingSamples) {
  EXPECT_EQ(phases_of("........", 1), Spans{});
  EXPECT_EQ(phases_of(".##...#.", 1), (Spans{{1, 2}, {6, 1}}));
  EXPECT_EQ(phases_of("########", 1), (Spans{{0, 8}}));
  EXPECT_EQ(phases_of("#.######", 1), (Spans{{2, 7}}));
}

TEST(SampledPhases, RunAcrossTheEndOfThePeriod) {
  EXPECT_EQ(phases_of("##....##", 1), (Spans{{6, 4}}));
  EXPECT_EQ(phases_of("#.#...#.", 2), (Spans{{6, 5}}));
}

TEST(SampledPhases, BridgeBreaksShorterThanTheResolution) {
  EXPECT_EQ(phases_of(".#.#..#....", 2), (Spans{{1, 3}, {6, 1}}));
  EXPECT_EQ(phases_of(".#.#..#....", 3), (Spans{{1, 6}}));
  // A break of just the resolution separates.
  EXPECT_EQ(phases_of("..#######", 2), (Spans{{2, 7}}));
  EXPECT_EQ(phases_of("..#######", 3), (Spans{{0, 9}}));
}

TEST(SampledPhases, IgnoreForcesUpToTheThreshold) {
  const Eigen::VectorXd force = (Eigen::VectorXd(5) << -1.0, -0.5, 0.0, -0.6, 0.7).finished();
  const auto phases = contact_phases(force, 0.5, 1);
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_EQ(phases[0].first, 0);
  EXPECT_EQ(phases[1].first, 3);
}

// Two pushing samples belong to one phase if, on one side at least, no longer break lies between them.
TEST(SampledPhases, CoverWhatASearchOfEveryBreakSaysOnRandomForces) {
  std::mt19937 generator(7);
  std::bernoulli_distribution pushes(0.4);
  constexpr int kCount = 40;
  for (int trial = 0; trial < 300; ++trial) {
    const int resolution = 1 + trial % 5;
    std::string text(kCount, '.');
    for (char& place : text) place = pushes(generator) ? '#' : '.';
    std::vector<bool> open(kCount, false);  // samples in a break of at least `resolution`
    for (int i = 0; i < kCount; ++i) {
      const auto free = [&](int k) { return text[static_cast<std::size_t>((i + k) % kCount)] == '.'; };
      int length = 0;
      while (length < resolution && free(length)) ++length;
      for (int k = 0; length == resolution && k < length; ++k)
        open[static_cast<std::size_t>((i + k) % kCount)] = true;
    }
    std::vector<bool> covered(kCount, false);
    for (const auto& [first, length] : phases_of(text, resolution))
      for (int k = 0; k < length; ++k) covered[static_cast<std::size_t>((first + k) % kCount)] = true;
    if (text.find('#') == std::string::npos) open.assign(kCount, true);
    for (int i = 0; i < kCount; ++i)
      EXPECT_NE(covered[static_cast<std::size_t>(i)], open[static_cast<std::size_t>(i)]) << text << " " << i;
  }
}

TEST(IntervalPhases, JoinIntervalsAcrossShortBreaks) {
  const auto phases = contact_phases({{0.1, 0.2}, {0.25, 0.3}, {0.6, 0.7}}, 0.1);
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_EQ(phases[0].size(), 2U);
  EXPECT_EQ(phases[1].front().begin, 0.6);
  EXPECT_EQ(contact_phases({{0.1, 0.2}, {0.25, 0.3}, {0.6, 0.7}}, 0.01).size(), 3U);
}

TEST(IntervalPhases, JoinTheFirstPhaseToTheLastAcrossTheEndOfThePeriod) {
  const auto phases = contact_phases({{0.01, 0.1}, {0.5, 0.6}, {0.9, 0.98}}, 0.05);
  ASSERT_EQ(phases.size(), 2U);
  ASSERT_EQ(phases[1].size(), 2U);
  EXPECT_EQ(phases[1][0].begin, 0.9);
  EXPECT_DOUBLE_EQ(phases[1][1].begin, 1.01);
  EXPECT_DOUBLE_EQ(phases[1][1].end, 1.1);
  // Alone, a phase keeps its break.
  EXPECT_EQ(contact_phases({{0.01, 0.99}}, 0.05).size(), 1U);
  EXPECT_TRUE(contact_phases(std::vector<ContactInterval>{}, 0.05).empty());
}

TEST(ListedContacts, RunFromAClosingToTheNextOpeningOfTheSameContact) {
  using Kind = ContactEvent::Kind;
  const std::vector<ContactEvent> events{{Kind::open, 0, 0.5},   {Kind::close, 1, 1.0},
                                         {Kind::impact, 1, 1.5}, {Kind::impact, 0, 2.0},
                                         {Kind::open, 1, 2.5},   {Kind::close, 0, 3.5}};
  const std::vector<ListedContact> contacts = listed_contacts(events, 4.0);
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[0].opening, 0U);
  EXPECT_EQ(contacts[0].contact, 0);
  EXPECT_DOUBLE_EQ(contacts[0].begin, 3.5) << "across the end of the period";
  EXPECT_DOUBLE_EQ(contacts[0].end, 4.5);
  EXPECT_EQ(contacts[1].opening, 4U);
  EXPECT_DOUBLE_EQ(contacts[1].begin, 1.0) << "an impact within a contact does not end it";
  EXPECT_DOUBLE_EQ(contacts[1].end, 2.5);
  EXPECT_TRUE(listed_contacts({{Kind::open, 0, 0.5}}, 4.0).empty());
  EXPECT_TRUE(listed_contacts({}, 4.0).empty());
}

}  // namespace
}  // namespace signorini::contact_phases_test
