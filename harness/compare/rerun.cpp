#include "harness/compare/rerun.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/plan/baseline.hpp"
#include "harness/plan/selection.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/run/rounds.hpp"

namespace signorini {

namespace {

bool below_bars(const Record& record) { return *record.errors.x_l2 <= measurable_error(record); }

bool decided_by_time(const Record& kept, const Record& now) {
  return kept.status != now.status && (kept.status == Status::timeout || now.status == Status::timeout);
}

/// The case that a record came from.
Case case_of(const Record& record, const Scene& scene, std::span<const MethodEntry> catalogue) {
  const auto entry = std::find_if(catalogue.begin(), catalogue.end(),
                                  [&](const MethodEntry& one) { return one.name == record.method; });
  if (entry == catalogue.end())
    throw NothingMatched(
        fmt::format("methods = {} (matches no method; see `signorini list methods`)", resolution_of(record)));
  return make_case(scene, 0, {&*entry, record.settings});
}

/// Keeps the complete records of a rerun.
class RerunObserver final : public RoundObserver {
 public:
  RerunObserver(std::vector<std::optional<Record>>& records,
                const std::function<void(const std::string&)>& news)
      : records_(records), news_(news) {}
  void begins(const std::string& what) override {
    if (news_) news_(what);
  }
  void case_done(std::size_t index, const Record& record) override { records_[index] = record; }

 private:
  std::vector<std::optional<Record>>& records_;
  const std::function<void(const std::string&)>& news_;
};

/// One scene's records again.
class SceneRerun {
 public:
  SceneRerun(Rerun& result, const std::function<void(const std::string&)>& news)
      : result_(result), news_(news) {}

  void run(const std::vector<const Record*>& kept, const Limits& limits,
           std::span<const MethodEntry> catalogue) {
    const Scene scene = read_scene(find_scene(kept.front()->scene));
    if (scene.sha256 != kept.front()->scene_sha256) {
      result_.differences.push_back(
          fmt::format("{}: the scene file has changed since the run: {} cases not compared",
                      scene.problem.name, kept.size()));
      return;
    }
    std::vector<Case> cases;
    for (const Record* record : kept) cases.push_back(case_of(*record, scene, catalogue));
    Runner runner(limits);
    if (news_) news_(scene.problem.name + ": references");
    const std::vector<Job> jobs = runner.make_jobs(scene, cases);
    if (interrupted()) return;
    runner.compute_references(scene, jobs);
    std::vector<std::optional<Record>> now(cases.size());
    RerunObserver observer(now, news_);
    run_rounds(runner, scene, jobs, now, {}, observer);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (now[i]) take(*kept[i], *now[i]);
    }
    const std::vector<RelativeTime> times = relative_times(kept, now);
    result_.relative_times.insert(result_.relative_times.end(), times.begin(), times.end());
  }

 private:
  void take(const Record& kept, const Record& now) {
    ++result_.cases;
    if (decided_by_time(kept, now)) {
      result_.remarks.push_back(
          fmt::format("{}: {} became {}", kept.case_id, status_name(kept.status), status_name(now.status)));
    }
    for (const std::string& line : compare_records(kept, now)) result_.differences.push_back(line);
    if (kept.seconds && now.seconds && kept.seconds->median > 0.0)
      result_.time_ratios.push_back(now.seconds->median / kept.seconds->median);
  }

  Rerun& result_;
  const std::function<void(const std::string&)>& news_;
};

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

Limits limits_of_run(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "manifest.json";
  if (!std::filesystem::exists(file)) return {};
  try {
    const auto json = nlohmann::json::parse(read_file(file)).at("limits");
    return {.timeout = json.at("timeout_s"),
            .memory_mb = json.at("memory_mb"),
            .repetitions = json.at("repetitions"),
            .certificate_timeout = json.at("certificate_timeout_s"),
            .reference_timeout = json.at("reference_timeout_s")};
  } catch (const nlohmann::json::exception&) {
    throw UsageError(
        fmt::format("{}: limits = unreadable (must be a manifest that run wrote)", file.string()));
  }
}

Rerun rerun_records(const std::vector<Record>& kept, const Limits& limits, const std::string& filter,
                    std::span<const MethodEntry> catalogue,
                    const std::function<void(const std::string& what)>& news) {
  std::vector<std::pair<std::string, std::vector<const Record*>>> scenes;  // in the order of the records
  for (const Record& record : kept) {
    if (!filter_matches(filter, record.case_id)) continue;
    const auto known = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const auto& one) { return one.first == record.scene; });
    if (known == scenes.end()) {
      scenes.emplace_back(record.scene, std::vector{&record});
    } else {
      known->second.push_back(&record);
    }
  }
  if (scenes.empty()) throw NothingMatched(fmt::format("cases = {} (matches no case of the run)", filter));
  Rerun result;
  for (const auto& [name, records] : scenes) {
    if (interrupted()) break;
    SceneRerun(result, news).run(records, limits, catalogue);
  }
  result.interrupted = interrupted();
  return result;
}

}  // namespace signorini
