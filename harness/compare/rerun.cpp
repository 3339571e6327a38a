#include "harness/compare/rerun.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/plan/case_name.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/responses/response_plan.hpp"
#include "harness/run/suite_run.hpp"

namespace signorini {

namespace {

bool below_bars(const Record& record) { return *record.errors.x_l2 <= measurable_error(record); }

/// Whether the method or the search for the orbit behind its answer ran out of time. A certified answer did
/// not, whatever its record says.
bool ran_out_of_time(const Record& record) {
  const bool certified = record.certificate.status == CertificateStatus::certified;
  return record.status == Status::timeout || (!certified && record.certificate.expired.value_or(false));
}

bool decided_by_time(const Record& kept, const Record& now) {
  const bool same = kept.status == now.status && kept.certificate.status == now.certificate.status;
  return !same && (ran_out_of_time(kept) || ran_out_of_time(now));
}

/// What became of a case: its status, and its certificate where that tells more.
std::string status_words(const Record& record) {
  const std::string status(status_name(record.status));
  return record.certificate.expired.value_or(false) ? status + ", uncertified for want of time" : status;
}

/// The case that a record came from. \throws InvalidOption
Case case_of(const Record& record, const Scene& scene, const MethodEntry& entry) {
  const MethodChoice choice{&entry, record.settings};
  if (!record.response) return make_case(scene, 0, choice);
  const ResponseQuestion& question = record.response->question;
  return question.way == ResponseWay::exact ? exact_case(scene, 0, question)
                                            : response_case(scene, 0, choice, question);
}

/// The same where it can be run here; otherwise counts it as left out.
std::optional<Case> case_here(const Record& record, const Scene& scene,
                              std::span<const MethodEntry> catalogue, Rerun& result) {
  const auto entry = std::ranges::find(catalogue, record.method, &MethodEntry::name);
  if (entry == catalogue.end()) {
    ++result.left_out[fmt::format("no method {} is here; --plugin loads those of others", record.method)];
    return std::nullopt;
  }
  if (entry->plugin != record.plugin) result.other_plugins.insert(record.method);
  try {
    return case_of(record, scene, *entry);
  } catch (const InvalidOption& error) {
    ++result.left_out[fmt::format("{} takes other options here: {}", record.method, error.what())];
    return std::nullopt;
  }
}

void compare_case(const Record& kept, const Record& now, Rerun& result) {
  ++result.cases;
  if (decided_by_time(kept, now)) {
    result.remarks.push_back(
        fmt::format("{}: {} became {}", kept.case_id, status_words(kept), status_words(now)));
  }
  for (const std::string& line : compare_records(kept, now)) result.differences.push_back(line);
  if (kept.seconds && now.seconds && kept.seconds->median > 0.0)
    result.time_ratios.push_back(now.seconds->median / kept.seconds->median);
}

/// Adds the exact response that other ones are measured against, unless it is among them.
void add_exact(const Scene& scene, std::vector<Case>& cases) {
  std::optional<ResponseQuestion> question;
  for (const Case& one : cases) {
    if (!one.response) continue;
    if (one.response->way == ResponseWay::exact) return;
    question = one.response;
  }
  if (question) cases.push_back(exact_case(scene, 0, *question));
}

/// The source of a scene; nothing where there is none of that name.
std::optional<SceneSource> source_here(const std::string& scene) {
  try {
    return find_scene(scene);
  } catch (const SceneError&) {
    return std::nullopt;
  }
}

/// Runs the cases of one scene's records again.
void rerun_scene(const std::vector<const Record*>& records, const Limits& limits,
                 std::span<const MethodEntry> catalogue, const std::function<void(const std::string&)>& news,
                 Rerun& result) {
  const std::optional<SceneSource> source = source_here(records.front()->scene);
  if (!source) {
    result.left_out[fmt::format("no scene {} is here", records.front()->scene)] += records.size();
    return;
  }
  const Scene scene = read_scene(*source);
  if (scene.sha256 != records.front()->scene_sha256) {
    result.differences.push_back(
        fmt::format("{}: the scene file has changed since the run: {} cases not compared", scene.problem.name,
                    records.size()));
    return;
  }
  std::vector<const Record*> kept;
  std::vector<Case> cases;
  for (const Record* record : records) {
    std::optional<Case> own = case_here(*record, scene, catalogue, result);
    if (!own) continue;
    kept.push_back(record);
    cases.push_back(std::move(*own));
  }
  if (cases.empty()) return;
  add_exact(scene, cases);
  Runner runner(limits);
  ExactResponse exact;
  news(scene.problem.name + ": references");
  std::vector<const Case*> pointers;
  for (const Case& one : cases) pointers.push_back(&one);
  const std::vector<Job> jobs = prepared_jobs(runner, scene, pointers, exact);
  if (interrupted()) return;
  const std::vector<std::optional<Record>> now =
      run_rounds(runner, scene, jobs, std::vector<std::optional<Record>>(cases.size()), {}, {.begins = news});
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (now[i]) compare_case(*kept[i], *now[i], result);
  }
  std::ranges::move(relative_times(kept, now), std::back_inserter(result.relative_times));
}

}  // namespace

