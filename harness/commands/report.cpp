#include "harness/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "harness/campaign.hpp"
#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/record_store.hpp"

namespace signorini {

void add_report_command(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::string folder;
    std::vector<std::string> formats{"md", "csv"};
  };
  auto* command = app.add_subcommand("report", "Tables from the records of a run, written to its folder.");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("dir", arguments->folder, "folder with records.jsonl")->required();
  command->add_option("--format", arguments->formats, "md, csv or both, separated by a comma")
      ->delimiter(',')
      ->check(CLI::IsMember({"md", "csv"}));
  command->callback([arguments, &exit_code] {
    const std::filesystem::path folder = arguments->folder;
    if (!std::filesystem::exists(folder / "records.jsonl")) {
      throw UsageError(
          fmt::format("dir = {} (must be a folder with records.jsonl, as run writes it)", folder.string()));
    }
    write_reports(folder, read_records(folder / "records.jsonl"), arguments->formats);
    for (const std::string& format : arguments->formats) {
      fmt::print("{}\n", (folder / ("table." + format)).string());
    }
    exit_code = kDone;
  });
}

}  // namespace signorini
