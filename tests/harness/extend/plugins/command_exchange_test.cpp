#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/run/trial.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::command_exchange_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPeriod = 2.0;  // [s]

/// A motion of one contact at two instants.
Json answer() {
  return {{"verdict", "converged"},
          {"residual", 1e-12},
          {"work", {{"iterations", 7}, {"points", 186}}},
          {"trajectory",
           {{"t", {0.0, 1.0}}, {"x", {{0.1, 0.2}}}, {"velocity", {{0.0, 0.0}}}, {"force", {{0.0, -1.0}}}}}};
}

std::string refusal(const Json& json) {
  try {
    static_cast<void>(read_command_answer(json.dump(), kPeriod));
  } catch (const SolveFailure& failure) {
    EXPECT_EQ(failure.status, Status::invalid_output);
    return failure.what();
  }
  return "accepted";
}

TEST(CommandRequest, HoldsTheWholeProblem) {
  const Problem problem = test::one_mass();
  const Json request = command_request(problem, {{"level", 3L, "[-]", "a level"}});
  EXPECT_EQ(request.at("schema"), 1);
  EXPECT_EQ(request.at("options"), (Json{{"level", 3}}));
  EXPECT_EQ(request.at("problem").at("size"), 1);
  EXPECT_EQ(request.at("problem").at("stiffness").at("value"), Json({1.0}));
  EXPECT_EQ(request.at("problem").at("contacts").at(0).at("gap"), 10.0);
  EXPECT_EQ(request.at("problem").at("law"), (Json{{"restitution", 1.0}}));
}

TEST(CommandRequest, OfAnotherFrequencyIsThatOfTheSceneThere) {
  Problem problem = test::one_mass();
  problem.force.front().omega_power = 2;
  Json request = command_request(problem, {});
  problem.frequency *= 1.5;
  EXPECT_NE(request, command_request(problem, {}));
  take_frequency(request, problem);
  EXPECT_EQ(request, command_request(problem, {}));
  EXPECT_EQ(request.at("problem").at("name"), "scene");
}

TEST(CommandInput, NamesTheTimeLeftOnlyWhereThereIsADeadline) {
  const Json request = command_request(test::one_mass(), {});
  EXPECT_FALSE(Json::parse(command_input(request, {})).contains("seconds"));
  const Start start{.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5)};
  const double seconds = Json::parse(command_input(request, start)).at("seconds");
  EXPECT_GT(seconds, 4.0);
  EXPECT_LE(seconds, 5.0);
}

TEST(ReadCommandAnswer, ReadsWhatTheCommandFound) {
  const Solution solution = read_command_answer(answer().dump(), kPeriod).solution;
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(solution.residual, 1e-12);
  EXPECT_EQ(solution.work.iterations, 7);
  EXPECT_EQ(solution.work.points, 186);
  EXPECT_FALSE(solution.work.unknowns.has_value());
  ASSERT_NE(solution.trajectory, nullptr);
  EXPECT_EQ(solution.trajectory->period(), kPeriod);
  EXPECT_EQ(solution.trajectory->sample(2).x(1, 0), 0.2);
  EXPECT_EQ(solution.trajectory->sample(2).force(1, 0), -1.0);
}

TEST(ReadCommandAnswer, MayBeOfAnotherPeriod) {
  Json json = answer();
  json["period"] = 4.0;
  json["trajectory"]["t"] = {0.0, 2.0};
  EXPECT_EQ(read_command_answer(json.dump(), kPeriod).solution.trajectory->period(), 4.0);
}

