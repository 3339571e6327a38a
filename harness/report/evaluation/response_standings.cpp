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

/// What a method's responses add up to.
class Sums {
 public:
  explicit Sums(std::string label) { standing_.label = std::move(label); }

  void add(const Record& record) {
    if (record.status == Status::not_applicable || record.law_matches_scene == false) return;
    ++standing_.asked;
    if (record.status == Status::converged) ++standing_.followed;
    if (!record.response->comparison) return;
    const CurveComparison& c = *record.response->comparison;
    covered_ += c.close.covered * c.exact_length;
    length_ += c.length;
    wrong_ += c.wide.false_share * c.length;
    right_ += c.right_length;
    standing_.located += located_points(c);
    standing_.points += std::ssize(c.points);
    standing_.invented += std::ssize(c.invented);
    if (record.seconds) standing_.seconds = standing_.seconds.value_or(0.0) + record.seconds->median;
    if (const auto largest = largest_error(c))
      standing_.largest_error = std::max(standing_.largest_error.value_or(0.0), *largest);
  }

  [[nodiscard]] ResponseStanding standing(double exact_length) const {
    ResponseStanding result = standing_;
    if (exact_length > 0.0) result.found = covered_ / exact_length;
    if (length_ > 0.0) result.false_share = wrong_ / length_;
    if (right_ > 0.0 && result.seconds) result.cost = *result.seconds / right_;
    return result;
  }

 private:
  ResponseStanding standing_;
  double covered_ = 0.0, length_ = 0.0, wrong_ = 0.0, right_ = 0.0;
};

/// By kResponseRule; null where none qualifies.
ResponseStanding* best_standing(std::vector<ResponseStanding>& standings) {
  constexpr double kAsMuch = 0.05;
  double most = 0.0;
  const auto qualifies = [](const ResponseStanding& one) {
    return !one.makes_the_exact && one.cost && one.score() > 0.0;
  };
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
    Sums sums(label);
    for (const Record* record : responses)
      if (response_label(*record) == label) sums.add(*record);
    ResponseStanding standing = sums.standing(exact);
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
  std::set<std::string> compared;  // scenes
  std::string exact_method;
  for (const Record& record : records) {
    if (record.response->comparison) compared.insert(record.scene);
    if (is_exact(record)) exact_method = record.method;
  }
  std::map<std::optional<SceneKind>, Responses> by_kind;
  for (const Record& record : records) {
    if (is_exact(record) || !compared.contains(record.scene)) continue;
    by_kind[kind_of_scene(record.scene_law, record.coordinates, record.contacts)].push_back(&record);
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
