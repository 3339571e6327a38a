#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "harness/cluster/scripts.hpp"
#include "harness/commands/command_line.hpp"
#include "harness/extend/plugins/plugins.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

struct SubmitArguments {
  std::string folder;
  Submission submission;
  bool dry_run = false;
};

/// Runs a command line in a shell. \return its exit code
int shell(const std::string& command) {
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): the words are quoted
  return WIFEXITED(status) ? WEXITSTATUS(status) : kInternalError;
}

/// Lets `run` check the command of a shard, so that a mistake is reported here and not on the cluster.
int check_run_command(const std::string& command) {
  return shell(command + " --dry-run 2>&1 >/dev/null | grep -v ' cases on ' >&2; " + command +
               " --dry-run >/dev/null 2>&1");
}

struct Script {
  std::string name;
  std::string text;
};

/// The shards of a command line: its options, and the words of `run` with plugins by absolute paths, for this
/// command has parsed them itself.
Submission submission_of(const SubmitArguments& arguments, const Command& command) {
  Submission submission = arguments.submission;
  submission.program = fs::read_symlink("/proc/self/exe");
  submission.folder = fs::absolute(arguments.folder).lexically_normal();
  submission.run_words = command.rest();
  for (const std::string& plugin : given_plugins()) {
    submission.run_words.emplace_back("--plugin");
    submission.run_words.push_back(fs::absolute(plugin).lexically_normal().string());
  }
  require_quotable(submission);
  return submission;
}

/// Writes the scripts and starts the last one, which starts the others, unless it is a dry run.
int submit(const SubmitArguments& arguments, const fs::path& folder, const std::string& launcher,
           const std::string& run_command, const std::vector<Script>& scripts) {
  if (const int refused = check_run_command(run_command); refused != kDone) return refused;
  if (arguments.dry_run) {
    for (const Script& script : scripts)
      fmt::print("# {}/{}\n{}\n", arguments.folder, script.name, script.text);
    return kDone;
  }
  if (shell("command -v " + launcher + " >/dev/null") != 0)
    throw UsageError(fmt::format("launcher = {} (must be installed)", launcher));
  std::error_code failure;
  fs::create_directories(folder, failure);
  for (const Script& script : scripts) write_whole(folder / script.name, script.text);
  const int code = shell("sh " + shell_word((folder / scripts.back().name).string()));
  if (code != 0) {
    throw UsageError(fmt::format("launcher = {} (must take {}, which ended with exit code {})", launcher,
                                 (folder / scripts.back().name).string(), code));
  }
  return kDone;
}

std::shared_ptr<SubmitArguments> add_common(const Command& command) {
  auto arguments = std::make_shared<SubmitArguments>();
  command.option("dir", arguments->folder, "folder of the shards, of their logs, and of the whole (merged)",
                 {.required = true});
  command.option("--shards", arguments->submission.shards, "parts; each scene is in one of them",
                 {.required = true, .range = {1, 10000}});
  command.flag("--dry-run", arguments->dry_run, "print the scripts, write and submit nothing");
  command.take_rest();
  command.footer(
      "All other words are those of `signorini run`: a suite, --scenes, --methods, --repetitions, ...");
  return arguments;
}

}  // namespace

void add_submit_command(const Command& program) {
  const Command command =
      program.command("submit", "Runs a suite in shards, on a cluster or side by side, and merges them.");
  command.require_command();
  const Command slurm = command.command(
      "slurm",
      "A Slurm job array, one task for each shard on a node of its own, and a merge job that follows it.");
  const auto array = add_common(slurm);
  slurm.option("--sbatch", array->submission.sbatch_words,
               "an option of sbatch, as --sbatch=--time=60; repeatable", {.one_word = true});
  slurm.on_run([slurm, array] {
    const Submission s = submission_of(*array, slurm);
    return submit(*array, s.folder, "sbatch", slurm_run_command(s, "1"),
                  {{"array.sh", slurm_array_script(s)},
                   {"merge.sh", slurm_merge_script(s)},
                   {"submit.sh", slurm_submit_script(s)}});
  });
  const Command parallel =
      command.command("parallel", "Shards by GNU parallel on this machine, then the merge.");
  const auto tasks = add_common(parallel);
  parallel.option("--at-once", tasks->submission.at_once,
                  "shards at the same time; with more than one, times are not comparable",
                  {.range = {1, 1024}});
  parallel.on_run([parallel, tasks] {
    const Submission s = submission_of(*tasks, parallel);
    return submit(*tasks, s.folder, "parallel", parallel_run_command(s, "1"),
                  {{"parallel.sh", parallel_script(s)}});
  });
}

}  // namespace signorini
