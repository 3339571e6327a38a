#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "harness/commands/command_line.hpp"
#include "harness/extend/scaffold/scaffold.hpp"
#include "harness/failure.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

struct NewArguments {
  std::string name;
  std::optional<std::string> tree;
  bool out_of_tree = false;
  bool python = false;
};

/// The source tree that is named, or the one around the current folder; empty for a method outside a tree.
std::optional<fs::path> tree_of(const NewArguments& arguments) {
  if (arguments.out_of_tree) return std::nullopt;
  if (!arguments.tree) return find_tree(fs::current_path());
  if (fs::is_regular_file(fs::path(*arguments.tree) / "methods" / "catalogue.cpp")) return *arguments.tree;
  throw UsageError(fmt::format("tree = {} (must be a source tree of signorini, with methods/catalogue.cpp)",
                               *arguments.tree));
}

Scaffold method_scaffold(const NewArguments& arguments) {
  if (arguments.python) return method_in_python(arguments.name, "");
  if (arguments.out_of_tree) return method_out_of_tree(arguments.name, "");
  if (const std::optional<fs::path> tree = tree_of(arguments)) return method_in_tree(arguments.name, *tree);
  throw UsageError(
      "tree = missing (must be the current folder, one above it or --tree; --out-of-tree makes a plugin "
      "instead)");
}

/// The path relative to the current folder if it lies below, as people type it.
std::string shown(const fs::path& path) {
  const fs::path relative = path.lexically_relative(fs::current_path());
  const bool below = path.is_absolute() && !relative.empty() && *relative.begin() != "..";
  return (below ? relative : path).string();
}

void write_and_tell(const Scaffold& scaffold) {
  write_scaffold(scaffold);
  for (const ScaffoldFile& file : scaffold.fresh) fmt::print("new      {}\n", shown(file.path));
  for (const ScaffoldFile& file : scaffold.changed) fmt::print("changed  {}\n", shown(file.path));
  fmt::print("next:\n");
  for (const std::string& line : scaffold.next) fmt::print("  {}\n", line);
}

void new_method(const NewArguments& arguments) { write_and_tell(method_scaffold(arguments)); }

void new_scene(const NewArguments& arguments) {
  const std::optional<fs::path> tree = tree_of(arguments);
  write_and_tell(tree ? scene_in_tree(arguments.name, *tree) : scene_out_of_tree(arguments.name, ""));
}

void add_kind(const Command& command, const std::string& kind, const char* description,
              void (*make)(const NewArguments&)) {
  const auto [sub, arguments] = command.command(kind, make, description);
  sub.option("name", arguments->name, "lower-kebab-case, such as my-" + kind, {.required = true});
  const Argument tree =
      sub.option("--tree", arguments->tree,
                 "source tree; if absent the current folder or the nearest above that is one");
  sub.flag("--out-of-tree", arguments->out_of_tree, "in the current folder, to be used without a source tree",
           {.excludes = tree});
  if (kind == "method") {
    sub.flag("--python", arguments->python,
             "in the current folder, as a function in Python; needs the package signorini (docs/python.md)",
             {.excludes = tree});
  }
}

}  // namespace

void add_new_command(const Command& program) {
  const Command command = program.command(
      "new", "Writes a template of a method or a scene, which builds and passes `check` at once.");
  command.require_command();
  add_kind(command, "method",
           "methods/NAME with header, source, test and page, and two lines in methods/catalogue.cpp; out of "
           "tree a folder NAME that builds a plugin, or with --python one that holds a function in Python.",
           new_method);
  add_kind(
      command, "scene",
      "problems/catalogue/NAME.toml, or NAME.toml in the current folder where that is in no source tree.",
      new_scene);
}

}  // namespace signorini
