#include "harness/orbits/orbit_candidate.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/records/record_json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;
using Origin = OrbitCandidate::Origin;

constexpr std::array<std::pair<Origin, std::string_view>, 4> kOrigins{
    {{Origin::rest, "rest"}, {Origin::method, "method"}, {Origin::grid, "grid"}, {Origin::state, "state"}}};
constexpr std::array<std::pair<ContactEvent::Kind, std::string_view>, 3> kKinds{
    {{ContactEvent::Kind::impact, "impact"},
     {ContactEvent::Kind::close, "close"},
     {ContactEvent::Kind::open, "open"}}};

template <class Names, class Value>
std::string name_in(const Names& names, Value value) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == value; });
  return std::string(found->second);
}

template <class Names>
auto value_in(const Names& names, const std::string& name) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == name; });
  if (found == names.end()) throw BadRecord("\"" + name + "\" is no value of this key");
  return found->first;
}

Json list(const Eigen::VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

Eigen::VectorXd vector(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Json guess_to_json(const OrbitGuess& guess) {
  Json events = Json::array();
  for (const SequenceEvent& event : guess.events) {
    events.push_back({{"kind", name_in(kKinds, event.kind)},
                      {"contact", event.contact},
                      {"time", event.time},
                      {"pushed", event.pushed},
                      {"restitution", event.restitution},
                      {"closed", event.closed}});
  }
  return {{"time", guess.start.time},     {"u", list(guess.start.state.u)}, {"v", list(guess.start.state.v)},
          {"closed", guess.start.closed}, {"events", std::move(events)},    {"origin", guess.origin}};
}

OrbitGuess guess_from_json(const Json& json) {
  OrbitGuess guess{.start = {.time = json.at("time"),
                             .state = {.u = vector(json.at("u")), .v = vector(json.at("v"))},
                             .closed = json.at("closed").get<std::vector<bool>>()},
                   .events = {},
                   .origin = json.at("origin")};
  for (const Json& event : json.at("events")) {
    guess.events.push_back({.kind = value_in(kKinds, event.at("kind").get<std::string>()),
                            .contact = event.at("contact"),
                            .time = event.at("time"),
                            .pushed = event.at("pushed").get<std::vector<int>>(),
                            .restitution = event.at("restitution").get<std::vector<double>>(),
                            .closed = event.at("closed").get<std::vector<bool>>()});
  }
  return guess;
}

}  // namespace

void take_search(const OrbitSearch& search, OrbitCandidate& candidate) {
  if (search.orbit.certified()) {
    candidate.orbit = search.orbit.trajectory->orbit();
  } else {
    candidate.reason = describe(search.orbit.outcome);
  }
}

SearchOptions search_until(Deadline deadline) {
  SearchOptions options;
  options.expired = [deadline] { return Start{.guess = {}, .deadline = deadline}.expired(); };
  return options;
}

Json to_json(const OrbitCandidate& candidate) {
  Json json{{"origin", name_in(kOrigins, candidate.origin)},
            {"source", candidate.source},
            {"order", candidate.order},
            {"near", candidate.near},
            {"reason", candidate.reason}};
  if (candidate.orbit) json["orbit"] = guess_to_json(*candidate.orbit);
  return json;
}

OrbitCandidate orbit_candidate_from_json(const Json& json) {
  try {
    OrbitCandidate candidate{.origin = value_in(kOrigins, json.at("origin").get<std::string>()),
                             .source = json.at("source"),
                             .order = json.at("order"),
                             .near = json.at("near"),
                             .orbit = {},
                             .reason = json.at("reason")};
    if (json.contains("orbit")) candidate.orbit = guess_from_json(json["orbit"]);
    return candidate;
  } catch (const nlohmann::json::exception& error) {
    throw BadRecord(error.what());
  }
}

}  // namespace signorini
