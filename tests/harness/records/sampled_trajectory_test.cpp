#include "harness/records/sampled_trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::sampled_trajectory_test {

namespace {

TEST(SampledTrajectory, GivesBackItsSamplesBitByBit) {
  const auto source = test::free_motion(test::one_mass());
  const SampledTrajectory sampled(*source, 512);
  const Samples stored = sampled.data().samples;
  EXPECT_EQ(sampled.sample(512).x, stored.x);
  const Samples thinned = sampled.sample(128);
  for (int i = 0; i < 128; ++i) EXPECT_EQ(thinned.x(i, 0), stored.x(4 * i, 0));
}

TEST(SampledTrajectory, InterpolatesAtFourthOrder) {
  const auto source = test::free_motion(test::one_mass());
  const auto error = [&](int stored) {
    return (SampledTrajectory(*source, stored).sample(3000).x - source->sample(3000).x).cwiseAbs().maxCoeff();
  };
  const double order = std::log2(error(64) / error(128));
  EXPECT_NEAR(order, 4.0, 0.2);
}

TEST(SampledTrajectory, RefusesWhatIsNoMotion) {
  const auto source = test::free_motion(test::one_mass());
  SampledTrajectory::Data data{source->period(), source->sample(16), {}, {}};
  data.samples.force(3, 0) = std::nan("");
  EXPECT_THROW(SampledTrajectory{data}, std::invalid_argument);
  data = {0.0, source->sample(16), {}, {}};
  EXPECT_THROW(SampledTrajectory{data}, std::invalid_argument);
  data = {1.0, source->sample(16), {{.contact = 2, .time = 0.0, .value = -1.0}}, {}};
  EXPECT_THROW(SampledTrajectory{data}, std::invalid_argument);
}

SampledTrajectory with_an_impulse() {
  SampledTrajectory::Data data{.period = 2.0,
                               .samples = {},
                               .impulses = {{.contact = 0, .time = 1.75, .value = -3.0}},
                               .bandwidth = 5};
  data.samples.x = Eigen::Vector4d(0.0, 1.0, 2.0, 3.0);
  data.samples.velocity = data.samples.force = -data.samples.x;
  return SampledTrajectory(std::move(data));
}

TEST(Delayed, MovesSamplesAndImpulsesBackInTime) {
  const SampledTrajectory late = delayed(with_an_impulse(), 0.25);
  EXPECT_EQ(late.sample(4).x.col(0), Eigen::Vector4d(3.0, 0.0, 1.0, 2.0));
  EXPECT_EQ(late.sample(4).force.col(0), Eigen::Vector4d(-3.0, 0.0, -1.0, -2.0));
  EXPECT_DOUBLE_EQ(late.impulses().front().time, 0.25);
  EXPECT_EQ(delayed(with_an_impulse(), 0.0).impulses().front().time, 1.75);
}

TEST(Repeated, TakesSeveralPeriodsForOne) {
  const SampledTrajectory twice = repeated(with_an_impulse(), 2);
  EXPECT_EQ(twice.period(), 4.0);
  EXPECT_EQ(twice.sample(8).x(5, 0), 1.0);
  EXPECT_EQ(twice.bandwidth(), 10);
  ASSERT_EQ(twice.impulses().size(), 2U);
  EXPECT_EQ(twice.impulses()[1].time, 3.75);
}

TEST(TrajectoryDefect, NamesWhatNoAnswerMayHave) {
  const auto defect = [](int contacts, double forcing_period) {
    return trajectory_defect(with_an_impulse(), contacts, forcing_period);
  };
  EXPECT_EQ(defect(1, 2.0), "");
  EXPECT_EQ(defect(1, 1.0), "") << "two forcing periods";
  EXPECT_EQ(defect(2, 2.0), "the trajectory has 1 contacts, the scene 2");
  EXPECT_NE(defect(1, 3.0).find("no whole multiple"), std::string::npos) << "shorter than the forcing period";
  EXPECT_NE(defect(1, 1.9).find("no whole multiple"), std::string::npos);
  EXPECT_EQ(defect(1, 2.0 * (1.0 + 1e-7)), "") << "within a millionth";
  EXPECT_EQ(defect(1, 2.0 / 256), "");
  EXPECT_NE(defect(1, 2e-9).find("more than 256 forcing periods"), std::string::npos)
      << "whoever samples it would need more memory than there is";
}

TEST(SamplesDefect, NamesWrongSizesAndNumbersThatAreNotFinite) {
  Samples samples = with_an_impulse().sample(4);
  EXPECT_EQ(samples_defect(samples, 4, 1), "");
  EXPECT_EQ(samples_defect(samples, 8, 1), "x has 4 x 1 samples, 8 x 1 were asked for");
  samples.velocity(2, 0) = std::nan("");
  EXPECT_EQ(samples_defect(samples, 4, 1), "velocity has values that are not finite");
  samples.velocity.resize(4, 2);
  EXPECT_EQ(samples_defect(samples, 4, 1), "velocity has 4 x 2 samples, 4 x 1 were asked for");
}

/// A motion at rest, of period 2 s, with events at 0.5 s and 1.75 s.
SampledTrajectory::Data with_events() {
  SampledTrajectory::Data data{.period = 2.0, .samples = {}, .impulses = {}, .bandwidth = {}};
  data.samples.x = data.samples.velocity = data.samples.force = Eigen::MatrixXd::Zero(8, 1);
  data.events = {{.kind = ContactEvent::Kind::close, .contact = 0, .time = 0.5},
                 {.kind = ContactEvent::Kind::open, .contact = 0, .time = 1.75}};
  return data;
}

TEST(Delayed, MovesEventsAndKeepsThemInOrder) {
  const auto events = delayed(SampledTrajectory(with_events()), 0.25).events().value();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, ContactEvent::Kind::open);
  EXPECT_DOUBLE_EQ(events[0].time, 0.25);
  EXPECT_DOUBLE_EQ(events[1].time, 1.0);
}

