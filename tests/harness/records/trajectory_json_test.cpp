#include "harness/records/trajectory_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(TrajectoryJson, ComesBackAsItWent) {
  const auto source = test::free_motion(test::one_mass());
  const SampledTrajectory sampled(*source, 32);
  const auto back = trajectory_of(source->period(), samples_of(sampled, 32));
  EXPECT_EQ(back->sample(32).x, sampled.sample(32).x);
  EXPECT_EQ(back->bandwidth(), source->bandwidth());
  TrajectorySamples uneven = samples_of(sampled, 32);
  uneven.force[0].pop_back();
  EXPECT_THROW(trajectory_of(1.0, uneven), BadRecord);
}

TEST(TrajectoryJson, HoldsInstantsAndImpulses) {
  const TrajectorySamples samples = *test::full_record().trajectory;
  const auto json = to_json(samples);
  EXPECT_EQ(json.at("impulses").dump(), R"([{"contact":0,"time":0.25,"value":-2.0}])");
  EXPECT_EQ(trajectory_samples_from_json(json).impulses[0].value, -2.0);
  EXPECT_EQ(trajectory_samples_from_json(json).bandwidth, 10);
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
}

}  // namespace
}  // namespace signorini
