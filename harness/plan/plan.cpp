#include "harness/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

struct OptionPrinter {
  std::string operator()(std::monostate) const { return "auto"; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(long value) const { return std::to_string(value); }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return value; }
};

bool belongs(const Suite& suite, const SceneHeader& scene) {
  const auto named = [&](const std::string& glob) { return scene_glob_match(glob, scene.name); };
  const auto carried = [&](const std::string& tag) { return scene.carries(tag); };
  if (std::any_of(suite.without_tags.begin(), suite.without_tags.end(), carried)) return false;
  return std::any_of(suite.scenes.begin(), suite.scenes.end(), named) ||
         std::any_of(suite.tags.begin(), suite.tags.end(), carried);
}

/// The suite's settings for the methods it mentions, the method's own ladder for the others.
DefaultSettings suite_settings(const Suite& suite, std::span<const MethodEntry> catalogue) {
  std::vector<MethodChoice> mentioned;
  for (const std::string& filter : suite.methods) {
    for (MethodChoice& choice : select_methods(filter, catalogue)) mentioned.push_back(std::move(choice));
  }
  return [mentioned](const MethodEntry& entry) {
    std::vector<Settings> settings;
    for (const MethodChoice& choice : mentioned) {
      if (choice.entry->name == entry.name) settings.push_back(choice.settings);
    }
    return settings.empty() ? ladder_of(entry) : settings;
  };
}

}  // namespace

std::string print_option(const OptionValue& value) { return std::visit(OptionPrinter{}, value); }

Scene read_scene(const SceneSource& source) {
  const std::string name = source.file.string();
  const std::string text = read_file(source.file);
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
  const std::vector<MethodChoice> choices =
      select_methods(narrowing.methods.value_or("*"), catalogue, suite_settings(suite, catalogue));
  Plan plan{choose_scenes(suite, narrowing.scenes, sources), {}};
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    for (const MethodChoice& choice : choices) plan.cases.push_back(make_case(plan.scenes[i], i, choice));
  }
  return plan;
}

std::string case_key(const Scene& scene, const Case& planned_case, const Limits& limits,
                     std::string_view code_version) {
  std::string text = fmt::format("{}\n{}\n", scene.sha256, planned_case.choice.entry->name);
  for (const OptionEcho& option : planned_case.options)
    text += option.name + "=" + print_option(option.value) + "\n";
  text += fmt::format("timeout={}\nmemory={}\nrepetitions={}\ncertificate={}\nreference={}\ncode={}\n",
                      limits.timeout, limits.memory_mb, limits.repetitions, limits.certificate_timeout,
                      limits.reference_timeout, code_version);
  if (!planned_case.choice.entry->plugin.empty())
    text += fmt::format("plugin={}\n", planned_case.choice.entry->plugin);
  return sha256(text);
}

}  // namespace signorini
