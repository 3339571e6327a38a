#include <fmt/format.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "harness/cluster/scripts.hpp"
#include "harness/commands/command_line.hpp"
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

/// The launcher of the shards and its settings.
struct Launcher {
  std::string program;
  std::string (*run_command)(const Submission&, const std::string& index);
  std::vector<Script> (*scripts)(const Submission&);
};

int submit(SubmitArguments& arguments, const std::vector<std::string>& run_words, const Launcher& launcher) {
  Submission& submission = arguments.submission;
  submission.program = fs::read_symlink("/proc/self/exe");
  submission.folder = fs::absolute(arguments.folder).lexically_normal();
  submission.run_words = run_words;
  if (const int refused = check_run_command(launcher.run_command(submission, "1")); refused != kDone)
    return refused;
  const std::vector<Script> scripts = launcher.scripts(submission);
  if (arguments.dry_run) {
    for (const Script& script : scripts)
      fmt::print("# {}/{}\n{}\n", arguments.folder, script.name, script.text);
    return kDone;
  }
  if (shell("command -v " + launcher.program + " >/dev/null") != 0)
    throw UsageError(fmt::format("launcher = {} (must be installed)", launcher.program));
  std::error_code failure;
  fs::create_directories(submission.folder, failure);
  for (const Script& script : scripts) write_whole(submission.folder / script.name, script.text);
  // The last one starts the others.
  const int code = shell("sh " + shell_word((submission.folder / scripts.back().name).string()));
  if (code != 0) {
    throw UsageError(fmt::format("launcher = {} (must take {}, which ended with exit code {})",
                                 launcher.program, (submission.folder / scripts.back().name).string(), code));
  }
  return kDone;
}

std::vector<Script> slurm_scripts(const Submission& s) {
  return {{"array.sh", slurm_array_script(s)},
          {"merge.sh", slurm_merge_script(s)},
          {"submit.sh", slurm_submit_script(s)}};
}

std::vector<Script> parallel_scripts(const Submission& s) { return {{"parallel.sh", parallel_script(s)}}; }

/// The arguments of `run`, with the plugins by absolute paths: this command has parsed them itself.
std::vector<std::string> run_words(const CLI::App& command) {
  std::vector<std::string> words = command.remaining();
  for (const std::string& plugin : command.get_option("--plugin")->results()) {
    words.emplace_back("--plugin");
    words.push_back(fs::absolute(plugin).lexically_normal().string());
  }
  return words;
}

std::shared_ptr<SubmitArguments> add_common(CLI::App& command) {
  auto arguments = std::make_shared<SubmitArguments>();
  command
      .add_option("dir", arguments->folder, "folder of the shards, of their logs, and of the whole (merged)")
      ->required();
  command.add_option("--shards", arguments->submission.shards, "parts; each scene is in one of them")
      ->required()
      ->check(CLI::Range(1, 10000));
  command.add_flag("--dry-run", arguments->dry_run, "print the scripts, write and submit nothing");
  command.allow_extras();
  command.footer(
      "All other words are those of `signorini run`: a suite, --scenes, --methods, --repetitions, ...");
  return arguments;
}

}  // namespace

void add_submit_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("submit", "Runs a suite in shards, on a cluster or side by side, and merges them.");
  command->require_subcommand(1);
  auto* slurm = command->add_subcommand(
      "slurm",
      "A Slurm job array, one task for each shard on a node of its own, and a merge job that follows it.");
  const auto array = add_common(*slurm);
  slurm
      ->add_option("--sbatch", array->submission.sbatch_words,
                   "an option of sbatch, as --sbatch=--time=60; repeatable")
      ->allow_extra_args(false);
  slurm->callback([slurm, array, &exit_code] {
    exit_code = submit(*array, run_words(*slurm), {"sbatch", slurm_run_command, slurm_scripts});
  });
  auto* parallel =
      command->add_subcommand("parallel", "Shards by GNU parallel on this machine, then the merge.");
  const auto tasks = add_common(*parallel);
  parallel
      ->add_option("--at-once", tasks->submission.at_once,
                   "shards at the same time; with more than one, times are not comparable")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  parallel->callback([parallel, tasks, &exit_code] {
    exit_code = submit(*tasks, run_words(*parallel), {"parallel", parallel_run_command, parallel_scripts});
  });
}

}  // namespace signorini