TEST(Repeated, RepeatsEvents) {
  const auto events = repeated(SampledTrajectory(with_events()), 3).events().value();
  ASSERT_EQ(events.size(), 6U);
  EXPECT_DOUBLE_EQ(events.back().time, 5.75);
}

TEST(SampledTrajectory, RefusesEventsThatCannotBe) {
  const auto with = [](ContactEvent event) {
    SampledTrajectory::Data data = with_events();
    data.events->push_back(event);
    return data;
  };
  using Kind = ContactEvent::Kind;
  EXPECT_NO_THROW(SampledTrajectory(with({.kind = Kind::close, .contact = 0, .time = 1.8})));
  for (const ContactEvent& event : {ContactEvent{.kind = Kind::close, .contact = 1, .time = 1.8},
                                    ContactEvent{.kind = Kind::close, .contact = 0, .time = 2.1},
                                    ContactEvent{.kind = Kind::close, .contact = 0, .time = 1.0}})
    EXPECT_THROW(SampledTrajectory(with(event)), std::invalid_argument) << event.time;
}

TEST(TrajectoryJson, ComesBackAsItWent) {
  const auto source = test::free_motion(test::one_mass());
  const SampledTrajectory sampled(*source, 32);
  const auto back = trajectory_of(source->period(), samples_of(sampled, 32));
  EXPECT_EQ(back->sample(32).x, sampled.sample(32).x);
  EXPECT_EQ(back->bandwidth(), source->bandwidth());
  EXPECT_FALSE(back->events());
  const SampledTrajectory listed(with_events());
  const auto again = trajectory_of(listed.period(), samples_of(listed, 8))->events();
  ASSERT_TRUE(again);
  ASSERT_EQ(again->size(), listed.events()->size());
  for (std::size_t i = 0; i < again->size(); ++i) {
    EXPECT_EQ(again->at(i).kind, listed.events()->at(i).kind);
    EXPECT_EQ(again->at(i).time, listed.events()->at(i).time);
  }
  TrajectorySamples uneven = samples_of(sampled, 32);
  uneven.force[0].pop_back();
  EXPECT_THROW(trajectory_of(1.0, uneven), BadRecord);
}

TEST(TrajectoryJson, HoldsInstantsAndImpulses) {
  const TrajectorySamples samples = *test::full_record().trajectory;
  const auto json = write_fields(samples);
  EXPECT_EQ(json.at("impulses").dump(), R"([{"contact":0,"time":0.25,"value":-2.0}])");
  TrajectorySamples back;
  read_fields(json, back);
  EXPECT_EQ(back.impulses[0].value, -2.0);
  EXPECT_EQ(back.bandwidth, 10);
  ASSERT_TRUE(back.events);
  ASSERT_EQ(back.events->size(), 2U);
  EXPECT_EQ(back.events->at(0).kind, ContactEvent::Kind::impact);
  EXPECT_EQ(back.events->at(0).impulse, -2.0);
  EXPECT_EQ(back.events->at(1).push, -0.5);
  const auto source = test::free_motion(test::one_mass());
  EXPECT_EQ(samples_of(*source, 4).t, (std::vector<double>{0.0, 0.25 * source->period(),
                                                           0.5 * source->period(), 0.75 * source->period()}));
}

/// What a start from a file of this text is refused with.
std::string refusal(std::string_view text) {
  const std::filesystem::path file = test::fresh_folder("start") / "start.json";
  write_whole(file, std::string(text));
  try {
    start_from_file(file.string());
    return "read";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(StartFromFile, ReadsTheRecordOfASolveWithSamples) {
  EXPECT_EQ(refusal(to_json(test::full_record()).dump()), "read");
}

TEST(StartFromFile, NamesTheFileAndWhatIsWrongWithIt) {
  Record record = test::full_record();
  record.trajectory.reset();
  EXPECT_NE(refusal("{ torn").find("start.json (must be JSON as printed by solve"), std::string::npos);
  EXPECT_NE(refusal("{}").find("key 'schema' not found"), std::string::npos) << refusal("{}");
  EXPECT_NE(refusal(to_json(record).dump()).find("must hold a trajectory"), std::string::npos);
  EXPECT_THROW(start_from_file("no-such-file"), UsageError);
  for (const int bandwidth : {-5, 1000001}) {
    record = test::full_record();
    record.trajectory->bandwidth = bandwidth;
    EXPECT_NE(refusal(to_json(record).dump()).find("trajectory.bandwidth"), std::string::npos) << bandwidth;
  }
}

TEST(SampledTrajectory, RefusesNumbersWhoseSquaresOverflow) {
  const auto source = test::free_motion(test::one_mass());
  Samples samples = source->sample(16);
  EXPECT_EQ(samples_defect(samples, 16, 1), "");
  samples.force(3, 0) = -1e308;
  EXPECT_NE(samples_defect(samples, 16, 1).find("1e+308"), std::string::npos);
}

}  // namespace

}  // namespace signorini::sampled_trajectory_test
