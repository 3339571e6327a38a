#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/extend/plugins/command_method.hpp"
#include "harness/extend/plugins/plugins.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/pack/pack_index.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/run_folder/status.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// Descriptions of the commands that a run used, as far as they are loaded and are still what they were in
/// the run; says of which plugins there is none.
std::vector<PluginDescriptionFile> descriptions_for(const RunFolder& run) {
  std::vector<PluginDescriptionFile> found;
  if (!run.manifest.contains("plugins")) return found;
  for (const auto& [method, hash] : run.manifest["plugins"].items()) {
    const auto describes_it = [&name = method, &sum = hash](const fs::path& file) {
      if (file.extension() != ".toml") return false;
      const CommandDescription description = read_command_file(file);
      return description.name == name && description.sha256 == sum.get<std::string>();
    };
    const auto file = std::ranges::find_if(loaded_plugins(), describes_it);
    if (file == loaded_plugins().end())
      fmt::print(stderr, "{}: its description is left out: no --plugin FILE.toml is what the run used\n",
                 method);
    else
      found.push_back({.method = method, .text = read_file(*file, kLargestScene)});
  }
  return found;
}

struct PackArguments {
  std::string folder, out;
};

void pack(const PackArguments& arguments) {
  const auto& [folder, out] = arguments;
  const RunFolder run = read_run(folder);
  if (run.manifest.contains("runs"))
    throw UsageError(fmt::format("dir = {} (must be a run, not several side by side: pack each)", folder));
  const std::vector<PluginDescriptionFile> descriptions = descriptions_for(run);
  const std::string bytes = pack_run(run, descriptions);
  write_whole(out, bytes);
  fmt::print("{}: {}, {} of plugins, SHA-256 {}\n", out, plural(std::ssize(run.records), "record"),
             plural(std::ssize(descriptions), "description"), sha256(bytes));
  if (const std::size_t pending = status_of(run).pending; pending > 0)
    fmt::print(stderr, "{} of the plan {} no record yet; see `signorini status`\n",
               plural(static_cast<std::ptrdiff_t>(pending), "case"), pending == 1 ? "has" : "have");
}

struct FetchArguments {
  std::string index, packs = "*";
  std::optional<std::string> out;
};

/// Lists the packs of an archive, or copies them into a folder, each once its hash is found right.
void fetch(const FetchArguments& arguments) {
  const std::vector<IndexedPack> indexed = read_pack_index(arguments.index);
  const fs::path out = arguments.out.value_or("");
  std::size_t chosen = 0;
  for (const IndexedPack& pack : indexed) {
    if (!glob_match(arguments.packs, pack.file)) continue;
    ++chosen;
    if (arguments.out)
      write_whole(folder_inside(out.parent_path(), out.filename().string()) / pack.file,
                  pack_beside(arguments.index, pack));
    fmt::print("{}  {}\n", pack.sha256, pack.file);
  }
  if (chosen == 0)
    throw NothingMatched(fmt::format("--packs = {} (matches none of the {} of {})", arguments.packs,
                                     plural(std::ssize(indexed), "pack"), arguments.index));
}

}  // namespace

void add_fetch_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "fetch", fetch,
      "Lists the packs of an archive, or copies them into a folder after a check of their hashes "
      "against the index, which is the output of `sha256sum *.tar.gz`. "
      "Nothing in them is run. URLs are fetched by the program curl.");
  command.option("index", arguments->index, "the index: a file or a URL; the packs lie beside it",
                 {.required = true});
  command.option("--packs", arguments->packs, "packs by glob on their names");
  command.option("--out", arguments->out, "folder to copy them into; if absent they are listed");
}

void add_pack_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "pack", pack,
      "A run as one file, for others to verify and to report beside theirs: records, plan, manifest (with "
      "the command line), the descriptions of commands that are loaded by --plugin, and hashes of all. A "
      "gzipped tar archive; report, compare and verify take it in place of a folder.");
  command.option("dir", arguments->folder, "folder of a run", {.required = true});
  command.option("--out", arguments->out, "the file, NAME.tar.gz: tables call the run NAME",
                 {.required = true});
}

}  // namespace signorini
