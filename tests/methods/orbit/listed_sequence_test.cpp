// Sequences from listed events: those of exact orbits come back, whatever hides the type of the motion.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "methods/event_driven/event_driven.hpp"
#include "methods/orbit/orbit_guess.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::listed_sequence_test {
namespace {

using Kind = ContactEvent::Kind;

// A motion of which only the public interface is left.
class Masked final : public Trajectory {
 public:
  explicit Masked(std::shared_ptr<const Trajectory> motion) : motion_(std::move(motion)) {}
  [[nodiscard]] int contact_count() const override { return motion_->contact_count(); }
  [[nodiscard]] double period() const override { return motion_->period(); }
  [[nodiscard]] Samples sample(int count) const override { return motion_->sample(count); }
  [[nodiscard]] std::vector<Impulse> impulses() const override { return motion_->impulses(); }
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override { return motion_->events(); }

 private:
  std::shared_ptr<const Trajectory> motion_;
};

std::vector<Problem> scenes() {
  Problem held =
      test::to_problem({.damping = 0.1, .load = 0.1, .frequency = 0.7, .gap = 0.0, .static_load = 1.0});
  return {test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}),
          test::to_problem({.damping = 0.1, .frequency = 0.4, .gap = 0.0, .restitution = 0.0}),
          test::to_problem({.damping = 0.02, .frequency = 0.5, .gap = 0.2, .restitution = 0.5}),
          test::stopped_chain(3, 0.0, 2, 0.3),
          test::skew_damped_pair(0.5),
          test::penalty_oscillator(1e4),
          held};
}

TEST(ListedSequence, OfAnExactOrbitIsTheOrbit) {
  for (const Problem& problem : scenes()) {
    const auto found = test::cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    OrbitModel model(problem);
    const auto guess = orbit_guess(model, Masked(found.orbit));
    ASSERT_TRUE(guess) << found.solution.message;
    EXPECT_EQ(guess->origin, "its own events");
    ASSERT_EQ(guess->events.size(), found.orbit->orbit().events.size());
    // The state is that of the orbit at the new section, to the conditioning of its equations.
    const State expected = found.orbit->at(guess->start.time);
    const MotionScales& scales = model.dynamics.scales();
    EXPECT_LT((guess->start.state.u - expected.u).norm(), 1e-9 * scales.displacement)
        << found.solution.message;
    EXPECT_LT((guess->start.state.v - expected.v).norm(), 1e-9 * scales.velocity) << found.solution.message;
    const OrbitSearch again = OrbitFinder(problem).find(Masked(found.orbit));
    EXPECT_TRUE(again.orbit.certified()) << again.orbit.reason;
    EXPECT_EQ(again.attempts, 1);
    EXPECT_LE(again.iterations, 3);
  }
}

TEST(ListedSequence, OfAMarchedChatterSticksFromItsLastImpactOn) {
  const Problem problem =
      test::to_problem({.damping = 0.02, .frequency = 0.5, .gap = 0.2, .restitution = 0.5});
  const Solution marched = test::solve<EventDriven>(problem, {.tolerance = 1e-8});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  OrbitModel model(problem);
  const auto guess = orbit_guess(model, *marched.trajectory);
  ASSERT_TRUE(guess);
  int closings = 0;
  for (const SequenceEvent& event : guess->events) {
    if (event.kind != Kind::close) continue;
    ++closings;
    EXPECT_EQ(event.restitution, std::vector<double>{0.0});
  }
  EXPECT_EQ(closings, 1);
  EXPECT_TRUE(OrbitFinder(problem).find(*marched.trajectory).orbit.certified());
}

TEST(ListedSequence, RefusesContradictions) {
  OrbitModel model(test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}));
  const auto sequence = [&](std::vector<ContactEvent> events) {
    return listed_sequence(model, std::move(events), 0.0, {false});
  };
  EXPECT_TRUE(sequence({{.kind = Kind::impact, .time = 1.0, .impulse = -1.0}}));
  EXPECT_FALSE(sequence({{.kind = Kind::open, .time = 1.0}, {.kind = Kind::open, .time = 2.0}}));
  EXPECT_FALSE(sequence({{.kind = Kind::close, .time = 1.0, .impulse = -1.0}}));  // never opens
}

TEST(ListedSequence, JoinsTheEventsOfOneInstant) {
  // A resting contact passes an impulse on that another one takes: the mass couples them.
  Problem chain = test::stopped_chain(3, 0.5, 2, 0.3);
  chain.edit_structure([](Structure& structure) {
    structure.mass = Eigen::Matrix3d{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.3}, {0.0, 0.3, 1.0}}.sparseView();
  });
  OrbitModel model(chain);
  const auto guess = listed_sequence(model,
                                     {{.kind = Kind::close, .contact = 0, .time = 1.0, .impulse = -1.0},
                                      {.kind = Kind::impact, .contact = 0, .time = 2.0, .impulse = -0.1},
                                      {.kind = Kind::impact, .contact = 1, .time = 2.0, .impulse = -1.0},
                                      {.kind = Kind::open, .contact = 0, .time = 3.0}},
                                     0.0, {false, false});
  ASSERT_TRUE(guess);
  ASSERT_EQ(guess->events.size(), 3U);
  const SequenceEvent& impact = guess->events[1];
  EXPECT_EQ(impact.contact, 1);
  EXPECT_EQ(impact.pushed, (std::vector<int>{0, 1}));
  EXPECT_EQ(impact.restitution, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(impact.closed, (std::vector<bool>{true, false}));
}

// From shortly behind the first event of an orbit that rests on its stop.
TEST(SimulatedSequence, BeginsInTheMiddleOfTheLongestTimeBetweenTwoEvents) {
  const Problem problem =
      test::to_problem({.damping = 0.1, .frequency = 0.4, .gap = 0.0, .restitution = 0.0});
  const auto found = test::cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  const auto& events = found.orbit->orbit().events;
  ASSERT_GE(events.size(), 2U);
  const double section = events[0].time + 0.05 * (events[1].time - events[0].time);
  OrbitModel model(problem);
  const auto guess = simulated_sequence(
      model, {.time = section, .state = found.orbit->at(section), .closed = {false}}, [] { return false; });
  ASSERT_TRUE(guess);
  ASSERT_EQ(guess->events.size(), events.size());
  const double before = guess->start.time + model.period - guess->events.back().time;
  const double after = guess->events.front().time - guess->start.time;
  EXPECT_NEAR(before, after, 1e-6 * model.period);
  for (std::size_t i = 1; i < guess->events.size(); ++i)
    EXPECT_LT(guess->events[i].time - guess->events[i - 1].time, before + after) << i;
}

}  // namespace
}  // namespace signorini::listed_sequence_test
