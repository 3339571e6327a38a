#include "harness/commands/verify.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/commands/command_line.hpp"
#include "harness/compare/rerun.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/orbits/kept_reference.hpp"
#include "harness/orbits/orbit_comparison.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

int verify(const VerifyArguments& arguments) {
  const fs::path folder = arguments.folder ? fs::path(*arguments.folder) : references_folder();
  if (!arguments.update && !fs::is_directory(folder)) refuse_folder(folder);
  watch_interrupts();
  return fs::exists(folder / "records.jsonl") ? verify_records(arguments, folder)
                                              : verify_references(arguments, folder);
}

}  // namespace

void refuse_folder(const std::filesystem::path& folder) {
  throw UsageError(
      fmt::format("dir = {} (must be a folder of references, as verify --update makes it, or of records, as "
                  "run makes it)",
                  folder.string()));
}

void print_lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
}

void add_verify_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "verify",
      fmt::format(
          "Are the committed results still true? Of a folder of references: searches every scene's "
          "orbits again; each kept orbit must be found, or certified "
          "again from its impacts, its events within {:g} times the sum of both "
          "error bars plus {:g} of a period, with the same multipliers and stability. Of a folder with "
          "records.jsonl: runs the cases again; each must end with the same status and an error of x "
          "within a factor of {:g} or below ten error bars, while times are only reported. Exit code 0 "
          "if all is the same, 1 if not.",
          kErrorBars, kInstantFloor, kErrorFactor));
  const auto arguments = std::make_shared<VerifyArguments>();
  command->add_option("dir", arguments->folder,
                      "folder of references or of a run; results/references here or above if absent");
  command->add_option("--scenes", arguments->scenes,
                      "scenes by glob, A*:B*-C*; levels of families only where it speaks of them, as "
                      "grazing@*; if absent the "
                      "catalogue but for the scenes tagged large or long-search");
  command->add_option("--cases", arguments->cases, "cases of a run by glob on SCENE/METHOD[OPTIONS]")
      ->capture_default_str();
  command->add_flag(
      "--update", arguments->update,
      "search, and keep what is found, instead of comparing; --starts, --subharmonics and --seed "
      "are for this, a comparison searches as the files say");
  add_search_options(*command, arguments->options, arguments->subharmonics);
  command->callback([arguments, &exit_code] { exit_code = verify(*arguments); });
}

}  // namespace signorini
