#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/commands/command_line.hpp"
#include "harness/plan/suite.hpp"
#include "methods/catalogue.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

void list_methods() {
  for (const MethodEntry& entry : method_catalogue()) {
    fmt::print("{:<20} {}\n{:<20} laws: {}; runs {}\n", entry.name, entry.title, "", entry.laws,
               entry.ladder);
  }
}

void list_scenes() {
  for (const SceneSource& source : shipped_scenes()) {
    const SceneHeader scene = load_header(source);
    fmt::print("{:<26} {} [{}]\n", scene.name, scene.title, fmt::join(scene.tags, ", "));
  }
}

void list_suites() {
  for (const auto& file : shipped_files("suites")) {
    const Suite suite = load_suite(file.string());
    fmt::print("{:<20} {}\n", suite.name, suite.title);
  }
}

}  // namespace

void add_list_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("list", "Names and one-line descriptions of methods, scenes and suites.");
  const auto what = std::make_shared<std::string>();
  command->add_option("what", *what, "methods, scenes or suites; all of them if absent")
      ->check(CLI::IsMember({"methods", "scenes", "suites"}));
  command->callback([what, &exit_code] {
    const bool all = what->empty();
    if (all) fmt::print("Methods\n");
    if (all || *what == "methods") list_methods();
    if (all) fmt::print("\nScenes\n");
    if (all || *what == "scenes") list_scenes();
    if (all) fmt::print("\nSuites\n");
    if (all || *what == "suites") list_suites();
    exit_code = kDone;
  });
}

}  // namespace signorini
