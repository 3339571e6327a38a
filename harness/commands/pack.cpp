#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/extend/plugins/command_method.hpp"
#include "harness/extend/plugins/plugins.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
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

void pack(const std::string& folder, const std::string& out) {
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

}  // namespace

void add_pack_command(const Command& program, int& exit_code) {
  struct Arguments {
    std::string folder, out;
  };
  const Command command = program.command(
      "pack",
      "A run as one file, for others to verify and to report beside theirs: records, plan, manifest (with "
      "the command line), the descriptions of commands that are loaded by --plugin, and hashes of all. A "
      "gzipped tar archive; report, compare and verify take it in place of a folder.");
  const auto arguments = std::make_shared<Arguments>();
  command.option("dir", arguments->folder, "folder of a run").required();
  command.option("--out", arguments->out, "the file, NAME.tar.gz: tables call the run NAME").required();
  command.on_run([arguments, &exit_code] {
    pack(arguments->folder, arguments->out);
    exit_code = kDone;
  });
}

}  // namespace signorini
