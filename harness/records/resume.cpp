#include "harness/records/resume.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>

#include "harness/failure.hpp"
#include "harness/records/merge.hpp"

namespace signorini {

namespace {

bool same_keys(const RunFolder& before, const RunFolder& now) {
  using Pointer = nlohmann::ordered_json::json_pointer;
  constexpr std::array kPlaces{"/limits", "/build/sources"};
  return std::all_of(kPlaces.begin(), kPlaces.end(), [&](const char* place) {
    const Pointer pointer(place);
    return before.manifest.contains(pointer) && now.manifest.contains(pointer) &&
           before.manifest.at(pointer) == now.manifest.at(pointer);
  });
}

}  // namespace

void require_same_machine(const RunFolder& before, const RunFolder& now) {
  if (const auto found = machine_difference(before, now)) throw UsageError(*found);
}

std::vector<PlannedCase> joined_plan(const RunFolder& before, const RunFolder& now) {
  std::vector<PlannedCase> plan = now.plan;
  if (!same_keys(before, now) || plugin_difference(before, now)) return plan;
  std::unordered_set<std::string> cases;
  for (const PlannedCase& one : now.plan) cases.insert(one.case_id);
  std::copy_if(before.plan.begin(), before.plan.end(), std::back_inserter(plan),
               [&](const PlannedCase& one) { return !cases.contains(one.case_id); });
  return plan;
}

}  // namespace signorini
