#include "harness/run/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/isolation/isolation.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

/// Processes at the same time: nothing is being timed while references are computed.
constexpr int kReferenceProcesses = 2;

/// For an orbit that is kept, where no time is given to the search for one [s].
constexpr double kKeptSeconds = 1.0;

std::string key_of(const RepresentedLaw& law, const Problem& problem) {
  const bool undetermined = std::holds_alternative<Undetermined>(law);
  return json_text(JsonForm<RepresentedLaw>::write(undetermined ? as_represented(problem.law()) : law));
}

/// As it is kept, or by marching from rest, which may take `seconds`.
Reference find_reference(const Scene& scene, const RepresentedLaw& law, const OrbitTools& tools,
                         double seconds) {
  if (law_matches(law, scene.problem.law())) {
    if (std::optional<Reference> kept = kept_reference(scene, references_folder(), tools.polish,
                                                       Deadline::after(std::max(kKeptSeconds, seconds))))
      return *std::move(kept);
  }
  if (seconds == 0.0) return {.reason = "not checked, see --reference"};
  return compute_reference(under_law(scene.problem, law), tools, Deadline::after(seconds));
}

Reference received_reference(const ChildEnd& end) {
  Reference reference;
  if (end.lines.empty()) {
    reference.reason = "its computation ended by " + describe(end);
    return reference;
  }
  try {
    return reference_from_json(parse_json(end.lines.back()));
  } catch (const std::exception& error) {
    reference.reason = fmt::format("its computation left {}", error.what());
    return reference;
  }
}

}  // namespace

void References::compute(const Scene& scene, std::span<const Applicability> methods, const OrbitTools& tools,
                         const Limits& limits) {
  std::vector<std::string> keys;
  std::vector<IsolatedWork> work;
  const auto add = [&](const RepresentedLaw& law) {
    const std::string key = key_of(law, scene.problem);
    if (by_law_.contains(key) || std::find(keys.begin(), keys.end(), key) != keys.end()) return;
    keys.push_back(key);
    work.push_back([&scene, &tools, &limits, law](const LineSender& send) {
      send(json_line(to_json(find_reference(scene, law, tools, limits.reference_timeout))));
    });
  };
  const auto applies = [](const Applicability& method) { return method.applies; };
  if (std::none_of(methods.begin(), methods.end(), applies)) return;
  add(as_represented(scene.problem.law()));
  for (const Applicability& method : methods) {
    if (method.law) add(*method.law);
  }
  const std::vector<ChildEnd> ends = run_isolated_together(
      work,
      {.stage_seconds = {kQuickSeconds + enforced(limits.reference_timeout)}, .memory_mb = limits.memory_mb},
      kReferenceProcesses);
  for (std::size_t i = 0; i < keys.size(); ++i) by_law_[keys[i]] = received_reference(ends[i]);
}

const Reference& References::under(const RepresentedLaw& law, const Problem& problem) const {
  static const Reference none{.reason = "not computed"};
  const auto found = by_law_.find(key_of(law, problem));
  return found == by_law_.end() ? none : found->second;
}

void References::keep_confirmed(const Problem& problem, const Record& record) {
  if (!record.certificate.return_distance) return;
  const auto found = by_law_.find(key_of(*record.law, problem));
  if (found == by_law_.end()) return;
  std::vector<Certificate>& confirmed = found->second.confirmed;
  // The certificate of an orbit that was recognised holds the very distance of the one known.
  const auto is_same = [&](const Certificate& known) {
    return known.return_distance == record.certificate.return_distance;
  };
  if (std::none_of(confirmed.begin(), confirmed.end(), is_same)) confirmed.push_back(record.certificate);
}

}  // namespace signorini
