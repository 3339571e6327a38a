#include "harness/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>

#include "harness/files.hpp"

namespace signorini {

Case make_case(const Scene& scene, std::size_t index, MethodChoice choice) {
  Case result{.scene = index, .choice = std::move(choice), .id = {}};
  static_cast<void>(result.choice.options());  // which refuses what is none
  result.id = scene.problem.name + "/" + result.choice.label();
  return result;
}

Plan make_plan(const Suite& suite, const Narrowing& narrowing, std::span<const MethodEntry> catalogue,
               std::span<const SceneSource> sources) {
  std::vector<MethodChoice> prescribed;
  for (const std::string& filter : suite.methods)
    std::ranges::move(select_methods(filter, catalogue), std::back_inserter(prescribed));
  const std::vector<MethodChoice> choices =
      select_methods(narrowing.methods.value_or("*"), catalogue, prescribed);
  const Instances instances{.count = narrowing.instances.value_or(suite.instances), .seed = narrowing.seed};
  Plan plan{choose_scenes(suite, narrowing.scenes, sources, instances), {}};
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    for (const MethodChoice& choice : choices) plan.cases.push_back(make_case(plan.scenes[i], i, choice));
  }
  return plan;
}

std::string case_key(const Scene& scene, const Case& planned_case, const Limits& limits,
                     std::string_view code_version, std::string_view reference) {
  std::string text = fmt::format("{}\n{}\n", scene.sha256, planned_case.choice.entry->name);
  for (const OptionEcho& option : planned_case.choice.options())
    text += option.name + "=" + print_option(option.value) + "\n";
  text += fmt::format("timeout={}\nmemory={}\nrepetitions={}\ncertificate={}\nreference={}\ncode={}\n",
                      limits.timeout, limits.memory_mb, limits.repetitions, limits.certificate_timeout,
                      limits.reference_timeout, code_version);
  if (const std::optional<ResponseQuestion>& asked = planned_case.response)
    text += fmt::format("response={} {} {} {}\n", asked->from, asked->to, asked->orders,
                        static_cast<int>(asked->way));
  if (!reference.empty()) text += fmt::format("kept={}\n", reference);
  if (!planned_case.choice.entry->plugin.empty())
    text += fmt::format("plugin={}\n", planned_case.choice.entry->plugin);
  return sha256(text);
}

std::vector<std::size_t> round_order(std::size_t count, std::uint64_t seed, std::string_view scene,
                                     int round) {
  // The hash spreads equal seeds over scenes and rounds; 16 hexadecimal digits are 64 bits.
  const std::string hash = sha256(fmt::format("{} {} {}", seed, scene, round));
  std::mt19937_64 random(std::stoull(hash.substr(0, 16), nullptr, 16));
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

}  // namespace signorini