std::vector<RelativeTime> relative_times(const std::vector<const Record*>& kept,
                                         const std::vector<std::optional<Record>>& now) {
  const auto timed = [&](std::size_t i) {
    return kept[i]->seconds && now[i] && now[i]->seconds && kept[i]->seconds->median > 0.0 &&
           now[i]->seconds->median > 0.0;
  };
  std::map<std::string, std::size_t> baselines;  // by scene
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (resolution_of(*kept[i]) == kTimeBaseline && timed(i)) baselines[kept[i]->scene] = i;
  }
  std::vector<RelativeTime> times;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto baseline = baselines.find(kept[i]->scene);
    if (baseline == baselines.end() || !timed(i)) continue;
    const std::size_t y = baseline->second;
    times.push_back({.method = resolution_of(*kept[i]),
                     .kept = kept[i]->seconds->median / kept[y]->seconds->median,
                     .now = now[i]->seconds->median / now[y]->seconds->median});
  }
  return times;
}

std::vector<std::string> compare_records(const Record& kept, const Record& now) {
  if (decided_by_time(kept, now)) return {};
  if (kept.status != now.status) {
    return {fmt::format("{}: {} became {}{}{}", kept.case_id, status_name(kept.status),
                        status_name(now.status), now.message.empty() ? "" : ": ", now.message)};
  }
  if (kept.certificate.status != now.certificate.status) {
    return {fmt::format("{}: certificate {} became {}{}{}", kept.case_id, enum_name(kept.certificate.status),
                        enum_name(now.certificate.status), now.certificate.reason.empty() ? "" : ": ",
                        now.certificate.reason)};
  }
  if (kept.response && now.response) {
    const std::optional<ResponseChange> found = response_change(*kept.response, *now.response);
    return found ? std::vector{fmt::format("{}: {}", kept.case_id, found->detail)}
                 : std::vector<std::string>();
  }
  if (!kept.errors.x_l2 || !now.errors.x_l2) {
    if (kept.errors.x_l2.has_value() == now.errors.x_l2.has_value()) return {};
    return {fmt::format("{}: the error of x is there in one of the two only", kept.case_id)};
  }
  const double before = *kept.errors.x_l2, after = *now.errors.x_l2;
  if ((below_bars(kept) && below_bars(now)) ||
      std::max(before, after) <= kErrorFactor * std::min(before, after))
    return {};
  return {fmt::format("{}: error of x {:.2e} became {:.2e}", kept.case_id, before, after)};
}

Rerun rerun_records(const std::vector<Record>& kept, const Limits& limits, const std::string& filter,
                    std::span<const MethodEntry> catalogue,
                    const std::function<void(const std::string& what)>& news) {
  std::vector<std::pair<std::string, std::vector<const Record*>>> scenes;  // in the order of the records
  for (const Record& record : kept) {
    if (!filter_matches(filter, record.case_id)) continue;
    const auto known =
        std::ranges::find_if(scenes, [&](const auto& one) { return one.first == record.scene; });
    if (known == scenes.end()) {
      scenes.emplace_back(record.scene, std::vector{&record});
    } else {
      known->second.push_back(&record);
    }
  }
  if (scenes.empty()) throw NothingMatched("cases = {} (matches no case of the run)", filter);
  Rerun result;
  for (const auto& [name, records] : scenes) {
    if (interrupted()) break;
    rerun_scene(records, limits, catalogue, news, result);
  }
  result.interrupted = interrupted();
  return result;
}

}  // namespace signorini
