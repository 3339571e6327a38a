#pragma once
// Scripts that run the shards of one benchmark, on a cluster or side by side, and merge them.

#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// What is to be run in shards.
struct Submission {
  std::filesystem::path program = {};  ///< this program
  std::filesystem::path folder = {};   ///< absolute; shards go to shard-I below it, the whole to `merged`
  std::vector<std::string> run_words = {};  ///< suite and options of `run`, alike for all shards
  int shards = 1;
  int at_once = 1;                             ///< of shards on this machine, for GNU parallel
  std::vector<std::string> sbatch_words = {};  ///< further options of sbatch, as "--time=60"
};

/// The command of one shard in the job array; `index` is its number, or what the shell replaces by it.
std::string slurm_run_command(const Submission& submission, const std::string& index);

/// The same of a shard that GNU parallel starts.
std::string parallel_run_command(const Submission& submission, const std::string& index);

/// A job array with one task for each shard; a task that is requeued resumes. Tasks take whole nodes unless
/// `sbatch_words` say otherwise, so that nothing else disturbs their times.
std::string slurm_array_script(const Submission& submission);

/// The job that merges them when all have ended, in whatever way.
std::string slurm_merge_script(const Submission& submission);

/// Submits the two, the second after the first, and prints their numbers.
std::string slurm_submit_script(const Submission& submission);

/// Shards by GNU parallel, then the merge. Cases of several shards at once disturb each other, which their
/// manifests say.
std::string parallel_script(const Submission& submission);

/// The text as one word of a POSIX shell.
std::string shell_word(const std::string& text);

}  // namespace signorini
