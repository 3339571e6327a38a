#pragma once
// The fields of a response in a record.

#include <array>
#include <string_view>

#include "harness/records/json_fields.hpp"
#include "harness/records/recorded_response.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// The names in record files.
template <>
struct EnumNames<ResponseWay> {
  /// In order.
  static constexpr std::array<std::string_view, 3> values{"exact", "arc-length", "steps"};
};

void visit_fields(Either<LocatedPoint> auto& point, auto&& field) {
  field(required("kind"), point.kind);
  field(required("omega", "rad/s"), point.frequency);
  field(required("order"), point.order);
  field(Field{"amplitude", "m"}, point.amplitude);
}

void visit_fields(Either<CurveShares> auto& shares, auto&& field) {
  field(required("covered"), shares.covered);
  field(Field{"covered_stable"}, shares.covered_stable);
  field(required("false"), shares.false_share);
}

void visit_fields(Either<PointMatch> auto& match, auto&& field) {
  field(required("exact"), match.exact);
  field(Field{"omega", "rad/s"}, match.frequency);
}

void visit_fields(Either<CurveComparison> auto& comparison, auto&& field) {
  field(required("within_0.02"), comparison.close);
  field(required("within_0.05"), comparison.wide);
  field(required("exact_length"), comparison.exact_length);
  field(required("length"), comparison.length);
  field(required("right_length"), comparison.right_length);
  field(Field{"points", "", Presence::always}, comparison.points);
  field(Field{"invented", "", Presence::always}, comparison.invented);
}

void visit_fields(Either<DrawnBranch> auto& branch, auto&& field) {
  field(required("omega", "rad/s"), branch.frequency);
  field(required("amplitude", "m"), branch.amplitude);
  field(required("stable"), branch.stable);
  field(Field{"motion", "m"}, branch.motion);
  field(Field{"by_steps"}, branch.by_steps);
}

void visit_fields(Either<RecordedResponse> auto& response, auto&& field) {
  field(required("way"), response.question.way);
  field(required("from", "rad/s"), response.question.from);
  field(required("to", "rad/s"), response.question.to);
  field(required("orders"), response.question.orders);
  field(required("points"), response.points);
  field(Field{"comparison"}, response.comparison);
  field(Field{"located"}, response.located);
  field(Field{"open_ends"}, response.open_ends);
  field(Field{"branches"}, response.branches);
}

}  // namespace signorini
