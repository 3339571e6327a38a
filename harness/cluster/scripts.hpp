#pragma once
// Scripts that run the shards of one benchmark, on a cluster or side by side, and merge them.

#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// A benchmark that is to be run in shards.
struct Submission {
  std::filesystem::path program = {};  ///< this program
  std::filesystem::path folder = {};   ///< absolute; shards go to shard-I below it, the whole to `merged`
  std::vector<std::string> run_words = {};  ///< suite and options of `run`, alike for all shards
  int shards = 1;
  int at_once = 1;                             ///< of shards on this machine, for GNU parallel
  std::vector<std::string> sbatch_words = {};  ///< further options of sbatch, as "--time=60"
};

/// Lines of #SBATCH know no escape for a quotation mark or a line break, and GNU parallel replaces what
/// stands in braces: such folders and options are refused. \throws UsageError
void require_quotable(const Submission& submission);

/// The command of one shard in the job array. \param index  its number, or a shell variable with that value
std::string slurm_run_command(const Submission& submission, const std::string& index);

/// The command of one shard that GNU parallel starts. \param index  as above
std::string parallel_run_command(const Submission& submission, const std::string& index);

/// A job array with one task for each shard; a task that is requeued resumes. Tasks take whole nodes unless
/// `sbatch_words` say otherwise, so that nothing else disturbs their times.
std::string slurm_array_script(const Submission& submission);

/// The job that merges the shards when all of them have ended, whether they succeeded or failed.
std::string slurm_merge_script(const Submission& submission);

/// Submits the job array, and the merge to run after it, and prints the numbers of both jobs.
std::string slurm_submit_script(const Submission& submission);

/// Runs the shards by GNU parallel, then merges them. Shards that run at the same time disturb each other's
/// times; their manifests say so.
std::string parallel_script(const Submission& submission);

/// The text as one word of a POSIX shell.
std::string shell_word(const std::string& text);

}  // namespace signorini
