#pragma once
// Records of responses with figures that are easy to add up.

#include <string>
#include <utility>
#include <vector>

#include "harness/records/record.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "methods/curve.hpp"

namespace signorini::test {

/// The exact response of a scene: a branch of three points, the one in the middle unstable, and a fold there.
inline Record exact_response(const std::string& scene) {
  Record record;
  record.case_id = scene + "/exact response";
  record.key = record.case_id;
  record.scene = scene;
  record.method = "exact-orbit";
  record.law = record.scene_law = Restitution{1.0};
  record.law_matches_scene = true;
  record.coordinates = 1;
  record.contacts = 1;
  record.status = Status::converged;
  RecordedResponse& response = record.response.emplace();
  response.question = {.from = 1.0, .to = 2.0, .orders = 2, .way = ResponseWay::exact};
  response.points = 3;
  response.branches = {{.frequency = {1.0, 1.5, 2.0}, .amplitude = {0.1, 0.2, 0.3}, .stable = {1, 0, 1}}};
  response.located = {{.kind = SpecialKind::fold, .frequency = 1.5, .order = 1, .amplitude = 0.2}};
  return record;
}

/// That of a method, by arc length, which finds the fold of two points, 20 % off.
inline Record response_of(const std::string& scene, const std::string& method, double covered,
                          double length) {
  Record record = exact_response(scene);
  const CaseName name = parse_method_label(method);
  record.case_id = scene + "/" + method + " by arc length";
  record.key = record.case_id;
  record.method = name.method;
  record.settings = name.settings;
  record.seconds = Seconds{.median = 0.5, .min = 0.5, .repetitions = 1, .solve = 0.5};
  RecordedResponse& response = *record.response;
  response.question.way = ResponseWay::arc_length;
  CurveComparison& comparison = response.comparison.emplace();
  comparison = {.close = {.covered = covered, .false_share = 0.0},
                .wide = {.covered = covered, .false_share = 0.25},
                .exact_length = length,
                .length = 2.0,
                .right_length = 1.5};
  comparison.points = {{.exact = {SpecialKind::fold, 1.25, 1}, .frequency = 1.5},
                       {.exact = {SpecialKind::period_doubling, 1.75, 1}}};
  return record;
}

/// The same of a method that represents e = 1 where the scene has e = 0.5.
inline Record of_another_law(Record record) {
  record.scene_law = Restitution{0.5};
  record.law_matches_scene = false;
  return record;
}

/// A method that finds a share of the exact branches of scenes a, b and c at a cost, with a share of false
/// ones.
inline void add_method(std::vector<Record>& records, const std::string& method, double covered, double wrong,
                       double seconds) {
  for (const char* scene : {"a", "b", "c"}) {
    Record record = response_of(scene, method, covered, 1.0);
    record.response->comparison->wide.false_share = wrong;
    record.seconds->median = seconds;
    records.push_back(std::move(record));
  }
}

}  // namespace signorini::test