TEST(ReadCommandAnswer, HandsOnTheEventsThatACommandLists) {
  EXPECT_FALSE(read_command_answer(answer().dump(), kPeriod).solution.trajectory->events().has_value());
  Json json = answer();
  json["events"] = Json::array();
  EXPECT_TRUE(read_command_answer(json.dump(), kPeriod).solution.trajectory->events().value().empty());
  json["events"] = {{{"kind", "close"}, {"contact", 0}, {"time", 0.5}, {"impulse", -0.25}},
                    {{"kind", "open"}, {"contact", 0}, {"time", 1.5}, {"push", -0.125}}};
  const auto events = read_command_answer(json.dump(), kPeriod).solution.trajectory->events().value();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, ContactEvent::Kind::close);
  EXPECT_EQ(events[0].time, 0.5);
  EXPECT_EQ(events[0].impulse, -0.25);
  EXPECT_EQ(events[1].kind, ContactEvent::Kind::open);
  EXPECT_EQ(events[1].impulse, 0.0);
  EXPECT_FALSE(events[0].push.has_value());
  EXPECT_EQ(events[1].push, -0.125);
  // Those of a trajectory are of the motion that a command may have copied it from.
  Json copied = answer();
  copied["trajectory"]["events"] = json["events"];
  EXPECT_FALSE(read_command_answer(copied.dump(), kPeriod).solution.trajectory->events());
}

TEST(ReadCommandAnswer, RefusesEventsThatCannotBe) {
  const auto refused = [](const Json& events) {
    Json json = answer();
    json["events"] = events;
    return refusal(json);
  };
  const Json open{{"kind", "open"}, {"contact", 0}, {"time", 1.5}};
  Json other = open;
  other["kind"] = "bounce";
  EXPECT_NE(refused(Json::array({other})).find("events.kind = bounce"), std::string::npos);
  other = open;
  other["contact"] = 1;
  EXPECT_NE(refused(Json::array({other})).find("contact 1 of 1"), std::string::npos);
  other = open;
  other["time"] = 2.5;
  EXPECT_NE(refused(Json::array({other})).find("outside the period"), std::string::npos);
  other = open;
  other["time"] = 1.0;
  EXPECT_NE(refused(Json::array({open, other})).find("comes after"), std::string::npos);
  other = open;
  other["push"] = 0.125;
  EXPECT_NE(refused(Json::array({other})).find("ends a push of 0.125 N s"), std::string::npos);
  EXPECT_NE(refused(Json::array({1})), "accepted");
}

TEST(ReadCommandAnswer, RefusesCountsThatNobodyCounted) {
  Json negative = answer();
  negative["work"]["iterations"] = -7;
  EXPECT_NE(refusal(negative).find("work.iterations = -7 (must be 0 or more)"), std::string::npos);
  Json unknown = answer();
  unknown["work"]["flops"] = 7;
  EXPECT_NE(refusal(unknown).find("work.flops = unknown"), std::string::npos);
  for (const long bandwidth : {-5L, 2'000'000'000L}) {
    Json wide = answer();
    wide["trajectory"]["bandwidth"] = bandwidth;
    EXPECT_NE(refusal(wide).find("trajectory.bandwidth = "), std::string::npos) << bandwidth;
  }
}

TEST(ReadCommandAnswer, RefusesWhatIsNoAnswer) {
  Json json = answer();
  json["colour"] = "red";
  EXPECT_NE(refusal(json).find("colour = unknown"), std::string::npos) << refusal(json);
  json = answer();
  json["verdict"] = "perhaps";
  EXPECT_NE(refusal(json).find("verdict = perhaps"), std::string::npos) << refusal(json);
  json = answer();
  json["trajectory"]["t"] = {0.0, 0.5};
  EXPECT_NE(refusal(json).find("trajectory.t[1]"), std::string::npos) << refusal(json);
  json = answer();
  json["trajectory"]["x"] = {{0.1}};
  EXPECT_NE(refusal(json).find("uneven"), std::string::npos) << refusal(json);
  EXPECT_NE(refusal(Json::array({1, 2})).find("no JSON object"), std::string::npos);
}

TEST(ReadCommandAnswer, TakesTheTimeThatTheCommandTells) {
  Json json = answer();
  EXPECT_FALSE(read_command_answer(json.dump(), kPeriod).seconds.has_value());
  json["seconds"] = 0.25;
  EXPECT_EQ(read_command_answer(json.dump(), kPeriod).seconds, 0.25);
  json["seconds"] = -0.25;
  EXPECT_EQ(refusal(json), "the command's answer: seconds = -0.25 (must be 0 or more)");
}

}  // namespace
}  // namespace signorini::command_exchange_test
