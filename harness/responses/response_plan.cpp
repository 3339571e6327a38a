#include "harness/responses/response_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "harness/glob.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

std::vector<MethodChoice> prescribed(const std::vector<std::string>& filters,
                                     std::span<const MethodEntry> catalogue) {
  std::vector<MethodChoice> choices;
  for (const std::string& filter : filters)
    std::ranges::move(select_methods(filter, catalogue), std::back_inserter(choices));
  return choices;
}

/// The choices of a suite for responses, each with its way.
std::vector<std::pair<MethodChoice, ResponseWay>> ways_of(const Suite& suite, const Narrowing& narrowing,
                                                          std::span<const MethodEntry> catalogue) {
  std::vector<MethodChoice> own = prescribed(suite.methods, catalogue);
  if (narrowing.methods) own = select_methods(*narrowing.methods, catalogue, own);
  std::vector<std::pair<MethodChoice, ResponseWay>> ways;
  for (MethodChoice& choice : own) {
    const ResponseWay way = has_curve(choice) ? ResponseWay::arc_length : ResponseWay::steps;
    ways.emplace_back(std::move(choice), way);
  }
  for (MethodChoice& choice : prescribed(suite.by_steps, catalogue)) {
    if (!narrowing.methods || filter_matches(*narrowing.methods, choice.entry->name))
      ways.emplace_back(std::move(choice), ResponseWay::steps);
  }
  return ways;
}

/// The place of a response's scene in the plan, which it may have for its motions already.
std::size_t place_of(Plan& plan, const SuiteResponse& response) {
  Scene scene = read_scene(find_scene(response.scene));
  const auto known = std::ranges::find_if(
      plan.scenes, [&](const Scene& other) { return other.problem.name == scene.problem.name; });
  if (known == plan.scenes.end()) {
    plan.scenes.push_back(std::move(scene));
    return plan.scenes.size() - 1;
  }
  if (known->sha256 != scene.sha256)
    throw UsageError(
        fmt::format("scene = {} (must be one scene: two files have this name)", scene.problem.name));
  return static_cast<std::size_t>(known - plan.scenes.begin());
}

/// By which it is asked for: of a scene file its own.
std::string name_of(const SuiteResponse& response) {
  return looks_like_path(response.scene) ? load_header(find_scene(response.scene)).name : response.scene;
}

void add_responses(const Suite& suite, const SceneFilter& filter, const Narrowing& narrowing,
                   std::span<const MethodEntry> catalogue, Plan& plan) {
  const auto ways = ways_of(suite, narrowing, catalogue);
  for (const SuiteResponse& response : suite.responses) {
    if (!filter.takes(name_of(response))) continue;
    const std::size_t place = place_of(plan, response);
    const Scene& scene = plan.scenes[place];
    ResponseQuestion question{.from = response.from, .to = response.to, .orders = response.orders};
    plan.cases.push_back(exact_case(scene, place, question));
    for (const auto& [choice, way] : ways) {
      question.way = way;
      plan.cases.push_back(response_case(scene, place, choice, question));
    }
  }
}

}  // namespace

Case response_case(const Scene& scene, std::size_t index, MethodChoice choice,
                   const ResponseQuestion& question) {
  Case result = make_case(scene, index, std::move(choice));
  result.id += question.way == ResponseWay::steps ? " by steps" : " by arc length";
  result.response = question;
  result.measured_by = exact_method().name;
  return result;
}

Case exact_case(const Scene& scene, std::size_t index, ResponseQuestion question) {
  question.way = ResponseWay::exact;
  Case result = make_case(scene, index, {.entry = &exact_method()});
  result.id = scene.problem.name + "/exact response";
  result.response = question;
  return result;
}

Plan plan_of_suite(const Suite& suite, const Narrowing& narrowing, std::span<const MethodEntry> catalogue,
                   std::span<const SceneSource> sources) {
  if (suite.responses.empty()) return make_plan(suite, narrowing, catalogue, sources);
  const SceneFilter filter(narrowing.scenes);
  const bool has_scenes = !(suite.scenes.empty() && suite.files.empty() && suite.tags.empty());
  if (!has_scenes && !filter.files().empty())
    throw UsageError(fmt::format("scenes = {} (must be names: suite {} says between which frequencies)",
                                 filter.files().front().file.string(), suite.name));
  Plan plan;
  std::optional<NothingMatched> nothing;
  try {
    if (has_scenes) plan = make_plan(suite, narrowing, catalogue, sources);
  } catch (const NothingMatched& error) {  // unless a response is meant
    nothing = error;
  }
  add_responses(suite, filter, narrowing, catalogue, plan);
  if (!plan.cases.empty()) return plan;
  if (nothing) throw *nothing;
  throw NothingMatched(fmt::format("scenes = {} (matches no response of suite {})",
                                   joined(narrowing.scenes, " "), suite.name));
}

}  // namespace signorini
