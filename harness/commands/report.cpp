#include "harness/report/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/run_folder/merge.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/run_folder/side_by_side.hpp"
#include "harness/terminal/terminal.hpp"

namespace signorini {

namespace {

/// The format that is printed and leaves no file.
const std::string kScreen = "screen";

struct ReportArguments {
  std::vector<std::string> folders;
  std::optional<std::string> out;
  std::vector<std::string> formats{"md", "csv"};
  std::optional<std::string> document;
  Column column = Column::own;
};

std::vector<std::string> formats_known() {
  std::vector<std::string> formats = kReportFormats;
  formats.push_back(kScreen);
  return formats;
}

void require_records(const std::filesystem::path& folder) {
  refuse_old_responses(folder);
  if (!std::filesystem::exists(folder / "records.jsonl")) {
    throw UsageError(
        fmt::format("dir = {} (must be a folder with records.jsonl, as run writes it)", folder.string()));
  }
}

/// The folder to report on: that of the run, or of several side by side.
std::filesystem::path folder_of(const ReportArguments& arguments) {
  const std::vector<OpenedRun> runs = opened_runs(arguments.folders);
  std::vector<std::filesystem::path> folders;
  for (const OpenedRun& run : runs) folders.push_back(run.folder());
  std::ranges::for_each(folders, require_records);
  if (runs.size() == 1 && !runs.front().was_packed()) {
    if (arguments.out)
      throw UsageError("out = " + *arguments.out +
                       " (is for several runs: a report stands in the folder of its run)");
    return folders.front();
  }
  if (!arguments.out)
    throw UsageError("out = missing (must be the folder for the page of several runs, or of a pack)");
  require_no_run(*arguments.out);
  put_side_by_side(folders, *arguments.out);
  return *arguments.out;
}

void report(const ReportArguments& arguments) {
  const std::filesystem::path folder = folder_of(arguments);
  const Evaluation evaluation = evaluation_of_run(folder, limits_of_run(folder));
  if (arguments.document) {
    write_tables_into(*arguments.document, folder, evaluation);
    fmt::print("{}\n", *arguments.document);
    return;
  }
  if (std::ranges::count(arguments.formats, kScreen) > 0) {
    fmt::print("{}", screen_report(evaluation, {.folder = folder.string(),
                                                .program = typed_program(),
                                                .colour = takes_colour(STDOUT_FILENO)}));
  }
  for (const std::filesystem::path& file :
       write_report(folder, evaluation, arguments.formats, arguments.column))
    fmt::print("{}\n", file.string());
}

}  // namespace

void add_report_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "report", report, "Tables, figures and a page from the records of a run, written to its folder.");
  command.option(
      "dir", arguments->folders,
      "folder with records.jsonl, or file that pack made; several: one report of all, their methods "
      "with the names of the folders and files, times of other machines scaled",
      {.required = true});
  command.option("--out", arguments->out,
                 "of several runs, or of a pack: folder of their records side by side and of the report, new "
                 "or of an earlier such report");
  command.option(
      "--format", arguments->formats,
      "md (table.md, in large runs the first rows of long tables), whole (table-whole.md, all rows), csv "
      "(table.csv, measures.csv), tex (tables/*.tex), html (report.html), screen (printed as at the end of "
      "run, no file), separated by commas; tex also draws figures/*.svg and *.pdf, which needs gnuplot",
      {.separated_by = ',', .one_of = formats_known()});
  add_column_option(command, arguments->column, "figures/*");
  command.option("--into", arguments->document,
                 "instead bring the tables in this Markdown file up to date, each between the lines <!-- "
                 "table RUN/SECTION [WORD] --> and <!-- /table -->; RUN is the folder's name");
}

}  // namespace signorini
