#pragma once
// The commands.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/arguments/arguments.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

struct OrbitSearchOptions;

/// Exit codes of the program.
enum ExitCode : int {
  kDone = 0,
  kUnexpectedFailure = 1,
  kBadUsage = 2,
  kNothingMatched = 3,
  kRegression = 4,
  kInternalError = 5,
  kIncomplete = 6,  ///< a response that leaves out parts of its interval, or motions that starts settle to
  kInterrupted = 130
};

/// Parses, runs one command and returns its exit code; errors are one line on stderr.
int run_command_line(int argc, char** argv);

// Each adds one subcommand.
void add_list_command(const Command& program);
void add_show_command(const Command& program);
void add_solve_command(const Command& program);
void add_run_command(const Command& program);
void add_status_command(const Command& program);
void add_merge_command(const Command& program);
void add_compare_command(const Command& program);
void add_history_command(const Command& program);
void add_submit_command(const Command& program);
void add_check_command(const Command& program);
void add_new_command(const Command& program);
void add_sweep_command(const Command& program);
void add_doctor_command(const Command& program);
void add_completion_command(const Command& program);
void add_man_command(const Command& program);
void add_report_command(const Command& program);
void add_pack_command(const Command& program);
void add_fetch_command(const Command& program);
void add_orbits_command(const Command& program);
void add_motion_command(const Command& program);
void add_reduce_command(const Command& program);
void add_verify_command(const Command& program);

/// --starts, --subharmonics, --seed, --timeout: of the commands that search for orbits.
void add_search_options(const Command& command, OrbitSearchOptions& options,
                        std::optional<int>& subharmonics);

/// --plot FILE, refused at once where no picture can be written there.
/// \param what  is drawn, for --help
void add_plot_option(const Command& command, std::string& file, const std::string& what);
/// --column single|double, of figures for a journal. \param of  which figures, for --help
void add_column_option(const Command& command, Column& column, const std::string& of);

/// `key=value` as --set takes it, any number. \throws UsageError
std::vector<std::pair<std::string, std::string>> parse_settings(const std::vector<std::string>& texts);

}  // namespace signorini
