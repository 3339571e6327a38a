#include <fmt/format.h>

#include <algorithm>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/glob.hpp"
#include "harness/plan/scene_choice.hpp"
#include "harness/plan/suite.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/words.hpp"
#include "methods/catalogue.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

struct ListArguments {
  std::string what, only;
};

void list_methods() {
  const auto print = [](const std::string& name, const std::string& text) {
    fmt::print("{}", named_lines(name, 22, text, kTerminalWidth));
  };
  for (const MethodEntry& entry : method_catalogue()) {
    print(entry.name, entry.title);
    print("  laws", entry.laws);
    if (!entry.limits.empty()) print("  limits", entry.limits);
  }
}

/// \param filter  glob on the names, or a tag; all where it is empty
void list_scenes(const std::string& filter) {
  bool found = false;
  for (const SceneSource& source : shipped_scenes()) {
    const SceneHeader scene = load_header(source);
    if (!filter.empty() && !filter_matches(filter, scene.name) && std::ranges::count(scene.tags, filter) == 0)
      continue;
    found = true;
    fmt::print("{:<26} {} [{}]\n", scene.name, scene.title, joined(scene.tags, ", "));
  }
  if (!found) throw NothingMatched(fmt::format("only = {} (matches no name of a scene and no tag)", filter));
}

void list_suites() {
  const std::vector<SceneSource> shipped = shipped_scenes();
  for (const auto& file : shipped_files("suites")) {
    const Suite suite = load_suite(file.string());
    const std::size_t scenes = count_scenes(suite, shipped);
    const std::string held = suite.responses.empty()
                                 ? fmt::format("{} scene{}", scenes, scenes == 1 ? "" : "s")
                                 : fmt::format("{} responses", suite.responses.size());
    fmt::print("{:<20} {} ({}{})\n", suite.name, suite.title, held,
               suite.instances > 0 ? fmt::format(", {} of each file with ranges", suite.instances) : "");
  }
}

void list(const ListArguments& arguments) {
  const auto& [what, only] = arguments;
  if (!only.empty() && what != "scenes")
    throw UsageError(fmt::format("only = {} (must go with scenes)", only));
  const bool all = what.empty();
  if (all) fmt::print("Methods\n");
  if (all || what == "methods") list_methods();
  if (all) fmt::print("\nScenes\n");
  if (all || what == "scenes") list_scenes(only);
  if (all) fmt::print("\nSuites\n");
  if (all || what == "suites") list_suites();
}

}  // namespace

void add_list_command(const Command& program) {
  const auto [command, arguments] =
      program.command("list", list, "Names and one-line descriptions of methods, scenes and suites.");
  command.option("what", arguments->what, "methods, scenes or suites; all of them if absent",
                 {.one_of = {"methods", "scenes", "suites"}});
  command.option("only", arguments->only,
                 "of scenes: those whose names match this glob, or that carry this tag");
}

}  // namespace signorini
