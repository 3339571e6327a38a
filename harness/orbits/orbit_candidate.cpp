#include "harness/orbits/orbit_candidate.hpp"

#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"

namespace signorini {

template <>
struct JsonForm<Eigen::VectorXd> {
  static nlohmann::ordered_json write(const Eigen::VectorXd& values) {
    return std::vector<double>(values.begin(), values.end());
  }
  static Eigen::VectorXd read(const nlohmann::ordered_json& json) {
    const auto values = json.get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
};

void visit_fields(Either<SequenceEvent> auto& event, auto&& field) {
  field(required("kind"), event.kind);
  field(required("contact"), event.contact);
  field(required("time"), event.time);
  field(required("pushed"), event.pushed);
  field(required("restitution"), event.restitution);
  field(required("closed"), event.closed);
}

void visit_fields(Either<OrbitGuess> auto& guess, auto&& field) {
  field(required("time"), guess.start.time);
  field(required("u"), guess.start.state.u);
  field(required("v"), guess.start.state.v);
  field(required("closed"), guess.start.closed);
  field(required("events"), guess.events);
  field(required("origin"), guess.origin);
}

void visit_fields(Either<OrbitCandidate> auto& candidate, auto&& field) {
  field(required("origin"), candidate.origin);
  field(required("source"), candidate.source);
  field(required("order"), candidate.order);
  field(required("near"), candidate.near);
  field(required("reason"), candidate.reason);
  field(Field{"orbit"}, candidate.orbit);
}

nlohmann::ordered_json to_json(const OrbitCandidate& candidate) { return write_fields(candidate); }

OrbitCandidate orbit_candidate_from_json(const nlohmann::ordered_json& json) {
  OrbitCandidate candidate;
  try {
    read_fields(json, candidate);
  } catch (const nlohmann::json::exception& error) {
    throw BadRecord(error.what());
  }
  return candidate;
}

}  // namespace signorini
