#include "harness/orbits/orbit_candidate.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "harness/records/record_json.hpp"

namespace signorini::orbit_candidate_test {
namespace {

using Json = nlohmann::ordered_json;

OrbitCandidate candidate() {
  OrbitCandidate found{.origin = OrbitCandidate::Origin::grid, .source = "grid 48", .order = 3, .near = true};
  found.orbit = OrbitGuess{
      .start = {.time = 0.1,
                .state = {.u = Eigen::Vector2d(1.0 / 3.0, -2e-300), .v = Eigen::Vector2d(0.7, 1e300)},
                .closed = {false, true}},
      .events = {{.kind = ContactEvent::Kind::close,
                  .contact = 1,
                  .time = 0.3,
                  .pushed = {0, 1},
                  .restitution = {0.5, 0.0},
                  .closed = {false, true}}},
      .origin = "a state"};
  return found;
}

TEST(OrbitCandidateJson, ComesBackAsItWentBitByBit) {
  const OrbitCandidate sent = candidate();
  const OrbitCandidate back = orbit_candidate_from_json(Json::parse(to_json(sent).dump()));
  EXPECT_EQ(back.origin, sent.origin);
  EXPECT_EQ(back.source, sent.source);
  EXPECT_EQ(back.order, 3);
  EXPECT_TRUE(back.near);
  ASSERT_TRUE(back.orbit);
  EXPECT_EQ(back.orbit->start.time, 0.1);
  EXPECT_EQ(back.orbit->start.state.u, sent.orbit->start.state.u);
  EXPECT_EQ(back.orbit->start.state.v, sent.orbit->start.state.v);
  EXPECT_EQ(back.orbit->start.closed, sent.orbit->start.closed);
  EXPECT_EQ(back.orbit->origin, "a state");
  ASSERT_EQ(back.orbit->events.size(), 1U);
  const SequenceEvent& event = back.orbit->events.front();
  EXPECT_EQ(event.kind, ContactEvent::Kind::close);
  EXPECT_EQ(event.contact, 1);
  EXPECT_EQ(event.time, 0.3);
  EXPECT_EQ(event.pushed, (std::vector<int>{0, 1}));
  EXPECT_EQ(event.restitution, (std::vector<double>{0.5, 0.0}));
  EXPECT_EQ(event.closed, (std::vector<bool>{false, true}));
}

TEST(OrbitCandidateJson, NamesWhatItMeans) {
  const Json json = to_json(candidate());
  EXPECT_EQ(json.at("origin"), "grid");
  EXPECT_EQ(json.at("orbit").at("events").at(0).at("kind"), "close");
  OrbitCandidate none{.origin = OrbitCandidate::Origin::rest, .reason = "it wanders"};
  EXPECT_EQ(to_json(none).at("origin"), "rest");
  EXPECT_FALSE(to_json(none).contains("orbit"));
  EXPECT_EQ(orbit_candidate_from_json(to_json(none)).reason, "it wanders");
}

TEST(OrbitCandidateJson, RefusesUnknownNamesAndMissingKeys) {
  Json json = to_json(candidate());
  json["origin"] = "heaven";
  EXPECT_THROW(orbit_candidate_from_json(json), BadRecord);
  json = to_json(candidate());
  json["orbit"]["events"][0]["kind"] = "bounce";
  EXPECT_THROW(orbit_candidate_from_json(json), BadRecord);
  json.erase("source");
  EXPECT_THROW(orbit_candidate_from_json(json), BadRecord);
}

TEST(SearchUntil, ExpiresAtTheDeadline) {
  EXPECT_TRUE(search_until(Deadline::min()).expired());
  EXPECT_FALSE(search_until(Deadline::max()).expired());
}

}  // namespace
}  // namespace signorini::orbit_candidate_test
