#pragma once
// Records of responses with figures that are easy to add up.

#include <string>
#include <vector>

#include "harness/responses/response_record.hpp"

namespace signorini::test {

/// A branch of three points, the one in the middle unstable, and a fold there.
inline ResponseRecord exact_response(const std::string& scene) {
  ResponseRecord record{.case_id = scene + "/",
                        .scene = scene,
                        .from = 1.0,
                        .to = 2.0,
                        .scene_law = Restitution{1.0},
                        .coordinates = 1,
                        .contacts = 1,
                        .status = Status::converged};
  record.branches = {{.frequency = {1.0, 1.5, 2.0}, .amplitude = {0.1, 0.2, 0.3}, .stable = {1, 0, 1}}};
  record.located = {{.kind = SpecialKind::fold, .frequency = 1.5, .order = 1, .amplitude = 0.2}};
  return record;
}

/// Finds the fold of two points, 20 % off.
inline ResponseRecord response_of(const std::string& scene, const std::string& method, double covered,
                                  double length) {
  ResponseRecord record = exact_response(scene);
  record.case_id = scene + "/" + method;
  record.method = method;
  record.law = Restitution{1.0};
  record.law_matches_scene = true;
  record.seconds = 0.5;
  record.comparison = CurveComparison{.close = {.covered = covered, .false_share = 0.0},
                                      .wide = {.covered = covered, .false_share = 0.25},
                                      .exact_length = length,
                                      .length = 2.0,
                                      .right_length = 1.5};
  record.comparison->points = {{.exact = {SpecialKind::fold, 1.25, 1}, .frequency = 1.5},
                               {.exact = {SpecialKind::period_doubling, 1.75, 1}}};
  return record;
}

/// A method that finds a share of the exact branches of scenes a and b at a cost, with a share of false ones.
inline void add_method(std::vector<ResponseRecord>& records, const std::string& method, double covered,
                       double wrong, double seconds) {
  for (const char* scene : {"a", "b"}) {
    ResponseRecord record = response_of(scene, method, covered, 1.0);
    record.comparison->wide.false_share = wrong;
    record.seconds = seconds;
    records.push_back(record);
  }
}

}  // namespace signorini::test
