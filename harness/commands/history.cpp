#include "harness/compare/history.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/plots/history_plot.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

struct HistoryArguments {
  std::vector<std::string> places;
  std::string plot;
  Column column = Column::own;
};

void print_history(const History& history) {
  Table table{{"run", "date", "commit", "certified", "error of x", "time"}, {}};
  for (const HistoryPoint& point : history.points)
    table.rows.push_back(
        {point.run, point.date.substr(0, 16), point.commit,  // to the minute
         count_cell(static_cast<std::ptrdiff_t>(point.certified), static_cast<std::ptrdiff_t>(history.cases)),
         point.error ? fmt::format("{:.1e}", *point.error) : "-",
         point.seconds ? time_text(*point.seconds) : "-"});
  fmt::print(
      "{}\nOf {} cases in all runs. Error: median over the {} certified in all of them. Time: geometric mean "
      "over\n"
      "the {} of these timed in all runs with a time, as on the machine of the first.\n",
      to_columns(table, kTerminalWidth), history.cases, history.certified, history.timed);
  for (const HistoryPoint& point : history.points)
    if (!point.hides_time.empty()) fmt::print("note: no time of {}: {}\n", point.run, point.hides_time);
}

void show_history(const HistoryArguments& arguments) {
  std::vector<WholeRun> runs;
  for (const std::string& place : arguments.places) {
    const OpenedRun opened(place);
    runs.push_back(read_whole_run(opened.folder()));
  }
  const History history = history_of(std::move(runs));
  if (history.cases == 0)
    throw NothingMatched(fmt::format("dirs = {} (have no case in common)", joined(arguments.places, " ")));
  print_history(history);
  if (!arguments.plot.empty()) write_plot(arguments.plot, history_plot(history, arguments.column));
}

}  // namespace

void add_history_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "history", show_history,
      "Runs of one suite by date, over the cases that all of them have: the number certified, the median "
      "error, and the mean time, converted to the machine of the first run by the calibration solves.");
  command.option("dirs", arguments->places, "folders of runs, or packs", {.required = true});
  add_plot_option(command, arguments->plot, "the same over the dates");
  add_column_option(command, arguments->column, "--plot");
}

}  // namespace signorini
