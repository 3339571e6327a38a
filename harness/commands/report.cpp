#include "harness/report/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/terminal/terminal.hpp"

namespace signorini {

namespace {

/// The format that is printed and leaves no file.
const std::string kScreen = "screen";

struct ReportArguments {
  std::string folder;
  std::vector<std::string> formats{"md", "csv"};
  std::optional<std::string> document;
  Column column = Column::own;
};

std::vector<std::string> formats_known() {
  std::vector<std::string> formats = kReportFormats;
  formats.push_back(kScreen);
  return formats;
}

void report(const ReportArguments& arguments) {
  const std::filesystem::path folder = arguments.folder;
  refuse_old_responses(folder);
  if (!std::filesystem::exists(folder / "records.jsonl")) {
    throw UsageError(
        fmt::format("dir = {} (must be a folder with records.jsonl, as run writes it)", folder.string()));
  }
  const Evaluation evaluation = evaluation_of_run(folder, limits_of_run(folder));
  if (arguments.document) {
    write_tables_into(*arguments.document, folder, evaluation);
    fmt::print("{}\n", *arguments.document);
    return;
  }
  if (std::ranges::count(arguments.formats, kScreen) > 0) {
    fmt::print("{}", screen_report(evaluation, {.folder = arguments.folder,
                                                .program = typed_program(),
                                                .colour = takes_colour(STDOUT_FILENO)}));
  }
  for (const std::filesystem::path& file :
       write_report(folder, evaluation, arguments.formats, arguments.column))
    fmt::print("{}\n", file.string());
}

}  // namespace

void add_report_command(const Command& program, int& exit_code) {
  const Command command = program.command(
      "report", "Tables, figures and a page from the records of a run, written to its folder.");
  const auto arguments = std::make_shared<ReportArguments>();
  command.option("dir", arguments->folder, "folder with records.jsonl").required();
  command
      .option(
          "--format", arguments->formats,
          "md (table.md), csv (table.csv, measures.csv), tex (tables/*.tex), html (report.html), screen "
          "(printed as at the end of run, no file), separated by commas; tex also draws figures/*.svg and "
          "*.pdf, which needs gnuplot")
      .separated_by(',')
      .one_of(formats_known())
      .shows_default();
  add_column_option(command, arguments->column, "figures/*");
  command.option("--into", arguments->document,
                 "instead bring the tables in this Markdown file up to date, each between the lines <!-- "
                 "table RUN/SECTION [WORD] --> and <!-- /table -->; RUN is the folder's name");
  command.on_run([arguments, &exit_code] {
    report(*arguments);
    exit_code = kDone;
  });
}

}  // namespace signorini
