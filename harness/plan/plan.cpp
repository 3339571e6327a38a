#include "harness/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"

namespace signorini {

namespace {

bool belongs(const Suite& suite, const SceneHeader& scene) {
  const auto named = [&](const std::string& glob) { return scene_glob_match(glob, scene.name); };
  const auto carried = [&](const std::string& tag) { return scene.carries(tag); };
  if (std::ranges::any_of(suite.without_tags, carried)) return false;
  return std::ranges::any_of(suite.scenes, named) || std::ranges::any_of(suite.tags, carried);
}

}  // namespace

Scene read_scene(const SceneSource& source) {
  const std::string name = source.file.string();
  const std::string text = read_file(source.file, kLargestScene);
  // Read once, so that the hash is of what was parsed.
  SceneWithSources scene = parse_scene_with_sources(text, name, source.level);
  std::string identity = text;
  if (scene.family) identity += "@" + level_label(scene.family->level);  // however the level was spelt
  for (const std::filesystem::path& matrix : scene.matrix_files) identity += "\n" + sha256_of_file(matrix);
  return {.problem = std::move(scene.problem), .sha256 = sha256(identity), .family = std::move(scene.family)};
}

Case make_case(const Scene& scene, std::size_t index, MethodChoice choice) {
  Case result{.scene = index, .choice = std::move(choice), .options = {}, .id = {}};
  result.options = result.choice.options();
  result.id = scene.problem.name + "/" + result.choice.label();
  return result;
}

bool names_scene_file(const std::string& filter) {
  return filter.ends_with(".toml") || filter.find(".toml@") != std::string::npos;
}

std::vector<Scene> choose_scenes(const Suite& suite, const std::optional<std::string>& filter,
                                 std::span<const SceneSource> sources) {
  std::vector<Scene> scenes;
  if (filter && names_scene_file(*filter)) {
    scenes.push_back(read_scene(find_scene(*filter)));
    return scenes;
  }
  for (const SceneSource& source : sources) {
    const SceneHeader header = load_header(source);  // first: a large scene takes time to assemble
    if (!belongs(suite, header)) continue;
    if (filter && !scene_filter_matches(*filter, header.name)) continue;
    scenes.push_back(read_scene(source));
  }
  if (scenes.empty()) {
    throw NothingMatched(
        fmt::format("scenes = {} (matches no scene of suite {}; see `signorini list scenes`)",
                    filter.value_or("*"), suite.name));
  }
  return scenes;
}

Plan make_plan(const Suite& suite, const Narrowing& narrowing, std::span<const MethodEntry> catalogue,
               std::span<const SceneSource> sources) {
  std::vector<MethodChoice> prescribed;
  for (const std::string& filter : suite.methods)
    std::ranges::move(select_methods(filter, catalogue), std::back_inserter(prescribed));
  const std::vector<MethodChoice> choices =
      select_methods(narrowing.methods.value_or("*"), catalogue, prescribed);
  Plan plan{choose_scenes(suite, narrowing.scenes, sources), {}};
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    for (const MethodChoice& choice : choices) plan.cases.push_back(make_case(plan.scenes[i], i, choice));
  }
  return plan;
}

std::string case_key(const Scene& scene, const Case& planned_case, const Limits& limits,
                     std::string_view code_version, std::string_view reference) {
  std::string text = fmt::format("{}\n{}\n", scene.sha256, planned_case.choice.entry->name);
  for (const OptionEcho& option : planned_case.options)
    text += option.name + "=" + print_option(option.value) + "\n";
  text += fmt::format("timeout={}\nmemory={}\nrepetitions={}\ncertificate={}\nreference={}\ncode={}\n",
                      limits.timeout, limits.memory_mb, limits.repetitions, limits.certificate_timeout,
                      limits.reference_timeout, code_version);
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
