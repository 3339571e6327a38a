#include "harness/report/evaluation/response_standings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace signorini {

namespace {

using Responses = std::vector<const Record*>;

/// What a method's responses of a kind add up to, whose exact branches have this length.
ResponseStanding standing_of(const std::string& label, const Responses& responses, double exact_length) {
  ResponseStanding standing{.label = label};
  double covered = 0.0, length = 0.0, wrong = 0.0, right = 0.0;
  for (const Record* record : responses) {
    if (response_label(*record) != label || record->status == Status::not_applicable ||
        record->law_matches_scene == false)
      continue;
    ++standing.asked;
    if (record->status == Status::converged) ++standing.followed;
    if (!record->response->comparison) continue;
    const CurveComparison& c = *record->response->comparison;
    covered += c.close.covered * c.exact_length;
    length += c.length;
    wrong += c.wide.false_share * c.length;
    right += c.right_length;
    standing.located += located_points(c);
    standing.points += std::ssize(c.points);
    standing.invented += std::ssize(c.invented);
    if (record->seconds) standing.seconds = standing.seconds.value_or(0.0) + record->seconds->median;
    if (const auto largest = largest_error(c))
      standing.largest_error = std::max(standing.largest_error.value_or(0.0), *largest);
  }
  if (exact_length > 0.0) standing.found = covered / exact_length;
  if (length > 0.0) standing.false_share = wrong / length;
  if (right > 0.0 && standing.seconds) standing.cost = *standing.seconds / right;
  return standing;
}

/// By kResponseRule; null where none qualifies.
ResponseStanding* best_standing(std::vector<ResponseStanding>& standings) {
  constexpr double kAsMuch = 0.05;
  const auto qualifies = [](const ResponseStanding& one) {
    return !one.makes_the_exact && one.cost && one.score() > 0.0;
  };
  double most = 0.0;
  for (const ResponseStanding& one : standings)
    if (qualifies(one)) most = std::max(most, one.score());
  ResponseStanding* best = nullptr;
  for (ResponseStanding& one : standings)
    if (qualifies(one) && one.score() >= most - kAsMuch && (best == nullptr || *one.cost < *best->cost))
      best = &one;
  return best;
}

void rank_responses(std::vector<ResponseStanding>& standings, bool recommend) {
  if (ResponseStanding* best = recommend ? best_standing(standings) : nullptr) best->recommended = true;
  std::ranges::stable_sort(standings, {}, [](const ResponseStanding& one) {
    return std::pair(one.recommended ? 0 : one.makes_the_exact ? 2 : 1, -one.score());
  });
}

/// Of the exact responses, as far as any method was compared with them.
double exact_length_of(const Responses& responses) {
  std::map<std::string, double> by_scene;
  for (const Record* record : responses)
    if (record->response->comparison) by_scene[record->scene] = record->response->comparison->exact_length;
  double sum = 0.0;
  for (const auto& [scene, length] : by_scene) sum += length;
  return sum;
}

ResponseGroup group_of_responses(std::optional<SceneKind> kind, const Responses& responses,
                                 const std::vector<std::string>& labels, const std::string& exact_method) {
  ResponseGroup group{.kind = kind};
  for (const Record* record : responses)
    if (std::ranges::find(group.scenes, record->scene) == group.scenes.end())
      group.scenes.push_back(record->scene);
  const double exact = exact_length_of(responses);
  for (const std::string& label : labels) {
    ResponseStanding standing = standing_of(label, responses, exact);
    standing.makes_the_exact = parse_method_label(label).method == exact_method;
    if (standing.asked > 0) group.standings.push_back(std::move(standing));
  }
  rank_responses(group.standings, !group.is_too_small());
  return group;
}

}  // namespace

double ResponseStanding::score() const {
  const double true_share = 1.0 - false_share;
  return found > 0.0 ? 2.0 * found * true_share / (found + true_share) : 0.0;
}

bool is_exact(const Record& record) { return record.response->question.way == ResponseWay::exact; }

std::string response_label(const Record& record) {
  const bool by_steps = record.response->question.way == ResponseWay::steps;
  return resolution_of(record) + (by_steps ? " by steps" : "");
}

std::string label_with_law(const Record& record) {
  const std::string remark = law_remark(record);
  return response_label(record) + (remark.empty() ? "" : ", " + remark);
}

std::vector<std::string> response_labels(std::span<const Record> records) {
  std::vector<std::string> found;
  for (const Record& record : records) {
    if (is_exact(record)) continue;
    std::string label = response_label(record);
    if (std::ranges::find(found, label) == found.end()) found.push_back(std::move(label));
  }
  return found;
}

std::vector<ResponseGroup> response_groups(std::span<const Record> records) {
  std::set<std::string> compared, asked, contested;  // scenes; the latter of other methods than the exact one
  std::string exact_method;
  for (const Record& record : records)
    if (is_exact(record)) exact_method = record.method;
  for (const Record& record : records) {
    if (record.response->comparison) compared.insert(record.scene);
    if (record.method == exact_method) continue;
    asked.insert(record.scene);
    if (record.status != Status::not_applicable) contested.insert(record.scene);
  }
  // Where no other method applies, as to free motions, there is nothing to choose beside scenes where one
  // does.
  std::erase_if(compared, [&](const std::string& scene) {
    return !contested.empty() && asked.contains(scene) && !contested.contains(scene);
  });
  std::map<std::optional<SceneKind>, Responses> by_kind;
  for (const Record& record : records) {
    if (is_exact(record) || !compared.contains(record.scene)) continue;
    by_kind[kind_of(case_scene_of(record))].push_back(&record);
  }
  const std::vector<std::string> labels = response_labels(records);
  std::vector<ResponseGroup> groups;
  for (const auto& [kind, responses] : by_kind)
    groups.push_back(group_of_responses(kind, responses, labels, exact_method));
  return groups;
}

std::string group_title(const ResponseGroup& group) {
  return fmt::format("{}, {} response{}", group.kind ? kind_title(*group.kind) : "Scenes of unrecorded law",
                     group.scenes.size(), group.scenes.size() == 1 ? "" : "s");
}

std::ptrdiff_t located_points(const CurveComparison& comparison) {
  return std::ranges::count_if(comparison.points,
                               [](const PointMatch& m) { return m.frequency.has_value(); });
}

std::optional<double> error_of(const PointMatch& match) {
  if (!match.frequency) return std::nullopt;
  return std::abs(*match.frequency - match.exact.frequency) / match.exact.frequency;
}

std::optional<double> largest_error(const CurveComparison& comparison) {
  std::optional<double> largest;
  for (const PointMatch& match : comparison.points) {
    if (const auto error = error_of(match)) largest = std::max(largest.value_or(0.0), *error);
  }
  return largest;
}

}  // namespace signorini
